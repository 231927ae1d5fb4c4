#pragma once

#include "core/effect/catalogue/finding.hpp"
#include "core/effect/model/null_model.hpp"

/// What a search has to tell that did not come to its end.
namespace analogon {

class SearchContext;

/// What a fit that was stopped came to: with its traces where they are simulated soon, else with its values alone.
Outcome<ModelState> stateSoFar(const NullModel& null, const SimulationOptions& simulation);

/// What a search reports that was stopped in its first fit.
Outcome<Finding> fittedSoFar(const NullModel& null, const SimulationOptions& simulation);

/// Hands on what there is to tell until now, whenever that is more than before (DiscoverOptions::keep).
void keepSoFar(SearchContext& search, const std::vector<CandidateResult>& candidates);

/// Fits the best node of a search that works on fewer samples to all of them, as the model as given was (`given`);
/// where it cannot be, or is stopped, the node stays.
void fitBestOnAll(SearchContext& search, const NullModel& given, const Progress& progress);

/// What a search that was stopped reports: the best model that was whole, since what came after it may be half a refit;
/// else, or where that is no better on all samples, the model as given. It had no time to say what is left. `first`:
/// the first fit, as far as it came.
Outcome<Finding> foundSoFar(SearchContext& search, const NullModel& first);

}  // namespace analogon
