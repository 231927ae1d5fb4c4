#pragma once

#include "core/structure/equations.hpp"
#include "core/structure/rewrite.hpp"

namespace analogon {

/// The equations in the order in which they are solved: matching, strong components, then each component as an
/// explicit expression, a linear block or a nonlinear block. `isKnown` (by unknown) are given from outside.
/// Faults: a singular structure, named by its equations and unknowns.
Outcome<std::vector<SolutionBlock>> orderSolution(EquationSystem& system, const std::vector<Equation>& equations,
                                                  const std::vector<char>& isKnown);

/// One component: as many equations as unknowns, none solvable alone.
Outcome<std::vector<SolutionBlock>> solveComponent(EquationSystem& system, DependenceCheck& depends,
                                                   const std::vector<Equation>& equations,
                                                   const std::vector<ExpressionId>& unknowns);

}  // namespace analogon
