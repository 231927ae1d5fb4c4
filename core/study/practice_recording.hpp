#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "core/base/outcome.hpp"
#include "core/effect/catalogue/finding.hpp"
#include "core/measure/table.hpp"

/// A recording to practise on: what a model said of itself, sampled and with noise, as if a test bench had measured it.
namespace analogon {

struct PracticeOptions {
    double sampleTime{};                    // [s]
    std::uint64_t seed{1};                  // of the noise: the same seed gives the same recording
    std::map<std::string, double> noise{};  // standard deviation by output, in its unit; not named: none
};

/// Time and every output of a run, each on the raster start, start + sampleTime, … up to the end of the run; between
/// two points of the run on the straight line, at a jump the value behind it. Noise is white and normal, and that of
/// one output does not depend on which others there are. Faults: the sample time is not above 0, is longer than the
/// run, or gives more than ten million samples; a standard deviation below 0; the run has no values.
Outcome<Table> practiceRecording(const ExperimentState& run, const PracticeOptions& options);

}  // namespace analogon
