#pragma once

#include "core/measure/byte_view.hpp"
#include "core/measure/recording.hpp"

namespace analogon {

/// Whether these are the first bytes of an archive, as a workbook is one.
bool isZip(ByteView bytes);

/// XLSX: each sheet with numbers is a group, or several where it has several columns of time.
Outcome<MeasurementFile> openXlsx(const std::string& file);

}  // namespace analogon
