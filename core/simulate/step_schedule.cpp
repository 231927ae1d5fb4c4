#include "core/simulate/step_schedule.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

#include "core/base/stopwatch.hpp"
#include "core/simulate/gap_steps.hpp"
#include "core/simulate/interval_stepper.hpp"
#include "core/simulate/state_jacobian.hpp"

namespace analogon {

double costOfImplicitStep(Dynamics& dynamics) {
    return dynamics.prepareRows(0.0) || dynamics.prepareSteps() ? 12.0 : 3.0;
}

namespace {

/// matrix * matrix. Size 0: of any n.
template <int Size>
void square(const double* __restrict matrix, double* __restrict to, int n) {
    if constexpr (Size == 0) {
        using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
        const Eigen::Map<const RowMajor> a(matrix, n, n);
        Eigen::Map<RowMajor>(to, n, n).noalias() = a * a;
        return;
    }
    n = Size;
    std::fill_n(to, n * n, 0.0);
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k)
            for (int j = 0; j < n; ++j) to[i * n + j] += matrix[i * n + k] * matrix[k * n + j];
}

constexpr void (*squares[])(const double*, double*, int){square<0>, square<1>, square<2>, square<3>, square<4>,
                                                         square<5>, square<6>, square<7>, square<8>};

}  // namespace

double spectralRadius(double* matrix, double* scratch, int n, double enough) {
    const int size = n * n;
    const auto norm = [&] {
        double sum = 0.0;
        for (int i = 0; i < size; ++i) sum += matrix[i] * matrix[i];
        return std::sqrt(sum);
    };
    const auto squared = squares[n < static_cast<int>(std::size(squares)) ? n : 0];
    const double low = enough > 0.0 ? std::log(enough) : -std::numeric_limits<double>::infinity();
    double logarithm = 0.0, power = 1.0;
    for (int round = 0;; ++round, power *= 2.0) {
        const double length = norm();
        if (length == 0.0) return 0.0;
        logarithm += std::log(length) / power;
        constexpr int squarings = 6;
        if (round == squarings || logarithm <= low) return std::exp(logarithm);
        for (int i = 0; i < size; ++i) matrix[i] /= length;
        squared(matrix, scratch, n);
        std::copy_n(scratch, size, matrix);
    }
}

namespace {

constexpr int kFewestSamples = 200;  // below, one number for all of them serves as well
constexpr int kMostExplicit = 128;   // substeps of an interval
constexpr int kMostImplicit = 32;
constexpr double kStableReach = 1.6;  // |eigenvalue| * step kept, of the 2.8 at which the explicit method fails
constexpr int kReach = 3;             // intervals: what happens in one may move that far while parameters are fitted

/// What the walk found in an interval: the difference that halving the steps made.
struct Found {
    bool isImplicit{};
    std::int16_t substeps{1};
    std::int32_t stable{1};  // explicit substeps that stability asks for
    float error{};           // one of these for every sample: they are kept short
};

class Scheduler {
public:
    Scheduler(Dynamics& dynamics, const SampledInputs& inputs, const Gaps& gaps, double tolerance,
              const SimulationOptions& options, const Progress& progress)
        : dynamics_(dynamics),
          inputs_(inputs),
          recordGaps_(gaps),
          options_(options),
          progress_(progress),
          tolerance_(tolerance),
          implicitCost_(costOfImplicitStep(dynamics)),
          jacobian_(dynamics),
          count_(static_cast<int>(inputs.time.size())),
          n_(static_cast<std::size_t>(dynamics.shape().states)) {
        for (std::vector<double>* v : {&x_, &coarse_, &fine_, &other_}) v->resize(n_);
        u_.resize(static_cast<std::size_t>(dynamics.shape().slots));
        if (!comparesStates()) gaps_ = gaps.intervals();
    }

    std::optional<GridPlan> run(const Trajectory& survey) {
        stateRanges_ = rangesOf(survey.states, dynamics_.shape().stateNominal);
        for (int round = 0;; ++round) {
            if (!walk()) return std::nullopt;
            const Eigen::VectorXd ranges = rangesBetween(lowest_, highest_, dynamics_.shape().stateNominal);
            const Eigen::ArrayXd ratio = ranges.array() / stateRanges_.array();
            stateRanges_ = ranges;
            if ((ratio > 0.5).all() && (ratio < 2.0).all()) break;
            if (round == 2) return std::nullopt;
        }
        outputRanges_ = rangesOf(reference_, dynamics_.shape().outputNominal);
        return fitted();
    }

