#include "core/fit/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "core/base/guard.hpp"
#include "core/base/limits.hpp"
#include "core/base/number_text.hpp"
#include "core/base/parallel.hpp"
#include "core/base/stop.hpp"
#include "core/base/stopwatch.hpp"
#include "core/base/unit.hpp"
#include "core/fit/difference_slopes.hpp"
#include "core/fit/failure_words.hpp"
#include "core/fit/kink.hpp"
#include "core/fit/misfit.hpp"
#include "core/fit/optimum_uncertainty.hpp"
#include "core/fit/partial_records.hpp"
#include "core/fit/starts.hpp"
#include "core/fit/uncertainty.hpp"

namespace analogon {

namespace {

constexpr int mostFailures = 20;  // in a row, at a point that could be simulated before

/// One descent, from one start.
struct Descent {
    Minimum minimum;
    double startCost{};
    std::vector<GridPlan> plans;
    Linearisation optimum;  // ok when it is known already
    ReducedMisfit reduced;  // at the optimum; not ok: not known
    int simulations{}, failedSimulations{};
    double lossScale{1};
    double scatter{1};
    bool takesDifferences{};
    Eigen::VectorXd startSlopes;              // how much the residuals moved with each parameter at the start
    int partIterations{}, partSimulations{};  // on parts of the records
};

/// A descent goes on in rounds: the scatter of the residuals and the integration steps are judged where it starts, and
/// again where it arrives. Least squares goes most of the way with coarse steps (what they get wrong is far less than
/// what is to be fitted there); the last part, and the simplex, take steps as fine as the options ask for.
class Rounds {
public:
    /// `known`: plans to begin with; empty: they are made.
    Rounds(Misfit& misfit, const FitOptions& options, const Eigen::VectorXd& start, bool isNear,
           std::vector<GridPlan> known)
        : misfit_(misfit), options_(options), isRough_(!isNear && !isDirect(options.method)), plannedAt_(start) {
        const double looseness = isRough_ ? farLooseness : 1.0;
        if (known.empty())
            misfit.plan(start, looseness);
        else
            misfit.adopt(std::move(known), looseness);
        // Where the coarsest steps are fine enough there is nothing to refine.
        const auto& plans = misfit.plans();
        const bool isFine = std::all_of(plans.begin(), plans.end(), [&](const GridPlan& plan) {
            return plan.method == GridMethod::Exact ||
                   (!plan.steps && plan.errorEstimate <= options.simulation.relativeTolerance);
        });
        if (isFine && !plans.empty() && options.loss == RobustLoss::None) isRough_ = false;
        misfit.rescaleLoss(start);
    }

    FitOptions optionsNow() const {
        FitOptions now = options_;
        if (isRough_) now.costTolerance = std::max(options_.costTolerance, 1e-4);
        return now;
    }

    /// Whether another round is due from where the last one ended.
    bool goOn(const Minimum& minimum) {
        if (minimum.status == FitStatus::Cancelled) return false;
        // what is flat to the tolerance of coarse steps may fall on with fine ones
        const bool isFlatForRough = isRough_ && options_.goesOnInValleys && !minimum.isAtKink;
        if (minimum.status == FitStatus::IterationLimit && !isFlatForRough) return false;
        bool goesOn = isRough_;
        if (options_.loss != RobustLoss::None && lossRounds_++ < 5) {
            const double before = misfit_.lossScale();
            misfit_.rescaleLoss(minimum.values);
            goesOn = goesOn || std::abs(misfit_.lossScale() - before) > 0.02 * before;
        }
        if (priorRounds_ < 8 && misfit_.rescalePriors(minimum.values)) {
            ++priorRounds_;
            goesOn = true;
        }
        const auto moved = (minimum.values - plannedAt_).array().abs() > 0.05 * plannedAt_.array().abs();
        if (isRough_) {
            misfit_.plan(minimum.values);
            plannedAt_ = minimum.values;
        } else if (planRounds_ < 3 &&
                   ((moved.any() && !holdsAt(minimum.values)) || minimum.status == FitStatus::Failed)) {
            ++planRounds_;
            goesOn = misfit_.refinePlan(minimum.values) || goesOn;
            plannedAt_ = minimum.values;
        }
        isRough_ = false;
        if (!goesOn && options_.integrationShare > 0.0 && !isWithinScatter_ && !isDirect(options_.method)) {
            isWithinScatter_ = true;
            goesOn = misfit_.planWithin(options_.integrationShare, minimum.values);
        }
        if (!goesOn && !isDirect(options_.method) && misfit_.slopesMislead(minimum.values)) {
            misfit_.takeDifferences();
            goesOn = true;
        }
        return goesOn;
    }

private:
    /// Whether steps that were far finer than asked for where they were judged must be fine enough here: rates are
    /// products of powers of the parameters, and the error grows with the fourth power of the rate.
    bool holdsAt(const Eigen::VectorXd& values) const {
        const Eigen::ArrayXd ratio = values.array() / plannedAt_.array();
        if (!(ratio > 0.0).all()) return false;
        const double growth = std::exp(4.0 * ratio.log().abs().sum());
        const auto& plans = misfit_.plans();
        return std::all_of(plans.begin(), plans.end(), [&](const GridPlan& plan) {
            const bool isExplicit = plan.method == GridMethod::RungeKutta4 && !plan.steps && plan.errorEstimate > 0.0;
            return plan.method == GridMethod::Exact ||
                   (isExplicit && growth * plan.errorEstimate <= 10.0 * options_.simulation.relativeTolerance);
        });
    }

