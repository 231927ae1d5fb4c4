#include "core/flat/random_numbers.hpp"

#include <array>
#include <bit>
#include <cassert>
#include <cmath>

namespace analogon {
namespace {

constexpr int wordBits = 64, halfBits = 32, limbBits = 16;
constexpr double halfRange = 4294967296.0, limbRange = 65536.0;  // 2^32, 2^16

/// A word of 64 bits, each of them an expression that is 0 or 1; the lowest one first.
using Bits = std::array<ExpressionId, wordBits>;

/// A word as two numbers without sign.
struct Halves {
    ExpressionId low, high;
};

/// Arithmetic of words in operations on real numbers, each of them exact: what is summed stays below 2^53.
class WordArithmetic {
public:
    explicit WordArithmetic(ExpressionPool& pool) : pool_(pool) {}

    Bits bits(ExpressionId low, ExpressionId high) {
        Bits result;
        half(low, result.data());
        half(high, result.data() + halfBits);
        return result;
    }

    Halves halves(const Bits& word) { return {sum(word.data(), halfBits), sum(word.data() + halfBits, halfBits)}; }

    Bits exclusiveOr(const Bits& a, const Bits& b) {
        Bits result;
        for (std::size_t i = 0; i < a.size(); ++i) {
            const bool isPlain = pool_.isConstant(a[i], 0) || pool_.isConstant(b[i], 0);
            result[i] = isPlain ? pool_.add(a[i], b[i]) : holds(Operation::NotEqual, a[i], b[i]);
        }
        return result;
    }

    /// To higher bits; below 0 to lower ones.
    Bits shifted(const Bits& word, int by) {
        Bits result;
        for (int i = 0; i < wordBits; ++i) {
            const int from = i - by;
            result[static_cast<std::size_t>(i)] =
                from < 0 || from >= wordBits ? number(0) : word[static_cast<std::size_t>(from)];
        }
        return result;
    }

    /// Modulo 2^64, in four limbs of 16 bits.
    Halves product(const Bits& word, std::uint64_t factor) {
        std::array<ExpressionId, 4> limbs{}, results{};
        for (std::size_t i = 0; i < limbs.size(); ++i) limbs[i] = sum(word.data() + i * limbBits, limbBits);
        ExpressionId carry = number(0);
        for (std::size_t k = 0; k < limbs.size(); ++k) {
            ExpressionId all = carry;
            for (std::size_t i = 0; i <= k; ++i) {
                const auto part = static_cast<std::uint16_t>(factor >> (limbBits * (k - i)));
                all = pool_.add(all, pool_.multiply(limbs[i], number(part)));
            }
            carry = quotient(all, limbRange);
            results[k] = pool_.subtract(all, pool_.multiply(carry, number(limbRange)));
        }
        const auto joined = [&](std::size_t low) {
            return pool_.add(results[low], pool_.multiply(results[low + 1], number(limbRange)));
        };
        return {joined(0), joined(2)};
    }

    /// Modulo 2^64.
    Halves total(const Halves& a, const Halves& b) {
        const ExpressionId low = pool_.add(a.low, b.low), carry = quotient(low, halfRange);
        const ExpressionId high = pool_.add(pool_.add(a.high, b.high), carry);
        return {pool_.subtract(low, pool_.multiply(carry, number(halfRange))),
                pool_.subtract(high, pool_.multiply(quotient(high, halfRange), number(halfRange)))};
    }

    /// The Integer of 32 bits that has the bits of a half.
    ExpressionId withSign(ExpressionId half) {
        const ExpressionId isNegative = holds(Operation::GreaterEqual, half, number(halfRange / 2));
        return pool_.subtract(half, pool_.ifThenElse(isNegative, number(halfRange), number(0)));
    }

    ExpressionId withoutSign(ExpressionId integer) {
        const ExpressionId isNegative = holds(Operation::Less, integer, number(0));
        return pool_.add(integer, pool_.ifThenElse(isNegative, number(halfRange), number(0)));
    }

    /// The number in (0, 1] that belongs to a word; one rounding makes it a Real.
    ExpressionId fraction(const Halves& word) {
        const ExpressionId whole = pool_.add(pool_.multiply(withSign(word.high), number(halfRange)), word.low);
        return pool_.add(pool_.multiply(whole, number(std::ldexp(1, -wordBits))), number(0.5));
    }

    ExpressionId holds(Operation relation, ExpressionId a, ExpressionId b) {
        return pool_.unary(Operation::NoEvent, pool_.binary(relation, a, b));
    }
    ExpressionId number(double value) { return pool_.constant(value); }

private:
    ExpressionId quotient(ExpressionId a, double powerOfTwo) {
        return pool_.unary(Operation::NoEvent,
                           pool_.unary(Operation::Floor, pool_.multiply(a, number(1 / powerOfTwo))));
    }

