/// Parameters that change, in mid run or with a recorded channel, beside what the search for effects comes to.
#include <algorithm>
#include <cmath>

#include "core/effect/judge/disturbance.hpp"
#include "core/effect/search/search.hpp"

namespace analogon {
namespace {

constexpr double changeShare = 0.5, leastChange = 100;
constexpr double leastPromised = 0.1;  // of what is above the noise, by first order, for a change to outdo effects
constexpr double leastAlone = 1000;  // evidence beyond one effect: what is wrong does not leave noise of that by chance

/// Evidence for a change against the effects that were found, beside independent samples.
template <class Change>
double gainOf(const NullModel& base, const NullModel& with, const Change& change) {
    const double left = sumInUnitsOf(base, with), leftByChange = change.fit.optimum.residuals.squaredNorm();
    const FitResult& nearer = left < leftByChange ? with.fit : change.fit;  // to the truth, as far as we know
    const double count = effectiveCount(base.channels, nearer.optimum.residuals);
    const double rows = static_cast<double>(nearer.optimum.residuals.size());
    const double variance =
        std::min(left, leftByChange) / std::max(1.0, rows - static_cast<double>(nearer.estimates.size()));
    const double gain = (left - leftByChange) / variance * count / rows;
    // the parameter that changes was chosen, too
    const double more = static_cast<double>(change.fit.estimates.size()) - with.parameterCount() + 1;
    return gain - more * std::log(count);
}

/// Whether a change accounts for most of what is above the noise, by a wide margin over chance, and is a better account
/// of it than the effects that were found: another structure, or all of them only to imitate it.
template <class Change>
bool isBetterThan(const NullModel& base, const NullModel& with, const Change& change,
                  double leastGain = equivalenceMargin) {
    return change.explained > changeShare * excess(base) && change.explained > leastChange &&
           gainOf(base, with, change) > leastGain;
}

/// What the best change explains to first order.
double promisedByChange(const NullModel& base) {
    return std::max(explainedByChange(base), explainedByDependence(base));
}

/// Whether it is a better account than a disturbance.
template <class Change>
bool isBorneOut(const NullModel& base, const Change& change, const SimulationOptions& simulation,
                const Progress& progress) {
    if (isNoise(base.channels, change.fit)) return true;
    const NullModel changed = base.with(change.variant, change.fit);
    const int freed = static_cast<int>(change.fit.estimates.size()) - base.parameterCount();
    return isBorneOut(besideDisturbance(base, simulation, progress), besideDisturbance(changed, simulation, progress),
                      changed.fit.optimum.residuals.size(), freed + 1);
}

}  // namespace

/// A parameter that changed in mid run is imitated by many slow effects; none of them is it.
void Search::seekChange(const NullModel& base) {
    if (soughtChange_ || isNoise(base) || progress_.stopRequested()) return;
    soughtChange_ = true;
    say("reconsider", phrase("parameters that change"), -1);
    change_ = bestChange(base, search_.fit, options_.threads, progress_);
    if (!progress_.stopRequested()) dependence_ = bestDependence(base, search_.fit, options_.threads, progress_);
    if (change_)
        trace("course", "change " + change_->parameter,
              {{"explained", change_->explained},
               {"time", change_->time},
               {"before", change_->before},
               {"after", change_->after}},
              "best");
    if (dependence_)
        trace("course", "dependence " + dependence_->parameter + " on " + dependence_->channel,
              {{"explained", dependence_->explained}, {"slope", dependence_->slope}}, "best");
}

/// Whether one change leaves noise alone and is a better account than these effects, by so much evidence.
bool Search::isChangeAll(const NullModel& base, const NullModel& with, double leastGain) {
    seekChange(base);
    const auto isAll = [&](const auto& change) {
        return change && isNoise(base.channels, change->fit) && isBetterThan(base, with, *change, leastGain);
    };
    return isAll(change_) || isAll(dependence_);
}

/// Whether one change leaves noise alone where the effect that the first round chose leaves far too much for it to be
/// half of a pair: none is added to it then.
bool Search::isChangeAlone(const NullModel& base, const Round& first) {
    if (!first.chosen || !(excess(base) > leastAlone)) return false;
    const Trial& winner = first.trials[*first.chosen];
    if (isNoise(base.channels, winner.fit) || !(promisedByChange(base) > changeShare * excess(base))) return false;
    return isChangeAll(base, base.with(winner.variant, winner.fit), leastAlone);
}

/// Keeps the better of the changes where it is a better account than the effects that were found.
void Search::settleChange(const NullModel& base, const NullModel& with) {
    // hardly anything outdoes effects that leave noise
    if (!soughtChange_ && isNoise(with) && !(promisedByChange(base) > leastPromised * excess(base))) return;
    seekChange(base);
    const auto settle = [&](auto& change) {
        if (!change) return;
        const bool isBetter = isBetterThan(base, with, *change);
        const bool isTaken = isBetter && isBorneOut(base, *change, search_.fit.simulation, progress_);
        trace("course", change->parameter, {{"explained", change->explained}, {"gain", gainOf(base, with, *change)}},
              isTaken    ? "accepted"
              : isBetter ? "no more than a disturbance"
                         : "no better than the effects");
        if (!isTaken) change.reset();
    };
    settle(change_);
    settle(dependence_);
    if (!change_ || !dependence_) return;
    if (change_->explained > dependence_->explained)
        dependence_.reset();
    else
        change_.reset();
}

}  // namespace analogon
