#pragma once

#include <optional>
#include <vector>

#include "core/measure/read_options.hpp"
#include "core/measure/text/dialect.hpp"

namespace analogon {

/// The rows between the preamble and the data, told apart.
struct HeaderRows {
    std::optional<SampleRow> names, units;
    std::vector<SampleRow> descriptions;
    std::vector<SampleRow> keys;                     // rows of a key and its values that stand among them
    std::vector<std::pair<CsvCell, CsvCell>> facts;  // names and values beside the table ("Increment" over 5e-4)
    std::size_t first{};                             // of the rows of the sample, the first that belongs to the header
};

HeaderRows findHeader(const SampledRows& sample, const ReadOptions& options);

/// Whether the channels stand in rows and not in columns: names with units in front of each of a few long rows of
/// numbers, and no header.
bool areChannelsInRows(const SampledRows& sample);

}  // namespace analogon
