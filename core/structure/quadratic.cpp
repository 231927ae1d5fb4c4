#include "core/structure/quadratic.hpp"

#include <unordered_map>

namespace analogon {
namespace {

/// At least or at most 0 (1, -1) for all parameters within their bounds; 0: not known, or exactly 0.
class SignOf {
public:
    explicit SignOf(const EquationSystem& system) : system_(system), pool_(*system.pool) {}

    int operator()(ExpressionId id) {
        if (const auto known = known_.find(id.value); known != known_.end()) return known->second;
        const int sign = find(pool_[id]);
        known_.emplace(id.value, sign);
        return sign;
    }

private:
    int find(const ExpressionNode node) {
        switch (node.operation) {
            case Operation::Constant:
                return (node.value > 0) - (node.value < 0);
            case Operation::Variable: {
                const FlatVariable& variable = (*system_.model)[node.variable];
                if (variable.variability == FlatVariability::Continuous) return 0;
                return variable.min && *variable.min >= 0 ? 1 : variable.max && *variable.max <= 0 ? -1 : 0;
            }
            case Operation::Negate:
                return -(*this)(node.a);
            case Operation::Add:
                return (*this)(node.a) == (*this)(node.b) ? (*this)(node.a) : 0;
            case Operation::Subtract:
                return (*this)(node.a) == -(*this)(node.b) ? (*this)(node.a) : 0;
            case Operation::Multiply:
                return node.a == node.b ? 1 : (*this)(node.a) * (*this)(node.b);
            case Operation::Divide:
                return (*this)(node.a) * (*this)(node.b);
            case Operation::NoEvent:
            case Operation::Smooth:
                return (*this)(node.a);
            case Operation::Abs:
            case Operation::Sqrt:
            case Operation::Exp:
                return 1;
            default:
                return 0;
        }
    }

    const EquationSystem& system_;
    const ExpressionPool& pool_;
    std::unordered_map<std::uint32_t, int> known_;
};

/// Expressions in z as c0 + c1 y + c2 y abs(y), y = p + q z being what stands under the magnitude.
class QuadraticForm {
public:
    struct Terms {
        ExpressionId c0, c1, c2;
    };

    QuadraticForm(ExpressionPool& pool, DependenceCheck& depends, ExpressionId z)
        : pool_(pool), depends_(depends), z_(z), zero_(pool.constant(0)), one_(pool.constant(1)) {}

    std::optional<Terms> of(ExpressionId residual) {
        findMagnitude(residual);
        if (!y_.valid() || !isOne_) return std::nullopt;
        const std::optional<Terms> affine = terms(y_);
        if (!affine || isZero(affine->c1)) return std::nullopt;
        p_ = affine->c0;
        q_ = affine->c1;
        isInY_ = true;
        return terms(residual);
    }
    /// z where y is known.
    ExpressionId back(ExpressionId y) { return pool_.divide(pool_.subtract(y, p_), q_); }

private:
    /// factor * y^linear * abs(y)^magnitude, both 0 or 1
    struct Monomial {
        ExpressionId factor;
        int linear{}, magnitude{};
    };

    bool isFree(ExpressionId e) { return depends_(e) == Dependence::None; }
    bool isZero(ExpressionId e) const { return pool_.isConstant(e, 0); }

    /// What z enters through its magnitude: one expression, or it is of another kind.
    void findMagnitude(ExpressionId e) {
        if (++visits_ > mostVisits || isFree(e)) return;
        const ExpressionNode node = pool_[e];
        if (node.operation == Operation::Abs) {
            isOne_ = isOne_ && (!y_.valid() || y_ == node.a);
            y_ = node.a;
            return;
        }
        for (const ExpressionId operand : {node.a, node.b, node.c})
            if (operand.valid()) findMagnitude(operand);
    }

    std::optional<Terms> terms(ExpressionId e) {
        if (++visits_ > mostVisits) return std::nullopt;
        if (isFree(e)) return Terms{e, zero_, zero_};
        if (isInY_ && e == y_) return Terms{zero_, one_, zero_};
        if (e == z_)
            return isInY_ ? Terms{pool_.negate(pool_.divide(p_, q_)), pool_.divide(one_, q_), zero_}
                          : Terms{zero_, one_, zero_};
        const ExpressionNode node = pool_[e];
        switch (node.operation) {
            case Operation::NoEvent:
            case Operation::Smooth:
                return terms(node.a);
            case Operation::Negate:
                return each(terms(node.a), [&](ExpressionId c) { return pool_.negate(c); });
            case Operation::Add:
            case Operation::Subtract:
                return sum(node.operation, terms(node.a), terms(node.b));
            case Operation::Multiply:
                if (isFree(node.a))
                    return each(terms(node.b), [&](ExpressionId c) { return pool_.multiply(node.a, c); });
                if (isFree(node.b))
                    return each(terms(node.a), [&](ExpressionId c) { return pool_.multiply(c, node.b); });
                return product(e);
            case Operation::Divide:
                if (!isFree(node.b)) return std::nullopt;
                return each(terms(node.a), [&](ExpressionId c) { return pool_.divide(c, node.b); });
            default:
                return std::nullopt;
        }
    }

