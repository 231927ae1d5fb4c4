#pragma once

#include <string>
#include <vector>

#include "core/effect/catalogue/finding.hpp"
#include "core/effect/model/null_model.hpp"

namespace analogon {

/// A parameter that is held, and the value at which it would explain as much as an effect does.
struct HeldInstead {
    std::string parameter, unit;
    double held{}, value{}, standardError{};
    bool byBound{};  // it is fitted, and rests at a bound of its own
    bool leavesNoise{};
    double gain{};        // decrease of chi-square against the effect's, in units of the variance that this leaves
    double explained{};   // the same against neither
    ErrorsWith errors{};  // with this value instead

    /// "core.C = 302 J/K"
    Text text() const;
};

/// A value that is known wrongly is answered by an effect that imitates its correction (a torque constant by a gain of
/// the speed sensor). `with`: the model with an effect, `without`: the same refitted without it. Of the parameters that
/// the model has for itself and that are not fitted, or rest at a bound: those that, freed, leave as little as the
/// effect and stay within a factor of three of where they are held, or leave clearly less; what leaves least first.
std::vector<HeldInstead> heldInstead(const NullModel& without, const NullModel& with, const FitOptions& options,
                                     const Progress& progress);

}  // namespace analogon
