#pragma once

#include <string>

#include "core/library/measured_signals.hpp"
#include "core/study/study.hpp"

namespace analogon {

/// What the recordings of a study are mapped to, as what is known of its model's class.
MeasuredSignals mappedSignals(const Study& study, const std::string& className);

}  // namespace analogon
