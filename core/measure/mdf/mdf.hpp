#pragma once

#include "core/measure/mapped_file.hpp"
#include "core/measure/recording.hpp"

namespace analogon {

/// Whether these are the first bytes of an ASAM MDF file.
bool isMdf(ByteView bytes);

/// ASAM MDF 2 to 4.2. What is damaged is left out and told; a fault where nothing can be read.
Outcome<MeasurementFile> openMdf(std::shared_ptr<const MappedFile> file, const std::string& name);

}  // namespace analogon
