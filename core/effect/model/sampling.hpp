#pragma once

#include "core/fit/estimation_task.hpp"

namespace analogon {

/// Median time between samples of the fitted recordings [s]; 0: there are none.
double samplingInterval(const EstimationTask& task);

/// How many samples the fitted recordings have together.
std::size_t fittedSamples(const EstimationTask& task);

}  // namespace analogon
