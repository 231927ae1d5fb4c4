#include "core/flat/parameter_change.hpp"

#include <fmt/format.h>

#include <unordered_map>

namespace analogon {
namespace {

/// Replaces one parameter, and those bound to it, by expressions over time.
class Follower {
public:
    Follower(FlatModel& model, VariableId parameter, ExpressionId instead) : model_(model) {
        known_[parameter.value] = instead;
    }

    ExpressionId operator()(ExpressionId in) {
        return model_.pool->substitute(in, [&](const ExpressionNode& node) {
            return node.operation == Operation::Variable ? insteadOf(node.variable) : ExpressionId{};
        });
    }

private:
    /// Invalid: the variable does not depend on the parameter.
    ExpressionId insteadOf(VariableId id) {
        if (const auto found = known_.find(id.value); found != known_.end()) return found->second;
        known_[id.value] = {};  // also ends a cycle of bindings, which is a fault elsewhere
        const FlatVariable& variable = model_.variables[id.value];
        if (variable.variability == FlatVariability::Continuous || !variable.binding.valid()) return {};
        const ExpressionId binding = variable.binding, moved = (*this)(binding);
        if (moved != binding) known_[id.value] = moved;
        return known_[id.value];
    }

    FlatModel& model_;
    std::unordered_map<std::uint32_t, ExpressionId> known_;
};

VariableId addParameter(FlatModel& model, std::string name, std::string unit) {
    FlatVariable variable;
    variable.name = std::move(name);
    variable.variability = FlatVariability::Parameter;
    variable.unit = std::move(unit);
    variable.binding = model.pool->constant(0);
    const VariableId id{static_cast<std::uint32_t>(model.variables.size())};
    model.byName[variable.name] = id;
    model.variables.push_back(std::move(variable));
    return id;
}

}  // namespace

std::string stepOf(const std::string& parameter) { return parameter + ".step"; }
std::string momentOf(const std::string& parameter) { return parameter + ".moment"; }

Outcome<FlatModel> withChange(FlatModel model, const std::string& parameter, double width) {
    const VariableId changed = model.find(parameter);
    if (!changed.valid() || model[changed].variability != FlatVariability::Parameter ||
        model[changed].type != FlatType::Real)
        return error(fmt::format("{} has no parameter {} that could change", model.name, parameter));
    const std::string unit = model[changed].unit;
    const VariableId step = addParameter(model, stepOf(parameter), unit);
    const VariableId moment = addParameter(model, momentOf(parameter), "s");
    ExpressionPool& pool = *model.pool;
    const ExpressionId argument =
        pool.multiply(pool.constant(2 / width), pool.subtract(pool.time(), pool.variable(moment)));
    const ExpressionId risen =
        pool.multiply(pool.constant(0.5), pool.add(pool.constant(1), pool.unary(Operation::Tanh, argument)));
    const ExpressionId instead = pool.add(pool.variable(changed), pool.multiply(pool.variable(step), risen));
    Follower follow(model, changed, instead);
    for (FlatEquation& e : model.equations) {
        e.left = follow(e.left);
        e.right = follow(e.right);
    }
    for (FlatEquation& e : model.initialEquations) {
        e.left = follow(e.left);
        e.right = follow(e.right);
    }
    return model;
}

}  // namespace analogon
