#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/flat/flat_model.hpp"

namespace analogon {

/// As flatten(library, className), but that ordinates of tables which depend on a parameter named in `free` are no
/// numbers: their tables are sums over them, and the parameter may take another value without a new flatten().
/// Abscissas, and surfaces by Akima's method, are numbers all the same.
Outcome<FlatModel> flatten(const Library& library, std::string_view className, const std::vector<std::string>& free);

}  // namespace analogon
