#include "core/flat/expression.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/base/guard.hpp"
#include "core/base/limits.hpp"
#include "core/base/stop.hpp"

namespace analogon {
namespace {

using enum Operation;

std::size_t hashOf(const ExpressionNode& node) {
    const auto mix = [](std::uint64_t h, std::uint64_t v) {
        h ^= v + 0x9e3779b97f4a7c15ull + (h << 6) + (h >> 2);
        h *= 0xff51afd7ed558ccdull;
        return h ^ (h >> 32);
    };
    std::uint64_t h = static_cast<std::uint64_t>(node.operation);
    h = mix(h, std::bit_cast<std::uint64_t>(node.value));
    h = mix(h, (std::uint64_t{node.variable.value} << 32) | node.a.value);
    h = mix(h, (std::uint64_t{node.b.value} << 32) | node.c.value);
    return h;
}

bool sameNode(const ExpressionNode& x, const ExpressionNode& y) {
    return x.operation == y.operation &&
           std::bit_cast<std::uint64_t>(x.value) == std::bit_cast<std::uint64_t>(y.value) && x.variable == y.variable &&
           x.a == y.a && x.b == y.b && x.c == y.c;
}

bool isCommutative(Operation operation) {
    switch (operation) {
        case Add:
        case Multiply:
        case Equal:
        case NotEqual:
        case And:
        case Or:
        case Min:
        case Max:
            return true;
        default:
            return false;
    }
}

}  // namespace

double apply(Operation operation, double a, double b) {
    switch (operation) {
        case Negate:
            return -a;
        case Add:
            return a + b;
        case Subtract:
            return a - b;
        case Multiply:
            return a * b;
        case Divide:
            return a / b;
        case Power:
            return std::pow(a, b);
        case Less:
            return a < b;
        case LessEqual:
            return a <= b;
        case Greater:
            return a > b;
        case GreaterEqual:
            return a >= b;
        case Equal:
            return a == b;
        case NotEqual:
            return a != b;
        case And:
            return a != 0 && b != 0;
        case Or:
            return a != 0 || b != 0;
        case Not:
            return a == 0;
        case Abs:
            return std::fabs(a);
        case Sign:
            return (a > 0) - (a < 0);
        case Sqrt:
            return std::sqrt(a);
        case Exp:
            return std::exp(a);
        case Log:
            return std::log(a);
        case Log10:
            return std::log10(a);
        case Sin:
            return std::sin(a);
        case Cos:
            return std::cos(a);
        case Tan:
            return std::tan(a);
        case Asin:
            return std::asin(a);
        case Acos:
            return std::acos(a);
        case Atan:
            return std::atan(a);
        case Atan2:
            return std::atan2(a, b);
        case Sinh:
            return std::sinh(a);
        case Cosh:
            return std::cosh(a);
        case Tanh:
            return std::tanh(a);
        case Min:
            return b < a ? b : a;
        case Max:
            return b > a ? b : a;
        case Floor:
            return std::floor(a);
        case Ceil:
            return std::ceil(a);
        case Mod:
            return a - std::floor(a / b) * b;
        case Rem:
            return a - std::trunc(a / b) * b;
        case Div:
            return std::trunc(a / b);
        case NoEvent:
        case Smooth:
            return a;
        default:
            break;
    }
    assert(false && "apply() is for operations on numbers");
    return std::nan("");
}

// ---------------------------------------------------------------------------------------------- construction

void ExpressionPool::growIndex() {
    const std::size_t size = std::max<std::size_t>(256, index_.size() * 2);
    constexpr std::size_t nodeBytes = 2 * sizeof(ExpressionNode) + 2 * sizeof(std::uint32_t);  // while it moves
    if (const auto enough = limits::checkExpressions(size / 2, nodeBytes); !enough)
        throw LimitReached(enough.diagnostics().front());
    index_.assign(size, 0);
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
        std::size_t slot = hashOf(nodes_[i]) & (size - 1);
        while (index_[slot]) slot = (slot + 1) & (size - 1);
        index_[slot] = i + 1;
    }
}

std::size_t ExpressionPool::slotOf(const ExpressionNode& node) const {
    const std::size_t mask = index_.size() - 1;
    std::size_t slot = hashOf(node) & mask;
    while (index_[slot] && !sameNode(nodes_[index_[slot] - 1], node)) slot = (slot + 1) & mask;
    return slot;
}

