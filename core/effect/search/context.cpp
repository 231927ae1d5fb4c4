#include "core/effect/search/context.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/effect/model/thin.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::paths;

namespace {

constexpr double sameOptimum = 1e-3;  // of the misfit, within which two fits are one

/// The options with limits in work alone: what is found depends on no clock, and on no other load of the machine.
DiscoverOptions limitedInWork(DiscoverOptions options) {
    SimulationOptions& simulation = options.fit.simulation;
    simulation.wallClockLimit = std::numeric_limits<double>::infinity();
    simulation.stepLimit = std::min(simulation.stepLimit, mostSteps);
    return options;
}

}  // namespace

bool SoughtFirst::isBeside(const NullModel& null) const {
    const Eigen::VectorXd& left = null.fit.optimum.residuals;
    if (residuals.size() == 0 || residuals.size() != left.size()) return false;
    const double along = residuals.dot(left), both = residuals.squaredNorm() * left.squaredNorm();
    return along > 0 && along * along > (1 - sameOptimum) * both;
}

void WorkLimit::add(double steps) {
    done += steps;
    if (most_ > 0 && done > most_) end_.request_stop();
}

void WorkLimit::check() {
    if (!(mostSimulated_ > 0 && simulated.done() > mostSimulated_)) return;
    isSpent_ = true;
    end_.request_stop();
}

double workAllowed(double patience, double fitWork) { return patience * std::max(leastPatience, mostOfAFit * fitWork); }

bool Stay::isLike(const Stay& other) const {
    return effects == other.effects && std::abs(misfit - other.misfit) < sameOptimum * misfit;
}

SearchContext::SearchContext(const EstimationTask& task, const DiscoverOptions& given, const Progress& outside)
    : options(limitedInWork(given)),
      work(given.mostWork, outside.stopToken()),
      progress(work.token(), [&outside](const Progress::Report& report) { outside.report(report); }),
      fit(options.fit),
      journal(given.trace) {
    readings.thinning = thinningFor(task, mostSearchedSamples);
    readings.full.task = task;
    readings.searched.task = thinned(task, readings.thinning);
}

Stay stayAt(const SearchContext& search, const NullModel& null, double misfit) {
    return {keysOf(null.variant.effects), misfit, search.journal.path};
}

}  // namespace analogon
