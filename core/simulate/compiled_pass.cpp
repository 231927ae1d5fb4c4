#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "core/base/stopwatch.hpp"
#include "core/simulate/grid.hpp"
#include "core/simulate/sample_recorder.hpp"
#include "core/simulate/step_method.hpp"

namespace analogon {

namespace {

/// The state walks over the samples inside the machine code; what comes out are the outputs.
class CompiledPass {
public:
    CompiledPass(Dynamics& dynamics, const SampledInputs& inputs, const GridRun& run, const SimulationOptions& options,
                 const Progress& progress, Trajectory& result)
        : dynamics_(dynamics),
          inputs_(inputs),
          run_(run),
          options_(options),
          progress_(progress),
          result_(result),
          slots_(dynamics, inputs, run.gaps),
          last_(run.last < 0 ? static_cast<int>(inputs.time.size()) - 1 : run.last),
          n_(dynamics.shape().states),
          K_(dynamics.shape().directions) {}

    bool execute() {
        allocate();
        if (!begin() || !record(run_.first)) return false;
        const auto started = std::chrono::steady_clock::now();
        for (int k = run_.first; k < last_; ++k) {
            if (dynamics_.evaluations() > options_.evaluationLimit) return stop(k, "step limit");
            if ((k & 255) == 0) {
                if (progress_.stopRequested()) return stop(k, "cancelled");
                if (secondsSince(started) > options_.wallClockLimit) return stop(k, "time limit");
                if (options_.reached) options_.reached(run_.part(k, last_));
            }
            if (!interval(k) || !record(k + 1)) return false;
        }
        return dynamics_.isStateFinite();
    }

private:
    double time(int sample) const { return inputs_.time[static_cast<std::size_t>(sample)]; }

    void allocate() {
        const Dynamics::Shape& shape = dynamics_.shape();
        y_.resize(static_cast<std::size_t>(shape.outputs));
        dy_.resize(y_.size() * static_cast<std::size_t>(K_));
        x_.resize(static_cast<std::size_t>(n_));
        dx_.resize(x_.size() * static_cast<std::size_t>(K_));
        for (std::vector<double>& u : u_) u.resize(static_cast<std::size_t>(shape.slots));
        makeRoom(result_, dynamics_, last_ - run_.first + 1, run_.keepStates, run_.sink != nullptr);
        if (run_.sink) run_.sink->restart();
    }

    bool begin() {
        if (run_.startState) {
            std::copy_n(run_.startState, n_, x_.data());
        } else {
            slots_.atSample(run_.first, u_[0].data());
            if (!dynamics_.initialise(time(run_.first), u_[0].data(), nullptr, x_.data(),
                                      K_ > 0 ? dx_.data() : nullptr)) {
                return false;
            }
        }
        dynamics_.loadState(x_.data(), dx_.data());
        return true;
    }

    /// u[2] holds the inputs at the end of the step before; their slopes belong to an interval.
    bool interval(int k) {
        const int substeps = run_.plan.substepsIn(k);
        const double begin = time(k), h = (time(k + 1) - begin) / substeps;
        if (run_.plan.methodIn(k) == GridMethod::Esdirk) return implicitly(k, substeps);
        slots_.at(k, begin, u_[2].data());
        if (run_.plan.method == GridMethod::Exact) {
            std::swap(u_[0], u_[2]);
            slots_.at(k, time(k + 1), u_[2].data());
            dynamics_.recur(u_[0].data(), u_[2].data());
            return true;
        }
        for (int s = 0; s < substeps; ++s) {
            const double t = begin + s * h, end = s + 1 == substeps ? time(k + 1) : begin + (s + 1) * h;
            std::swap(u_[0], u_[2]);
            slots_.at(k, end, u_[2].data());
            for (std::size_t i = 0; i < u_[1].size(); ++i) u_[1][i] = 0.5 * (u_[0][i] + u_[2][i]);
            if (!dynamics_.step(t, h, u_[0].data(), u_[1].data(), u_[2].data())) return false;
        }
        return true;
    }

