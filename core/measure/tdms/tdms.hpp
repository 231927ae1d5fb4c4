#pragma once

#include "core/measure/mapped_file.hpp"
#include "core/measure/recording.hpp"

namespace analogon {

bool isTdms(ByteView bytes);

/// National Instruments TDMS 1.0 and 2.0. Channels of one group that share length and time step are a group here.
Outcome<MeasurementFile> openTdms(std::shared_ptr<const MappedFile> file, const std::string& name);

}  // namespace analogon
