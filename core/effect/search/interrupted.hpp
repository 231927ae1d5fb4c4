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

/// What a search that was stopped reports: the best model that was whole, since what came after it may be half a refit;
/// else the model as given. It had no time to say what is left. `first`: the first fit, as far as it came.
Outcome<Finding> foundSoFar(SearchContext& search, const NullModel& first);

}  // namespace analogon
