#include "core/simulate/plan_ladder.hpp"

#include <algorithm>
#include <map>

namespace analogon {

namespace {

constexpr int kMostExplicit = 32;  // substeps beyond which an explicit method is not worth it
constexpr int kMostImplicit = 64;

// Where the solution is not smooth (sticking, dead zones) the last digits cost too much: a tenfold error is taken
// when less would cost this many times as much. A hundred times the tolerance is still below any sensor noise.
constexpr double kWorthIt = 5.0;

/// Evaluations of the model a substep costs, in units of one with tangents.
double costOf(const GridPlan& plan) { return (plan.method == GridMethod::Esdirk ? 12.0 : 4.0) * plan.substeps; }

}  // namespace

std::vector<GridPlan> PlanLadder::plans() const {
    std::vector<GridPlan> plans;
    const auto add = [&](GridMethod method, int most) {
        if (options_.method != GridMethod::Auto && options_.method != method) return;
        if (options_.substeps > 0) {
            plans.push_back({method, options_.substeps, 0.0});
            return;
        }
        for (int s = 1; s <= most; s *= 2) plans.push_back({method, s, 0.0});
    };
    add(GridMethod::RungeKutta4, kMostExplicit);
    add(GridMethod::Esdirk, kMostImplicit);
    std::stable_sort(plans.begin(), plans.end(),
                     [](const GridPlan& a, const GridPlan& b) { return costOf(a) < costOf(b); });
    return plans;
}

void PlanLadder::passOver(const GridPlan& plan) { least_ = costOf(plan) * 1.01; }

GridPlan PlanLadder::cheapest(
    const std::function<std::optional<double>(const GridPlan&, const GridPlan&)>& difference) const {
    std::vector<GridPlan> judged;
    std::map<bool, double> lastDifference;
    for (GridPlan plan : plans()) {
        if (costOf(plan) < least_) continue;
        const bool isImplicit = plan.method == GridMethod::Esdirk;
        GridPlan finer = plan;
        finer.substeps *= 2;
        const auto known = std::find_if(judged.begin(), judged.end(), [&](const GridPlan& p) {
            return p.method == plan.method && p.substeps == plan.substeps && p.errorEstimate <= tolerance_;
        });
        if (known != judged.end()) return *known;
        const std::optional<double> moved = difference(plan, finer);
        if (!moved) continue;
        plan.errorEstimate = *moved;
        judged.push_back(plan);
        if (*moved <= tolerance_ || options_.substeps > 0) return plan;
        const auto before = lastDifference.find(isImplicit);
        const double fall = before == lastDifference.end() ? 2.0 : before->second / std::max(*moved, 1e-300);
        finer.errorEstimate = *moved / std::clamp(fall, 1.0, isImplicit ? 8.0 : 16.0);
        if (finer.errorEstimate <= tolerance_ && finer.substeps <= (isImplicit ? kMostImplicit : kMostExplicit)) {
            judged.push_back(finer);
        }
        lastDifference[isImplicit] = *moved;
        if (isEnough(judged, plan)) break;
    }
    return bestOf(judged);
}

/// The cheapest plan with an error up to `factor` times the tolerance; null: none.
const GridPlan* PlanLadder::cheapestWithin(const std::vector<GridPlan>& judged, double factor) const {
    const GridPlan* best{};
    for (const GridPlan& plan : judged) {
        if (plan.errorEstimate <= factor * tolerance_ && (!best || costOf(plan) < costOf(*best))) best = &plan;
    }
    return best;
}

bool PlanLadder::isEnough(const std::vector<GridPlan>& judged, const GridPlan& current) const {
    const GridPlan* known = cheapestWithin(judged, 100.0);
    return known && costOf(current) >= kWorthIt * costOf(*known) &&
           (!cheapestWithin(judged, 10.0) || costOf(current) >= kWorthIt * costOf(*cheapestWithin(judged, 10.0)));
}

GridPlan PlanLadder::bestOf(const std::vector<GridPlan>& judged) const {
    if (judged.empty()) return fallback();
    const GridPlan* best{};
    for (const double factor : {100.0, 10.0, 1.0}) {
        const GridPlan* better = cheapestWithin(judged, factor);
        if (better && (!best || costOf(*better) <= kWorthIt * costOf(*best))) best = better;
    }
    if (best) return *best;
    return *std::min_element(judged.begin(), judged.end(),
                             [](const GridPlan& a, const GridPlan& b) { return a.errorEstimate < b.errorEstimate; });
}

GridPlan PlanLadder::fallback() const {
    const bool isExplicit = options_.method == GridMethod::RungeKutta4;
    return {isExplicit ? GridMethod::RungeKutta4 : GridMethod::Esdirk, options_.substeps > 0 ? options_.substeps : 4,
            1.0};
}

}  // namespace analogon
