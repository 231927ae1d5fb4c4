#pragma once

#include "core/effect/catalogue/finding.hpp"
#include "core/effect/model/variant.hpp"
#include "core/flat/flat_model.hpp"

namespace analogon {

/// How much of a state is worked out: traces and errors, or also what a report says of them (how far the parameters
/// leave the outputs uncertain, what switches), which takes several simulations more.
enum class Detail { Errors, Report };

/// Holds a variant at its values against every recording; recordings with Role::Validate are simulated here and
/// nowhere else. Recordings run side by side on up to `threads` threads.
Outcome<ModelState> stateOf(const Variant& variant, const FitResult& fit, const SimulationOptions& simulation,
                            const Progress& progress, Detail detail = Detail::Report, int threads = 1);

/// The values of a fit without any simulation.
Outcome<ModelState> valuesAlone(const Variant& variant, const FitResult& fit);

/// The equations of a model with its values written in.
Outcome<FlatModel> flattened(const EstimationTask& task, const std::string& textWithValues);

/// Adds what an effect holds or computes beside the values known of it (the temperature of the surroundings, the limit
/// behind a reciprocal), without a standard error; not what is off, at 0.
void addOtherParameters(const FlatModel& model, const PlacedEffect& placed, std::vector<EffectValue>& values);

/// Whether a residual has more autocorrelation than white noise has by chance: standard errors then reckon with it.
bool isColoured(const ResidualSummary& residual);

/// Root mean square of error_percent over outputs, those left out that are 0 throughout.
double errorPercentOf(const std::vector<OutputState>& outputs);

/// Root mean square of error_percent over the experiments of a role; 0 when there is none.
double errorPercentOf(const ModelState& state, Role role);

/// The same over the experiments that were not fitted; -1 when there is none.
double validationErrorOf(const ModelState& state);

/// Both.
ErrorsWith errorsOf(const ModelState& state);

}  // namespace analogon