    /// With the steps that were chosen.
    std::optional<Trajectory>& taken() { return taken_; }

private:
    double time(int sample) const { return inputs_.time[static_cast<std::size_t>(sample)]; }

    Eigen::VectorXd rangesOf(const Eigen::MatrixXd& y, const std::vector<double>& nominal) const {
        return rangesBetween(y.rowwise().minCoeff(), y.rowwise().maxCoeff(), nominal);
    }
    Eigen::VectorXd rangesBetween(const Eigen::VectorXd& lowest, const Eigen::VectorXd& highest,
                                  const std::vector<double>& nominal) const {
        Eigen::VectorXd ranges(lowest.size());
        for (Eigen::Index i = 0; i < ranges.size(); ++i) {
            const double low = lowest[i], high = highest[i];
            ranges[i] = std::max({high - low, 1e-6 * std::max(std::abs(low), std::abs(high)),
                                  options_.absoluteTolerance * nominal[static_cast<std::size_t>(i)], 1e-300});
        }
        return ranges;
    }
    /// The walk knows no delayed signals of the model's own: then the states must agree with it, not the outputs alone.
    bool comparesStates() const { return !dynamics_.shape().delays.empty(); }

    bool isGap(int interval) const { return !gaps_.empty() && recordGaps_.has(interval); }

    bool isOverLimit(std::chrono::steady_clock::time_point started) const {
        return progress_.stopRequested() || secondsSince(started) > options_.wallClockLimit;
    }

    /// The reference, interval by interval, and what each of them takes.
    bool walk() {
        const auto started = std::chrono::steady_clock::now();
        InputSlots slots(dynamics_, inputs_, &recordGaps_);
        IntervalStepper stepper(dynamics_, slots, inputs_, options_);
        slots.atSample(0, u_.data());
        if (!dynamics_.initialise(time(0), u_.data(), nullptr, x_.data(), nullptr)) return false;
        found_.assign(static_cast<std::size_t>(count_ - 1), {});
        if (comparesStates()) states_.resize(static_cast<Eigen::Index>(n_), count_);
        lowest_ = highest_ = Eigen::Map<const Eigen::VectorXd>(x_.data(), static_cast<Eigen::Index>(n_));
        reference_.resize(dynamics_.shape().outputs, count_);
        guess_[0] = guess_[1] = 1;
        behindGaps_.clear();
        for (int k = 0;; ++k) {
            const Eigen::Map<const Eigen::VectorXd> x(x_.data(), static_cast<Eigen::Index>(n_));
            lowest_ = lowest_.cwiseMin(x);
            highest_ = highest_.cwiseMax(x);
            if (comparesStates()) states_.col(k) = x;
            slots.atSample(k, u_.data());
            if (!dynamics_.outputs(time(k), x_.data(), u_.data(), reference_.col(k).data(), nullptr)) return false;
            if (k + 1 == count_) return true;
            if (dynamics_.evaluations() > options_.evaluationLimit) return false;
            if ((k & 63) == 0 && isOverLimit(started)) return false;
            if (!interval(stepper, k)) return false;
            x_.swap(fine_);
            if (isGap(k)) behindGaps_.push_back(x_);
        }
    }

    /// From x_ to fine_.
    bool interval(IntervalStepper& stepper, int k) {
        Found& found = found_[static_cast<std::size_t>(k)];
        // u_ holds the inputs at the begin of the interval.
        if (!jacobian_.evaluate(time(k), x_.data(), u_.data(), coarse_.data())) return false;
        // One step is stable wherever a bound says so: how much less the eigenvalues are does not matter then.
        const double length = time(k + 1) - time(k);
        const double enough = (1.0 - 1e-9) * kStableReach / length;
        const double stable = std::ceil(jacobian_.radius(enough) * length / kStableReach);
        found.stable = static_cast<int>(std::clamp(stable, 1.0, 1e6));
        if (found.stable <= 2.0 * implicitCost_ && resolve(stepper, k, false, found)) return true;
        if (!resolve(stepper, k, true, found)) return false;
        const bool isResolved = found.error <= local();
        if (found.stable > kMostExplicit || (isResolved && found.substeps * implicitCost_ <= found.stable)) return true;
        Found other = found;
        other_ = fine_;
        if (!resolve(stepper, k, false, other) ||
            (isResolved ? other.substeps > found.substeps * implicitCost_ : other.error > found.error)) {
            fine_.swap(other_);
            return true;
        }
        found = other;
        return true;
    }

