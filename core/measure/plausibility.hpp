#pragma once

#include <string>
#include <vector>

#include "core/base/diagnostic.hpp"
#include "core/measure/table.hpp"

namespace analogon {

/// What the numbers of columns that are used cannot well be, each told with its rows and taken no further: temperatures
/// below absolute zero, an angle that starts anew after each turn, a column that stands still while others move, single
/// values far beyond all others. Warnings.
Diagnostics implausibilities(const Table& table, const std::vector<const Column*>& used);

}  // namespace analogon
