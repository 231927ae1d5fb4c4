#pragma once

#include <optional>
#include <string>

#include "core/effect/null_model.hpp"

namespace analogon {

/// A parameter that is held, and the value at which it would explain as much as an effect does.
struct HeldInstead {
    std::string parameter, unit;
    double held{}, value{}, standardError{};
    bool leavesNoise{};
    double gain{};  // fall in the sum of squares against the effect's, in units of the variance that this leaves
};

/// A value that is known wrongly is answered by an effect that imitates its correction (a torque constant by a gain of
/// the speed sensor). `with`: the model with an effect, `without`: the same refitted without it. Of the parameters that
/// the model has for itself and that are not fitted: the one that, freed, leaves as little as the effect and stays
/// within a third of where it is held, or leaves clearly less; nothing where there is none.
std::optional<HeldInstead> heldInstead(const NullModel& without, const NullModel& with, const FitOptions& options,
                                       const Progress& progress);

}  // namespace analogon
