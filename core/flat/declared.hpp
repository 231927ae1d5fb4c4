#pragma once

#include <string_view>

#include "core/flat/flat_model.hpp"

namespace analogon {

/// What the declarations of a class tell of its variables (names, units, values, ranges), whatever is wrong with it
/// otherwise: without a single equation or connection, so it is no model to simulate. Components that cannot be made
/// are left out; empty where the class is not known.
FlatModel declared(const Library& library, std::string_view className);

}  // namespace analogon
