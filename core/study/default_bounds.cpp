#include "core/study/default_bounds.hpp"

#include <algorithm>
#include <cmath>

namespace analogon {

std::optional<DefaultBounds> defaultBounds(std::optional<double> least, std::optional<double> most, double value) {
    constexpr double reach = 1e3;
    if (!least || *least < 0 || !(value > 0) || !std::isfinite(value)) return std::nullopt;
    DefaultBounds bounds{std::max(*least, value / reach), value * reach};
    if (most) bounds.max = std::min(*most, bounds.max);
    return bounds;
}

}  // namespace analogon
