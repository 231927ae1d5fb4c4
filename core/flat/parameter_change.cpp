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

VariableId addInput(FlatModel& model, const std::string& name) {
    FlatVariable signal;
    signal.name = name;
    signal.causality = FlatCausality::Input;
    const VariableId id{static_cast<std::uint32_t>(model.variables.size())};
    model.byName[name] = id;
    model.variables.push_back(std::move(signal));
    return id;
}

/// Invalid: the model has no such parameter.
VariableId realParameter(const FlatModel& model, const std::string& name) {
    const VariableId id = model.find(name);
    const bool isParameter =
        id.valid() && model[id].variability == FlatVariability::Parameter && model[id].type == FlatType::Real;
    return isParameter ? id : VariableId{};
}

void replaceEverywhere(FlatModel& model, VariableId parameter, ExpressionId instead) {
    Follower follow(model, parameter, instead);
    for (std::vector<FlatEquation>* equations : {&model.equations, &model.initialEquations})
        for (FlatEquation& e : *equations) {
            e.left = follow(e.left);
            e.right = follow(e.right);
        }
}

Diagnostic noParameter(const FlatModel& model, const std::string& name) {
    return error(phrase("{} has no parameter {} that could change", model.name, name));
}

}  // namespace

std::set<std::uint32_t> decidedAtStart(const FlatModel& model) {
    std::vector<ExpressionId> sides;
    for (const FlatEquation& e : model.initialEquations) sides.insert(sides.end(), {e.left, e.right});
    std::set<std::uint32_t> decided;
    for (const ExpressionId leaf : model.pool->leaves(sides)) decided.insert((*model.pool)[leaf].variable.value);
    return decided;
}

std::string startOf(const std::string& variable) { return variable + ".start"; }
std::string toldOf(const std::string& start) { return start + ".told"; }
std::string stepOf(const std::string& parameter) { return parameter + ".step"; }
std::string momentOf(const std::string& parameter) { return parameter + ".moment"; }
std::string slopeOf(const std::string& parameter) { return parameter + ".slope"; }

Outcome<FlatModel> withChange(FlatModel model, const std::string& parameter, double width) {
    const VariableId changed = realParameter(model, parameter);
    if (!changed.valid()) return noParameter(model, parameter);
    const std::string unit = model[changed].unit;
    const VariableId step = addParameter(model, stepOf(parameter), unit);
    const VariableId moment = addParameter(model, momentOf(parameter), "s");
    ExpressionPool& pool = *model.pool;
    const ExpressionId argument =
        pool.multiply(pool.constant(2 / width), pool.subtract(pool.time(), pool.variable(moment)));
    const ExpressionId risen =
        pool.multiply(pool.constant(0.5), pool.add(pool.constant(1), pool.unary(Operation::Tanh, argument)));
    replaceEverywhere(model, changed, pool.add(pool.variable(changed), pool.multiply(pool.variable(step), risen)));
    return model;
}

Outcome<FlatModel> withDependence(FlatModel model, const std::string& parameter, const std::string& input) {
    const VariableId changed = realParameter(model, parameter);
    if (!changed.valid()) return noParameter(model, parameter);
    if (model.find(input).valid()) return error(phrase("{} has a variable {} already", model.name, input));
    const VariableId slope = addParameter(model, slopeOf(parameter), model[changed].unit);
    const VariableId moving = addInput(model, input);
    ExpressionPool& pool = *model.pool;
    replaceEverywhere(model, changed,
                      pool.add(pool.variable(changed), pool.multiply(pool.variable(slope), pool.variable(moving))));
    return model;
}

VariableId startedBy(const FlatModel& model, const std::string& start) {
    constexpr std::string_view attribute = ".start";
    if (model.find(start).valid() || !start.ends_with(attribute)) return {};
    const VariableId id = model.find(start.substr(0, start.size() - attribute.size()));
    const bool isFree = id.valid() && model[id].variability == FlatVariability::Continuous &&
                        model[id].type == FlatType::Real && model[id].causality != FlatCausality::Input;
    return isFree ? id : VariableId{};
}

namespace {

/// The initial equation that decides where a variable begins: the one that has it alone on a side, else the first that
/// names it. Null: none does.
FlatEquation* decidingEquation(FlatModel& model, VariableId started) {
    const auto isAlone = [&](ExpressionId side) {
        const ExpressionNode& node = (*model.pool)[side];
        return node.operation == Operation::Variable && node.variable == started;
    };
    FlatEquation* first = nullptr;
    for (FlatEquation& e : model.initialEquations) {
        if (isAlone(e.left) || isAlone(e.right)) return &e;
        for (const ExpressionId leaf : model.pool->leaves(std::vector{e.left, e.right}))
            if ((*model.pool)[leaf].variable == started && first == nullptr) first = &e;
    }
    return first;
}

/// left = right gives way to x = start where `told` is 1: (1 - told)*(left - right) + told*(x - start) = 0.
void giveWay(ExpressionPool& pool, FlatEquation& equation, ExpressionId told, ExpressionId beyondStart) {
    const ExpressionId own = pool.subtract(equation.left, equation.right);
    equation.left =
        pool.add(pool.multiply(pool.subtract(pool.constant(1), told), own), pool.multiply(told, beyondStart));
    equation.right = pool.constant(0);
}

}  // namespace

Outcome<FlatModel> withStart(FlatModel model, const std::string& start, StartTold told) {
    const VariableId started = startedBy(model, start);
    if (!started.valid()) return error(phrase("{} has no variable that begins at {}", model.name, start));
    const VariableId parameter = addParameter(model, start, model.unitOf(model[started]));
    ExpressionPool& pool = *model.pool;
    FlatEquation* const equation = model[started].isFixed ? nullptr : decidingEquation(model, started);
    if (equation != nullptr) {
        const VariableId flag = addParameter(model, toldOf(start), "1");
        if (told == StartTold::Always) model.variables[flag.value].binding = pool.constant(1);
        giveWay(pool, *equation, pool.variable(flag), pool.subtract(pool.variable(started), pool.variable(parameter)));
    }
    FlatVariable& variable = model.variables[started.value];
    if (variable.start.valid()) model.variables[parameter.value].binding = variable.start;
    variable.start = pool.variable(parameter);
    variable.isFixed = equation == nullptr;
    return model;
}

Outcome<FlatModel> withStarts(FlatModel model, const std::vector<std::string>& names, StartTold told) {
    Outcome<FlatModel> started = std::move(model);
    for (const std::string& name : names)
        if (started && startedBy(*started, name).valid()) started = withStart(std::move(*started), name, told);
    return started;
}

Outcome<FlatModel> withImposed(FlatModel model, const std::string& variable, const std::string& input) {
    const VariableId imposed = model.find(variable);
    if (model.find(input).valid()) return error(phrase("{} has a variable {} already", model.name, input));
    for (FlatEquation& e : model.equations) {
        const ExpressionNode& left = (*model.pool)[e.left];
        if (left.operation != Operation::Variable || !imposed.valid() || left.variable != imposed) continue;
        e.right = model.pool->variable(addInput(model, input));
        return model;
    }
    return error(phrase("no equation of {} sets {} alone", model.name, variable));
}

}  // namespace analogon
