#pragma once

#include "core/structure/fold.hpp"

namespace analogon {

/// The system over representatives only, and who stands for whom.
struct AliasedSystem {
    EquationSystem system;
    std::vector<std::pair<VariableId, ExpressionId>> aliases;
    std::vector<Equation> redundant;  // equations that came to say 0 = 0
    Diagnostics warnings;
};

/// Removes equations x = ±y and x = const. der(x) takes part like a variable, and equality of two variables
/// makes their derivatives equal, so two rigidly joined inertias share phi, w and der(w) from here on without
/// any index reduction. Attributes of merged variables are merged; fixed start values that contradict each
/// other are a fault.
Outcome<AliasedSystem> eliminateAliases(FoldedModel folded);

}  // namespace analogon