ExpressionId ExpressionPool::find(const ExpressionNode& node) const {
    if (index_.empty()) return {};
    const std::uint32_t entry = index_[slotOf(node)];
    return entry ? ExpressionId{entry - 1} : ExpressionId{};
}

ExpressionId ExpressionPool::intern(const ExpressionNode& node) {
    if (2 * (nodes_.size() + 1) > index_.size()) growIndex();
    std::uint32_t& entry = index_[slotOf(node)];
    if (!entry) {
        stopPoint();  // all that is done with a model makes nodes
        if (nodes_.size() >= limits::expressions)
            throw LimitReached(
                error(phrase("the equations of the model, or their derivatives, take more than {} expressions",
                             limits::expressions),
                      {}, limits::shorterEquations()));
        nodes_.push_back(node);
        entry = static_cast<std::uint32_t>(nodes_.size());
    }
    return {entry - 1};
}

ExpressionId ExpressionPool::constant(double value) {
    return intern({.operation = Constant, .value = value == 0 ? 0.0 : value});  // -0 and 0 are one node
}

ExpressionId ExpressionPool::variable(VariableId variable) {
    return intern({.operation = Variable, .variable = variable});
}

ExpressionId ExpressionPool::derivativeOf(VariableId variable) {
    return intern({.operation = Derivative, .variable = variable});
}

ExpressionId ExpressionPool::time() { return intern({.operation = Time}); }

ExpressionId ExpressionPool::unary(Operation operation, ExpressionId a) {
    const ExpressionId folded = foldUnary(operation, a);
    return folded.valid() ? folded : intern({.operation = operation, .a = a});
}

ExpressionId ExpressionPool::binary(Operation operation, ExpressionId a, ExpressionId b) {
    const ExpressionId folded = foldBinary(operation, a, b);
    if (folded.valid()) return folded;
    // a + b and b + a are one node: the order written first stays, so that a listing reads like its source.
    if (isCommutative(operation)) {
        const ExpressionId known = find({.operation = operation, .a = b, .b = a});
        if (known.valid()) return known;
    }
    return intern({.operation = operation, .a = a, .b = b});
}

ExpressionId ExpressionPool::foldUnary(Operation operation, ExpressionId a) {
    const ExpressionNode node = nodes_[a.value];
    if (node.operation == Constant) {
        const double value = apply(operation, node.value);
        if (std::isfinite(value)) return constant(value);
        return {};
    }
    const bool isLeaf = node.operation == Variable || node.operation == Derivative || node.operation == Time;
    switch (operation) {
        case Negate:
            if (node.operation == Negate) return node.a;
            if (node.operation == Subtract) return subtract(node.b, node.a);
            break;
        case Not:
            if (node.operation == Not) return node.a;
            break;
        case Abs:
            if (node.operation == Abs) return a;
            if (node.operation == Negate) return unary(Abs, node.a);
            break;
        case NoEvent:
            if (isLeaf || node.operation == NoEvent) return a;
            break;
        default:
            break;
    }
    return {};
}

ExpressionId ExpressionPool::foldAdd(ExpressionId a, ExpressionId b) {
    if (isConstant(a, 0)) return b;
    if (isConstant(b, 0)) return a;
    if (nodes_[b.value].operation == Negate) return subtract(a, nodes_[b.value].a);
    if (nodes_[a.value].operation == Negate) return subtract(b, nodes_[a.value].a);
    return {};
}

ExpressionId ExpressionPool::foldSubtract(ExpressionId a, ExpressionId b) {
    if (a == b) return constant(0);
    if (isConstant(b, 0)) return a;
    if (isConstant(a, 0)) return negate(b);
    if (nodes_[b.value].operation == Negate) return add(a, nodes_[b.value].a);
    return {};
}

ExpressionId ExpressionPool::foldMultiply(ExpressionId a, ExpressionId b) {
    if (isConstant(a, 0) || isConstant(b, 0)) return constant(0);
    if (isConstant(a, 1)) return b;
    if (isConstant(b, 1)) return a;
    if (isConstant(a, -1)) return negate(b);
    if (isConstant(b, -1)) return negate(a);
    const ExpressionNode na = nodes_[a.value], nb = nodes_[b.value];
    if (na.operation == Negate && nb.operation == Negate) return multiply(na.a, nb.a);
    if (na.operation == Negate) return negate(multiply(na.a, b));
    if (nb.operation == Negate) return negate(multiply(a, nb.a));
    return {};
}

