#pragma once

#include "core/measure/recording.hpp"
#include "core/measure/table.hpp"

namespace analogon {

/// A table as a recording of one group. Its master is the first column of rising values that is a time by its unit or
/// its name.
MeasurementFile recordingOf(Table table, std::string format);

/// Whether a name says time: t, time, Zeit, timestamp …
bool namesTime(std::string_view name);

}  // namespace analogon