    /// Doubles the substeps until that makes no difference.
    bool resolve(IntervalStepper& stepper, int k, bool isImplicit, Found& found) {
        const int most = !isImplicit ? kMostExplicit : isGap(k) ? kMostInGap / 2 : kMostImplicit;
        int own = 1;
        int& guess = isGap(k) ? own : guess_[isImplicit];
        int substeps = std::clamp(isImplicit ? guess : std::max(guess, found.stable), 1, most);
        while (!stepper.cross(k, isImplicit, substeps, x_.data(), coarse_.data())) {
            substeps *= 2;  // what does not converge in a long step may do in a shorter one
            if (!isImplicit || !isGap(k) || substeps > most) return false;
        }
        for (;; substeps *= 2, coarse_.swap(fine_)) {
            if (!stepper.cross(k, isImplicit, 2 * substeps, x_.data(), fine_.data())) return false;
            double error = 0.0;
            for (std::size_t i = 0; i < n_; ++i) {
                const double part = std::abs(fine_[i] - coarse_[i]) / stateRanges_[static_cast<Eigen::Index>(i)];
                if (!(part <= error)) error = part;
            }
            if (!(error < 1e100) && 2 * substeps > most) return false;
            if (error <= local() || 2 * substeps > most) {
                found.isImplicit = isImplicit;
                found.substeps = static_cast<std::int16_t>(substeps);
                found.error = static_cast<float>(error);
                guess = needed(found, local());
                return true;
            }
        }
    }

    double local() const { return 0.1 * tolerance_; }

    /// Substeps at which the difference would be this small: it falls with their fourth or third power.
    static int needed(const Found& found, double error) {
        const double factor = std::pow(found.error / error, found.isImplicit ? 1.0 / 3.0 : 0.25);
        return static_cast<int>(std::ceil(std::clamp(found.substeps * factor, 1.0, 1e4)));
    }

    /// The same for the implicit method, where the explicit one was tried: (rate * step)^4 was its error.
    static int neededImplicitly(const Found& found, double error) {
        if (found.isImplicit) return needed(found, error);
        const double substeps = found.substeps * std::pow(found.error, 0.25) / std::cbrt(error);
        return static_cast<int>(std::ceil(std::clamp(substeps, 1.0, 1e4)));
    }

    /// The cheapest plan of which the outputs agree with the reference: the allowance of each interval is set by what
    /// came of the last one.
    std::optional<GridPlan> fitted() {
        double allowance = local();
        std::optional<GridPlan> best, closest;
        for (int round = 0; round < 6; ++round) {
            if (progress_.stopRequested()) return std::nullopt;
            GridPlan plan = planWith(allowance);
            plan.errorEstimate = errorOf(plan);
            const bool holds = plan.errorEstimate <= tolerance_;
            if (holds && (!best || plan.work() < best->work())) {
                best = plan;
                taken_ = std::move(run_);
            }
            if (!holds && best) break;
            if (!closest || plan.errorEstimate < closest->errorEstimate) {
                closest = plan;
                if (!holds) taken_ = std::move(run_);
            }
            const double share = tolerance_ / std::max(plan.errorEstimate, 1e-3 * tolerance_);
            if (holds && (share < 4.0 || round >= 2)) break;
            // Errors do not simply add up; a failed run (infinite) is taken for ten times too much.
            allowance *= holds ? std::min(0.3 * share, 30.0) : std::max(0.3 * share, 0.03);
        }
        // Where the solution is not smooth the last digits are not to be had; this is still below any sensor noise.
        if (!best && closest->errorEstimate <= 100.0 * tolerance_) return closest;
        return best;
    }

    GridPlan planWith(double allowance) const {
        const auto count = static_cast<int>(found_.size());
        std::vector<int> own(found_.size());
        for (std::size_t k = 0; k < found_.size(); ++k) {
            const Found& found = found_[k];
            const int substeps = std::min(needed(found, allowance), 2 * found.substeps);
            own[k] = found.isImplicit ? -substeps : std::clamp(std::max(substeps, found.stable), 1, kMostExplicit);
        }
        std::vector<std::int16_t> steps;
        for (int k = 0; k < count; ++k) {
            if (isGap(k)) {
                steps.push_back(static_cast<std::int16_t>(own[static_cast<std::size_t>(k)]));
                continue;
            }
            int explicitly = 0, implicitly = 0;
            for (int j = std::max(0, k - kReach); j <= std::min(count - 1, k + kReach); ++j) {
                if (isGap(j)) continue;
                const int steps_j = own[static_cast<std::size_t>(j)];
                if (steps_j < 0) implicitly = std::max(implicitly, -steps_j);
                explicitly = std::max({explicitly, std::abs(steps_j), found_[static_cast<std::size_t>(j)].stable});
            }
            const Found& found = found_[static_cast<std::size_t>(k)];
            if (implicitly > 0 && !found.isImplicit)
                implicitly = std::max(implicitly, neededImplicitly(found, allowance));
            implicitly = std::min(implicitly, 2 * kMostImplicit);
            const bool isExplicit =
                explicitly <= kMostExplicit && (implicitly == 0 || explicitly <= implicitCost_ * implicitly);
            if (!isExplicit && implicitly == 0) implicitly = 1;
            steps.push_back(static_cast<std::int16_t>(isExplicit ? explicitly : -implicitly));
        }
        return planOf(std::move(steps));
    }

