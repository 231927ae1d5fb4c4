#include "core/simulate/grid.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/stopwatch.hpp"
#include "core/simulate/moving_jump.hpp"
#include "core/simulate/sample_recorder.hpp"
#include "core/simulate/step_method.hpp"

namespace analogon {

namespace {

/// Cubic Hermite interpolation of states and tangents between the two ends of a substep.
class HermiteInterpolant final : public StateInterpolant {
public:
    HermiteInterpolant(Dynamics& dynamics, InputSlots& slots) : dynamics_(dynamics), slots_(slots) {
        const Dynamics::Shape& shape = dynamics.shape();
        n_ = static_cast<std::size_t>(shape.states);
        total_ = n_ * static_cast<std::size_t>(1 + shape.directions);
        for (std::vector<double>* v : {&begin_, &end_, &beginSlope_, &endSlope_}) v->resize(total_);
        u_.resize(static_cast<std::size_t>(shape.slots));
        if (slots.hasTangents()) du_.resize(u_.size() * static_cast<std::size_t>(shape.directions));
    }

    void setBegin(double t, const double* x, const double* dx) { keep(t, x, dx, beginTime_, begin_); }
    /// Evaluates the slopes at both ends; false when that failed.
    bool setEnd(int interval, double t, const double* x, const double* dx) {
        keep(t, x, dx, endTime_, end_);
        // the slopes on the inside of both ends, where a held input jumps
        if (slots_.hasHeld()) slots_.holdLines(0.5 * (beginTime_ + endTime_));
        const bool isKnown =
            slope(interval, beginTime_, begin_, beginSlope_) && slope(interval, endTime_, end_, endSlope_);
        if (slots_.hasHeld()) slots_.releaseLines();
        return isKnown;
    }

    bool at(double t, double* x, double* dx, double* xdot) override {
        const double h = endTime_ - beginTime_, s = std::clamp((t - beginTime_) / h, 0.0, 1.0);
        const double b1 = s * s * (3.0 - 2.0 * s), b0 = 1.0 - b1;
        const double c0 = h * s * (1.0 - s) * (1.0 - s), c1 = -h * s * s * (1.0 - s);
        for (std::size_t i = 0; i < total_; ++i) {
            const double value = b0 * begin_[i] + b1 * end_[i] + c0 * beginSlope_[i] + c1 * endSlope_[i];
            if (i < n_) {
                x[i] = value;
            } else {
                dx[i - n_] = value;
            }
        }
        for (std::size_t i = 0; i < n_; ++i) {
            xdot[i] = 6.0 * s * (1.0 - s) * (end_[i] - begin_[i]) / h + (1.0 - s) * (1.0 - 3.0 * s) * beginSlope_[i] +
                      s * (3.0 * s - 2.0) * endSlope_[i];
        }
        return true;
    }

private:
    void keep(double t, const double* x, const double* dx, double& time, std::vector<double>& to) const {
        time = t;
        std::copy_n(x, n_, to.begin());
        if (total_ > n_) std::copy_n(dx, total_ - n_, to.begin() + static_cast<std::ptrdiff_t>(n_));
    }
    bool slope(int interval, double t, const std::vector<double>& state, std::vector<double>& slopes) {
        double* const du = du_.empty() ? nullptr : du_.data();
        slots_.at(interval, t, u_.data(), du);
        if (total_ == n_) return dynamics_.derivatives(t, state.data(), u_.data(), slopes.data());
        return dynamics_.derivatives(t, state.data(), state.data() + n_, u_.data(), du, slopes.data(),
                                     slopes.data() + n_);
    }

    Dynamics& dynamics_;
    InputSlots& slots_;
    std::size_t n_{}, total_{};
    double beginTime_{}, endTime_{};
    std::vector<double> begin_, end_, beginSlope_, endSlope_, u_, du_;
};

/// One pass: the state walks over the samples, the recorder looks at it there.
class GridPass {
public:
    GridPass(Dynamics& dynamics, const SampledInputs& inputs, const GridRun& run, const SimulationOptions& options,
             const Progress& progress, Trajectory& result)
        : dynamics_(dynamics),
          inputs_(inputs),
          run_(run),
          options_(options),
          progress_(progress),
          result_(result),
          last_(run.last < 0 ? static_cast<int>(inputs.time.size()) - 1 : run.last),
          slots_(dynamics, inputs, run.gaps),
          recorder_(dynamics, slots_, inputs, run.first, last_, run.keepStates, result),
          interpolant_(dynamics, slots_),
          jumps_(dynamics, slots_),
          u_(static_cast<std::size_t>(dynamics.shape().slots)),
          x_(static_cast<std::size_t>(dynamics.shape().states)),
          dx_(x_.size() * static_cast<std::size_t>(dynamics.shape().directions)) {}

    void execute() {
        if (!begin()) return fail(run_.first, time(run_.first), recorder_.reason());
        const auto started = std::chrono::steady_clock::now();
        for (int k = run_.first; k < last_; ++k) {
            if (dynamics_.evaluations() > options_.evaluationLimit) return fail(k + 1, time(k), "step limit");
            if ((k & 255) == 0) {
                if (progress_.stopRequested()) return fail(k + 1, time(k), "cancelled");
                if (secondsSince(started) > options_.wallClockLimit) return fail(k + 1, time(k), "time limit");
                if (options_.reached) options_.reached(run_.part(k, last_));
            }
            if (const char* reason = interval(k)) return fail(k + 1, time_, reason);
            if (!recorder_.record(k + 1, x_.data(), dx_.data())) return fail(k + 1, time(k + 1), recorder_.reason());
        }
    }

private:
    double time(int sample) const { return inputs_.time[static_cast<std::size_t>(sample)]; }

