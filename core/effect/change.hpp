#pragma once

#include <optional>
#include <string>

#include "core/effect/screen.hpp"

namespace analogon {

/// A fitted parameter that has another value from some moment of a recording on.
struct Change {
    std::string parameter;
    int experiment{};  // among the fitted ones
    double time{};     // [s]
    double before{};   // value
    double after{};
    double explained{};  // fall in the sum of squares, in units of the noise
    FitResult fit;       // with the change
};

/// For each parameter the change in mid run that explains most of the residual to first order, best first (Chow 1960:
/// the regression before and after a break). The trace of a change is taken as the parameter's slope from then on,
/// which leaves out how the states move over to it. `fit` is empty.
std::vector<Change> likelyChanges(const NullModel& null);

/// The best of the likeliest changes once each is fitted with all parameters of the model, its moment and its size.
/// Empty: nothing to gain.
std::optional<Change> bestChange(const NullModel& null, const FitOptions& options, const Progress& progress);

}  // namespace analogon
