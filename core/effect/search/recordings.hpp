#pragma once

#include <optional>
#include <string>

#include "core/effect/model/evidence.hpp"
#include "core/effect/search/round.hpp"

/// What lies in the recordings and not in the component: start values that were told wrongly look like an offset, a lag
/// or a dead zone, the noise of a recorded input like a limit or a play that cuts it off.
namespace analogon {

class SearchContext;

/// A fit that allows for something wrong with a recording, and what it explains.
struct Allowed {
    FitResult fit;
    Acceptance gain;
};

/// Leaves out, in all that the search fits from here on, the samples that are faults of the measurement by what a fit
/// on every sample leaves; true: there are such.
bool leaveOutFaults(SearchContext& search, const NullModel& fitted);

/// The fit of a model that allows for something wrong with a recording, and what it explains.
std::optional<Allowed> allowed(const SearchContext& search, const NullModel& null, const Variant& variant, int freed,
                               double threshold);

/// Allows for what is wrong with a recording, where that explains more than what this round has chosen. True when it
/// did: the round is to be repeated beside it.
bool allowForRecordings(SearchContext& search, NullModel& null, const Round& round);

}  // namespace analogon
