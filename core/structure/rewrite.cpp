#include "core/structure/rewrite.hpp"

#include <algorithm>

#include "core/base/guard.hpp"
#include "core/base/limits.hpp"

namespace analogon {

ExpressionId Rewriter::operator()(ExpressionId in) {
    if (!in.valid()) return in;
    if (const std::uint32_t* done = done_.find(in.value)) return {*done};
    const ExpressionId out = rebuild(in);
    done_.insert(in.value, out.value);
    return out;
}

ExpressionId Rewriter::rebuild(ExpressionId in) {
    const ExpressionNode node = pool_[in];  // a copy: the pool grows below
    switch (node.operation) {
        case Operation::Constant:
            return in;
        case Operation::Variable:
        case Operation::Derivative:
        case Operation::Time: {
            const ExpressionId out = leaf_(in);
            return out.valid() ? out : in;
        }
        case Operation::If: {
            const ExpressionId condition = (*this)(node.a);
            // Only the branch that is taken: the other may hold what folding has made senseless (1/0).
            if (pool_.isConstant(condition)) return (*this)(pool_[condition].value != 0 ? node.b : node.c);
            const ExpressionId then = (*this)(node.b);
            return pool_.ifThenElse(condition, then, (*this)(node.c));
        }
        case Operation::Delay: {
            if (delays_ == Delays::Keep) return in;
            const ExpressionId signal = (*this)(node.a);
            return pool_.delay(signal, (*this)(node.b));
        }
        case Operation::Smooth:
            return pool_.smooth(static_cast<int>(node.value), (*this)(node.a));
        case Operation::Table: {
            const ExpressionId x = (*this)(node.a);
            if (x == node.a) return in;
            const LookupTable table = pool_.tables()[static_cast<std::size_t>(node.value)];
            return pool_.table(table, x);
        }
        case Operation::TableDerivative:
            return pool_.tableDerivative(static_cast<std::size_t>(node.value), (*this)(node.a));
        default: {
            const ExpressionId a = (*this)(node.a);
            if (!node.b.valid()) return a == node.a ? in : pool_.unary(node.operation, a);
            const ExpressionId b = (*this)(node.b);
            // A numerator that has turned out to be 0, as a factor that has: what it multiplies is not in the model.
            if (node.operation == Operation::Divide && a != node.a && pool_.isConstant(a, 0) && !pool_.isConstant(b))
                return a;
            return a == node.a && b == node.b ? in : pool_.binary(node.operation, a, b);
        }
    }
}

const std::vector<ExpressionId>& LeafCollector::leaves(std::span<const ExpressionId> roots) {
    leaves_.clear();
    delays_.clear();
    seen_.resize(pool_.size());
    ++visit_;
    stack_.assign(roots.rbegin(), roots.rend());
    while (!stack_.empty()) {
        const ExpressionId id = stack_.back();
        stack_.pop_back();
        if (!id.valid() || seen_[id.value] == visit_) continue;
        seen_[id.value] = visit_;
        if (++visited_ > limits::references)
            throw LimitReached(error(
                phrase("the equations of the model refer to its variables more than {} times", limits::references), {},
                phrase("Give a sum that stands in many equations a variable of its own.")));
        const ExpressionNode& node = pool_[id];
        if (node.operation == Operation::Variable || node.operation == Operation::Derivative) {
            leaves_.push_back(id);
        } else if (node.operation == Operation::Delay) {
            delays_.push_back(id);
        } else {
            stack_.push_back(node.c);
            stack_.push_back(node.b);
            stack_.push_back(node.a);
        }
    }
    return leaves_;
}

void DependenceCheck::setUnknowns(std::span<const ExpressionId> unknowns) {
    ++round_;
    isComplete_ = false;
    known_.resize(pool_.size());
    for (const ExpressionId unknown : unknowns) known_[unknown.value] = {round_, Dependence::Linear};
}

void DependenceCheck::setUnknown(ExpressionId unknown, std::span<const std::uint32_t> dependent) {
    setUnknowns({&unknown, 1});
    isComplete_ = true;
    for (const std::uint32_t node : dependent)
        if (node != unknown.value) known_[node] = {round_, classify(pool_[{node}])};
}

Dependence DependenceCheck::operator()(ExpressionId of) {
    if (!of.valid()) return Dependence::None;
    if (of.value >= known_.size()) known_.resize(pool_.size());
    if (known_[of.value].round == round_) return known_[of.value].dependence;
    if (isComplete_) return Dependence::None;
    const Dependence found = classify(pool_[of]);
    known_[of.value] = {round_, found};
    return found;
}

Dependence DependenceCheck::classify(const ExpressionNode& node) {
    switch (node.operation) {
        case Operation::Constant:
        case Operation::Variable:
        case Operation::Derivative:
        case Operation::Time:
        case Operation::Delay:
            return Dependence::None;
        case Operation::Negate:
        case Operation::NoEvent:
        case Operation::Smooth:
            return (*this)(node.a);
        case Operation::Add:
        case Operation::Subtract:
            return std::max((*this)(node.a), (*this)(node.b));
        case Operation::Multiply: {
            const Dependence a = (*this)(node.a), b = (*this)(node.b);
            if (a == Dependence::None) return b;
            return b == Dependence::None ? a : Dependence::Nonlinear;
        }
        case Operation::Divide:
            return (*this)(node.b) == Dependence::None ? (*this)(node.a) : Dependence::Nonlinear;
        case Operation::If:
            if ((*this)(node.a) != Dependence::None) return Dependence::Nonlinear;
            return std::max((*this)(node.b), (*this)(node.c));
        default: {
            const Dependence most = std::max({(*this)(node.a), (*this)(node.b), (*this)(node.c)});
            return most == Dependence::None ? most : Dependence::Nonlinear;
        }
    }
}

}  // namespace analogon
