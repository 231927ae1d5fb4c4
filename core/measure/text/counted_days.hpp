#pragma once

#include "core/measure/text/row_reader.hpp"

namespace analogon {

/// Clocks of four fields ("1:10:30:05") are hours to hundredths or days to seconds: what one stamp of a column, its
/// header or "time_format" tells holds for all of them. A column that nothing is told of is a fault, and asked.
Diagnostics settleDays(RawTable& raw, const ReadOptions& options, Questions& asked);

}  // namespace analogon
