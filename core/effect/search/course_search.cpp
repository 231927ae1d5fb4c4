#include "core/effect/search/course_search.hpp"

#include <algorithm>
#include <cmath>

#include "core/effect/judge/disturbance.hpp"
#include "core/effect/judge/judgement.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using threshold::acceptance::farMore;
using threshold::judgement::farLess;

namespace {

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
    return change.explained > leastOfRest * excess(base) && change.explained > farMore &&
           gainOf(base, with, change) > leastGain;
}

/// What the best change explains to first order.
double promisedByCourse(const NullModel& base) {
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

void seekCourses(SearchContext& search, const NullModel& base) {
    if (search.courses.isSought || isNoise(base) || search.progress.stopRequested()) return;
    search.courses.isSought = true;
    search.say("reconsider", phrase("parameters that change"), -1);
    search.courses.change = bestChange(base, search.fit, search.options.threads, search.progress);
    if (!search.progress.stopRequested())
        search.courses.dependence = bestDependence(base, search.fit, search.options.threads, search.progress);
    if (search.courses.change)
        search.journal.add("course", "change " + search.courses.change->parameter,
                           {{"explained", search.courses.change->explained},
                            {"time", search.courses.change->time},
                            {"before", search.courses.change->before},
                            {"after", search.courses.change->after}},
                           "best");
    if (search.courses.dependence)
        search.journal.add(
            "course",
            "dependence " + search.courses.dependence->parameter + " on " + search.courses.dependence->channel,
            {{"explained", search.courses.dependence->explained}, {"slope", search.courses.dependence->slope}}, "best");
}

bool isCourseAll(SearchContext& search, const NullModel& base, const NullModel& with, double leastGain) {
    seekCourses(search, base);
    const auto isAll = [&](const auto& change) {
        return change && isNoise(base.channels, change->fit) && isBetterThan(base, with, *change, leastGain);
    };
    return isAll(search.courses.change) || isAll(search.courses.dependence);
}

bool isCourseAlone(SearchContext& search, const NullModel& base, const Round& first) {
    if (!first.chosen || !isBeyondDoubt(excess(base))) return false;
    const Trial& winner = first.trials[*first.chosen];
    if (isNoise(base.channels, winner.fit) || !(promisedByCourse(base) > leastOfRest * excess(base))) return false;
    return isCourseAll(search, base, base.with(winner.variant, winner.fit), beyondDoubt);
}

Text betterAccount(const Courses& courses) {
    return courses.change
               ? phrase("{} that changes in mid run is the better account", courses.change->parameter)
               : phrase("{} that moves with a recorded channel is the better account", courses.dependence->parameter);
}

void settleCourses(SearchContext& search, const NullModel& base, const NullModel& with) {
    // hardly anything outdoes effects that leave noise
    if (!search.courses.isSought && isNoise(with) && !(promisedByCourse(base) > farLess * excess(base))) return;
    seekCourses(search, base);
    const auto settle = [&](auto& change) {
        if (!change) return;
        const bool isBetter = isBetterThan(base, with, *change);
        const bool isTaken = isBetter && isBorneOut(base, *change, search.fit.simulation, search.progress);
        search.journal.add("course", change->parameter,
                           {{"explained", change->explained}, {"gain", gainOf(base, with, *change)}},
                           isTaken    ? "accepted"
                           : isBetter ? "no more than a disturbance"
                                      : "no better than the effects");
        if (!isTaken) change.reset();
    };
    settle(search.courses.change);
    settle(search.courses.dependence);
    if (!search.courses.change || !search.courses.dependence) return;
    if (search.courses.change->explained > search.courses.dependence->explained)
        search.courses.dependence.reset();
    else
        search.courses.change.reset();
}

}  // namespace analogon
