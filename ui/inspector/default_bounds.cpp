#include "ui/inspector/default_bounds.hpp"

#include <algorithm>
#include <cmath>

namespace analogon::ui {

void giveDefaultBounds(StudyParameter& setting, const ParameterFact& fact, double value) {
    constexpr double reach = 1e3;
    const bool isPositive = fact.min && *fact.min >= 0 && value > 0 && std::isfinite(value);
    if (!isPositive || setting.min || setting.max || setting.prior) return;
    setting.min = std::max(*fact.min, value / reach);
    setting.max = fact.max ? std::min(*fact.max, value * reach) : value * reach;
}

}  // namespace analogon::ui
