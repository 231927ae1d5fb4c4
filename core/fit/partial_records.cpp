#include "core/fit/partial_records.hpp"

#include <algorithm>
#include <cmath>

#include "core/fit/coordinates.hpp"
#include "core/fit/difference_slopes.hpp"
#include "core/fit/held_input.hpp"
#include "core/fit/misfit.hpp"
#include "core/fit/uncertainty.hpp"

namespace analogon {
namespace {

using Eigen::Index;

constexpr Index tenth = 10;
constexpr Index fewest = 1000;  // samples of a record that stands for a longer one
constexpr Index shortest = 10 * fewest;

Index sampleCount(const FitExperiment& experiment) { return static_cast<Index>(experiment.inputs.time.size()); }

/// The first `count` of every `stride`-th sample.
FitExperiment taken(const FitExperiment& from, Index count, Index stride) {
    FitExperiment to;
    to.name = from.name;
    to.system = from.system;
    to.weights = from.weights;
    to.parameters = from.parameters;
    to.isInterpreted = from.isInterpreted;
    to.inputs.held = from.inputs.held;
    to.inputs.values.resize(from.inputs.values.rows(), count);
    to.measured.resize(from.measured.rows(), count);
    for (Index k = 0; k < count; ++k) {
        to.inputs.time.push_back(from.inputs.time[static_cast<std::size_t>(k * stride)]);
        if (to.inputs.values.rows() > 0) to.inputs.values.col(k) = from.inputs.values.col(k * stride);
        to.measured.col(k) = from.measured.col(k * stride);
    }
    for (const int i : from.inputs.heldInputs())
        if (stride > 1)
            to.inputs.values.row(i) = heldMeans(from.inputs.time, from.inputs.values.row(i), to.inputs.time);
    return to;
}

/// Each record shortened by the same factor, but not below the fewest samples.
FitProblem shortened(const FitProblem& problem, bool isThinned) {
    FitProblem part;
    part.parameters = problem.parameters;
    part.weightsAreNoise = problem.weightsAreNoise;
    part.scatter = problem.scatter;
    part.beforeSimulation = problem.beforeSimulation;
    for (const FitExperiment& experiment : problem.experiments) {
        const Index samples = sampleCount(experiment);
        const Index stride = isThinned ? std::clamp<Index>(samples / fewest, 1, tenth) : 1;
        const Index head = std::min(samples, std::max(samples / tenth, fewest));
        part.experiments.push_back(taken(experiment, isThinned ? (samples - 1) / stride + 1 : head, stride));
    }
    return part;
}

/// Whether each output that is fitted is measured in the part about as often as elsewhere.
bool isMeasuredAlike(const FitProblem& problem, const FitProblem& part) {
    for (std::size_t e = 0; e < part.experiments.size(); ++e) {
        const FitExperiment &all = problem.experiments[e], &some = part.experiments[e];
        const double share = static_cast<double>(sampleCount(some)) / static_cast<double>(sampleCount(all));
        for (Index o = 0; o < some.measured.rows(); ++o) {
            if (!all.isFitted(o)) continue;
            const auto expected = share * static_cast<double>(all.measuredCount(o));
            if (static_cast<double>(some.measuredCount(o)) < 0.5 * expected) return false;
        }
    }
    return true;
}

/// Whether the lines between the samples left (what is held after them) meet those left out, but for a few: steps are
/// drawn as short ramps, and nothing falls between them.
bool keepsInputs(const FitExperiment& all, const FitExperiment& thinned) {
    constexpr double tolerated = 0.1;  // root mean square, of the range
    const Index samples = sampleCount(all), stride = (samples - 1) / std::max<Index>(1, sampleCount(thinned) - 1);
    for (Index i = 0; i < all.inputs.values.rows(); ++i) {
        const auto u = all.inputs.values.row(i), left = thinned.inputs.values.row(i);
        const bool isHeld = all.inputs.isHeld(i);
        double squares = 0.0;
        for (Index j = 0; j + 1 < left.size(); ++j) {
            const double rise = isHeld ? 0.0 : (left[j + 1] - left[j]) / static_cast<double>(stride);
            for (Index k = isHeld ? 0 : 1; k < stride; ++k) {
                const double gap = u[j * stride + k] - left[j] - static_cast<double>(k) * rise;
                squares += gap * gap;
            }
        }
        const double range = u.maxCoeff() - u.minCoeff();
        if (std::sqrt(squares / static_cast<double>(samples)) > tolerated * range) return false;
    }
    return true;
}

std::vector<GridPlan> roughPlans(const FitProblem& problem, const Eigen::VectorXd& start, SimulationOptions options,
                                 const Progress& progress) {
    options.relativeTolerance *= farLooseness;
    std::vector<GridPlan> plans;
    for (std::size_t e = 0; e < problem.experiments.size(); ++e)
        plans.push_back(planFor(problem, static_cast<int>(e), start, options, progress));
    return plans;
}

bool asksForAll(const FitProblem& problem, const FitOptions& options) {
    const bool isPlain = options.method == FitMethod::LeastSquares && options.loss == RobustLoss::None &&
                         options.simulation.engine != Engine::Adaptive;
    const bool isLimited = options.simulation.evaluationLimit < SimulationOptions().evaluationLimit;
    return !options.beginsWithPart || !isPlain || isLimited || problem.hasPriors() || problem.hasClocks() ||
           maySwitch(problem);
}

}  // namespace

std::optional<PartialRecords> partOf(const FitProblem& problem, const Eigen::VectorXd& start, const FitOptions& options,
                                     const Progress& progress) {
    if (asksForAll(problem, options)) return std::nullopt;
    Index all = 0, some = 0;
    for (const FitExperiment& experiment : problem.experiments) {
        const Index samples = sampleCount(experiment);
        all += samples;
        some += std::min(samples, std::max(samples / tenth, fewest));
    }
    if (all < shortest || 5 * some > all) return std::nullopt;
    PartialRecords thinned{shortened(problem, true), true, {}};
    bool isEnough = isMeasuredAlike(problem, thinned.problem);
    for (std::size_t e = 0; isEnough && e < problem.experiments.size(); ++e)
        isEnough = keepsInputs(problem.experiments[e], thinned.problem.experiments[e]);
    if (isEnough) {
        thinned.plans = roughPlans(thinned.problem, start, options.simulation, progress);
        if (areSingleSteps(thinned.plans)) return thinned;
    }
    PartialRecords head{shortened(problem, false), false, {}};
    if (isMeasuredAlike(problem, head.problem)) return head;
    return std::nullopt;
}

std::vector<GridPlan> plansFromThinned(const FitProblem& problem, const std::vector<GridPlan>& thinned,
                                       const Eigen::VectorXd& values, const Progress& progress) {
    std::vector<GridPlan> plans;
    for (std::size_t e = 0; e < thinned.size(); ++e)
        plans.push_back(singleStepsFor(problem, static_cast<int>(e), values, thinned[e].errorEstimate, progress));
    return plans;
}

bool areSingleSteps(const std::vector<GridPlan>& plans) {
    return std::all_of(plans.begin(), plans.end(), [](const GridPlan& plan) {
        return plan.method == GridMethod::RungeKutta4 && !plan.steps && plan.substeps == 1;
    });
}

bool determinesAll(const FitProblem& part, const Eigen::VectorXd& values, const ReducedMisfit& there) {
    constexpr double most = 0.2;  // standard error, of the value
    const auto K = static_cast<Index>(part.parameters.size());
    const int freedom = part.residualCount() - static_cast<int>(K);
    if (!there.ok || freedom <= 0) return false;
    const Uncertainty found = uncertaintyOf(there.jacobian, 2.0 * there.cost() / freedom,
                                            std::vector<std::string>(static_cast<std::size_t>(K)));
    for (Index i = 0; i < K; ++i) {
        const FitParameter& p = part.parameters[static_cast<std::size_t>(i)];
        const double size = std::max(std::abs(values[i]), std::abs(p.start));
        if (!(found.standardErrors[i] <= most * size) || !(values[i] > p.min && values[i] < p.max)) return false;
    }
    return true;
}

bool tellTheSame(const FitProblem& problem, double cost, const FitProblem& part, double costOfPart) {
    constexpr double tolerated = 1.5;
    return cost / problem.residualCount() <= tolerated * costOfPart / part.residualCount();
}

}  // namespace analogon
