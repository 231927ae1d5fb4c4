#pragma once

#include <filesystem>

#include "core/measure/recording.hpp"

namespace analogon {

/// What a measurement file holds. The format is told by its content; what no binary format claims is read as text.
Outcome<MeasurementFile> openRecording(const std::filesystem::path& file);

}  // namespace analogon
