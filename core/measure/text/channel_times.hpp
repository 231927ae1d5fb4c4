#pragma once

#include <optional>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/measure/question.hpp"
#include "core/measure/read_options.hpp"
#include "core/measure/text/row_reader.hpp"

/// A table with several columns of time: two loggers, or two rates, beside each other in one file.
namespace analogon {

/// The first of several columns that are times only by standing in front of a channel each: "t1", "a", "t2", "b"
/// without units, each with even steps. None: the table has no two of them.
std::optional<std::size_t> firstOfPairedTimes(const Table& table, const std::vector<CellKind>& kinds);

/// Columns over one time: all channels that have it, with the time itself, in the order of the file.
struct ChannelTime {
    std::size_t time{};
    std::vector<std::size_t> columns;
};

/// The times of the channels, that of `first` in front; one where all channels have the same. As was told, else as the
/// layout says; where a row may be one moment as well, the other reading is asked.
std::vector<ChannelTime> timesOfChannels(const RawTable& raw, std::size_t first, const ReadOptions& options,
                                         Diagnostics& told, Questions& asked);

}  // namespace analogon
