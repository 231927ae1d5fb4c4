#pragma once

#include "core/measure/mapped_file.hpp"
#include "core/measure/recording.hpp"

namespace analogon::mdf {

/// Formats 2 and 3.
Outcome<MeasurementFile> openMdf3(std::shared_ptr<const MappedFile> file, const std::string& name);

}  // namespace analogon::mdf
