#pragma once

#include <vector>

#include "core/effect/model/null_model.hpp"

namespace analogon {

class SearchContext;

/// What people should know of what was allowed for in the recordings.
std::vector<Text> recordingRemarks(const SearchContext& search, const NullModel& null);

}  // namespace analogon