    bool begin() {
        if (run_.startState) {
            std::copy_n(run_.startState, x_.size(), x_.begin());
        } else {
            const Dynamics::Shape& shape = dynamics_.shape();
            std::vector<double> u(static_cast<std::size_t>(shape.slots));
            std::vector<double> du(slots_.hasTangents() ? u.size() * static_cast<std::size_t>(shape.directions) : 0);
            slots_.atSample(run_.first, u.data(), du.empty() ? nullptr : du.data());
            if (!dynamics_.initialise(time(run_.first), u.data(), du.empty() ? nullptr : du.data(), x_.data(),
                                      dx_.empty() ? nullptr : dx_.data())) {
                return false;
            }
        }
        return recorder_.start(x_.data(), dx_.data());
    }

    /// From sample k to k + 1; null, or why it failed (at time_).
    const char* interval(int k) {
        const double length = time(k + 1) - time(k);
        double begin = time(k);
        for (const double end : slots_.piecesOf(k)) {
            // A piece gets its share of the substeps.
            const double share = run_.plan.substepsIn(k) * (end - begin) / length;
            if (jumps_.any() && !jump(k, begin, 0.5 * (begin + end))) return "not finite";
            if (const char* reason = piece(k, begin, end, std::max(1, static_cast<int>(std::ceil(share - 1e-6))))) {
                return reason;
            }
            begin = end;
        }
        return nullptr;
    }

    /// Into the piece that begins here and holds `within`.
    bool jump(int k, double begin, double within) {
        if (k == run_.first && begin == time(k)) {
            jumps_.begin(within);
            return true;
        }
        slots_.holdLines(within);
        slots_.at(k, begin, u_.data());
        slots_.releaseLines();
        return jumps_.pass(begin, within, u_.data(), x_.data(), dx_.data());
    }

    const char* piece(int k, double begin, double end, int substeps) {
        Substeps steps{begin, end, substeps};
        const bool isWhole = begin == time(k) && end == time(k + 1);
        if (isWhole && run_.plan.methodIn(k) == GridMethod::Esdirk) steps = slots_.gaps().implicitSteps(k, substeps);
        for (int s = 0; s < substeps; ++s) {
            const double h = steps.length(s), reached = steps.time(s + 1);
            time_ = steps.time(s);
            const bool isLookedAt = recorder_.needsInterpolant(reached);
            if (isLookedAt) interpolant_.setBegin(time_, x_.data(), dx_.data());
            if (!x_.empty()) {
                slots_.holdLines(time_ + 0.5 * h);
                StepMethod& method = methodIn(k);
                if (!method.step(k, time_, h, x_.data(), dx_.data())) {
                    culprit_ = method.culprit();
                    return method.reason();
                }
                slots_.releaseLines();
            }
            if (isLookedAt && !(interpolant_.setEnd(k, reached, x_.data(), dx_.data()) &&
                                recorder_.advance(interpolant_, reached, k))) {
                return "not finite";
            }
        }
        return nullptr;
    }

    StepMethod& methodIn(int interval) {
        const GridMethod method = run_.plan.methodIn(interval);
        std::unique_ptr<StepMethod>& made = method == GridMethod::Esdirk ? implicit_ : explicit_;
        if (!made) made = makeStepMethod(method, dynamics_, slots_, options_);
        return *made;
    }

    void fail(int sample, double at, const char* reason) {
        if (run_.marksUnreached(progress_)) recorder_.abandon(std::min(sample, last_));
        result_.failure = {true, at, dynamics_.failure(), reason};
        if (result_.failure.reason == "cancelled" || result_.failure.reason == "time limit") {
            result_.failure.variable.clear();
        } else if (result_.failure.variable.empty() && culprit_ >= 0) {
            result_.failure.variable = dynamics_.shape().stateNames[static_cast<std::size_t>(culprit_)];
        }
    }

    Dynamics& dynamics_;
    const SampledInputs& inputs_;
    const GridRun& run_;
    const SimulationOptions& options_;
    const Progress& progress_;
    Trajectory& result_;
    int last_{};
    InputSlots slots_;
    SampleRecorder recorder_;
    HermiteInterpolant interpolant_;
    MovingJumps jumps_;
    std::vector<double> u_;
    std::unique_ptr<StepMethod> explicit_, implicit_;
    std::vector<double> x_, dx_;
    double time_{};
    int culprit_{-1};  // the state at which a step failed; -1: not known
};

}  // namespace

Trajectory runGrid(Dynamics& dynamics, const SampledInputs& inputs, const GridRun& run,
                   const SimulationOptions& options, const Progress& progress) {
    Trajectory result;
    result.plan = run.plan;
    result.engine = Engine::Grid;
    if (inputs.time.empty()) {
        result.failure = {true, 0.0, {}, "no samples"};
        return result;
    }
    if (run.sink && progress.stopRequested()) {  // nobody waits for a record full of gaps
        result.failure = {true, inputs.time[static_cast<std::size_t>(run.first)], {}, "cancelled"};
        return result;
    }
    if (runRows(dynamics, inputs, run, options, progress, result) ||
        runCompiled(dynamics, inputs, run, options, progress, result)) {
        return result;
    }
    GridRun general = run;
    // The plan of a model that was linear: what has joined it may need any steps.
    if (run.plan.method == GridMethod::Exact) general.plan = choosePlan(dynamics, inputs, options, progress);
    result.plan = general.plan;
    GridPass(dynamics, inputs, general, options, progress, result).execute();
    if (run.sink && !result.failure.failed) pour(result, dynamics.shape().directions, *run.sink);
    return result;
}

}  // namespace analogon
