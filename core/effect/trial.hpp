#pragma once

#include "core/effect/screen.hpp"

namespace analogon {

/// A candidate refitted together with all parameters of the model.
struct Trial {
    Screened screened;
    Variant variant;  // with the effect's parameters freed, at the optimum
    FitResult fit;
    bool ok{};
    Text failure;
    double evidence{};  // fall in the sum of squares over the residual variance, less k ln N_eff (set by `rank`)

    double sumOfSquares() const { return fit.optimum.residuals.squaredNorm(); }
    int freed() const { return static_cast<int>(variant.effects.back().freed.size()); }
};

constexpr int trialIterations = 12;  // a trial shows what it is worth; the winner is fitted to convergence
FitOptions trialOptions(FitOptions options, int iterations);

/// Refits from the best probes (one start a distinct shape or secant, at most `starts`).
Trial refit(const NullModel& null, const Screened& screened, const FitOptions& options, int starts,
            const Progress& progress);

/// Goes on with the fit of a trial from where it stopped.
void proceed(const NullModel& null, Trial& trial, const FitOptions& options, const Progress& progress);

/// Sorts by evidence, best first; the noise level and N_eff are those of the residual of the best fit among them.
void rank(const NullModel& null, std::vector<Trial>& trials);

constexpr double leastHeldOut = 0.5;  // share of the fall that blocks must show which the fit did not see

/// The tests a winner must pass (all in units of its own noise).
struct Acceptance {
    double explained{};  // fall in the sum of squares under the winner's noise model
    double evidence{};   // the same less k ln N
    double effective{};  // fall in the sum of squares over variance and correlation time, less k ln N_eff
    double heldOut{};    // H on blocks left out in turn
    double share{};      // fall in the sum of squares over what stays unexplained (above the noise)
    bool isSignificant{}, holdsOut{}, isWorthwhile{};

    bool accepted() const { return isSignificant && holdsOut && isWorthwhile; }
};
Acceptance examine(const NullModel& null, const FitResult& with, int freed, double threshold);

}  // namespace analogon
