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
    Variant variant;     // with the change, at the values of its fit
    FitResult fit;
};

/// The best of the changes that are likely to first order, once each is fitted with all parameters of the model, its
/// moment and its size. Empty: nothing to gain.
std::optional<Change> bestChange(const NullModel& null, FitOptions options, int threads, const Progress& progress);

/// What the likeliest change explains of the residual, to first order.
double explainedByChange(const NullModel& null);

}  // namespace analogon
