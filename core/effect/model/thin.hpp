#pragma once

#include "core/effect/thresholds.hpp"
#include "core/fit/estimation_task.hpp"

namespace analogon {

using threshold::screen::mostSearchedSamples;

/// What a search works on of long recordings.
struct Thinning {
    int factor{1};       // neighbouring samples of which the mean is taken, odd
    bool isFirstPart{};  // where means of more would blur what is fast: the first part of each recording

    bool isWhole() const { return factor < 2 && !isFirstPart; }
};

/// The odd factor that brings all fitted recordings together under a number of samples; 1: they are.
Thinning thinningFor(const EstimationTask& task, long mostSamples);

/// The same number of samples of means of a third as many, of the first part of each recording.
Thinning finer(const Thinning& thinning);

/// The task with its fitted recordings made shorter: every `factor` neighbouring samples become their mean (time,
/// inputs, outputs, spare channels; what was not measured is left out of it), so that the noise falls and nothing is
/// aliased. The first sample stays, since the simulation starts there; those behind it that are nearer to it than to
/// the middle of the first mean are left out, so that an even raster stays even where the factor is odd. Of first parts
/// all together are `mostSamples`, each as large a part of its recording.
EstimationTask thinned(const EstimationTask& task, const Thinning& thinning, long mostSamples = mostSearchedSamples);

}  // namespace analogon
