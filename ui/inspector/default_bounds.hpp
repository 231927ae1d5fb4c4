#pragma once

#include "core/study/study.hpp"
#include "ui/document/model_facts.hpp"

namespace analogon::ui {

/// A quantity that is declared not to be negative is searched over three decades on either side of the value it has,
/// where nobody has set a bound: then on a logarithmic scale, and never at 0, where the model may have no solution.
void giveDefaultBounds(StudyParameter& setting, const ParameterFact& fact, double value);

}  // namespace analogon::ui
