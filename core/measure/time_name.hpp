#pragma once

#include <string_view>

namespace analogon {

/// Whether a name says time: t (not T), time, Zeit, timestamp, t_ms …
bool namesTime(std::string_view name);

}  // namespace analogon
