#pragma once

#include "core/effect/model/null_model.hpp"
#include "core/effect/thresholds.hpp"

/// How much a fitted model is better than one without an effect, and the tests that this must pass.
namespace analogon {

using threshold::acceptance::leastHeldOut;

/// Decrease of chi-square in units of the variance that the best trial leaves, less k ln N_eff of its residual.
class EvidenceScale {
public:
    EvidenceScale(const NullModel& null, const FitResult& best);
    double of(double sumOfSquares, int freed) const;

private:
    double without_, variance_, logCount_;
};

/// What is asked of a winner at least.
struct AskedOfWinner {
    double evidence{}, heldOut{};
};

/// The tests a winner must pass (all in units of its own noise).
struct Acceptance {
    double explained{};  // decrease of chi-square under the winner's noise model
    double evidence{};   // the same less k ln N
    double effective{};  // decrease of chi-square over variance and correlation time, less k ln N_eff
    double heldOut{};    // H on blocks left out in turn
    double share{};      // decrease of chi-square over what stays unexplained (above the noise)
    bool isSignificant{}, holdsOut{}, isWorthwhile{};
    bool isAtEdges{};  // not significant for that alone, see happensAtEdges
    AskedOfWinner asked{};

    bool accepted() const { return isSignificant && holdsOut && isWorthwhile; }
};

/// Into how many blocks a record with so many independent samples is cut, to be left out in turn.
int heldOutBlocks(double independentSamples);

Acceptance examine(const NullModel& null, const FitResult& with, int freed, double threshold);

}  // namespace analogon
