#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/measure/text/stamp.hpp"

namespace analogon {

/// What "time_format" tells where it is how the rows follow each other and no format of stamps: "0.001 s", "1 kHz".
/// In seconds.
std::optional<double> intervalOf(std::string_view timeFormat);

/// What "time_format" tells where it is the unit of a time that is written as numbers: "d", "ms".
std::optional<std::string> timeUnitOf(std::string_view timeFormat);

/// Neither of the two: how dates and clocks are written.
bool isStampFormat(std::string_view timeFormat);

/// A cell by the format that was told: the whole of it, or its date or clock alone where these stand in two columns.
/// By the usual ways to write them where none was told.
std::optional<Stamp> readStampBy(std::string_view text, const std::string& timeFormat);

/// Whether a cell is a stamp of the format that was told.
bool isOfTimeFormat(std::string_view text, const std::string& timeFormat);

}  // namespace analogon
