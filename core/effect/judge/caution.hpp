#pragma once

#include <vector>

#include "core/effect/block/screen.hpp"

/// What an engineer should know before trusting a fitted model. One sentence each.
namespace analogon {

/// Channels on which a validation recording leaves the range of the fitted ones by more than a tenth of it.
std::vector<Text> extrapolations(const EstimationTask& task);

/// Parameters that seem to have another value in one of several fitted recordings: where that explains, to first order,
/// most of what is above the noise (Chow 1960, with recordings instead of moments).
std::vector<Text> driftBetweenRecordings(const NullModel& null);

/// Channels of validation recordings that a model misses by clearly more than those of the fitted ones: by how much,
/// and whether an offset or a gain of that recording alone is what it looks like.
std::vector<Text> poorValidations(const ModelState& state);

/// The validation recordings of which the above has something to say, in their order.
std::vector<std::string> missedRecordings(const ModelState& state);

/// Outputs of the recordings with a role that begin elsewhere than the model does, by far more than what it leaves in
/// the fitted ones.
std::vector<Text> wrongStarts(const ModelState& state, Role role);

/// Outputs of the fitted recordings that read exactly the same for long, and hardly ever elsewhere.
std::vector<Text> stuckReadings(const EstimationTask& task);

/// Dead times below one sample interval: how a channel is read between its samples may be all there is to them. Those
/// of many samples: they may stand in for a storage.
std::vector<Text> delaysInSamples(const EstimationTask& task, const std::vector<AddedEffect>& effects);

/// Whether any output of the fitted recordings takes more than one value, rounding aside.
bool anyOutputMoves(const EstimationTask& task);

/// Why what a model leaves cannot be judged: no output moves. Empty: one does. `state`: the model against the task.
Text nothingMoves(const EstimationTask& task, const ModelState& state);

/// Why what a model leaves cannot be judged: hardly more was measured than is fitted. Empty: it can.
Text tooFewSamples(const NullModel& null);

/// Parameters that the fit left at a bound.
std::vector<Text> boundHits(const FitResult& fit);

}  // namespace analogon
