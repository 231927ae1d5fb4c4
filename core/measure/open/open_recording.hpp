#pragma once

#include <filesystem>

#include "core/measure/read_options.hpp"
#include "core/measure/recording.hpp"

namespace analogon {

/// What a measurement file holds. The format is told by its content; what no binary format claims is read as text.
/// `options` tell how a text is written.
Outcome<MeasurementFile> openRecording(const std::filesystem::path& file, const ReadOptions& options = {});

/// Whether it is read as text.
Outcome<bool> isTextRecording(const std::filesystem::path& file);

}  // namespace analogon
