#pragma once

#include "core/structure/equations.hpp"

namespace analogon {

/// Sums with constant factors, such as balances of currents, that speak of states alone once what is no state is taken
/// out of them: three phases with chokes whose star point is grounded and that feed a floating circuit have two
/// independent currents, though no equation by itself says so. One equation of each such combination becomes what the
/// combination says.
void revealConstraints(EquationSystem& system);

}  // namespace analogon
