#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace analogon {

/// The known units that a text which is none may stand for, the likeliest first: "kPa" for "kpa", "MPa" and "mPa" for
/// "mpa"; empty: nobody can tell.
std::vector<std::string> unitsAlike(std::string_view unit);

}  // namespace analogon