    /// The state comes out of the machine code's memory and goes back.
    bool implicitly(int k, int substeps) {
        if (!implicit_) implicit_ = makeStepMethod(GridMethod::Esdirk, dynamics_, slots_, options_);
        if (k == run_.first || run_.plan.methodIn(k - 1) != GridMethod::Esdirk)
            dynamics_.storeState(x_.data(), dx_.data());
        const Substeps steps = slots_.gaps().implicitSteps(k, substeps);
        for (int s = 0; s < substeps; ++s)
            if (!implicit_->step(k, steps.time(s), steps.length(s), x_.data(), K_ > 0 ? dx_.data() : nullptr))
                return false;
        dynamics_.loadState(x_.data(), dx_.data());
        return true;
    }

    bool record(int sample) {
        const Eigen::Index column = sample - run_.first;
        slots_.atSample(sample, u_[0].data());
        double* const y = run_.sink ? y_.data() : result_.outputs.data() + column * result_.outputs.rows();
        if (!dynamics_.outputsOfState(time(sample), u_[0].data(), y, K_ > 0 ? dy_.data() : nullptr)) return false;
        if (run_.keepStates) dynamics_.storeState(result_.states.data() + column * n_, nullptr);
        if (dynamics_.observedCount() > 0) observe(sample, column);
        if (run_.sink) {
            run_.sink->take(static_cast<int>(column), y, K_ > 0 ? dy_.data() : nullptr);
            return true;
        }
        const double* dy = dy_.data();
        for (Eigen::MatrixXd& tangents : result_.tangents) {
            double* to = tangents.data() + column;
            for (int k = 0; k < K_; ++k, to += tangents.rows()) *to = *dy++;
        }
        return true;
    }

    void observe(int sample, Eigen::Index column) {
        dynamics_.storeState(x_.data(), nullptr);
        double* const to = result_.observed.data() + column * result_.observed.rows();
        if (!dynamics_.observed(time(sample), x_.data(), u_[0].data(), to))
            result_.observed.col(column).setConstant(std::numeric_limits<double>::quiet_NaN());
    }

    /// Ended from outside after sample k.
    bool stop(int k, const char* reason) {
        if (run_.marksUnreached(progress_)) result_.leaveOpen(last_ - k);
        result_.failure = {true, time(k), {}, reason};
        return true;
    }

    Dynamics& dynamics_;
    const SampledInputs& inputs_;
    const GridRun& run_;
    const SimulationOptions& options_;
    const Progress& progress_;
    Trajectory& result_;
    InputSlots slots_;
    std::unique_ptr<StepMethod> implicit_;
    int last_{}, n_{}, K_{};
    std::vector<double> y_, dy_, x_, dx_;
    std::vector<double> u_[3];
};

}  // namespace

bool canBeExact(Dynamics& dynamics, const SampledInputs& inputs) {
    const Dynamics::Shape& shape = dynamics.shape();
    if (shape.states == 0 || !shape.delays.empty()) return false;
    const std::optional<double> h = equidistantStep(inputs);
    return h && (dynamics.prepareRows(*h) || dynamics.prepareRecurrence(*h));
}

bool runCompiled(Dynamics& dynamics, const SampledInputs& inputs, const GridRun& run, const SimulationOptions& options,
                 const Progress& progress, Trajectory& result) {
    const Dynamics::Shape& shape = dynamics.shape();
    const bool isExact = run.plan.method == GridMethod::Exact;
    const std::optional<double> h = isExact ? equidistantStep(inputs) : std::nullopt;
    if (isExact ? !h || shape.states == 0 || !shape.delays.empty() || !dynamics.prepareRecurrence(*h)
                : (run.plan.method != GridMethod::RungeKutta4 && !run.plan.steps) || shape.states == 0 ||
                      !shape.delays.empty() || inputs.time.size() <= 100 || !dynamics.prepareSteps()) {
        return false;
    }
    return CompiledPass(dynamics, inputs, run, options, progress, result).execute();
}

}  // namespace analogon