    template <class Change>
    std::optional<Terms> each(std::optional<Terms> t, const Change& change) const {
        if (!t) return t;
        for (ExpressionId* c : {&t->c0, &t->c1, &t->c2})
            if (!isZero(*c)) *c = change(*c);
        return t;
    }

    std::optional<Terms> sum(Operation operation, const std::optional<Terms>& a, const std::optional<Terms>& b) {
        if (!a || !b) return std::nullopt;
        return Terms{pool_.binary(operation, a->c0, b->c0), pool_.binary(operation, a->c1, b->c1),
                     pool_.binary(operation, a->c2, b->c2)};
    }

    std::optional<Terms> product(ExpressionId e) {
        const std::optional<Monomial> m = isInY_ ? monomial(e) : std::nullopt;
        if (!m || m->linear != 1 || m->magnitude != 1) return std::nullopt;
        return Terms{zero_, zero_, m->factor};
    }

    std::optional<Monomial> monomial(ExpressionId e) {
        if (++visits_ > mostVisits) return std::nullopt;
        if (isFree(e)) return Monomial{e, 0, 0};
        if (e == y_) return Monomial{one_, 1, 0};
        if (e == z_ && isZero(p_)) return Monomial{pool_.divide(one_, q_), 1, 0};
        const ExpressionNode node = pool_[e];
        switch (node.operation) {
            case Operation::NoEvent:
            case Operation::Smooth:
                return monomial(node.a);
            case Operation::Abs:
                return node.a == y_ ? std::optional(Monomial{one_, 0, 1}) : std::nullopt;
            case Operation::Negate: {
                std::optional<Monomial> m = monomial(node.a);
                if (m) m->factor = pool_.negate(m->factor);
                return m;
            }
            case Operation::Multiply: {
                const std::optional<Monomial> a = monomial(node.a), b = monomial(node.b);
                if (!a || !b || a->linear + b->linear > 1 || a->magnitude + b->magnitude > 1) return std::nullopt;
                return Monomial{pool_.multiply(a->factor, b->factor), a->linear + b->linear,
                                a->magnitude + b->magnitude};
            }
            case Operation::Divide: {
                std::optional<Monomial> m = isFree(node.b) ? monomial(node.a) : std::nullopt;
                if (m) m->factor = pool_.divide(m->factor, node.b);
                return m;
            }
            default:
                return std::nullopt;
        }
    }

    static constexpr int mostVisits = 2000;  // of nodes: what is larger is not of this kind
    ExpressionPool& pool_;
    DependenceCheck& depends_;
    ExpressionId z_, zero_, one_;
    ExpressionId y_, p_, q_;
    bool isOne_{true}, isInY_{};
    int visits_{};
};

}  // namespace

std::optional<ExpressionId> quadraticSolution(const EquationSystem& system, DependenceCheck& depends,
                                              ExpressionId residual, ExpressionId z) {
    ExpressionPool& pool = *system.pool;
    const ExpressionId one[] = {z};
    depends.setUnknowns(one);
    QuadraticForm form(pool, depends, z);
    const std::optional<QuadraticForm::Terms> terms = form.of(residual);
    if (!terms) return std::nullopt;
    SignOf signOf(system);
    const int sign = signOf(terms->c2);
    if (sign == 0 || (!pool.isConstant(terms->c1, 0) && signOf(terms->c1) != sign)) return std::nullopt;
    const auto positive = [&](ExpressionId e) { return sign > 0 ? e : pool.negate(e); };
    const ExpressionId a = positive(terms->c2), b = positive(terms->c1), g = pool.negate(positive(terms->c0));
    const ExpressionId inside =
        pool.add(pool.multiply(b, b), pool.multiply(pool.multiply(pool.constant(4), a), pool.unary(Operation::Abs, g)));
    const ExpressionId divisor = pool.add(b, pool.unary(Operation::Sqrt, inside));
    const ExpressionId y = pool.ifThenElse(pool.binary(Operation::NotEqual, divisor, pool.constant(0)),
                                           pool.divide(pool.multiply(pool.constant(2), g), divisor), pool.constant(0));
    return form.back(pool.unary(Operation::NoEvent, y));
}

}  // namespace analogon
