#include "core/study/default_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace analogon {

std::optional<DefaultBounds> defaultBounds(std::optional<double> least, std::optional<double> most, double value) {
    constexpr double reach = 1e3;
    if (!least || *least < 0 || !(value > 0) || !std::isfinite(value)) return std::nullopt;
    DefaultBounds bounds{std::max(*least, value / reach), value * reach};
    if (most) bounds.max = std::min(*most, bounds.max);
    return bounds;
}

Text defaultBoundsRemark(std::vector<std::string> names) {
    constexpr std::size_t shown = 8;
    const std::size_t count = names.size();
    names.resize(std::min(shown, count));
    Text which = count <= shown ? listed(names) : phrase("{} parameters, first {}", count, listed(names));
    return phrase(
        "no bounds are given for {}; what is positive is looked for within a factor of 1000 of its start value",
        std::move(which));
}

bool isDefaultBoundsRemark(const Text& text) { return text.pattern() == defaultBoundsRemark({""}).pattern(); }

}  // namespace analogon
