#pragma once

#include <QString>
#include <optional>

#include "core/fit/problem.hpp"

namespace analogon::ui {

/// "3.2 ± 0.1"
QString priorText(const NormalPrior& prior, int digits);

/// What was typed for a mean and a standard deviation: "3.2 ± 0.1", "3,2 +- 0,1", "3.2 0.1". Nothing when it is not
/// two numbers, the second above 0.
std::optional<NormalPrior> readPrior(const QString& typed);

}  // namespace analogon::ui
