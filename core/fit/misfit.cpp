#include "core/fit/misfit.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/parallel.hpp"
#include "core/base/range.hpp"
#include "core/fit/difference_slopes.hpp"
#include "core/fit/normal_equations.hpp"
#include "core/fit/rounding.hpp"

namespace analogon {

namespace {

/// sqrt of rho(r^2) with the sign of r, and its derivative: least squares of it is the robust loss.
struct Softened {
    double value, slope;
};

Softened soften(RobustLoss loss, double r) {
    constexpr double huber = 1.345, cauchy = 2.385;  // 95 % efficiency on Gaussian noise
    const double size = std::abs(r), sign = r < 0.0 ? -1.0 : 1.0;
    if (loss == RobustLoss::Huber && size > huber) {
        const double value = std::sqrt(2.0 * huber * size - huber * huber);
        return {sign * value, huber / value};
    }
    if (loss == RobustLoss::Cauchy && size > 1e-8) {
        const double ratio = size / cauchy;
        const double value = cauchy * std::sqrt(std::log1p(ratio * ratio));
        return {sign * value, size / ((1.0 + ratio * ratio) * value)};
    }
    return {r, 1.0};
}

/// The range of a fitted output as it was measured, in residuals; of the outputs of a recording the largest.
double largestRange(const FitExperiment& experiment) {
    double largest = 0.0;
    for (Eigen::Index o = 0; o < experiment.measured.rows(); ++o) {
        if (experiment.isFitted(o))
            largest = std::max(largest, rangeOf(experiment.measured.row(o)).width() * experiment.weights[o]);
    }
    return largest;
}

}  // namespace

Misfit::Misfit(const FitProblem& problem, const FitOptions& options, const Progress& progress)
    : problem_(problem), options_(options), progress_(progress) {
    // Starts take the threads first, then the experiments.
    threads_ = std::max(1, options.threads / std::max(1, options.starts));
    constexpr int few = 1000;  // residuals: below, nothing is gained
    isLong_ = problem.residualCount() >= few && !problem.hasClocks();
    // The data speak first (weighed by range, as if they scattered by a hundredth of it): a prior that they contradict
    // must not hide behind the misfit that it causes itself.
    scatter_ = problem.scatter > 0.0 ? problem.scatter : problem.weightsAreNoise ? 1.0 : 0.01;
    // a trial, whose effort is limited, takes its chances
    maySwitch_ = options.loss == RobustLoss::None && options.simulation.engine != Engine::Adaptive && !isLimited() &&
                 maySwitch(problem);
    if (maySwitch_) signal_ = signalOf(problem);
    if (options.loss == RobustLoss::None) rounding_ = roundingOf(problem);
}

bool Misfit::isLimited() const { return options_.simulation.evaluationLimit < SimulationOptions().evaluationLimit; }

bool Misfit::maySumUp() const {
    return isLong_ && options_.loss == RobustLoss::None && options_.simulation.engine != Engine::Adaptive &&
           !takesDifferences_;
}

/// One evaluation, counted. Steps that were fine where they were chosen may be too long for a stiffer model (a lag that
/// grows short): where it fails it is tried with those that would be chosen here.
template <class Evaluate>
auto Misfit::attempt(const Eigen::VectorXd& values, const Evaluate& evaluate) {
    auto result = evaluate(plans_);
    ++simulations_;
    const auto tryWith = [&](std::vector<GridPlan> plans) {
        result = evaluate(plans);
        ++simulations_;
        if (!result.ok) return;
        plans_ = std::move(plans);
        plannedWith_ = 1.0;
    };
    const bool mayPlan = options_.simulation.engine != Engine::Adaptive;
    if (!result.ok && !isCancelled() && mayPlan)
        if (std::vector<GridPlan> finer = plansFor(values, 1.0); finer != plans_) tryWith(std::move(finer));
    // explicit steps may meet a stiffness that their plan did not: a fit that cannot even begin tries without them
    // (a trial, whose effort is limited, is given up instead)
    const bool mayBeImplicit = mayPlan && !isLimited() && options_.simulation.method == GridMethod::Auto &&
                               !hasBest() && failedSimulations_ == 0;
    if (!result.ok && !isCancelled() && mayBeImplicit) tryWith(plansFor(values, 1.0, GridMethod::Esdirk));
    if (!result.ok && !isCancelled()) {
        ++failedSimulations_;
        failure_ = result.failure;
    }
    return result;
}

MisfitSums Misfit::sum(const Eigen::VectorXd& values, bool withJacobian) {
    return attempt(values, [&](const std::vector<GridPlan>& plans) {
        return sumUp(problem_, values, withJacobian, plans, options_.simulation, progress_, threads_);
    });
}

Linearisation Misfit::simulate(const Eigen::VectorXd& values, bool withJacobian, MisfitSums* sums) {
    return attempt(values, [&](const std::vector<GridPlan>& plans) {
        if (withJacobian && takesDifferences_)
            return lineariseByDifferences(problem_, values, plans, options_.simulation, progress_, simulations_);
        return linearise(problem_, values, withJacobian, plans, options_.simulation, progress_, sums, threads_);
    });
}

/// False: the sums are not exact enough here.
bool Misfit::summed(const Eigen::VectorXd& values, ReducedMisfit& reduced) {
    MisfitSums sums = sum(values, true);
    if (!sums.ok) {
        reduced = {};
        return true;
    }
    std::optional<ReducedMisfit> found = squeezed(sums, values);
    if (found) reduced = std::move(*found);
    return found.has_value();
}

/// With the priors; nothing: the sums are not exact enough.
std::optional<ReducedMisfit> Misfit::squeezed(MisfitSums& sums, const Eigen::VectorXd& values) {
    const PriorResiduals priors = priorsAt(values);
    sums.hessian += priors.jacobian.transpose() * priors.jacobian;
    sums.gradient += priors.jacobian.transpose() * priors.residuals;
    sums.squares += priors.squares();
    std::optional<ReducedMisfit> found = reduce(sums.hessian, sums.gradient, sums.squares);
    isIllConditioned_ = !found;
    return found;
}

void Misfit::note(const Eigen::VectorXd& values, double cost, Linearisation line) {
    if (cost < bestCost_) {
        bestCost_ = cost;
        best_ = values;
        bestLine_ = std::move(line);
    } else if (line.ok && values == best_) {  // its cost alone was known
        bestLine_ = std::move(line);
    }
}

void Misfit::forgetBest() {
    bestCost_ = std::numeric_limits<double>::infinity();
    bestLine_ = {};
    for (Point& point : memory_) point = {};
}

void Misfit::report(Text detail, double fraction) const {
    std::vector<Progress::Value> best;
    for (std::size_t i = 0; hasBest() && i < problem_.parameters.size(); ++i) {
        const FitParameter& p = problem_.parameters[i];
        const std::string experiment =
            p.experiment < 0 ? std::string() : problem_.experiments[static_cast<std::size_t>(p.experiment)].name;
        best.push_back({p.name, experiment, best_[static_cast<Eigen::Index>(i)]});
    }
    progress_.report({"fit", std::move(detail), std::min(1.0, fraction), -1.0, std::move(best)});
}

void Misfit::applyLoss(Eigen::VectorXd& residuals, Eigen::MatrixXd* jacobian) const {
    if (options_.loss == RobustLoss::None) return;
    Eigen::VectorXd slopes(residuals.size());
    for (Eigen::Index i = 0; i < residuals.size(); ++i) {
        const Softened soft = soften(options_.loss, residuals[i] / lossScale_);
        residuals[i] = soft.value * lossScale_;
        slopes[i] = soft.slope;
    }
    if (jacobian) jacobian->array().colwise() *= slopes.array();
}

const ReducedMisfit* Misfit::remembered(const Eigen::VectorXd& values) const {
    for (const Point& point : memory_) {
        if (point.values.size() == values.size() && point.values == values) return &point.reduced;
    }
    return nullptr;
}

const ReducedMisfit& Misfit::reduced(const Eigen::VectorXd& values) {
    if (const ReducedMisfit* known = remembered(values)) return *known;
    Point& point = memory_[oldest_];
    point.values.resize(0);  // what fails is not remembered
    evaluate(values, point.reduced);
    if (point.reduced.ok) {
        point.values = values;
        oldest_ = (oldest_ + 1) % memory_.size();
    }
    return point.reduced;
}

void Misfit::stepUnseen(const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
    const Eigen::VectorXd step = to - from;
    Point& point = memory_[oldest_];
    point = {to, reduced(from)};
    point.reduced.residuals += point.reduced.jacobian * step;
    oldest_ = (oldest_ + 1) % memory_.size();
    Linearisation line = best_ == from ? std::move(bestLine_) : Linearisation{};
    if (line.ok) line.residuals.noalias() += line.jacobian * step;
    note(to, point.reduced.cost(), std::move(line));
}

bool Misfit::mayKeepSlopes() const {
    constexpr double most = 5e6;  // numbers: 40 MB
    const auto size = static_cast<double>(problem_.residualCount()) * static_cast<double>(problem_.parameters.size());
    return options_.keepsOptimum && options_.loss == RobustLoss::None && !takesDifferences_ && size <= most;
}

std::optional<Eigen::VectorXd> Misfit::slopesTimesChange(const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
    if (!bestLine_.ok || best_ != from || bestLine_.jacobian.cols() != from.size()) return std::nullopt;
    const Linearisation there = simulate(to, false);
    if (!there.ok || !bestLine_.ok) return std::nullopt;
    const PriorResiduals before = priorsAt(from), after = priorsAt(to);
    return bestLine_.jacobian.transpose() * (there.residuals - bestLine_.residuals) +
           before.jacobian.transpose() * (after.residuals - before.residuals);
}

void Misfit::evaluate(const Eigen::VectorXd& values, ReducedMisfit& reduced) {
    const int failedBefore = failedSimulations_;
    evaluateSlopes(values, reduced);
    if (!reduced.ok && failedSimulations_ == failedBefore && !isCancelled())
        failure_ = phrase("the sensitivities are not finite");
    if (!reduced.ok || !arousesDoubt(values, reduced) || !mislead(values, reduced)) return;
    // perhaps only here: on the way some zone may be narrower than it is in the end
    constexpr int oftenEnough = 3;
    takeDifferences();
    evaluateSlopes(values, reduced);
    takesDifferences_ = ++misled_ >= oftenEnough;
}

void Misfit::takeDifferences() {
    takesDifferences_ = true;
    forgetBest();
}

/// A hundredth of a parameter that moves the outputs by as much as they move at all.
bool Misfit::arousesDoubt(const Eigen::VectorXd& values, const ReducedMisfit& reduced) const {
    constexpr int mostDoubts = 6;
    if (!maySwitch_ || takesDifferences_ || doubts_ >= mostDoubts) return false;
    const Eigen::ArrayXd moved = 1e-2 * values.array().abs() * reduced.jacobian.colwise().norm().transpose().array();
    return (moved > signal_).any();
}

bool Misfit::slopesMislead(const Eigen::VectorXd& values) {
    if (!maySwitch_ || takesDifferences_ || isCancelled()) return false;
    const ReducedMisfit& here = reduced(values);
    return here.ok && !takesDifferences_ && mislead(values, here);
}

/// All parameters changed at once, visibly: the length of what the slopes promise against what comes of it.
bool Misfit::mislead(const Eigen::VectorXd& values, const ReducedMisfit& reduced) {
    constexpr double tolerated = 10.0, floor = 1e-3;  // factor; of the signal
    ++doubts_;
    const Eigen::VectorXd steps = visibleSteps(problem_, values);
    const double ofPriors = (priorsAt(values).jacobian * steps).squaredNorm();
    const double promised = std::sqrt(std::max(0.0, (reduced.jacobian * steps).squaredNorm() - ofPriors));
    if (promised <= floor * signal_) return false;
    simulations_ += 2;
    const Linearisation here =
        linearise(problem_, values, false, plans_, options_.simulation, progress_, nullptr, threads_);
    const Linearisation there =
        linearise(problem_, values + steps, false, plans_, options_.simulation, progress_, nullptr, threads_);
    if (!here.ok || !there.ok) return false;
    return promised > tolerated * (there.residuals - here.residuals).norm() + floor * signal_;
}

void Misfit::evaluateSlopes(const Eigen::VectorXd& values, ReducedMisfit& reduced) {
    const bool maySum = maySumUp() && !isIllConditioned_, isKept = isLast_ && options_.keepsOptimum;
    if (maySum && !isKept && summed(values, reduced)) {
        if (reduced.ok) note(values, reduced.cost());
        return;
    }
    const bool addsUp = maySum && isKept;
    if (addsUp) bestLine_ = {};  // of long records there is memory for one
    reduced = {};
    MisfitSums sums;
    Linearisation line = simulate(values, true, addsUp ? &sums : nullptr);
    if (!line.ok) return;
    applyLoss(line.residuals, &line.jacobian);
    if (addsUp)
        if (std::optional<ReducedMisfit> found = squeezed(sums, values)) reduced = std::move(*found);
    if (!reduced.ok) reduced = withPriors(reduce(line.jacobian, line.residuals), priorsAt(values));
    line.ok = options_.loss == RobustLoss::None;
    if (reduced.ok) note(values, reduced.cost(), std::move(line));
}

double Misfit::cost(const Eigen::VectorXd& values) {
    if (maySumUp()) {
        const MisfitSums sums = sum(values, false);
        if (!sums.ok) return std::numeric_limits<double>::infinity();
        const double cost = 0.5 * (sums.squares + priorsAt(values).squares());
        note(values, cost);
        return cost;
    }
    Linearisation line = simulate(values, false);
    if (!line.ok) return std::numeric_limits<double>::infinity();
    applyLoss(line.residuals, nullptr);
    const double cost = 0.5 * (line.residuals.squaredNorm() + priorsAt(values).squares());
    note(values, cost);
    return cost;
}

void Misfit::rescaleLoss(const Eigen::VectorXd& values) {
    if (options_.loss == RobustLoss::None) return;
    const Linearisation line = simulate(values, false);
    if (!line.ok || line.residuals.size() == 0) return;
    Eigen::VectorXd sizes = line.residuals.cwiseAbs();
    const auto middle = sizes.data() + sizes.size() / 2;
    std::nth_element(sizes.data(), middle, sizes.data() + sizes.size());
    lossScale_ = std::max(*middle / 0.6745, 1e-300);
    forgetBest();
}

bool Misfit::rescalePriors(const Eigen::VectorXd& values) {
    if (problem_.scatter > 0.0 || !problem_.hasPriors()) return false;
    double scatter = lossScale_;
    if (options_.loss == RobustLoss::None) {
        const ReducedMisfit& here = reduced(values);
        const auto freedom = problem_.residualCount() - static_cast<Eigen::Index>(problem_.parameters.size());
        if (!here.ok || freedom <= 0) return false;
        const double squares = std::max(0.0, 2.0 * here.cost() - priorsAt(values).squares());
        scatter = std::sqrt(squares / static_cast<double>(freedom));
    }
    if (problem_.weightsAreNoise) scatter = std::max(scatter, 1.0);
    constexpr double close = 0.02;  // what the data say of their scatter is not known better
    if (!(scatter > 0.0) || std::abs(scatter - scatter_) <= close * scatter_) return false;
    scatter_ = scatter;
    forgetBest();
    return true;
}

std::vector<GridPlan> Misfit::plansFor(const Eigen::VectorXd& values, double looseness, GridMethod method) const {
    SimulationOptions options = options_.simulation;
    options.relativeTolerance *= looseness;
    options.isGlance = options.isGlance || looseness > 1.0;
    if (method != GridMethod::Auto) options.method = method;
    std::vector<GridPlan> plans(problem_.experiments.size());
    parallelFor(static_cast<int>(plans.size()), options.reached ? 1 : threads_, [&](int experiment) {
        const auto e = static_cast<std::size_t>(experiment);
        // steps that were chosen loosely hardly serve where they are to be exact
        const GridPlan* const known = problem_.knownPlan(experiment);
        const bool isLoose = plannedWith_ > looseness && known != nullptr;
        const GridPlan* const inForce = e < plans_.size() && !isLoose ? &plans_[e] : known;
        plans[e] =
            planFor(problem_, experiment, values, options, progress_, method == GridMethod::Auto ? inForce : nullptr);
    });
    return plans;
}

bool Misfit::take(std::vector<GridPlan> plans) {
    const bool isSame = plans == plans_;
    plans_ = std::move(plans);
    if (!isSame) forgetBest();
    return !isSame;
}

bool Misfit::plan(const Eigen::VectorXd& values, double looseness) {
    if (options_.simulation.engine == Engine::Adaptive) return false;
    std::vector<GridPlan> plans = plansFor(values, looseness);
    plannedWith_ = looseness;
    return take(std::move(plans));
}

void Misfit::adopt(std::vector<GridPlan> plans, double looseness) {
    if (options_.simulation.engine == Engine::Adaptive) return;
    plannedWith_ = looseness;
    take(std::move(plans));
}

bool Misfit::planWithin(double share, const Eigen::VectorXd& values) {
    constexpr double finest = 1e-3;  // times the tolerance: recordings that a model made leave nothing to compare with
    const auto freedom = problem_.residualCount() - static_cast<Eigen::Index>(problem_.parameters.size());
    if (options_.simulation.engine == Engine::Adaptive || freedom <= 0) return false;
    const ReducedMisfit& here = reduced(values);
    if (!here.ok) return false;
    const double scatter = std::sqrt(2.0 * here.cost() / static_cast<double>(freedom));
    double looseness = 1.0;
    for (std::size_t e = 0; e < plans_.size(); ++e) {
        const double allowed = share * scatter / largestRange(problem_.experiments[e]);
        if (plans_[e].errorEstimate > allowed)
            looseness = std::min(looseness, allowed / (plannedError * options_.simulation.relativeTolerance));
    }
    return looseness < 1.0 && plan(values, std::max(looseness, finest));
}

bool Misfit::refinePlan(const Eigen::VectorXd& values) {
    if (options_.simulation.engine == Engine::Adaptive) return false;
    std::vector<GridPlan> plans = plansFor(values, 1.0);
    for (std::size_t e = 0; e < plans.size(); ++e) {
        if (!plans[e].steps && plans[e].work() <= plans_[e].work()) plans[e] = plans_[e];
    }
    return take(std::move(plans));
}

}  // namespace analogon
