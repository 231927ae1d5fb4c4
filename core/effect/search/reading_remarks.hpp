#pragma once

#include <vector>

#include "core/effect/model/null_model.hpp"

namespace analogon {

class SearchContext;

/// Where the search has placed the jumps of the inputs or set their clocks, the errors are told with the recordings as
/// they are.
void reportAsRecorded(SearchContext& search, const NullModel& null, ModelState& state);

/// What people should know of what was allowed for in the recordings.
std::vector<Text> recordingRemarks(const SearchContext& search, const NullModel& null);

}  // namespace analogon