    Misfit& misfit_;
    const FitOptions& options_;
    bool isRough_{}, isWithinScatter_{};
    Eigen::VectorXd plannedAt_;
    int lossRounds_{}, priorRounds_{}, planRounds_{};
};

/// How much the residuals move with each parameter: in its own units, or relative where it is searched so.
Eigen::VectorXd relativeSlopes(const Coordinates& coordinates, const ReducedMisfit& at, const Eigen::VectorXd& values) {
    Eigen::VectorXd slopes = at.jacobian.colwise().norm();
    for (int i = 0; i < coordinates.size(); ++i)
        if (coordinates.isLogarithmic(i)) slopes[i] *= values[i];
    return slopes;
}

/// A parameter inside its bounds that moved the residuals at the start and no longer does; -1: none.
int lostInfluence(const FitProblem& problem, const Coordinates& coordinates, const Eigen::VectorXd& startSlopes,
                  const ReducedMisfit& end, const Minimum& minimum) {
    constexpr double next = 1e-9;  // to nothing
    if (!end.ok || startSlopes.size() != coordinates.size()) return -1;
    const Eigen::VectorXd slopes = relativeSlopes(coordinates, end, minimum.values);
    for (int i = 0; i < coordinates.size(); ++i) {
        const auto index = static_cast<std::size_t>(i);
        const FitParameter& p = problem.parameters[index];
        const bool isBounded = !Coordinates::isOpen(p.min) || !Coordinates::isOpen(p.max);
        if (!isBounded && slopes[i] <= next * startSlopes[i] && startSlopes[i] > 0.0) return i;
    }
    return -1;
}

/// Where a descent on a part of the records arrived, and what it met there.
struct PartialDescent {
    PartialRecords part;
    Descent descent;
};

Descent descend(const FitProblem& problem, const Eigen::VectorXd& start, const FitOptions& options,
                const Progress& progress, const std::vector<GridPlan>& roughPlans = {});

/// Nothing: there is none, or it is not to be relied upon. Either way `descent` is told what it took. Where it was
/// cancelled, its best is the best so far.
std::optional<PartialDescent> descendOnPart(const FitProblem& problem, const Eigen::VectorXd& start, FitOptions options,
                                            const Progress& progress, Descent& descent) {
    constexpr double near = 0.5;  // of the cost at the start: what falls by less began near its end
    constexpr double roughly = 1e-4;
    std::optional<PartialRecords> part = partOf(problem, start, options, progress);
    if (!part) return std::nullopt;
    for (std::size_t i = 0; i < problem.parameters.size(); ++i)
        part->problem.parameters[i].start = start[static_cast<Eigen::Index>(i)];
    options = options.besideOthers();
    options.keepsOptimum = false;
    options.costTolerance = std::max(options.costTolerance, roughly);
    PartialDescent result{std::move(*part), {}};
    Descent& there = result.descent = descend(result.part.problem, start, options, progress, result.part.plans);
    descent.partIterations = there.minimum.iterations + there.partIterations;
    descent.partSimulations = there.simulations + there.partSimulations;
    if (progress.stopRequested()) return result;
    const bool isSound = there.minimum.status == FitStatus::Converged && there.failedSimulations == 0 &&
                         !there.takesDifferences && !(there.minimum.cost > near * there.startCost);
    if (!isSound || !determinesAll(result.part.problem, there.minimum.values, there.reduced)) return std::nullopt;
    return result;
}

/// Where a descent begins: at its start, or where a part of the records has led, if all of them agree.
struct Beginning {
    Eigen::VectorXd values;
    bool isNear{};
    std::vector<GridPlan> plans;  // empty: not known
};

Beginning beginningOf(const FitProblem& problem, const PartialDescent& partial, const Progress& progress) {
    Beginning beginning{partial.descent.minimum.values, true, {}};
    if (partial.part.isThinned && areSingleSteps(partial.descent.plans))
        beginning.plans = plansFromThinned(problem, partial.descent.plans, beginning.values, progress);
    return beginning;
}

Descent descend(const FitProblem& problem, const Eigen::VectorXd& start, const FitOptions& options,
                const Progress& progress, const std::vector<GridPlan>& roughPlans) {
    Descent descent;
    const std::optional<PartialDescent> partial = descendOnPart(problem, start, options, progress, descent);
    Beginning beginning{start, false, roughPlans};
    if (partial) beginning = beginningOf(problem, *partial, progress);
    std::vector<FitParameter> parameters = problem.parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) parameters[i].start = start[static_cast<Eigen::Index>(i)];
    Coordinates coordinates(parameters);
    Misfit misfit(problem, options, progress);
    std::optional<Rounds> rounds(std::in_place, misfit, options, beginning.values, beginning.isNear, beginning.plans);
    if (partial) {
        const ReducedMisfit& there = misfit.reduced(beginning.values);
        const bool agrees =
            there.ok && tellTheSame(problem, there.cost(), partial->part.problem, partial->descent.minimum.cost);
        if (!agrees && !misfit.isCancelled()) {
            beginning = {start, false, roughPlans};
            rounds.emplace(misfit, options, start, false, roughPlans);
            misfit.forgetBest();
        }
    }
    Minimum& minimum = descent.minimum;
    minimum.values = beginning.values;
    int iterations = 0;
    for (bool isFirst = true; isFirst || rounds->goOn(minimum); isFirst = false) {
        ReducedMisfit here = misfit.reduced(minimum.values);
        // Where the last round ended it could be simulated: a failure there may be over at once.
        for (int tries = 0; !isFirst && !here.ok && tries < mostFailures && !misfit.isCancelled(); ++tries)
            here = misfit.reduced(minimum.values);
        if (!here.ok) {
            minimum.status = misfit.isCancelled() ? FitStatus::Cancelled : FitStatus::Failed;
            minimum.message = misfit.isCancelled() ? phrase("cancelled") : misfit.failure();
            break;
        }
        if (isFirst) {
            descent.startCost = beginning.isNear ? std::numeric_limits<double>::quiet_NaN() : here.cost();
            descent.startSlopes =
                beginning.isNear ? partial->descent.startSlopes : relativeSlopes(coordinates, here, minimum.values);
        }
        coordinates.moveOrigin(minimum.values);
        coordinates.scaleBy(here.jacobian.colwise().norm());
        const FitOptions now = rounds->optionsNow();
        const int left = options.maxIterations - iterations;
        minimum = isDirect(options.method) ? directSearch(misfit, coordinates, now)
                  : options.method == FitMethod::LeastSquares
                      ? levenbergMarquardt(misfit, coordinates, now, left, beginning.isNear, minimum.dampingInValley)
                      : leastSquares(misfit, coordinates, now, left);
        iterations += minimum.iterations;
    }
    minimum.iterations = iterations;
    const bool mayGoOn = minimum.isAtKink || (minimum.status == FitStatus::Converged && mayHaveKinks(problem));
    if (options.goesOnAtKinks && mayGoOn && !isDirect(options.method)) {
        minimum = pastKink(problem, minimum, misfit, coordinates);
        iterations = minimum.iterations;
    }
    if (minimum.status == FitStatus::Converged) {
        const int lost =
            lostInfluence(problem, coordinates, descent.startSlopes, misfit.reduced(minimum.values), minimum);
        if (lost >= 0) {
            minimum.status = FitStatus::IterationLimit;
            minimum.message =
                phrase("stopped on a plain: at {:.6g}, {} has no influence any more; start elsewhere, or bound it",
                       minimum.values[lost], problem.parameters[static_cast<std::size_t>(lost)].name);
        }
    }
    if (minimum.status == FitStatus::Converged && !isDirect(options.method)) {
        minimum.message = iterations == 0   ? phrase("it began at the optimum")
                          : iterations == 1 ? phrase("converged after one iteration")
                                            : phrase("converged after {} iterations", iterations);
    }
    descent.plans = misfit.plans();
    descent.optimum = misfit.takeBestLinearisation();
    if (const ReducedMisfit* known = misfit.remembered(minimum.values)) {
        descent.reduced = *known;
    } else if (!options.keepsOptimum && !misfit.isCancelled()) {
        descent.reduced = misfit.reduced(minimum.values);
    }
    descent.simulations = misfit.simulations();
    descent.failedSimulations = misfit.failedSimulations();
    descent.lossScale = misfit.lossScale();
    descent.scatter = misfit.scatter();
    descent.takesDifferences = misfit.takesDifferences();
    return descent;
}

double objectiveOf(const FitProblem& problem, double cost, double scatter) {
    if (problem.scatter > 0.0 || !problem.hasPriors()) return cost;
    return cost / (scatter * scatter) + problem.residualCount() * std::log(scatter);
}

/// What the data and the priors say of each other.
void addPriorRemarks(const FitProblem& problem, FitResult& result) {
    constexpr double asGood = 0.98;  // of its standard deviation
    for (std::size_t i = 0; i < problem.parameters.size(); ++i) {
        const FitParameter& p = problem.parameters[i];
        const FitEstimate& estimate = result.estimates[i];
        if (!p.prior) continue;
        const double distance = p.prior->distance(estimate.value);
        const Text name = fittedName(problem, p);
        if (std::abs(distance) > NormalPrior::contradiction)
            result.remarks.push_back(phrase(
                "{} = {:.6g} lies {:.1f} standard deviations from its prior {:.6g} ± {:.3g}: the data contradict what "
                "was known",
                name, estimate.value, std::abs(distance), p.prior->mean, p.prior->deviation));
        else if (estimate.standardError > asGood * p.prior->deviation)
            result.remarks.push_back(phrase("{} is known from its prior alone: the data add nothing", name));
    }
}

void addRemarks(const FitProblem& problem, const Descent& best, const Uncertainty& uncertainty, FitResult& result) {
    for (std::size_t i = 0; i < problem.parameters.size(); ++i) {
        const FitParameter& p = problem.parameters[i];
        if (!result.estimates[i].atBound) continue;
        const double value = result.values[static_cast<Eigen::Index>(i)];
        result.remarks.push_back(value <= p.min ? phrase("{} rests at its lower bound {:.6g}", p.name, value)
                                                : phrase("{} rests at its upper bound {:.6g}", p.name, value));
    }
    result.remarks.insert(result.remarks.end(), uncertainty.remarks.begin(), uncertainty.remarks.end());
    addPriorRemarks(problem, result);
    if (result.takesDifferences)
        result.remarks.push_back(
            phrase("the model switches faster than its steps: slopes are taken from changes of the parameters, and "
                   "the fit is slow; widen what rounds the change off (\"i_eps\", \"w_eps\") if you can"));
    if (result.failedSimulations > 0) {
        result.remarks.push_back(
            phrase("{} of {} simulations failed and were passed over", result.failedSimulations, result.simulations));
    }
    for (std::size_t e = 0; e < best.plans.size(); ++e) {
        if (best.plans[e].errorEstimate > 1e-3) {
            result.remarks.push_back(
                phrase("experiment '{}': the integration is only accurate to {:.2g} % of the output's range",
                       problem.experiments[e].name, 100.0 * best.plans[e].errorEstimate));
        }
    }
}

/// "a = 0.01, h0 = 0.2"
Text valuesText(const FitProblem& problem, const Eigen::VectorXd& values) {
    Text list;
    for (std::size_t i = 0; i < problem.parameters.size(); ++i) {
        if (i > 0) list += ", ";
        list += phrase("{} = {:.4g}", fittedName(problem, problem.parameters[i]), values[static_cast<Eigen::Index>(i)]);
    }
    return list;
}

/// Residuals, Jacobian and confidence at the best point found.
void conclude(const FitProblem& problem, const FitOptions& options, Descent& best, FitResult& result,
              const Progress& progress) {
    result.status = best.minimum.status;
    result.message = best.minimum.message;
    result.values = best.minimum.values;
    result.startCost = best.startCost;
    result.iterations = best.minimum.iterations;
    result.partIterations = best.partIterations;
    result.plans = best.plans;
    result.optimum = std::move(best.optimum);
    // A fit that was cancelled tells what it has: whoever cancelled it does not wait for a simulation.
    const bool isAsked = options.keepsOptimum || !best.reduced.ok;
    const int most = best.reduced.ok ? mostFailures : 1;
    for (int tries = 0; isAsked && !result.optimum.ok && tries < most && !progress.stopRequested(); ++tries) {
        result.optimum = best.takesDifferences
                             ? lineariseByDifferences(problem, result.values, best.plans, options.simulation, progress,
                                                      result.simulations)
                             : linearise(problem, result.values, true, best.plans, options.simulation, progress,
                                         nullptr, options.threads);
    }
    result.scatter = best.scatter;
    result.takesDifferences = best.takesDifferences;
    const PriorResiduals priors = priorResiduals(problem, result.values, best.scatter);
    // The search has looked at the optimum as closely as can be, unless a robust loss bends what it saw.
    const bool isReduced = best.reduced.ok && (options.loss == RobustLoss::None || !result.optimum.ok);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    result.cost = isReduced           ? best.reduced.cost()
                  : result.optimum.ok ? 0.5 * (result.optimum.residuals.squaredNorm() + priors.squares())
                                      : nan;  // even the best point failed
    result.objective = objectiveOf(problem, result.cost, best.scatter);

    const auto K = static_cast<Eigen::Index>(problem.parameters.size());
    Uncertainty uncertainty;
    uncertainty.standardErrors = Eigen::VectorXd::Constant(K, nan);
    uncertainty.covariance = uncertainty.correlation = Eigen::MatrixXd::Constant(K, K, nan);
    if ((result.optimum.ok || isReduced) && K > 0) {
        std::vector<std::string> names;
        for (const FitParameter& p : problem.parameters) names.push_back(fittedName(problem, p));
        const ReducedMisfit reduced =
            isReduced ? best.reduced : withPriors(reduce(result.optimum.jacobian, result.optimum.residuals), priors);
        std::optional<double> ofLoss;
        if (options.loss != RobustLoss::None) ofLoss = best.lossScale * best.lossScale;
        OptimumUncertainty found = uncertaintyAt(problem, names, result.values, result.optimum, reduced.jacobian,
                                                 2.0 * result.cost - priors.squares(), ofLoss);
        uncertainty = std::move(found.uncertainty);
        result.variance = found.variance;
    }
    Eigen::VectorXd robustErrors = Eigen::VectorXd::Constant(K, nan);
    if (options.findsRobustErrors && result.optimum.ok && K > 0)
        robustErrors = robustErrorsOf(problem, result.optimum, uncertainty.covariance / result.variance, best.scatter);
    if (!options.keepsOptimum) {
        Text failure = std::move(result.optimum.failure);
        result.optimum = {};
        result.optimum.failure = std::move(failure);
    }
    result.covariance = uncertainty.covariance;
    result.correlation = uncertainty.correlation;
    for (std::size_t i = 0; i < problem.parameters.size(); ++i) {
        const FitParameter& p = problem.parameters[i];
        const auto index = static_cast<Eigen::Index>(i);
        FitEstimate estimate;
        estimate.name = p.name;
        estimate.unit = p.unit;
        estimate.value = result.values[index];
        estimate.standardError = uncertainty.standardErrors[index];
        estimate.atBound = i < best.minimum.atBound.size() && best.minimum.atBound[i];
        estimate.experiment = p.experiment;
        estimate.robustError = robustErrors[index];
        estimate.prior = p.prior;
        result.estimates.push_back(std::move(estimate));
    }
    addRemarks(problem, best, uncertainty, result);
}

}  // namespace

