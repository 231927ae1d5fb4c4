#pragma once

#include <string>
#include <string_view>

#include "core/base/limits.hpp"
#include "core/base/visible.hpp"

namespace analogon {

/// A name or a cell of a file as a message tells it.
inline std::string cited(std::string_view text) { return shortened(text, limits::quotedBytes); }

}  // namespace analogon
