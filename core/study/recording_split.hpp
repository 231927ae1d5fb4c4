#pragma once

#include <cstddef>
#include <vector>

namespace analogon {

/// The sample between 60 and 85 % of a recording at which all channels come nearest to their first values, if that is
/// within a twentieth of their range; else 0. A model that starts at rest can start there again.
std::size_t restingSample(const std::vector<std::vector<double>>& channels);

}  // namespace analogon
