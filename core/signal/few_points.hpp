#pragma once

#include <span>
#include <vector>

namespace analogon {

/// The samples whose straight lines come nearest to all of them: the first, the last, and one after the other the one
/// that is farthest from the line over it, until none is farther than `share` of the range of the values, or there are
/// `most` (Ramer, Douglas and Peucker, with the farthest first). Samples without a value, or whose time does not rise,
/// are left out.
std::vector<std::size_t> fewPoints(std::span<const double> time, std::span<const double> values, std::size_t most,
                                   double share);

}  // namespace analogon
