#include "core/flat/balance.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <map>

#include "core/flat/connections.hpp"

namespace analogon {

void Balance::checkConnectors() {
    struct Count {
        int potentials{}, flows{};
        const Instance* first{};
    };
    std::map<const Instance*, Count> counts;  // by connector instance; the first of each class is judged
    std::map<std::string, const Instance*> judged;
    for (const VariableRecord& record : work_.records) {
        const Instance* connector = nullptr;
        for (const Instance* i = record.owner; i && !i->isComponent(); i = i->parent)
            if (i->isConnector()) connector = i;
        if (!connector) continue;
        if (connector->definition->definition->isExpandable) continue;
        if (judged.try_emplace(connector->className, connector).first->second != connector) continue;
        const VariableId id{static_cast<std::uint32_t>(&record - work_.records.data())};
        if (!work_.isContinuous(id) || record.causality != syntax::Causality::None) continue;
        Count& count = counts[connector];
        ++(work_.variable(id).isFlow ? count.flows : count.potentials);
    }
    for (const auto& [connector, count] : counts)
        if (count.flows != count.potentials)
            work_.messages.error(
                count.potentials == 1
                    ? phrase("the connector {} has {} flow and 1 potential variable", connector->className, count.flows)
                    : phrase("the connector {} has {} flow and {} potential variables", connector->className,
                             count.flows, count.potentials),
                connector->definition->definition->nameSpan,
                phrase("a connector needs as many flow variables as others"));
}

namespace {

Text equations(int count) { return count == 1 ? phrase("1 equation") : phrase("{} equations", count); }
Text unknowns(int count) { return count == 1 ? phrase("1 unknown") : phrase("{} unknowns", count); }

}  // namespace

/// Local number of unknowns: variables declared in the component, and the inputs and flows of what it holds.
/// What is supplied from outside, its own inputs and flows, counts as an equation.
void Balance::countUnknowns() {
    for (std::uint32_t i = 0; i < work_.records.size(); ++i) {
        const VariableId id{i};
        const VariableRecord& record = work_.records[i];
        if (!work_.isContinuous(id) || record.element >= record.owner->elements.size()) continue;
        const auto& element = record.owner->elements[record.element];
        if (!element.firstVariable.valid() || element.firstVariable.value + record.position != i) continue;
        Instance& component = record.owner->component();
        ++component.unknowns;
        const bool isFlow = work_.variable(id).isFlow && (&component != record.owner || element.type.isConnector);
        const bool isRead = work_.connections->isBusSignal(id) && !work_.connections->isDrivenWithin(id);
        if (!work_.variable(id).isFlow && work_.connections->isSetWithin(id)) continue;
        const bool isOpenInput = (record.causality == syntax::Causality::Input || isRead) && !record.isProtected &&
                                 (!record.isBound || work_.connections->isConnectedInside(id));
        if (!isFlow && !isOpenInput) continue;
        ++component.equations;
        if (component.parent) ++component.parent->component().unknowns;
    }
}

/// Variables of the component itself that stand in no equation, for the hint.
Balance::Unused Balance::unused(const Instance& component) const {
    std::vector<bool> used(work_.records.size());
    std::vector<ExpressionId> roots;
    for (const FlatEquation& equation : work_.model.equations) {
        roots.push_back(equation.left);
        roots.push_back(equation.right);
    }
    for (ExpressionId leaf : work_.pool.leaves(roots)) used[work_.pool[leaf].variable.value] = true;
    std::string names;
    bool areOutputs = !component.parent;
    for (std::uint32_t i = 0; i < work_.records.size(); ++i) {
        if (used[i] || !work_.isContinuous({i}) || &work_.records[i].owner->component() != &component) continue;
        if (work_.records[i].causality == syntax::Causality::Input && !component.parent) continue;
        areOutputs = areOutputs && work_.records[i].causality == syntax::Causality::Output;
        if (names.size() > 100) return {names + ", …", areOutputs};
        names += (names.empty() ? "" : ", ") + work_.variable({i}).name;
    }
    return {names, areOutputs && !names.empty()};
}

void Balance::checkComponents() {
    for (const Instance* component : work_.components) {
        const int surplus = component->equations - component->unknowns;
        if (surplus == 0 || !reported_.insert(component->className).second) continue;
        const auto [names, areOutputs] = surplus < 0 ? unused(*component) : Unused();
        const Text hint = surplus > 0     ? phrase("remove an equation or a value, or add a variable")
                          : names.empty() ? phrase("add an equation, or connect what is open")
                          : areOutputs    ? phrase("no equation holds the output {}", names)
                                          : phrase("no equation holds {}", names);
        work_.messages.error(surplus > 0
                                 ? phrase("{} has {} for {}: {} too many", component->label(),
                                          equations(component->equations), unknowns(component->unknowns), surplus)
                                 : phrase("{} has {} for {}: {} too few", component->label(),
                                          equations(component->equations), unknowns(component->unknowns), -surplus),
                             component->declared, hint);
    }
}

void Balance::check() {
    countUnknowns();
    checkComponents();
    if (work_.messages.hasErrors()) return;
    std::size_t unknowns = 0;
    for (const FlatVariable& variable : work_.model.variables)
        if (variable.variability == FlatVariability::Continuous && variable.causality != FlatCausality::Input)
            ++unknowns;
    if (work_.model.equations.size() != unknowns)
        work_.messages.error(phrase("model '{}' has {} equations for {} unknowns", work_.model.name,
                                    work_.model.equations.size(), unknowns),
                             work_.components.front()->declared);
}

}  // namespace analogon
