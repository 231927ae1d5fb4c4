#pragma once

#include "core/base/outcome.hpp"
#include "core/measure/text/row_reader.hpp"

namespace analogon {

/// Once all rows are read: values beyond the range of an instrument become gaps, which is told, and columns without a
/// name or with the keys of the header, in which nothing stands, are dropped.
Diagnostics tidyColumns(RawTable& raw);

}  // namespace analogon
