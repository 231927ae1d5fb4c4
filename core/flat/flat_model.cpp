#include "core/flat/flat_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace analogon {

VariableId FlatModel::find(std::string_view variableName) const {
    const auto found = byName.find(std::string(variableName));
    return found == byName.end() ? VariableId{} : found->second;
}

bool FlatModel::isInput(VariableId id) const {
    if (variables[id.value].causality != FlatCausality::Input) return false;
    const auto isIt = [&](VariableId other) { return other.valid() && other.value == id.value; };
    return !isIt(events.initial) && !isIt(events.terminal) &&
           std::none_of(events.pres.begin(), events.pres.end(), [&](const auto& pre) { return isIt(pre.first); }) &&
           std::none_of(events.samples.begin(), events.samples.end(), [&](const auto& s) { return isIt(s.flag); });
}

std::string FlatModel::unitOf(const FlatVariable& variable) const {
    if (!variable.unit.empty()) return variable.unit;
    if (const ConnectionSet* set = connectionOf(variable.name))
        for (const std::string& connector : set->connectors)
            if (const VariableId other = find(connector); other.valid() && !(*this)[other].unit.empty())
                return (*this)[other].unit;
    return {};
}

const ConnectionSet* FlatModel::connectionOf(std::string_view connector) const {
    for (const ConnectionSet& set : connections)
        if (std::find(set.connectors.begin(), set.connectors.end(), connector) != set.connectors.end()) return &set;
    return nullptr;
}

std::optional<double> FlatModel::parameterValue(VariableId id) const {
    // Depth first with an explicit stack; a parameter is open while those it uses are evaluated.
    constexpr double open = std::numeric_limits<double>::quiet_NaN();
    std::unordered_map<std::uint32_t, double> values;
    std::vector<VariableId> stack{id};
    while (!stack.empty()) {
        const VariableId top = stack.back();
        const FlatVariable& variable = variables[top.value];
        if (variable.variability == FlatVariability::Continuous || !variable.binding.valid()) return std::nullopt;
        const bool isFirstVisit = values.try_emplace(top.value, open).second;
        bool ready = true;
        if (isFirstVisit)
            for (ExpressionId leaf : pool->leaves(std::span(&variable.binding, 1))) {
                const VariableId used = (*pool)[leaf].variable;
                const auto known = values.find(used.value);
                if (known != values.end() && std::isnan(known->second)) return std::nullopt;  // a circle
                if (known != values.end()) continue;
                stack.push_back(used);
                ready = false;
            }
        if (!ready) continue;
        stack.pop_back();
        double& value = values[top.value];
        if (!std::isnan(value)) continue;
        value = pool->evaluate(variable.binding, [&](const ExpressionNode& leaf) {
            return leaf.operation == Operation::Variable ? values.at(leaf.variable.value) : open;
        });
        if (!std::isfinite(value)) return std::nullopt;
    }
    return values.at(id.value);
}

namespace {

class FlatPrinter {
public:
    explicit FlatPrinter(const FlatModel& model) : model_(model) {}

    std::string print() {
        text_ = fmt::format("model {}\n", model_.name);
        for (const FlatVariable& variable : model_.variables) declaration(variable);
        equations("initial equation", model_.initialEquations);
        equations("equation", model_.equations);
        return text_ + fmt::format("end {};\n", model_.name);
    }

private:
    std::string expression(ExpressionId id) const {
        return model_.pool->print(id, [this](VariableId v) { return model_[v].name; });
    }

    std::string value(const FlatVariable& variable, ExpressionId id) const {
        const bool isBoolean = variable.type == FlatType::Boolean && model_.pool->isConstant(id);
        if (isBoolean) return model_.pool->isConstant(id, 0) ? "false" : "true";
        return expression(id);
    }

    void attribute(std::string& list, std::string_view name, const std::string& attributeValue) const {
        list += fmt::format("{}{} = {}", list.empty() ? "" : ", ", name, attributeValue);
    }

    void declaration(const FlatVariable& variable) {
        std::string list;
        if (!variable.unit.empty()) attribute(list, "unit", fmt::format("\"{}\"", variable.unit));
        if (variable.min) attribute(list, "min", fmt::format("{}", *variable.min));
        if (variable.max) attribute(list, "max", fmt::format("{}", *variable.max));
        if (variable.nominal) attribute(list, "nominal", fmt::format("{}", *variable.nominal));
        if (variable.start.valid()) attribute(list, "start", value(variable, variable.start));
        if (variable.isFixed) attribute(list, "fixed", "true");
        text_ += "  ";
        if (variable.isProtected) text_ += "protected ";
        if (variable.isFinal) text_ += "final ";
        if (variable.variability == FlatVariability::Parameter) text_ += "parameter ";
        if (variable.variability == FlatVariability::Constant) text_ += "constant ";
        if (variable.causality == FlatCausality::Input) text_ += "input ";
        if (variable.causality == FlatCausality::Output) text_ += "output ";
        if (variable.isFlow) text_ += "flow ";
        constexpr const char* types[] = {"Real", "Integer", "Boolean", "String"};
        text_ += fmt::format("{} {}", types[static_cast<int>(variable.type)], variable.name);
        if (!list.empty()) text_ += fmt::format("({})", list);
        if (variable.binding.valid()) text_ += fmt::format(" = {}", value(variable, variable.binding));
        if (variable.type == FlatType::String) text_ += fmt::format(" = \"{}\"", variable.text);
        text_ += ";\n";
    }

    void equations(const char* heading, const std::vector<FlatEquation>& list) {
        if (list.empty()) return;
        text_ += fmt::format("{}\n", heading);
        for (const FlatEquation& equation : list)
            text_ += fmt::format("  {} = {};\n", expression(equation.left), expression(equation.right));
    }

    const FlatModel& model_;
    std::string text_;
};

}  // namespace

std::string print(const FlatModel& model) { return FlatPrinter(model).print(); }

}  // namespace analogon
