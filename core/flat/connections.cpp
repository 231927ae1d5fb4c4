#include "core/flat/connections.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/unit.hpp"
#include "core/flat/instantiator.hpp"

namespace analogon {
namespace {

std::string commaListed(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

std::string kindOf(const FlatVariable& variable) {
    return fmt::format("{}{}", variable.isFlow ? "flow " : "", typeName(variable.type));
}

}  // namespace

std::uint32_t DisjointSets::add() {
    parent_.push_back(size());
    return size() - 1;
}

std::uint32_t DisjointSets::find(std::uint32_t member) const {
    while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
    return member;
}

void DisjointSets::join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
}

// ------------------------------------------------------------------------------------------ connect equations

void Connections::connect(const syntax::Equation& equation, const Scope& scope) {
    if (isSwitchedOff(equation.left.name, scope) || isSwitchedOff(equation.right.name, scope)) return;
    const auto left = side(equation.left, scope);
    const auto right = side(equation.right, scope);
    if (!left || !right) return;
    if (left->dimensions != right->dimensions) {
        work_.messages.error(
            phrase("connect: the sizes differ, {}{} and {}{}", equation.left.span.text(), sizeText(left->dimensions),
                   equation.right.span.text(), sizeText(right->dimensions)),
            equation.span);
        return;
    }
    for (std::size_t i = 0; i < left->connectors.size() && !work_.messages.full(); ++i)
        if (fit(left->connectors[i], right->connectors[i], equation.span))
            join(left->connectors[i], left->isOutside, right->connectors[i], right->isOutside, scope, equation.span);
}

/// A connection to a conditional component that is not there is not there either (section 4.4.5).
bool Connections::isSwitchedOff(const syntax::Name& name, const Scope& scope) {
    Instance* instance = scope.instance;
    for (const auto& part : name.parts) {
        Element* element = instance ? instance->find(part.identifier) : nullptr;
        if (!element || !work_.instantiator->ensure(*instance, *element)) return false;
        if (element->isDisabled) return true;
        instance = element->items.empty() ? nullptr : element->items.front();
    }
    return false;
}

std::optional<Connections::Side> Connections::side(const syntax::Expression& expression, const Scope& scope) {
    const auto slice = work_.translator->resolve(expression.name, scope);
    if (!slice) return std::nullopt;
    const Element& element = *slice->element;
    const bool isSignalOfBus = !slice->variables.empty() && isBusSignal(slice->variables.front());
    if (!element.type.isConnector && !isSignalOfBus) {
        work_.messages.error(
            phrase("connect: '{}' is {}, not a connector", slice->owner->memberName(element.declaration->name),
                   element.isVariable() ? phrase("a {} variable", element.type.className)
                                        : phrase("a component of class {}", element.type.className)),
            expression.span, phrase("name one of its connectors"));
        return std::nullopt;
    }
    if (!slice->startsWithConnector && slice->componentsBefore != 1) {
        work_.messages.error(phrase("connect: '{}' lies inside a component", expression.span.text()), expression.span,
                             phrase("connect to a connector of the component itself"));
        return std::nullopt;
    }
    Side result;
    result.isOutside = slice->startsWithConnector;
    result.dimensions = slice->dimensions;
    for (VariableId id : slice->variables)
        result.connectors.push_back({work_.variable(id).name, element.type.className, {id}, {std::string()}});
    for (Instance* instance : slice->instances) {
        Connector connector{instance->name, instance->className, {}, {}};
        collectVariables(*instance, instance->name.size() + 1, connector);
        result.connectors.push_back(std::move(connector));
    }
    return result;
}

void Connections::collectVariables(Instance& instance, std::size_t prefix, Connector& connector) {
    for (Element& element : instance.elements) {
        for (Instance* item : element.items) collectVariables(*item, prefix, connector);
        if (!element.firstVariable.valid()) continue;
        for (std::uint32_t k = 0; k < element.count(); ++k) {
            const VariableId id{element.firstVariable.value + k};
            if (!work_.isContinuous(id)) continue;
            connector.variables.push_back(id);
            connector.members.push_back(work_.variable(id).name.substr(prefix));
        }
    }
}

/// Same members, of the same kind and unit.
bool Connections::fit(const Connector& a, const Connector& b, const Span& span) {
    const std::string connection = fmt::format("connect({}, {})", a.name, b.name);
    std::vector<std::string> sortedA = a.members, sortedB = b.members;
    std::sort(sortedA.begin(), sortedA.end());
    std::sort(sortedB.begin(), sortedB.end());
    if (sortedA != sortedB) {
        const auto has = [](const Connector& c) {
            return c.members.size() == 1 && c.members[0].empty() ? phrase("is a signal")
                                                                 : phrase("has {}", commaListed(c.members));
        };
        work_.messages.error(phrase("{}: the connectors do not fit: '{}' ({}) {}, '{}' ({}) {}", connection, a.name,
                                    a.className, has(a), b.name, b.className, has(b)),
                             span, phrase("connect connectors of the same kind"));
        return false;
    }
    for (std::size_t i = 0; i < a.members.size(); ++i) {
        const auto at = std::find(b.members.begin(), b.members.end(), a.members[i]) - b.members.begin();
        const VariableId first = a.variables[i], second = b.variables[static_cast<std::size_t>(at)];
        const FlatVariable &x = work_.variable(first), &y = work_.variable(second);
        if (x.isFlow != y.isFlow || x.type != y.type) {
            work_.messages.error(phrase("{}: '{}' is {}, '{}' is {}", connection, x.name, kindOf(x), y.name, kindOf(y)),
                                 span, phrase("connect connectors of the same kind"));
            return false;
        }
        if (!unitsFit(first, second, span, connection)) return false;
    }
    return true;
}

bool Connections::unitsFit(VariableId a, VariableId b, const Span& span, const std::string& connection) {
    const FlatVariable &x = work_.variable(a), &y = work_.variable(b);
    if (x.unit.empty() || y.unit.empty() || x.unit == y.unit) return true;
    const auto conversion = convertUnit(x.unit, y.unit);
    if (conversion && conversion->factor == 1 && conversion->offset == 0) return true;
    work_.messages.error(
        phrase("{}: the units differ: '{}' is in {}, '{}' in {}", connection, x.name, x.unit, y.name, y.unit), span,
        phrase("check which variables are meant to be connected"));
    return false;
}

std::uint32_t Connections::memberOf(VariableId variable, bool isOutside, const Scope& scope, const Span& span) {
    const std::size_t key = 2 * std::size_t{variable.value} + (isOutside ? 1 : 0);
    if (memberIndex_.size() <= key) memberIndex_.resize(2 * work_.model.variables.size());
    if (!memberIndex_[key]) {
        members_.push_back({variable, isOutside, scope.instance, span});
        memberIndex_[key] = sets_.add() + 1;
    }
    return memberIndex_[key] - 1;
}

bool Connections::isConnectedInside(VariableId id) const {
    const std::size_t key = 2 * std::size_t{id.value};
    return key < memberIndex_.size() && memberIndex_[key];
}

std::optional<int> Connections::cardinality(const std::string& connector) {
    if (!isComplete_) return std::nullopt;
    const auto known = ends_.find(connector);
    if (known != ends_.end()) return known->second;
    foundOpen_.insert(connector);
    return 0;
}

bool Connections::isSetWithin(VariableId input) {
    return foundOpen_.contains(connectorName(input)) && isSetByEquation(input);
}

std::uint32_t Connections::connectorSet(const Connector& connector) {
    const auto [entry, isNew] = connectorIndex_.try_emplace(connector.name, connectorSets_.size());
    if (isNew) {
        connectorSets_.add();
        connectors_.emplace_back(connector.name, connector.className);
    }
    return entry->second;
}

void Connections::join(const Connector& a, bool aOutside, const Connector& b, bool bOutside, const Scope& scope,
                       const Span& span) {
    for (std::size_t i = 0; i < a.members.size(); ++i) {
        const auto at = std::find(b.members.begin(), b.members.end(), a.members[i]) - b.members.begin();
        const auto x = memberOf(a.variables[i], aOutside, scope, span);
        const auto y = memberOf(b.variables[static_cast<std::size_t>(at)], bOutside, scope, span);
        sets_.join(x, y);
    }
    ++ends_[a.name];
    ++ends_[b.name];
    const auto x = connectorSet(a);
    connectorSets_.join(x, connectorSet(b));
}

// -------------------------------------------------------------------------------------------------- equations

void Connections::addEquations() {
    membersOf_.resize(members_.size());
    for (std::uint32_t m = 0; m < members_.size(); ++m) membersOf_[sets_.find(m)].push_back(m);
    dropUnusedSignals();
    for (const auto& set : membersOf_) {
        if (set.empty() || isUnused_[members_[set.front()].variable.value]) continue;
        if (work_.variable(members_[set.front()].variable).isFlow)
            flowEquation(set);
        else
            potentialEquations(set);
    }
    unconnectedFlows();
    unconnectedInputs();
}

bool Connections::isBusSignal(VariableId id) const {
    for (const Instance* i = work_.records[id.value].owner; i && !i->isComponent(); i = i->parent)
        if (i->definition->definition->isExpandable) return true;
    return false;
}

/// What an expandable connector declares is there where something is connected to it, on whatever level (section
/// 9.1.3). All else is left out; who names it in an equation is told.
void Connections::dropUnusedSignals() {
    const std::size_t count = work_.records.size();
    isUnused_.assign(count, false);
    std::vector<std::uint32_t> signals;
    for (std::uint32_t i = 0; i < count; ++i)
        if (isBusSignal({i}) && work_.isContinuous({i})) signals.push_back(i);
    if (signals.empty()) return;
    DisjointSets levels;
    for (std::size_t i = 0; i < count; ++i) levels.add();
    for (const auto& set : membersOf_)
        for (const std::uint32_t m : set) levels.join(members_[set.front()].variable.value, members_[m].variable.value);
    std::vector<bool> isUsed(count, false), isNamed(count, false);
    for (std::uint32_t i = 0; i < count; ++i)
        if (!isBusSignal({i})) isUsed[levels.find(i)] = true;
    std::vector<ExpressionId> sides;
    for (const FlatEquation& e : work_.model.equations) sides.insert(sides.end(), {e.left, e.right});
    for (const ExpressionId leaf : work_.pool.leaves(sides)) isNamed[work_.pool[leaf].variable.value] = true;
    for (const std::uint32_t i : signals) {
        if (isUsed[levels.find(i)]) continue;
        FlatVariable& variable = work_.model.variables[i];
        if (isNamed[i])
            work_.messages.error(
                phrase("nothing is connected to '{}', a signal of an expandable connector", variable.name),
                variable.declared, phrase("connect it to an output"));
        isUnused_[i] = true;
        variable.variability = FlatVariability::Constant;
        variable.isProtected = true;
        variable.binding = work_.pool.constant(0);
    }
}

bool Connections::isDrivenWithin(VariableId signal) const {
    const std::size_t key = 2 * std::size_t{signal.value} + 1;
    if (key >= memberIndex_.size() || !memberIndex_[key]) return false;
    const auto& set = membersOf_[sets_.find(memberIndex_[key] - 1)];
    return std::any_of(set.begin(), set.end(), [&](std::uint32_t m) {
        const Member& member = members_[m];
        const VariableRecord& record = work_.records[member.variable.value];
        if (member.isOutside) return record.causality == syntax::Causality::Input && !record.isProtected;
        if (record.causality == syntax::Causality::Output) return true;
        return isBusSignal(member.variable) && isDrivenWithin(member.variable);
    });
}

std::string Connections::connectorName(VariableId id) const {
    const VariableRecord& record = work_.records[id.value];
    const bool isSignal = record.owner->elements[record.element].type.isConnector;
    return isSignal ? work_.variable(id).name : record.owner->name;
}

/// The class whose unknowns a connection to this member decides: the one around its component, which an outer component
/// has elsewhere than the connection.
Instance* Connections::levelOf(const Member& member) const {
    Instance* const around = work_.records[member.variable.value].owner->component().parent;
    return member.isOutside || !around ? member.level : &around->component();
}

/// The first member on the outermost of the levels.
const Connections::Member& Connections::outermostOf(const std::vector<std::uint32_t>& set) const {
    const Member* outermost = &members_[set.front()];
    for (std::uint32_t m : set)
        if (levelOf(members_[m])->depth < levelOf(*outermost)->depth) outermost = &members_[m];
    return *outermost;
}

/// A flow counts positive into the component: seen from within the component its sign turns.
void Connections::flowEquation(const std::vector<std::uint32_t>& set) {
    ExpressionPool& pool = work_.pool;
    ExpressionId sum = pool.constant(0);
    for (std::uint32_t m : set) {
        const ExpressionId flow = pool.variable(members_[m].variable);
        sum = members_[m].isOutside ? pool.subtract(sum, flow) : pool.add(sum, flow);
    }
    const Member& first = members_[set.front()];
    work_.model.equations.push_back({sum, pool.constant(0), first.span, connectorName(first.variable), true});
    ++levelOf(outermostOf(set))->equations;
}

std::string Connections::memberLabel(const Member& member) const {
    return fmt::format("'{}'", work_.variable(member.variable).name);
}

void Connections::potentialEquations(const std::vector<std::uint32_t>& set) {
    // Section 9.2: of the signals in a set at most one is a source, an output of a component or a public input of the
    // class itself. A protected one is a variable between the others.
    const Member* source = nullptr;
    bool onlyInputs = true;
    for (std::uint32_t m : set) {
        const Member& member = members_[m];
        const VariableRecord& record = work_.records[member.variable.value];
        const auto causality = record.causality;
        const bool isSource = member.isOutside ? causality == syntax::Causality::Input && !record.isProtected
                                               : causality == syntax::Causality::Output;
        if (causality == syntax::Causality::None || isSource || member.isOutside) onlyInputs = false;
        if (isSource && source) {
            work_.messages.error(phrase("two signals drive each other: {} and {} are both sources",
                                        memberLabel(*source), memberLabel(member)),
                                 member.span, phrase("connect an output to inputs only"));
            return;
        }
        if (isSource) source = &member;
        if (onlyInputs && isSetByEquation(member.variable)) onlyInputs = false;
    }
    if (onlyInputs) {
        work_.messages.error(phrase("the input {} is connected to inputs only", memberLabel(members_[set[0]])),
                             members_[set[0]].span, phrase("connect one of them to an output"));
        return;
    }
    const Member& reference = source ? *source : outermostOf(set);
    const std::string name = connectorName(members_[set.front()].variable);
    for (std::uint32_t m : set) {
        const Member& member = members_[m];
        if (&member == &reference) continue;
        work_.model.equations.push_back(
            {work_.pool.variable(member.variable), work_.pool.variable(reference.variable), member.span, name, true});
        ++levelOf(member)->equations;
    }
}

void Connections::unconnectedFlows() {
    for (std::uint32_t i = 0; i < work_.records.size(); ++i) {
        const VariableId id{i};
        const FlatVariable& variable = work_.variable(id);
        if (!variable.isFlow) continue;
        Instance& owner = *work_.records[i].owner;
        const bool inConnector = owner.isConnector() || work_.elementOf(id).type.isConnector || owner.isRecord();
        if (!inConnector || !work_.isContinuous(id) || isConnectedInside(id)) continue;
        work_.model.equations.push_back(
            {work_.pool.variable(id), work_.pool.constant(0), variable.declared, connectorName(id), true});
        if (Instance* outer = owner.component().parent) ++outer->component().equations;
    }
}

void Connections::unconnectedInputs() {
    for (std::uint32_t i = 0; i < work_.records.size() && !work_.messages.full(); ++i) {
        const VariableId id{i};
        const VariableRecord& record = work_.records[i];
        if (record.causality != syntax::Causality::Input || !work_.isContinuous(id)) continue;
        Instance& component = record.owner->component();
        if (!component.parent || record.isProtected) continue;
        const std::string& name = work_.variable(id).name;
        const bool isConnected = isConnectedInside(id);
        if (isConnected && record.isBound && !isBoundByItself(id))
            work_.messages.error(phrase("the input '{}' is connected and has a value as well", name),
                                 component.declared, phrase("remove the connection or the value"));
        else if (!isConnected && !record.isBound && !isSetByEquation(id)) {
            const Element& element = work_.elementOf(id);
            const bool isConnector = record.owner->isConnector() || element.type.isConnector;
            work_.messages.error(
                isConnector ? phrase("the input '{}' of {} is not connected", name, component.label())
                            : phrase("the input '{}' of {} has no value", name, component.label()),
                component.declared,
                isConnector ? phrase("connect it to an output or a top-level input")
                            : phrase("give it one where the component is declared: {}({} = …); an equation can only "
                                     "set an input that is a connector, such as RealInput",
                                     component.name.substr(component.name.rfind('.') + 1), element.declaration->name));
        }
    }
}

/// `RealInput u = x` in the class of the component is an equation for x where u is connected.
bool Connections::isBoundByItself(VariableId id) const {
    const VariableRecord& record = work_.records[id.value];
    return work_.elementOf(id).modifier.value.scope.instance == record.owner;
}

/// A connector's variable may be set by an equation of the class that holds the component (section 4.7): it is one of
/// the unknowns of that class, whose balance tells whether the equation is there.
bool Connections::isSetByEquation(VariableId input) {
    if (!isSet_) isSet_ = inputsInEquations();
    return (*isSet_)[input.value];
}

std::vector<bool> Connections::inputsInEquations() const {
    std::unordered_map<std::string, std::vector<ExpressionId>> sides;  // by the component whose equations they are
    for (const FlatEquation& equation : work_.model.equations) {
        if (equation.fromConnection) continue;
        sides[equation.component].push_back(equation.left);
        sides[equation.component].push_back(equation.right);
    }
    std::vector<bool> held(work_.records.size());
    for (const auto& [holder, expressions] : sides)
        for (ExpressionId leaf : work_.pool.leaves(expressions)) {
            const VariableId id = work_.pool[leaf].variable;
            const VariableRecord& record = work_.records[id.value];
            if (record.causality != syntax::Causality::Input) continue;
            const bool isConnector = record.owner->isConnector() || work_.elementOf(id).type.isConnector;
            const Instance* around = record.owner->component().parent;
            const bool isOwn = record.owner->component().name == holder && foundOpen_.contains(connectorName(id));
            if (isConnector && ((around && around->name == holder) || isOwn)) held[id.value] = true;
        }
    return held;
}

void Connections::listSets() {
    std::vector<ConnectionSet> sets(connectors_.size());
    for (std::uint32_t c = 0; c < connectors_.size(); ++c) {
        ConnectionSet& set = sets[connectorSets_.find(c)];
        if (set.connectors.empty()) set.connectorClass = connectors_[c].second;
        set.connectors.push_back(connectors_[c].first);
    }
    for (ConnectionSet& set : sets)
        if (!set.connectors.empty()) work_.model.connections.push_back(std::move(set));
}

}  // namespace analogon