    ExpressionId sum(const ExpressionId* bits, int count) {
        ExpressionId all = number(0);
        for (int i = 0; i < count; ++i) all = pool_.add(all, pool_.multiply(bits[i], number(std::ldexp(1, i))));
        return all;
    }

    /// A bit is what is left of the number above it.
    void half(ExpressionId integer, ExpressionId* bits) {
        ExpressionId rest = withoutSign(integer);
        const ExpressionId whole = rest;
        for (int i = 0; i < halfBits; ++i) {
            const ExpressionId above = i + 1 < halfBits ? quotient(whole, std::ldexp(1, i + 1)) : number(0);
            bits[i] = pool_.subtract(rest, pool_.multiply(number(2), above));
            rest = above;
        }
    }

    ExpressionPool& pool_;
};

}  // namespace

RandomStep xorshift64star(ExpressionPool& pool, std::span<const ExpressionId> state) {
    assert(state.size() == 2);
    WordArithmetic words(pool);
    Bits x = words.bits(state[0], state[1]);
    for (const int shift : {-12, 25, -27}) x = words.exclusiveOr(x, words.shifted(x, shift));
    const Halves next = words.product(x, 2685821657736338717u);
    return {words.fraction(next), {words.withSign(next.low), words.withSign(next.high)}};
}

RandomStep xorshift128plus(ExpressionPool& pool, std::span<const ExpressionId> state) {
    assert(state.size() == 4);
    WordArithmetic words(pool);
    Bits first = words.bits(state[0], state[1]);
    const Bits second = words.bits(state[2], state[3]);
    first = words.exclusiveOr(first, words.shifted(first, 23));
    const Bits mixed = words.exclusiveOr(words.exclusiveOr(first, words.shifted(first, -17)),
                                         words.exclusiveOr(second, words.shifted(second, -26)));
    const Halves next = words.total(words.halves(mixed), {words.withoutSign(state[2]), words.withoutSign(state[3])});
    return {words.fraction(next), {state[2], state[3], words.withSign(next.low), words.withSign(next.high)}};
}

RandomStep xorshift1024star(ExpressionPool& pool, std::span<const ExpressionId> state) {
    assert(state.size() == 33);
    WordArithmetic words(pool);
    constexpr int count = 16;
    const auto turnOf = [&](ExpressionId at) { return pool.binary(Operation::Mod, at, words.number(count)); };
    const ExpressionId turn = turnOf(state[32]), next = turnOf(pool.add(turn, words.number(1)));
    const auto isTurn = [&](ExpressionId at, int k) { return words.holds(Operation::Equal, at, words.number(k)); };
    const auto chosen = [&](ExpressionId at, std::size_t half) {
        ExpressionId one = state[half];
        for (int k = 1; k < count; ++k)
            one = pool.ifThenElse(isTurn(at, k), state[2 * static_cast<std::size_t>(k) + half], one);
        return one;
    };
    Bits s0 = words.bits(chosen(turn, 0), chosen(turn, 1)), s1 = words.bits(chosen(next, 0), chosen(next, 1));
    s1 = words.exclusiveOr(s1, words.shifted(s1, 31));
    s1 = words.exclusiveOr(s1, words.shifted(s1, -11));
    s0 = words.exclusiveOr(s0, words.shifted(s0, -30));
    const Bits mixed = words.exclusiveOr(s0, s1);
    const Halves made = words.halves(mixed);
    RandomStep step{words.fraction(words.product(mixed, 1181783497276652981u)), {state.begin(), state.end()}};
    for (int k = 0; k < count; ++k) {
        const std::size_t at = 2 * static_cast<std::size_t>(k);
        step.state[at] = pool.ifThenElse(isTurn(next, k), words.withSign(made.low), state[at]);
        step.state[at + 1] = pool.ifThenElse(isTurn(next, k), words.withSign(made.high), state[at + 1]);
    }
    step.state[32] = next;
    return step;
}

std::int32_t hashOf(std::string_view text) {
    std::uint32_t hash = 0xaaaaaaaau;
    bool isEven = true;
    for (const char letter : text) {
        const std::uint32_t code = static_cast<unsigned char>(letter);
        hash ^= isEven ? (hash << 7) ^ (code * (hash >> 3)) : ~((hash << 11) + (code ^ (hash >> 5)));
        isEven = !isEven;
    }
    return std::bit_cast<std::int32_t>(hash);
}

}  // namespace analogon
