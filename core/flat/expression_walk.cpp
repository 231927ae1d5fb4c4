#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/flat/expression.hpp"
#include "core/flat/node_map.hpp"

namespace analogon {
namespace {

using enum Operation;

/// All nodes below the roots, ascending: children before parents.
std::vector<std::uint32_t> reachable(const std::vector<ExpressionNode>& nodes, std::span<const ExpressionId> roots) {
    NodeMap seen;
    std::vector<std::uint32_t> found, stack;
    const auto visit = [&](ExpressionId id) {
        if (id.valid() && seen.insert(id.value, 0)) {
            found.push_back(id.value);
            stack.push_back(id.value);
        }
    };
    for (ExpressionId root : roots) visit(root);
    while (!stack.empty()) {
        const ExpressionNode& node = nodes[stack.back()];
        stack.pop_back();
        visit(node.a);
        visit(node.b);
        visit(node.c);
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// Results of a bottom-up walk, addressed by node.
template <class T>
class Results {
public:
    explicit Results(std::span<const std::uint32_t> order) : values_(order.size()) {
        for (std::uint32_t i = 0; i < order.size(); ++i) place_.insert(order[i], i);
    }
    T& operator[](ExpressionId id) { return values_[*place_.find(id.value)]; }
    T get(ExpressionId id) { return id.valid() ? (*this)[id] : T{}; }
    T& at(std::size_t position) { return values_[position]; }
    /// nullptr for a node that is not among them.
    const T* find(ExpressionId id) const {
        const std::uint32_t* place = place_.find(id.value);
        return place ? &values_[*place] : nullptr;
    }

private:
    NodeMap place_;
    std::vector<T> values_;
};

}  // namespace

// ------------------------------------------------------------------------------------------- differentiation

ExpressionId ExpressionPool::chainRule(const ExpressionNode& node, ExpressionId self, ExpressionId da, ExpressionId db,
                                       ExpressionId dc) {
    const ExpressionId a = node.a, b = node.b;
    const auto c = [this](double value) { return constant(value); };
    const auto square = [this](ExpressionId x) { return multiply(x, x); };
    const auto zero = [this](ExpressionId x) { return !x.valid() || isConstant(x, 0); };
    switch (node.operation) {
        case Negate:
            return negate(da);
        case Add:
            return add(da, db);
        case Subtract:
            return subtract(da, db);
        case Multiply:
            return add(multiply(da, b), multiply(a, db));
        case Divide:
            if (zero(db)) return divide(da, b);
            return divide(subtract(da, multiply(self, db)), b);  // (a/b)' = (a' - (a/b) b')/b
        case Power: {
            ExpressionId result = c(0);
            if (!zero(da)) result = multiply(multiply(b, power(a, subtract(b, c(1)))), da);
            if (!zero(db)) result = add(result, multiply(multiply(self, unary(Log, a)), db));
            return result;
        }
        case If:
            return ifThenElse(a, db, dc);
        case Abs:
            return multiply(unary(Sign, a), da);
        case Sqrt:
            return divide(da, multiply(c(2), self));
        case Exp:
            return multiply(self, da);
        case Log:
            return divide(da, a);
        case Log10:
            return divide(da, multiply(c(std::log(10.0)), a));
        case Sin:
            return multiply(unary(Cos, a), da);
        case Cos:
            return negate(multiply(unary(Sin, a), da));
        case Tan:
            return multiply(add(c(1), square(self)), da);
        case Asin:
            return divide(da, unary(Sqrt, subtract(c(1), square(a))));
        case Acos:
            return negate(divide(da, unary(Sqrt, subtract(c(1), square(a)))));
        case Atan:
            return divide(da, add(c(1), square(a)));
        case Atan2:
            return divide(subtract(multiply(b, da), multiply(a, db)), add(square(a), square(b)));
        case Sinh:
            return multiply(unary(Cosh, a), da);
        case Cosh:
            return multiply(unary(Sinh, a), da);
        case Tanh:
            return multiply(subtract(c(1), square(self)), da);
        case Min:
            return ifThenElse(unary(NoEvent, binary(LessEqual, a, b)), da, db);
        case Max:
            return ifThenElse(unary(NoEvent, binary(GreaterEqual, a, b)), da, db);
        case Mod:
            return subtract(da, multiply(unary(Floor, divide(a, b)), db));
        case Rem:
            return subtract(da, multiply(binary(Div, a, b), db));
        case NoEvent:
            return unary(NoEvent, da);
        case Smooth:
            return node.value >= 1 ? smooth(static_cast<int>(node.value) - 1, da) : da;
        case Table:
            return multiply(tableDerivative(static_cast<std::size_t>(node.value), a), da);
        case TableDerivative: {
            LookupTable slope = tables_[static_cast<std::size_t>(node.value)];
            ++slope.order;
            return multiply(tableDerivative(tableIndex(slope), a), da);
        }
        default:
            return c(0);  // constants, relations, sign, floor, ceil, div: piecewise constant
    }
}

/// `order` holds the nodes that may have a derivative, children before parents; that of any other is 0.
ExpressionId ExpressionPool::derive(ExpressionId of, std::span<const std::uint32_t> order, const LeafDerivative& leaf,
                                    bool delaysMove) {
    Results<ExpressionId> derivatives(order);
    const ExpressionId zero = constant(0);
    const auto vanishes = [&](ExpressionId id) { return !id.valid() || id == zero; };
    const auto derivativeOfPart = [&](ExpressionId part) {
        if (!part.valid()) return part;
        const ExpressionId* known = derivatives.find(part);
        return known ? *known : zero;
    };
    for (std::size_t i = 0; i < order.size(); ++i) {
        const ExpressionId self{order[i]};
        const ExpressionNode node = nodes_[self.value];
        ExpressionId& result = derivatives.at(i);
        if (node.operation == Variable || node.operation == Derivative || node.operation == Time) {
            result = leaf(node);
            assert(result.valid());
            continue;
        }
        const ExpressionId da = derivativeOfPart(node.a), db = derivativeOfPart(node.b), dc = derivativeOfPart(node.c);
        if (vanishes(da) && vanishes(db) && vanishes(dc)) {
            result = zero;
        } else if (node.operation == Delay) {
            // A delayed signal at t is given by what lies in the past: it does not move with a variable at t.
            result = delaysMove ? delay(da, node.b) : zero;
        } else {
            result = chainRule(node, self, da, db, dc);
        }
    }
    return derivativeOfPart(of);
}

ExpressionId ExpressionPool::differentiate(ExpressionId of, ExpressionId with,
                                           std::span<const std::uint32_t> dependent) {
    const ExpressionNode target = nodes_[with.value];
    assert(target.operation == Variable || target.operation == Derivative);
    const ExpressionId one = constant(1), zero = constant(0);
    return derive(
        of, dependent,
        [&](const ExpressionNode& node) {
            return node.operation == target.operation && node.variable == target.variable ? one : zero;
        },
        false);
}

ExpressionId ExpressionPool::differentiate(ExpressionId of, ExpressionId with) {
    return differentiate(of, with, reachable(nodes_, std::span(&of, 1)));
}

ExpressionId ExpressionPool::timeDerivative(ExpressionId of,
                                            const std::function<ExpressionId(const ExpressionNode&)>& leaf) {
    const ExpressionId one = constant(1);
    return derive(
        of, reachable(nodes_, std::span(&of, 1)),
        [&](const ExpressionNode& node) { return node.operation == Time ? one : leaf(node); }, true);
}

// ------------------------------------------------------------------------------------------------ traversals

ExpressionId ExpressionPool::substitute(ExpressionId in,
                                        const std::function<ExpressionId(const ExpressionNode&)>& leaf) {
    const std::vector<std::uint32_t> order = reachable(nodes_, std::span(&in, 1));
    Results<ExpressionId> results(order);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const ExpressionId self{order[i]};
        const ExpressionNode node = nodes_[self.value];
        ExpressionId replaced{};
        if (node.operation == Variable || node.operation == Derivative || node.operation == Time ||
            node.operation == Delay)
            replaced = leaf(node);
        if (!replaced.valid()) {
            const ExpressionId a = results.get(node.a), b = results.get(node.b), c = results.get(node.c);
            if (a == node.a && b == node.b && c == node.c)
                replaced = self;
            else if (node.operation == If)
                replaced = ifThenElse(a, b, c);
            else if (node.operation == Smooth)
                replaced = smooth(static_cast<int>(node.value), a);
            else if (node.operation == Table)
                replaced = table(LookupTable(tables_[static_cast<std::size_t>(node.value)]), a);
            else if (node.operation == TableDerivative)
                replaced = tableDerivative(static_cast<std::size_t>(node.value), a);
            else if (node.operation == Delay)
                replaced = delay(a, b);
            else
                replaced = b.valid() ? binary(node.operation, a, b) : unary(node.operation, a);
        }
        results.at(i) = replaced;
    }
    return results[in];
}

std::vector<ExpressionId> ExpressionPool::leaves(std::span<const ExpressionId> roots) const {
    std::vector<ExpressionId> result;
    for (std::uint32_t id : reachable(nodes_, roots))
        if (nodes_[id].operation == Variable || nodes_[id].operation == Derivative) result.push_back({id});
    return result;
}

double ExpressionPool::evaluate(ExpressionId id, const std::function<double(const ExpressionNode&)>& leaf) const {
    const std::vector<std::uint32_t> order = reachable(nodes_, std::span(&id, 1));
    Results<double> values(order);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const ExpressionNode& node = nodes_[order[i]];
        double& value = values.at(i);
        switch (node.operation) {
            case Constant:
                value = node.value;
                break;
            case Variable:
            case Derivative:
            case Time:
            case Delay:
                value = leaf(node);
                break;
            case If:
                value = values[node.a] != 0 ? values[node.b] : values[node.c];
                break;
            case Table:
                value = tables_[static_cast<std::size_t>(node.value)].value(values[node.a]);
                break;
            case TableDerivative:
                value = tables_[static_cast<std::size_t>(node.value)].derivative(values[node.a]);
                break;
            default:
                value = apply(node.operation, values[node.a], values.get(node.b));
        }
    }
    return values[id];
}

}  // namespace analogon
