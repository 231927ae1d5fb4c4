#pragma once

#include <optional>
#include <string_view>

namespace analogon::xlsx {

/// A number that was written as text; `decimal` is '.' or ','. The other of the two may stand between thousands.
std::optional<double> numberOf(std::string_view text, char decimal);

/// Days since 1899-12-30 of a date with a time that was written as text: 15.06.2024 10:30:00,5 or
/// 2024-06-15T10:30:00.5. Of a clock alone (10:30:00,5) its part of a day.
std::optional<double> dateOf(std::string_view text);

/// The usual ways to write that there is no value.
bool meansNothing(std::string_view text);

}  // namespace analogon::xlsx
