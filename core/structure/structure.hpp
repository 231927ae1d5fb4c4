#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/flat/flat_model.hpp"

namespace analogon {

/// What stays symbolic: everything else that is constant in a simulation is folded to a number.
struct StructureOptions {
    /// Parameters that keep their name (those fitted, an experiment's start values, an effect's strength).
    /// A parameter that is exactly 0 and not named here is folded before the structure is analysed.
    std::vector<std::string> keep;
};

/// A block of the solution order. Explicit: unknown := expression. Implicit: residuals = 0 solved for unknowns.
struct SolutionBlock {
    std::vector<ExpressionId> unknowns;     // Variable or Derivative nodes
    std::vector<ExpressionId> expressions;  // explicit: one; implicit: one residual per unknown
    bool isExplicit{true};
    bool isLinear{};                        // implicit: residuals linear in the unknowns
    std::vector<ExpressionId> torn;         // implicit: the tearing variables (issue of size, may equal unknowns)
};

/// Equations in the order in which they are solved. States x are given; then blocks yield everything else.
struct Structure {
    std::shared_ptr<const FlatModel> model;
    std::shared_ptr<ExpressionPool> pool;   // own copy; ids of `model` stay valid in it

    std::vector<VariableId> states;         // x
    std::vector<ExpressionId> stateDerivatives;  // der(x_i) as an expression over the solved unknowns
    std::vector<VariableId> inputs;         // top-level inputs, declaration order
    std::vector<VariableId> outputs;        // top-level outputs, declaration order
    std::vector<VariableId> parameters;     // those of `keep`, in that order
    std::vector<SolutionBlock> parameterBlocks;  // depend on parameters only
    std::vector<SolutionBlock> blocks;      // in order
    std::vector<SolutionBlock> initialBlocks;    // at the initial time: yields all of x (and unknowns met on the way)
    std::vector<std::pair<VariableId, ExpressionId>> aliases;  // eliminated variable -> ± kept variable or constant

    int equationsBefore{}, equationsAfter{};  // flat and after alias elimination
    int indexReduction{};                     // how many equations were differentiated
    Diagnostics warnings;
};

/// Folding, alias elimination, matching, Pantelides with dummy derivatives, Tarjan blocks, symbolic solution of
/// linear scalar equations, tearing. Sources: Pantelides 1988; Mattsson & Söderlind 1993; Tarjan 1972;
/// Cellier & Kofman 2006, ch. 7.
Outcome<Structure> analyse(std::shared_ptr<const FlatModel> model, const StructureOptions& options = {});

std::string print(const Structure& structure);

}  // namespace analogon
