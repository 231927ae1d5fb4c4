#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace analogon {

/// The units that test benches write most, as they write them, with the usual parts and multiples; the greater first.
const std::vector<std::string>& usualUnits();
bool isUsualUnit(std::string_view unit);

}  // namespace analogon
