#include "core/structure/fold.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/structure/finite_check.hpp"
#include "core/structure/rewrite.hpp"

namespace analogon {
namespace {

bool isParameterLike(const FlatVariable& variable) {
    return variable.variability != FlatVariability::Continuous && variable.type != FlatType::String;
}

class Folder {
public:
    Folder(const FlatModel& model, FoldedModel& out, Diagnostics& faults)
        : model_(model),
          out_(out),
          faults_(faults),
          pool_(*out.system.pool),
          state_(model.variables.size(), State::New),
          result_(model.variables.size()),
          rewrite_(pool_, [this](ExpressionId node) { return leaf(node); }),
          finite_(model, pool_, rewrite_) {}

    void keep(const StructureOptions& options);
    void run();

private:
    enum class State { New, Open, Done };

    ExpressionId leaf(ExpressionId node);
    ExpressionId resolve(VariableId id);
    std::optional<double> nominalValue(VariableId id);
    void foldEquations(const std::vector<FlatEquation>& from, std::vector<Equation>& to);

    const FlatModel& model_;
    FoldedModel& out_;
    Diagnostics& faults_;
    ExpressionPool& pool_;
    std::vector<State> state_;
    std::vector<ExpressionId> result_;
    Rewriter rewrite_;
    FiniteCheck finite_;
};

/// The kept parameters, as named by the options.
void Folder::keep(const StructureOptions& options) {
    for (const std::string& name : options.keep) {
        const VariableId id = model_.find(name);
        if (!id.valid()) {
            std::vector<std::string> names;
            for (const FlatVariable& v : model_.variables)
                if (isParameterLike(v)) names.push_back(v.name);
            const std::string like = suggestion(name, names);
            faults_.push_back(error(phrase("The model '{}' has no parameter '{}'.", model_.name, name), {},
                                    like.empty() ? "" : phrase("Did you mean '{}'?", like)));
            continue;
        }
        const FlatVariable& variable = model_[id];
        if (!isParameterLike(variable) || variable.variability == FlatVariability::Constant) {
            faults_.push_back(error(phrase("'{}' is not a parameter and cannot be varied.", name), variable.declared,
                                    phrase("Only parameters of number type can be varied.")));
            continue;
        }
        if (std::find(out_.parameters.begin(), out_.parameters.end(), id) != out_.parameters.end()) continue;
        out_.parameters.push_back(id);
        result_[id.value] = pool_.variable(id);
        state_[id.value] = State::Done;
    }
    for (const VariableId id : out_.parameters) {
        const std::optional<double> value = nominalValue(id);
        if (!value)
            faults_.push_back(error(phrase("The parameter '{}' has no value.", model_[id].name), model_[id].declared,
                                    phrase("Give it a value to start from in the model.")));
        out_.parameterValues.push_back(value.value_or(0));
    }
}

std::optional<double> Folder::nominalValue(VariableId id) {
    if (const std::optional<double> value = model_.parameterValue(id)) return value;
    const ExpressionId start = model_[id].start;
    if (!start.valid()) return {};
    bool known = true;
    const double value = pool_.evaluate(start, [&](const ExpressionNode& node) {
        const std::optional<double> v =
            node.operation == Operation::Variable ? model_.parameterValue(node.variable) : std::nullopt;
        known = known && v.has_value();
        return v.value_or(0);
    });
    return known ? std::optional(value) : std::nullopt;
}

ExpressionId Folder::leaf(ExpressionId node) {
    const ExpressionNode n = pool_[node];
    if (n.operation == Operation::Time || !isParameterLike(model_[n.variable])) return {};
    if (n.operation == Operation::Derivative) return pool_.constant(0);
    return resolve(n.variable);
}

ExpressionId Folder::resolve(VariableId id) {
    if (state_[id.value] == State::Done) return result_[id.value];
    const FlatVariable& variable = model_[id];
    const ExpressionId self = pool_.variable(id);
    if (state_[id.value] == State::Open) {
        faults_.push_back(error(phrase("The value of the parameter '{}' depends on itself.", variable.name),
                                variable.declared,
                                phrase("Break the circle by giving one of the parameters a number.")));
        return self;
    }
    state_[id.value] = State::Open;
    ExpressionId value = variable.binding;
    if (!value.valid() && variable.start.valid()) {
        value = variable.start;
        out_.warnings.push_back(warning(
            phrase("The parameter '{}' has no value; its start value is used.", variable.name), variable.declared));
    }
    if (!value.valid()) {
        faults_.push_back(error(phrase("The parameter '{}' has no value.", variable.name), variable.declared,
                                phrase("Give it a value where the component is declared.")));
        state_[id.value] = State::Done;
        return result_[id.value] = pool_.constant(0);
    }
    ExpressionId expression = rewrite_(value);
    if (!pool_.isConstant(expression) && LeafCollector(pool_).leaves(expression).empty())  // 1/0 is not folded
        expression = pool_.constant(pool_.evaluate(expression, [](const ExpressionNode&) { return std::nan(""); }));
    ExpressionId result = expression;
    if (pool_.isConstant(expression)) {
        out_.folded.emplace_back(id, pool_[expression].value);
    } else {
        result = self;
        SolutionBlock block;
        block.unknowns = {self};
        block.expressions = {expression};
        out_.parameterBlocks.push_back(std::move(block));
    }
    state_[id.value] = State::Done;
    return result_[id.value] = result;
}

void Folder::foldEquations(const std::vector<FlatEquation>& from, std::vector<Equation>& to) {
    to.reserve(from.size());
    for (const FlatEquation& equation : from) {
        to.push_back({rewrite_(equation.left), rewrite_(equation.right), equation.span, equation.component, 0});
        if (std::optional<Diagnostic> fault = finite_(equation)) faults_.push_back(std::move(*fault));
    }
}

void Folder::run() {
    foldEquations(model_.equations, out_.system.equations);
    foldEquations(model_.initialEquations, out_.system.initialEquations);
    out_.starts.resize(model_.variables.size());
    for (std::uint32_t i = 0; i < model_.variables.size(); ++i) {
        const FlatVariable& variable = model_.variables[i];
        if (isParameterLike(variable)) {
            if (variable.binding.valid()) resolve({i});
        } else if (variable.start.valid()) {
            out_.starts[i] = rewrite_(variable.start);
        }
    }
}

}  // namespace

Outcome<FoldedModel> fold(const FlatModel& model, const StructureOptions& options) {
    FoldedModel out;
    out.system.model = std::make_shared<FlatModel>(model);
    out.system.pool = std::make_shared<ExpressionPool>(*model.pool);
    out.system.model->pool = out.system.pool;
    Diagnostics faults;
    Folder folder(model, out, faults);
    folder.keep(options);
    if (faults.empty()) folder.run();
    // A binding that depends on a variable of the simulation would slip through as a "dependent parameter".
    LeafCollector collect(*out.system.pool);
    for (const SolutionBlock& block : out.parameterBlocks)
        for (const ExpressionId leaf : collect.leaves(block.expressions.front()))
            if (!isParameterLike(model[(*out.system.pool)[leaf].variable]))
                faults.push_back(error(phrase("The value of the parameter '{}' depends on '{}', which varies in time.",
                                              out.system.nameOf(block.unknowns.front()), out.system.nameOf(leaf)),
                                       model[(*out.system.pool)[block.unknowns.front()].variable].declared));
    if (!faults.empty()) return faults;
    return out;
}

}  // namespace analogon
