#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/structure/equations.hpp"

namespace analogon {

/// By row: the entries of a column that are not 0.
using SparseColumn = std::map<int, double>;

/// The first columns, in their order, none of which is a combination of those before it, `rank` of them; nothing where
/// there are not so many.
std::optional<std::vector<std::size_t>> independentColumns(const std::vector<SparseColumn>& columns, std::size_t rank);

/// Value at the start values of the model, parameters at their own; for ranking only.
double startValueOf(const EquationSystem& system, ExpressionId expression);

/// Value at parameters as they are, and where every unknown has a value of its own: what is zero there is zero
/// everywhere, but for what parameters make of it.
double genericValueOf(const EquationSystem& system, ExpressionId expression);

}  // namespace analogon
