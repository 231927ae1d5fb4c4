#pragma once

#include <string_view>

namespace analogon {

/// Whether a name says time: t, time, Zeit, timestamp …
bool namesTime(std::string_view name);

}  // namespace analogon
