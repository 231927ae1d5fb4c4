#pragma once

#include <string>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/measure/question.hpp"
#include "core/measure/read_options.hpp"
#include "core/measure/text/row_reader.hpp"

/// Dates and clocks of a table become numbers.
namespace analogon {

/// Joins a date with the clock beside it, adds a column of milliseconds to it, and replaces each column of stamps by
/// seconds: since the first one, or as they stand where they count from a start. What can be read in two ways that
/// differ is a fault that names both, and asked. Told is the start of the recording by its stamps, as ISO 8601; empty:
/// the file does not tell it, or in two ways.
Outcome<std::string> makeSeconds(RawTable& raw, const ReadOptions& options, Questions& asked);

}  // namespace analogon
