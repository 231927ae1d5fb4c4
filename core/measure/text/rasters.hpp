#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/measure/text/named_rows.hpp"
#include "core/measure/text/text_file.hpp"

namespace analogon {

/// The groups of a table: one, or one for each column of time that channels have as their own (timesOfChannels); of a
/// table whose rows are named, one for each channel. What is made of the stamps, and what is odd about them, is added
/// to `told`.
std::vector<TextGroup> groupsOf(RawTable raw, const std::optional<NamedRows>& named,
                                const std::map<std::string, std::string>& comments, const ReadOptions& options,
                                Diagnostics& told, Questions& asked);

}  // namespace analogon
