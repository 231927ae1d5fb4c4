#include "ui/inspector/default_bounds.hpp"

#include "core/study/default_bounds.hpp"

namespace analogon::ui {

void giveDefaultBounds(StudyParameter& setting, const ParameterFact& fact, double value) {
    if (setting.min || setting.max || setting.prior) return;
    if (const std::optional<DefaultBounds> bounds = defaultBounds(fact.min, fact.max, value)) {
        setting.min = bounds->min;
        setting.max = bounds->max;
    }
}

}  // namespace analogon::ui
