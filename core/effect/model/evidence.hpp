#pragma once

#include "core/effect/model/null_model.hpp"

/// How much a fitted model is better than one without an effect, and the tests that this must pass.
namespace analogon {

/// Fall in the sum of squares in units of the variance that the best trial leaves, less k ln N_eff of its residual.
class EvidenceScale {
public:
    EvidenceScale(const NullModel& null, const FitResult& best);
    double of(double sumOfSquares, int freed) const;

private:
    double without_, variance_, logCount_;
};

constexpr double leastHeldOut = 0.5;  // share of the fall that blocks must show which the fit did not see

/// The tests a winner must pass (all in units of its own noise).
struct Acceptance {
    double explained{};  // fall in the sum of squares under the winner's noise model
    double evidence{};   // the same less k ln N
    double effective{};  // fall in the sum of squares over variance and correlation time, less k ln N_eff
    double heldOut{};    // H on blocks left out in turn
    double share{};      // fall in the sum of squares over what stays unexplained (above the noise)
    bool isSignificant{}, holdsOut{}, isWorthwhile{};
    bool isAtEdges{};                             // not significant for that alone, see happensAtEdges
    double leastEvidence{}, leastHeldOutAsked{};  // for these

    bool accepted() const { return isSignificant && holdsOut && isWorthwhile; }
};
Acceptance examine(const NullModel& null, const FitResult& with, int freed, double threshold);

}  // namespace analogon