    /// The stretches between gaps, each from where the reference is behind the gap: what is left of a difference after
    /// a long time may be nothing, or all (an angle that turns on), and no other steps elsewhere would change it.
    double errorOfStretches(const GridPlan& plan) {
        run_.reset();
        double largest = 0.0;
        for (std::size_t s = 0; s <= gaps_.size(); ++s) {
            GridRun run;
            run.plan = plan;
            run.gaps = &recordGaps_;
            run.first = s == 0 ? 0 : gaps_[s - 1] + 1;
            run.last = s < gaps_.size() ? gaps_[s] : count_ - 1;
            run.startState = s == 0 ? nullptr : behindGaps_[s - 1].data();
            if (run.last <= run.first) continue;
            const Trajectory part = runGrid(dynamics_, inputs_, run, options_, progress_);
            if (part.failure.failed) return std::numeric_limits<double>::infinity();
            const auto reference = reference_.middleCols(run.first, run.last - run.first + 1);
            const double error =
                ((part.outputs - reference).array().abs().colwise() / outputRanges_.array()).maxCoeff();
            if (!(error <= largest)) largest = error;
        }
        return std::isfinite(largest) ? largest : std::numeric_limits<double>::infinity();
    }

    double errorOf(const GridPlan& plan) {
        if (!gaps_.empty()) return errorOfStretches(plan);
        GridRun run;
        run.plan = plan;
        run.gaps = &recordGaps_;
        run.keepStates = comparesStates();
        const Trajectory& trajectory = run_.emplace(runGrid(dynamics_, inputs_, run, options_, progress_));
        if (trajectory.failure.failed) return std::numeric_limits<double>::infinity();
        const double largest =
            comparesStates()
                ? ((trajectory.states - states_).array().abs().colwise() / stateRanges_.array()).maxCoeff()
                : ((trajectory.outputs - reference_).array().abs().colwise() / outputRanges_.array()).maxCoeff();
        return std::isfinite(largest) ? largest : std::numeric_limits<double>::infinity();
    }

    Dynamics& dynamics_;
    const SampledInputs& inputs_;
    const Gaps& recordGaps_;
    const SimulationOptions& options_;
    const Progress& progress_;
    double tolerance_{}, implicitCost_{};
    StateJacobian jacobian_;
    int count_{};
    std::size_t n_{};
    int guess_[2]{1, 1};  // substeps to begin with: explicit, implicit
    std::vector<double> x_, coarse_, fine_, other_, u_;
    std::vector<Found> found_;
    Eigen::VectorXd stateRanges_, outputRanges_;
    Eigen::VectorXd lowest_, highest_;             // states
    Eigen::MatrixXd states_;                       // where they are compared
    Eigen::MatrixXd reference_;                    // outputs
    std::optional<Trajectory> run_, taken_;        // the last one; with the best plan so far
    std::vector<int> gaps_;                        // that stretches end at
    std::vector<std::vector<double>> behindGaps_;  // states of the reference
};

}  // namespace

std::optional<GridPlan> scheduleSteps(Dynamics& dynamics, const SampledInputs& inputs, const Gaps& gaps,
                                      const Trajectory& survey, double tolerance, const SimulationOptions& options,
                                      const Progress& progress, std::optional<Trajectory>* taken) {
    const Dynamics::Shape& shape = dynamics.shape();
    if (static_cast<int>(inputs.time.size()) < kFewestSamples || shape.states == 0 || shape.outputs == 0 ||
        shape.directions > 0) {
        return std::nullopt;
    }
    Scheduler scheduler(dynamics, inputs, gaps, tolerance, options, progress);
    std::optional<GridPlan> plan = scheduler.run(survey);
    if (taken && plan) *taken = std::move(scheduler.taken());
    return plan;
}

}  // namespace analogon
