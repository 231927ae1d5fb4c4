#pragma once

#include <optional>

#include "core/structure/equations.hpp"
#include "core/structure/rewrite.hpp"

namespace analogon {

/// Solves residual = 0 for z in closed form where it is b y + a y abs(y) = g with y affine in z, a and b of the same
/// sign whatever the parameters are within their bounds, and all of them free of z: the load that grows with the square
/// of the speed, the pressure drop of a turbulent flow. There is one real solution then,
///   y = 2 g / (b + sqrt(b^2 + 4 a abs(g))),
/// free of cancellation (Press et al., Numerical Recipes, section 5.6). Where b and g vanish it is 0, with a slope that
/// counts as 0. Nothing: it is of another kind.
std::optional<ExpressionId> quadraticSolution(const EquationSystem& system, DependenceCheck& depends,
                                              ExpressionId residual, ExpressionId z);

}  // namespace analogon
