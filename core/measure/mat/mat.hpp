#pragma once

#include "core/measure/byte_view.hpp"
#include "core/measure/recording.hpp"

namespace analogon {

bool isMat(ByteView bytes);

/// MATLAB levels 4, 5 (to 7) and 7.3: vectors, matrices by columns, structures with a time of their own, Simulink's
/// structure with time.
Outcome<MeasurementFile> openMat(ByteView bytes, const std::string& file);

}  // namespace analogon
