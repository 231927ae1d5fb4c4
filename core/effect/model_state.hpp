#pragma once

#include "core/effect/variant.hpp"

namespace analogon {

/// How much of a state is worked out: traces and errors, or also what a report says of them (how far the parameters
/// leave the outputs uncertain, what switches), which takes several simulations more.
enum class Detail { Errors, Report };

/// Holds a variant at its values against every recording; recordings with Role::Validate are simulated here and
/// nowhere else.
Outcome<ModelState> stateOf(const Variant& variant, const FitResult& fit, const SimulationOptions& simulation,
                            const Progress& progress, Detail detail = Detail::Report);

/// Root mean square of error_percent over the experiments of a role; 0 when there is none.
double errorPercentOf(const ModelState& state, Role role);

}  // namespace analogon