const FitEstimate* FitResult::find(const std::string& name, int experiment) const {
    const auto found = std::find_if(estimates.begin(), estimates.end(),
                                    [&](const FitEstimate& e) { return e.name == name && e.experiment == experiment; });
    return found == estimates.end() ? nullptr : &*found;
}

namespace {

FitResult onlySimulated(const FitProblem& problem, const FitOptions& options, const Progress& progress) {
    FitResult result;
    Descent only;
    for (std::size_t e = 0; e < problem.experiments.size(); ++e)
        only.plans.push_back(planFor(problem, static_cast<int>(e), {}, options.simulation, progress));
    only.minimum.values.resize(0);
    only.minimum.status = FitStatus::Converged;
    only.minimum.message = phrase("no parameter is free");
    conclude(problem, options, only, result, progress);
    result.startCost = result.cost;
    if (std::isfinite(result.cost)) return result;
    result.status = FitStatus::Failed;
    result.message = failureAt(problem, result.values, options.simulation, progress);
    if (result.message.empty()) result.message = result.optimum.failure;
    return result;
}

FitResult fitted(const FitProblem& problem, const FitOptions& options, const Progress& progress) {
    FitResult result;
    const Diagnostics faults = validate(problem);
    if (hasError(faults)) {
        result.message = format(faults);
        return result;
    }
    if (problem.parameters.empty()) return onlySimulated(problem, options, progress);
    const std::vector<Eigen::VectorXd> starts = startsOf(problem, options);
    std::vector<Descent> descents(starts.size());
    const auto descendFrom = [&](const std::vector<Eigen::VectorXd>& begins, std::size_t first) {
        parallelFor(static_cast<int>(begins.size()), std::max(1, options.threads), [&](int index) {
            const auto s = static_cast<std::size_t>(index);
            if (progress.stopRequested() && index > 0) return;
            descents[first + s] = descend(problem, begins[s], options, progress);
        });
    };
    descendFrom(starts, 0);
    const auto cannotBegin = [](const Descent& d) {
        return d.minimum.status == FitStatus::Failed && !std::isfinite(d.minimum.cost);
    };
    std::vector<Eigen::VectorXd> elsewhere;
    Text failure;
    if (options.otherStarts > 0 && !progress.stopRequested() &&
        std::all_of(descents.begin(), descents.end(), cannotBegin)) {
        failure = failureAt(problem, starts.front(), options.simulation, progress);
        if (failure.empty()) failure = descents.front().minimum.message;
        const StartsElsewhere looked = startsElsewhere(problem, options, progress);
        elsewhere = looked.starts;
        result.simulations += looked.simulations;
        result.failedSimulations += looked.failedSimulations;
        const std::size_t first = descents.size();
        descents.resize(first + elsewhere.size());
        descendFrom(elsewhere, first);
        descents.front().minimum.message = phrase(
            "{}; nor can it be simulated at any of {} other starts within the bounds", failure, options.otherStarts);
    }
    const auto objective = [&](const Descent& d) { return objectiveOf(problem, d.minimum.cost, d.scatter); };
    std::size_t best = 0;
    for (std::size_t s = 0; s < descents.size(); ++s) {
        if (objective(descents[s]) < objective(descents[best])) best = s;
        result.simulations += descents[s].simulations;
        result.failedSimulations += descents[s].failedSimulations;
        result.partSimulations += descents[s].partSimulations;
    }
    conclude(problem, options, descents[best], result, progress);
    result.startCost = descents[best < starts.size() ? 0 : best].startCost;
    tellFailure(problem, best < starts.size() ? starts[best] : elsewhere[best - starts.size()], result);
    if (best >= starts.size()) {
        result.beganElsewhere = true;
        result.remarks.insert(result.remarks.begin(),
                              phrase("the model cannot be simulated at its start values ({}); the fit began elsewhere "
                                     "within the bounds, at {}",
                                     failure, valuesText(problem, elsewhere[best - starts.size()])));
    }
    if (progress.stopRequested()) {
        result.status = FitStatus::Cancelled;
        result.message = phrase("cancelled; the best parameters so far are kept");
    }
    return result;
}

}  // namespace

FitResult fit(const FitProblem& problem, const FitOptions& options, const Progress& progress) {
    const StopScope scope(progress.stopToken());
    if (const auto enough = limits::checkSlopes(problem.residualCount(), problem.parameters.size()); !enough)
        throw LimitReached(enough.diagnostics().front());
    const auto begin = std::chrono::steady_clock::now();
    FitResult result = fitted(problem, options, progress);
    result.seconds = secondsSince(begin);
    return result;
}

}  // namespace analogon
