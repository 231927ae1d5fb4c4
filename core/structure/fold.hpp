#pragma once

#include "core/structure/equations.hpp"

namespace analogon {

/// The equations of a model in which every parameter is a number, a kept name, or an entry of parameterBlocks.
struct FoldedModel {
    EquationSystem system;             // unknowns not filled yet
    std::vector<ExpressionId> starts;  // by variable: start value over kept parameters; invalid: not given
    std::vector<VariableId> parameters;
    std::vector<double> parameterValues;
    std::vector<SolutionBlock> parameterBlocks;
    std::vector<std::pair<VariableId, double>> folded;
    Diagnostics warnings;
};

/// Replaces constants and every parameter that is not kept by its value. A parameter that depends on a kept one
/// stays a name and gets a block. Faults: unknown names in `keep`, parameters without value, cyclic bindings.
Outcome<FoldedModel> fold(const FlatModel& model, const StructureOptions& options);

}  // namespace analogon
