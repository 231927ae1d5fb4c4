#include "core/eval/senseless.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace analogon {
namespace {

/// Evaluates expressions on the graph and looks for the operation that makes something not finite of operands that
/// are.
class OperationCheck {
public:
    OperationCheck(const SystemPrograms& programs, const Observation& observation, double time,
                   const LineVector& registers)
        : structure_(programs.structure),
          pool_(*programs.structure.pool),
          model_(*programs.structure.model),
          observation_(observation),
          time_(time),
          registers_(registers),
          collect_(pool_) {}

    Text find() {
        for (const FlatVariable& v : model_.variables)
            if (v.variability == FlatVariability::Parameter && v.binding.valid())
                if (const std::optional<ExpressionId> culprit = culpritIn(v.binding))
                    return place(*culprit, fmt::format("{} = {}", v.name, text(v.binding)),
                                 v.value.valid() ? v.value : v.declared);
        for (const auto* equations : {&model_.equations, &model_.initialEquations})
            for (const FlatEquation& e : *equations)
                for (const ExpressionId side : {e.left, e.right})
                    if (const std::optional<ExpressionId> culprit = culpritIn(side))
                        return place(*culprit, fmt::format("{} = {}", text(e.left), text(e.right)), e.span);
        // what an equation was solved for may divide where it does not
        for (const SolutionBlock& block : structure_.blocks)
            for (std::size_t i = 0; i < block.expressions.size(); ++i)
                if (const std::optional<ExpressionId> culprit = culpritIn(block.expressions[i]))
                    return place(*culprit,
                                 fmt::format("{} = {}", block.isExplicit ? text(block.unknowns[i]) : "0",
                                             text(block.expressions[i])),
                                 {});
        return {};
    }

private:
    double observed(const std::string& name) const {
        const auto at = observation_.handleOf.find(name);
        return at == observation_.handleOf.end()
                   ? std::nan("")
                   : registers_[observation_.results[static_cast<std::size_t>(at->second)]];
    }

    double leaf(const ExpressionNode& node) const {
        switch (node.operation) {
            case Operation::Variable:
                return observed(model_[node.variable].name);
            case Operation::Derivative:
                return observed(fmt::format("der({})", model_[node.variable].name));
            case Operation::Time:
                return time_;
            default:
                return std::nan("");  // what was delayed is not asked for
        }
    }

    double value(ExpressionId id) const {
        return pool_.evaluate(id, [this](const ExpressionNode& node) { return leaf(node); });
    }
    bool isFinite(ExpressionId id) const { return !id.valid() || std::isfinite(value(id)); }

    /// The innermost operation below an expression that has no value although its operands have one; what a condition
    /// has decided against is not looked at.
    std::optional<ExpressionId> culpritIn(ExpressionId id) {
        if (!id.valid() || isFinite(id)) return std::nullopt;
        const ExpressionNode node = pool_[id];
        switch (node.operation) {
            case Operation::Constant:
            case Operation::Variable:
            case Operation::Derivative:
            case Operation::Time:
            case Operation::Delay:
                return std::nullopt;
            case Operation::If:
                if (!isFinite(node.a)) return culpritIn(node.a);
                return culpritIn(value(node.a) != 0 ? node.b : node.c);
            default:
                break;
        }
        for (const ExpressionId part : {node.a, node.b})
            if (part.valid() && !isFinite(part)) return culpritIn(part);
        return id;
    }

    std::string text(ExpressionId id) const {
        return pool_.print(id, [this](VariableId v) { return model_[v].name; });
    }

    Text what(ExpressionId id) const {
        const ExpressionNode node = pool_[id];
        const std::string whole = text(id);
        const double a = value(node.a), b = node.b.valid() ? value(node.b) : 0;
        switch (node.operation) {
            case Operation::Sqrt:
                return phrase("{} is the root of {:.4g}", whole, a);
            case Operation::Log:
            case Operation::Log10:
                return phrase("{} is the logarithm of {:.4g}", whole, a);
            case Operation::Asin:
                return phrase("{} is the arcsine of {:.4g}", whole, a);
            case Operation::Acos:
                return phrase("{} is the arccosine of {:.4g}", whole, a);
            case Operation::Divide:
            case Operation::Mod:
            case Operation::Rem:
            case Operation::Div:
                if (b == 0) return phrase("{} divides {:.4g} by 0", whole, a);
                break;
            case Operation::Power:
                return phrase("{} is the power of {:.4g} to {:.4g}", whole, a, b);
            default:
                break;
        }
        return phrase("{} is beyond all numbers", whole);
    }

    /// The variables of an operation with their values.
    Text values(ExpressionId id) {
        constexpr std::size_t most = 6;
        Text list;
        std::size_t count = 0;
        for (const ExpressionId leaf : collect_.leaves(id)) {
            if (++count > most) break;
            if (!list.empty()) list += ", ";
            list += phrase("{} = {:.4g}", text(leaf), value(leaf));
        }
        return list;
    }

    Text place(ExpressionId culprit, std::string equation, const Span& span) {
        constexpr std::size_t longest = 160;
        if (equation.size() > longest) equation = equation.substr(0, longest) + " …";
        const Text operation = what(culprit), where = values(culprit);
        Text told = where.empty() ? phrase("{}, in the equation {}", operation, equation)
                                  : phrase("{} ({}), in the equation {}", operation, where, equation);
        if (const Place place = placeOf(span); !place.file.empty() && place.line > 0)
            told = phrase("{} ({}, line {})", told, place.file, place.line);
        return told;
    }

    const Structure& structure_;
    const ExpressionPool& pool_;
    const FlatModel& model_;
    const Observation& observation_;
    double time_{};
    const LineVector& registers_;
    LeafCollector collect_;
};

}  // namespace

Text senselessOperation(const SystemPrograms& programs, const Observation& observation, double time,
                        const LineVector& values) {
    return OperationCheck(programs, observation, time, values).find();
}

}  // namespace analogon
