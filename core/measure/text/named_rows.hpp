#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/measure/text/text_file.hpp"

namespace analogon {

/// A table that is long and not wide: each row has one value and tells which channel it belongs to ("time;name;value").
/// By the names of its columns, which stay where others are taken out.
struct NamedRows {
    std::string key, value;
    std::string units{};  // empty: no column tells them
};

/// By what the columns are called; none: the table is an ordinary one.
std::optional<NamedRows> findNamedRows(const RawTable& raw);

/// A group for each channel, over the column `time`. A channel whose unit changes is a fault.
Outcome<std::vector<TextGroup>> channelsOf(const RawTable& raw, const NamedRows& rows, std::size_t time);

/// Where several rows share each stamp and a column of words tells them apart, they are rows of several channels,
/// though no column is called so: a fault.
Diagnostics tellMixedRows(const RawTable& raw, std::size_t time);

}  // namespace analogon
