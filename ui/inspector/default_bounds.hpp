#pragma once

#include "core/study/study.hpp"
#include "ui/document/model_facts.hpp"

namespace analogon::ui {

/// What a fit would take where nobody has set a bound (defaultBounds), so that it is seen and can be changed.
void giveDefaultBounds(StudyParameter& setting, const ParameterFact& fact, double value);

}  // namespace analogon::ui
