#pragma once

#include "core/flat/expression.hpp"

namespace analogon {

/// An expression of parameters in formulas that are written for numbers. One without a pool is 0.
struct PoolNumber {
    ExpressionPool* pool{};
    ExpressionId id{};

    PoolNumber() = default;
    PoolNumber(ExpressionPool& in, ExpressionId expression) : pool(&in), id(expression) {}
    ExpressionId in(ExpressionPool& p) const { return pool ? id : p.constant(0); }
};

/// The number as one of the pool of the other.
inline PoolNumber beside(const PoolNumber& other, double number) {
    return other.pool ? PoolNumber(*other.pool, other.pool->constant(number)) : PoolNumber();
}

inline PoolNumber combined(Operation operation, const PoolNumber& a, const PoolNumber& b) {
    ExpressionPool* const pool = a.pool ? a.pool : b.pool;
    return pool ? PoolNumber(*pool, pool->binary(operation, a.in(*pool), b.in(*pool))) : PoolNumber();
}

inline PoolNumber operator+(const PoolNumber& a, const PoolNumber& b) { return combined(Operation::Add, a, b); }
inline PoolNumber operator-(const PoolNumber& a, const PoolNumber& b) { return combined(Operation::Subtract, a, b); }
inline PoolNumber operator*(const PoolNumber& a, const PoolNumber& b) { return combined(Operation::Multiply, a, b); }
inline PoolNumber operator/(const PoolNumber& a, const PoolNumber& b) { return combined(Operation::Divide, a, b); }
inline PoolNumber operator*(double a, const PoolNumber& b) { return beside(b, a) * b; }
inline PoolNumber operator*(const PoolNumber& a, double b) { return a * beside(a, b); }
inline PoolNumber operator/(double a, const PoolNumber& b) { return beside(b, a) / b; }
inline PoolNumber operator/(const PoolNumber& a, double b) { return a / beside(a, b); }
inline PoolNumber operator-(const PoolNumber& a, double b) { return a - beside(a, b); }
inline PoolNumber operator-(const PoolNumber& a) { return a.pool ? PoolNumber(*a.pool, a.pool->negate(a.id)) : a; }

/// What slopes of curves are chosen by, for numbers and for expressions alike: no event comes of it.
inline PoolNumber magnitude(const PoolNumber& a) {
    return a.pool ? PoolNumber(*a.pool, a.pool->unary(Operation::Abs, a.id)) : a;
}
inline PoolNumber length(const PoolNumber& a, const PoolNumber& b) {
    const PoolNumber square = a * a + b * b;
    return square.pool ? PoolNumber(*square.pool, square.pool->unary(Operation::Sqrt, square.id)) : square;
}
inline PoolNumber least(const PoolNumber& a, const PoolNumber& b) { return combined(Operation::Min, a, b); }
inline PoolNumber ifPositive(const PoolNumber& tested, const PoolNumber& then, const PoolNumber& otherwise) {
    if (!tested.pool) return otherwise;
    ExpressionPool& p = *tested.pool;
    const ExpressionId holds = p.unary(Operation::NoEvent, p.binary(Operation::Greater, tested.id, p.constant(0)));
    return {p, p.ifThenElse(holds, then.in(p), otherwise.in(p))};
}

}  // namespace analogon
