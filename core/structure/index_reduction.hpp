#pragma once

#include "core/structure/equations.hpp"
#include "core/structure/matching.hpp"

namespace analogon {

/// The system with differentiated equations added, and the choice of states.
struct ReducedSystem {
    EquationSystem system;
    std::vector<char> isState;             // by unknown: given to the program; all others are solved for
    std::vector<char> isSolvedAtStart;     // by unknown: best left to the constraints at the initial time
    std::vector<Equation> startEquations;  // the equations at the initial time, with every constraint among them
    int differentiated{};                  // equations added
};

/// Pantelides 1988 finds which equations must be differentiated; dummy derivatives (Mattsson & Söderlind 1993)
/// choose which of the differentiated variables stay states: those with stateSelect, a fixed or given start
/// value first. The choice is static; where none holds in every state, all stay states and the constraint is stabilised
/// (Baumgarte 1972). `redundant` (equations that said 0 = 0) serves the message when the
/// system turns out to be singular.
Outcome<ReducedSystem> reduceIndex(EquationSystem system, const std::vector<Equation>& redundant);

/// For each equation the unknowns in it.
Adjacency incidenceOf(const EquationSystem& system);

/// The message for equations and unknowns that cannot be paired.
Diagnostic singularSystem(const EquationSystem& system, const std::vector<Equation>& equations,
                          const std::vector<int>& surplusEquations, const std::vector<int>& undeterminedUnknowns,
                          const std::vector<Equation>& redundant);

}  // namespace analogon
