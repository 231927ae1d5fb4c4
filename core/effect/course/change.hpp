#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "core/base/range.hpp"
#include "core/effect/block/screen.hpp"

namespace analogon {

/// A fitted parameter that has another value from some moment of a recording on.
struct Change {
    std::string parameter;
    int experiment{};  // among the fitted ones
    double time{};     // [s]
    double before{};   // value
    double after{};
    double explained{};  // decrease of chi-square, in units of the noise
    Variant variant;     // with the change, at the values of its fit
    FitResult fit;
};

/// How far a parameter can step from its value: to the ends of its own range, and never to the other sign, nor to next
/// to nothing, where it has but one.
Range stepsOf(const std::vector<FitParameter>& parameters, const std::string& parameter, double value);

/// The best of the changes that are likely to first order, once each is fitted with all parameters of the model, its
/// moment and its size. Empty: nothing to gain.
std::optional<Change> bestChange(const NullModel& null, FitOptions options, int threads, const Progress& progress);

/// What the likeliest change explains of the residual, to first order.
double explainedByChange(const NullModel& null);

/// Errors [%] of a recording that was not fitted: nothing tells in which condition it was taken.
struct CheckOfChange {
    std::string experiment;
    double before{}, after{};  // with the one value throughout, with the other
    double alike{};            // where it changes at the same time of the recording

    double least() const { return std::min({before, after, alike}); }
};

/// Errors [%] of a model with a change.
struct ErrorsOfChange {
    double fitted{};
    std::vector<CheckOfChange> checks;
};

/// Holds a model with a change against recordings, those it was fitted to and those that only validate.
Outcome<ErrorsOfChange> errorsOf(const Change& change, const std::vector<Recording>& recordings,
                                 const SimulationOptions& simulation, const Progress& progress);

}  // namespace analogon
