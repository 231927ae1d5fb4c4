#pragma once

#include "core/measure/mdf/mdf_file.hpp"
#include "core/measure/recording.hpp"

namespace analogon::mdf {

/// Settles how many records each group has: what the file says is held against the bytes that are there, and counted
/// where it cannot be right. `isUnfinished`: the recorder was stopped before it wrote the numbers.
void settleSamples(StoredFile& file, MeasurementFile& recording, bool isUnfinished);

}  // namespace analogon::mdf
