#pragma once

#include <optional>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/measure/question.hpp"
#include "core/measure/read_options.hpp"
#include "core/measure/table.hpp"
#include "core/measure/text/preamble.hpp"
#include "core/measure/text/row_reader.hpp"

/// Which column of a table is its time, and what is made of one that is written badly.
namespace analogon {

/// Never falls and ends above its beginning; what is missing is passed over.
bool rises(const std::vector<double>& values);

/// The column of rising values that is a time by its unit or its name: the plainest name of those that rise strictly.
std::optional<std::size_t> timeColumn(const Table& table, const std::vector<CellKind>& kinds);

/// Where a column that is a time by its name and its unit falls from row to row, the newest stands first: the rows are
/// turned around, and that is told.
Diagnostics putOldestFirst(RawTable& raw);

/// Rows that are only counted get a time where the preamble or "time_format" tells how they follow each other. The
/// column is put in front and is called "time". Nothing where the table has a time already. Where neither tells, it is
/// asked.
Diagnostics addCountedTime(RawTable& raw, const PreambleFacts& facts, const ReadOptions& options, Questions& asked);

/// Stamps that repeat because they have too few digits are laid on an even raster; single ones that repeat in a raster
/// that goes on evenly are spread over their gap. What can be a jump or a fault stays as it is.
Diagnostics mendRepeatedStamps(Table& table, std::size_t time);

/// A time without a unit gets the one that "time_format" tells.
void applyToldUnit(RawTable& raw, const ReadOptions& options);

/// A time without a unit gets the one that its name tells ("t_ms"); one whose numbers are those of a known count of
/// milliseconds, microseconds or nanoseconds since 1970 gets that unit; what may be seconds or days is a fault. All are
/// asked.
Diagnostics nameCountedUnit(Table& table, std::size_t time, const ReadOptions& options, Questions& asked);

/// What is odd about the course of the stamps: pauses.
Diagnostics oddStamps(const Table& table, std::size_t time);

}  // namespace analogon
