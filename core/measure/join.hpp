#pragma once

#include <span>
#include <vector>

/// Channels of several rasters beside each other on one. Stamps never fall; a value that is not finite was not
/// measured.
namespace analogon {

struct Trace {
    std::span<const double> stamps;
    std::span<const double> values;
};

/// How an input runs between its samples.
enum class Course { Linear, Held };

/// The stamps at which any of the channels was measured, in order, each once.
std::vector<double> unitedStamps(std::span<const Trace> traces);

/// An input at the stamps, its gaps bridged. Where a stamp repeats (a jump), the value behind the jump. NaN before its
/// first sample, and behind its last one unless it is held: nothing is extrapolated.
std::vector<double> courseAt(const Trace& input, std::span<const double> stamps, Course course);

}  // namespace analogon
