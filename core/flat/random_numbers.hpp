#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/flat/expression.hpp"

namespace analogon {

/// One step of a generator of pseudo-random numbers.
struct RandomStep {
    ExpressionId number;              // in (0, 1]
    std::vector<ExpressionId> state;  // that the next step begins with
};

/// The generators xorshift64*, xorshift128+ and xorshift1024* (Vigna 2016, ACM Trans. Math. Softw. 42(4):30; 2017,
/// J. Comput. Appl. Math. 315:175-181), written in the operations of the pool, so that they run wherever a model does.
/// The state holds Integers of 32 bits with sign, two for each word of 64 bits, the lower half first: 2, 4 and 32 of
/// them; the last also needs the number of the word whose turn it is, the 33rd. A number is the last word, read as
/// signed, times 2^-64 plus 1/2 (Doornik 2007).
RandomStep xorshift64star(ExpressionPool& pool, std::span<const ExpressionId> state);
RandomStep xorshift128plus(ExpressionPool& pool, std::span<const ExpressionId> state);
RandomStep xorshift1024star(ExpressionPool& pool, std::span<const ExpressionId> state);

/// The hash of a text by Partow (2002), begun with 0xaaaaaaaa: that of Modelica.Utilities.Strings.hashString.
std::int32_t hashOf(std::string_view text);

}  // namespace analogon