ExpressionId ExpressionPool::foldBinary(Operation operation, ExpressionId a, ExpressionId b) {
    if (isConstant(a) && isConstant(b)) {
        const double value = apply(operation, nodes_[a.value].value, nodes_[b.value].value);
        if (std::isfinite(value)) return constant(value);
        return {};
    }
    switch (operation) {
        case Add:
            return foldAdd(a, b);
        case Subtract:
            return foldSubtract(a, b);
        case Multiply:
            return foldMultiply(a, b);
        case Divide:
            if (isConstant(b, 1)) return a;
            if (isConstant(b, -1)) return negate(a);
            if (isConstant(b) && isConstant(a, 0) && nodes_[b.value].value != 0) return constant(0);
            if (nodes_[a.value].operation == Negate) return negate(divide(nodes_[a.value].a, b));
            break;
        case Power:
            if (isConstant(b, 1)) return a;
            if (isConstant(b, 0) || isConstant(a, 1)) return constant(1);
            break;
        case Min:
        case Max:
            if (a == b) return a;
            break;
        case Less:
        case Greater:
        case NotEqual:
            if (a == b) return constant(0);
            break;
        case LessEqual:
        case GreaterEqual:
        case Equal:
            if (a == b) return constant(1);
            break;
        case And:
            if (isConstant(a)) return nodes_[a.value].value != 0 ? b : a;
            if (isConstant(b)) return nodes_[b.value].value != 0 ? a : b;
            if (a == b) return a;
            break;
        case Or:
            if (isConstant(a)) return nodes_[a.value].value == 0 ? b : a;
            if (isConstant(b)) return nodes_[b.value].value == 0 ? a : b;
            if (a == b) return a;
            break;
        default:
            break;
    }
    return {};
}

ExpressionId ExpressionPool::ifThenElse(ExpressionId condition, ExpressionId then, ExpressionId otherwise) {
    if (isConstant(condition)) return nodes_[condition.value].value != 0 ? then : otherwise;
    if (then == otherwise) return then;
    return intern({.operation = If, .a = condition, .b = then, .c = otherwise});
}

ExpressionId ExpressionPool::smooth(int order, ExpressionId a) {
    if (isConstant(a)) return a;
    return intern({.operation = Smooth, .value = static_cast<double>(order), .a = a});
}

std::size_t ExpressionPool::tableIndex(const LookupTable& table) {
    LookupTable prepared = table;
    prepared.prepare();
    const auto known = std::find(tables_.begin(), tables_.end(), prepared);
    if (known != tables_.end()) return static_cast<std::size_t>(known - tables_.begin());
    tables_.push_back(std::move(prepared));
    return tables_.size() - 1;
}

ExpressionId ExpressionPool::table(const LookupTable& table, ExpressionId x) {
    const std::size_t index = tableIndex(table);
    if (isConstant(x)) {
        const double value = tables_[index].value(nodes_[x.value].value);
        if (std::isfinite(value)) return constant(value);
    }
    return intern({.operation = Table, .value = static_cast<double>(index), .a = x});
}

ExpressionId ExpressionPool::tableDerivative(std::size_t table, ExpressionId x) {
    assert(table < tables_.size());
    const LookupTable& t = tables_[table];
    const int degree = t.interpolation == LookupTable::Interpolation::Constant ? 0
                       : t.interpolation == LookupTable::Interpolation::Linear ? 1
                                                                               : 3;
    if (t.x.size() < 2 || t.order >= degree) return constant(0);
    if (isConstant(x)) return constant(t.derivative(nodes_[x.value].value));
    return intern({.operation = TableDerivative, .value = static_cast<double>(table), .a = x});
}

ExpressionId ExpressionPool::delay(ExpressionId signal, ExpressionId delayTime) {
    if (isConstant(signal) || isConstant(delayTime, 0)) return signal;
    return intern({.operation = Delay, .a = signal, .b = delayTime});
}

}  // namespace analogon
