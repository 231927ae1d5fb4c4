#pragma once

#include "core/structure/index_reduction.hpp"
#include "core/structure/solution_order.hpp"

namespace analogon {

/// The blocks that yield all states at the initial time, and nothing beyond what those need. Conditions are
/// the model's equations, its initial equations, fixed start values, and then as many other start values as
/// are needed (given ones first, 0 where none is given). A condition that the others already decide is not
/// used, with a warning.
Outcome<std::vector<SolutionBlock>> orderInitialisation(ReducedSystem& reduced, Diagnostics& warnings);

}  // namespace analogon
