#pragma once

#include <optional>
#include <string>

#include "core/effect/screen.hpp"

namespace analogon {

/// A fitted parameter that has another value from some moment of a recording on.
struct Change {
    std::string parameter;
    int experiment{};    // among the fitted ones
    double time{};       // [s]
    double before{};     // value
    double after{};      // to first order
    double explained{};  // fall in the sum of squares, in units of the noise
};

/// The change of one parameter in mid run that explains most of the residual (Chow 1960: the regression before and
/// after a break). The trace of a change is taken as the parameter's slope from then on, which leaves out how the
/// states move over to it: good where they do so fast against the recording. Empty: nothing to gain.
std::optional<Change> strongestChange(const NullModel& null);

}  // namespace analogon
