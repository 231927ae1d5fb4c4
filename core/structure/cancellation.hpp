#pragma once

#include "core/structure/equations.hpp"

namespace analogon {

/// Equations whose derivatives cancel in a linear combination constrain the states, which no incidence tells:
/// C*(der(a) - der(b)) = i and C*(der(b) - der(a)) = j say i + j = 0. One equation of every such group is replaced by
/// the combination without derivatives, so that the structural passes see the constraint. Looked at are equations with
/// two and more highest derivatives, linear in them with coefficients of parameters alone.
void combineCancellingDerivatives(EquationSystem& system);

}  // namespace analogon
