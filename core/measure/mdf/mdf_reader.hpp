#pragma once

#include "core/measure/mdf/mdf_file.hpp"
#include "core/measure/recording.hpp"

namespace analogon::mdf {

/// Reads values by the layout that was found in the file.
std::shared_ptr<const RecordingReader> makeReader(StoredFile file, std::string name);

}  // namespace analogon::mdf
