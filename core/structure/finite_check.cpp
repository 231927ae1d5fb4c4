#include "core/structure/finite_check.hpp"

#include <array>
#include <cmath>

namespace analogon {
namespace {

bool allowsInfinity(Operation operation) {
    switch (operation) {
        case Operation::Min:
        case Operation::Max:
        case Operation::Less:
        case Operation::LessEqual:
        case Operation::Greater:
        case Operation::GreaterEqual:
            return true;
        default:
            return false;
    }
}

bool isArithmetic(Operation operation) {
    return (operation >= Operation::Negate && operation <= Operation::Power) ||
           (operation >= Operation::Abs && operation <= Operation::Div);
}

}  // namespace

/// An infinite constant; 1/0 is not folded to one.
bool FiniteCheck::isInfinite(ExpressionId id) const {
    const ExpressionNode& n = pool_[id];
    if (n.operation == Operation::Constant) return std::isinf(n.value);
    return n.operation == Operation::Divide && pool_.isConstant(n.b, 0) && pool_.isConstant(n.a) &&
           !pool_.isConstant(n.a, 0);
}

/// From the judgements of its operands, which come before it in the pool.
bool FiniteCheck::judge(const ExpressionNode& node) const {
    const auto isBad = [&](ExpressionId id) {
        if (!id.valid() || !senseless_[id.value]) return false;
        return !(allowsInfinity(node.operation) && isInfinite(id));
    };
    if (node.operation == Operation::Constant) return !std::isfinite(node.value);
    if (node.operation == Operation::If) return isBad(node.a);
    if (node.operation == Operation::Divide && pool_.isConstant(node.b, 0)) return true;
    if (isBad(node.a) || isBad(node.b)) return true;
    if (!isArithmetic(node.operation) || !pool_.isConstant(node.a)) return false;
    return (!node.b.valid() || pool_.isConstant(node.b)) &&  // sqrt(-1) is not folded
           !std::isfinite(apply(node.operation, pool_[node.a].value, node.b.valid() ? pool_[node.b].value : 0));
}

bool FiniteCheck::isSenseless(ExpressionId rewritten) {
    while (senseless_.size() < pool_.size())
        senseless_.push_back(judge(pool_[{static_cast<std::uint32_t>(senseless_.size())}]));
    return senseless_[rewritten.value];
}

/// The innermost part of an expression that is senseless by itself; through the values of parameters.
ExpressionId FiniteCheck::sourceIn(ExpressionId original) {
    ExpressionId source = original;
    owner_ = {};
    for (bool isDeeper = true; isDeeper;) {
        isDeeper = false;
        const ExpressionNode node = pool_[source];
        std::array<ExpressionId, 3> parts{node.a, node.b, node.c};
        if (node.operation == Operation::Variable) {
            const ExpressionId binding = model_[node.variable].binding;
            owner_ = node.variable;
            // A number says less than the name of the parameter that has it.
            parts = {binding.valid() && !pool_.isConstant(binding) ? binding : ExpressionId{}, {}, {}};
        }
        for (const ExpressionId part : parts)
            if (!isDeeper && part.valid() && isSenseless(rewrite_(part))) {
                source = part;
                isDeeper = true;
            }
    }
    return source;
}

std::string FiniteCheck::text(ExpressionId of) const {
    return pool_.print(of, [this](VariableId v) { return model_[v].name; });
}

Text FiniteCheck::whatIsWrong(ExpressionId source) {
    const ExpressionId value = rewrite_(source);
    const ExpressionNode node = pool_[source];
    if (node.operation == Operation::Variable)
        return isInfinite(value) ? phrase("'{}' is infinite", model_[node.variable].name)
                                 : phrase("'{}' is not a number", model_[node.variable].name);
    if (node.operation == Operation::Constant)
        return isInfinite(value) ? phrase("it holds a constant that is infinite")
                                 : phrase("it holds a constant that is not a number");
    Text values;
    LeafCollector collect(pool_);
    for (const ExpressionId leaf : collect.leaves(source))
        if (const ExpressionId number = rewrite_(leaf); number != leaf && pool_.isConstant(number)) {
            if (!values.empty()) values += ", ";
            values += phrase("{} = {}", text(leaf), Text::number(text(number)));
        }
    if (values.empty() && owner_.valid()) values = phrase("the value of '{}'", model_[owner_].name);
    if (!values.empty()) values = " (" + values + ")";
    if (node.operation == Operation::Divide && pool_.isConstant(rewrite_(node.b), 0))
        return phrase("{} divides by 0{}", text(source), values);
    return isInfinite(value) ? phrase("{} is infinite{}", text(source), values)
                             : phrase("{} is not a number{}", text(source), values);
}

std::optional<Diagnostic> FiniteCheck::operator()(const FlatEquation& equation) {
    for (const ExpressionId side : {equation.left, equation.right})
        if (isSenseless(rewrite_(side)))
            return error(phrase("The equation {} = {} cannot hold: {}.", text(equation.left), text(equation.right),
                                whatIsWrong(sourceIn(side))),
                         equation.span, phrase("Give the parameter another value, or write the equation without it."));
    return std::nullopt;
}

}  // namespace analogon
