#pragma once

#include "core/measure/mdf/mdf_file.hpp"
#include "core/measure/recording.hpp"

namespace analogon::mdf {

/// What a conversion makes of a channel: its kind, the names of its values, its unit where it has none of its own.
void describeByConversion(const StoredChannel& stored, RecordedChannel& channel, std::vector<Text>& notes);

/// Whether a channel can lie in its record as it says; a note where not.
bool fitsItsRecord(const StoredChannel& stored, const RecordGroup& group, const std::string& name,
                   std::vector<Text>& notes);

}  // namespace analogon::mdf
