#pragma once

#include <optional>
#include <string>

#include "core/effect/block/screen.hpp"

namespace analogon {

/// A fitted parameter that moves with a recorded channel which the model does not use:
/// value + slope * (channel - middle) / range.
struct ChannelDependence {
    std::string parameter, channel;
    double value{}, slope{};
    double middle{}, range{};  // of the channel over the fitted recordings, in its own unit
    double explained{};        // decrease of chi-square, in units of the noise
    Variant variant;           // with the dependence, at the values of its fit
    FitResult fit;
};

/// The best of the dependences that are likely to first order, once each is fitted with all parameters of the model.
/// Empty: no unused channel, or nothing to gain.
std::optional<ChannelDependence> bestDependence(const NullModel& null, FitOptions options, int threads,
                                                const Progress& progress);

/// What the likeliest dependence explains of the residual, to first order.
double explainedByDependence(const NullModel& null);

}  // namespace analogon
