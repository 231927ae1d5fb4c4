#pragma once

#include <memory>
#include <string>
#include <utility>
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

/// A block of the solution order.
/// Explicit: the one unknown := the one expression.
/// Implicit: all expressions = 0, solved together for the unknowns; these are already the tearing variables,
/// the variables torn out of the loop follow as explicit blocks.
struct SolutionBlock {
    std::vector<ExpressionId> unknowns;     // Variable or Derivative nodes
    std::vector<ExpressionId> expressions;  // explicit: one; implicit: one residual per unknown
    bool isExplicit{true};
    bool isLinear{};                         // implicit: residuals linear in the unknowns
    std::vector<ExpressionId> torn;          // implicit: all unknowns of the loop, torn ones included
    std::vector<ExpressionId> jacobian;      // implicit: d residual_i / d unknown_j at [i * n + j]
    std::vector<ExpressionId> constantTerm;  // linear: residuals at unknowns = 0
};

/// Where an iteration starts, and how large the quantity is.
struct StartValue {
    ExpressionId node;   // a state, or an unknown of an implicit block
    ExpressionId value;  // over parameters only
    double nominal{1};
};

/// Equations in the order in which they are solved. States x are given; then blocks yield everything else.
struct Structure {
    std::shared_ptr<const FlatModel> model;  // with variables added at the end for derivatives that have no name
    std::shared_ptr<ExpressionPool> pool;    // own copy; ids of the analysed model stay valid in it

    std::vector<VariableId> states;              // x
    std::vector<ExpressionId> stateDerivatives;  // der(x_i) as an expression over the solved unknowns
    std::vector<VariableId> inputs;              // top-level inputs, declaration order
    std::vector<VariableId> outputs;             // top-level outputs, declaration order
    std::vector<VariableId> parameters;          // those of `keep`, in that order
    std::vector<double> parameterValues;         // the model's own values of these
    std::vector<SolutionBlock> parameterBlocks;  // depend on parameters only
    std::vector<SolutionBlock> blocks;           // in order
    std::vector<SolutionBlock> initialBlocks;    // at the initial time: yields all of x (and unknowns met on the way)
    std::vector<std::pair<VariableId, ExpressionId>> aliases;  // eliminated variable -> ± kept variable or constant
    std::vector<std::pair<VariableId, double>> folded;         // parameters and constants that became numbers
    std::vector<StartValue> starts;                            // of all states and of all unknowns of implicit blocks
    std::vector<ExpressionId> delays;                          // the Delay nodes in use, each once

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
