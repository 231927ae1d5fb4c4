#pragma once

#include <optional>
#include <vector>

#include "core/effect/catalogue/finding.hpp"
#include "core/effect/model/null_model.hpp"

/// How much better a model foretells what it was not fitted to: a disturbance cannot, a missing effect can
/// (cross-validation with long blocks left out, Burman, Chow and Nolan 1994).
namespace analogon {

/// What two models make of what was left out, whole recordings where there are several, else long parts of each; all
/// parameters follow the rest to first order about their optimum. Both beside the same noise.
Prediction predict(const NullModel& without, const FitResult& with);

/// The same, asked as the effect was chosen: where that was by its evidence beside a flow that nobody measured
/// (`chosen.besideFlow`), with that evidence of these models, of which one has `more` parameters.
Prediction predictAsChosen(const Prediction& chosen, const NullModel& without, const NullModel& with, int more,
                           const SimulationOptions& simulation, const Progress& progress);

/// The same with each model fitted anew without every part, from its optimum. Nothing where one cannot be.
std::optional<Prediction> predictByRefits(const NullModel& without, const NullModel& with, const FitOptions& options,
                                          const Progress& progress);

/// Whether a model predicts clearly better: by a good part of the error of what was left out, and in most of the parts;
/// where these are whole recordings, by a good part in each of them. Where it was chosen by its evidence beside a flow
/// that nobody measured, whether that is clear and it predicts better at all.
bool isClearlyBetter(const Prediction& prediction);

/// Rows of a residual that are left out together, by part.
std::vector<std::vector<Eigen::Index>> partsLeftOut(const std::vector<ResidualChannel>& channels);

}  // namespace analogon
