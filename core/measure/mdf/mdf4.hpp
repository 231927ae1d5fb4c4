#pragma once

#include "core/measure/mapped_file.hpp"
#include "core/measure/recording.hpp"

namespace analogon::mdf {

Outcome<MeasurementFile> openMdf4(std::shared_ptr<const MappedFile> file, const std::string& name);

}  // namespace analogon::mdf
