#include <cmath>
#include <limits>
#include <set>

#include "core/flat/binder.hpp"
#include "core/flat/translator.hpp"

/// Values that must be known before the simulation.
namespace analogon {

std::optional<double> Translator::knownNow(ExpressionId id) {
    if (work_.pool.isConstant(id)) return work_.pool[id].value;
    return isParametric(id) ? constantNumber(id, true) : std::nullopt;
}

bool Translator::isParametric(ExpressionId id) const {
    bool parametric = true;
    work_.pool.evaluate(id, [&](const ExpressionNode& leaf) {
        if (leaf.operation != Operation::Variable || work_.isContinuous(leaf.variable)) parametric = false;
        return 0.0;
    });
    return parametric;
}

std::optional<double> Translator::constantNumber(ExpressionId id, bool isStructural) {
    if (work_.pool.isConstant(id)) return work_.pool[id].value;
    if (depth_ >= deepestNesting) return std::nullopt;
    ++depth_;
    bool known = true;
    const double number = work_.pool.evaluate(id, [&](const ExpressionNode& leaf) {
        if (leaf.operation != Operation::Variable || work_.isContinuous(leaf.variable)) {
            known = false;
            return 0.0;
        }
        const VariableId used = leaf.variable;
        if (work_.records[used.value].number && (!isStructural || work_.variable(used).isStructural))
            return *work_.records[used.value].number;
        if (!known || !work_.binder->bindParameter(*work_.records[used.value].owner, work_.elementOf(used))) {
            known = false;
            return 0.0;
        }
        FlatVariable& variable = work_.model.variables[used.value];
        if (isStructural) variable.isStructural = true;
        const ExpressionId value = variable.binding.valid() ? variable.binding : variable.start;
        const auto constant = value.valid() ? constantNumber(value, isStructural) : std::nullopt;
        work_.records[used.value].number = constant;
        if (!constant) known = false;
        return constant.value_or(0.0);
    });
    --depth_;
    if (!known || !std::isfinite(number)) return std::nullopt;
    return number;
}

/// Whether a parameter that is left free is among what the expression depends on, through all bindings.
bool Translator::isFree(ExpressionId id) {
    std::vector<ExpressionId> ahead{id};
    std::set<VariableId> seen;
    while (!ahead.empty()) {
        const ExpressionId next = ahead.back();
        ahead.pop_back();
        for (const ExpressionId leaf : work_.pool.leaves(std::span(&next, 1))) {
            const VariableId used = work_.pool[leaf].variable;
            if (work_.isContinuous(used) || !seen.insert(used).second) continue;
            if (work_.free.contains(work_.variable(used).name)) return true;
            if (!work_.binder->bindParameter(*work_.records[used.value].owner, work_.elementOf(used))) continue;
            if (const ExpressionId binding = work_.variable(used).binding; binding.valid()) ahead.push_back(binding);
        }
    }
    return false;
}

std::optional<ExpressionId> Translator::ordinate(ExpressionId id) {
    if (!work_.free.empty() && isParametric(id) && isFree(id)) return id;
    const auto number = constantNumber(id, true);
    return number ? std::optional(work_.pool.constant(*number)) : std::nullopt;
}

std::optional<int> Translator::constantInteger(const Expression& expression, const Scope& scope, const Text& what) {
    const auto value = translate(expression, scope);
    if (!value) return std::nullopt;
    if (value->type == FlatType::Integer && value->isScalar()) {
        if (const auto number = constantNumber(value->elements[0], true);
            number && std::fabs(*number) <= std::numeric_limits<int>::max())
            return static_cast<int>(std::lround(*number));
        work_.messages.error(phrase("{} must be known before the simulation", what), expression.span,
                             phrase("use a number, a parameter with a value or a constant"));
        return std::nullopt;
    }
    work_.messages.error(phrase("{} must be an Integer, not {}", what, typeText(*value)), expression.span);
    return std::nullopt;
}

std::optional<bool> Translator::constantBoolean(const Expression& expression, const Scope& scope, const Text& what) {
    const auto value = translate(expression, scope);
    if (!value) return std::nullopt;
    if (value->type == FlatType::Boolean && value->isScalar()) {
        if (const auto number = constantNumber(value->elements[0], true)) return *number != 0;
        work_.messages.error(phrase("{} must be known before the simulation", what), expression.span,
                             phrase("use a parameter with a value"));
        return std::nullopt;
    }
    work_.messages.error(phrase("{} must be Boolean, not {}", what, typeText(*value)), expression.span);
    return std::nullopt;
}

}  // namespace analogon
