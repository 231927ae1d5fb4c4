#pragma once

#include "core/effect/thresholds.hpp"
#include "core/fit/estimation_task.hpp"

namespace analogon {

using threshold::screen::mostSearchedSamples;

/// The task with long recordings made shorter for a search: every `factor` neighbouring samples of the fitted
/// recordings become their mean (time, inputs, outputs, spare channels; what was not measured is left out of it), so
/// that the noise falls and nothing is aliased. The first sample stays, since the simulation starts there; those behind
/// it that are nearer to it than to the middle of the first mean are left out, so that an even raster stays even where
/// the factor is odd.
EstimationTask thinned(const EstimationTask& task, int factor);

/// The odd factor that brings all fitted recordings together under a number of samples; 1: they are.
int thinningFor(const EstimationTask& task, long mostSamples);

}  // namespace analogon
