#include <algorithm>
#include <cmath>
#include <limits>

#include "core/simulate/input_slots.hpp"
#include "core/simulate/simulate.hpp"

namespace analogon {

namespace {

/// Steps on from the last sample that was reached until an evaluation fails, and asks the model why.
class FailureSearch {
public:
    FailureSearch(const SimulationTask& task, SystemDynamics& dynamics)
        : task_(task),
          dynamics_(dynamics),
          slots_(dynamics, *task.inputs),
          u_(static_cast<std::size_t>(dynamics.shape().slots)),
          n_(static_cast<std::size_t>(dynamics.shape().states)) {}

    Text at(double t, const std::vector<double>& x) {
        slotsAt(t);
        return task_.system->senselessOperation(t, task_.parameters, x, u_);
    }

    Text after(int sample, std::vector<double> x) {
        constexpr int steps = 100, mostIntervals = 3;
        constexpr double runaway = 1e6;  // explicit steps that grow so far tell of themselves
        const std::vector<double>& time = task_.inputs->time;
        std::vector<double> far(n_);
        for (std::size_t i = 0; i < n_; ++i) far[i] = runaway * (std::abs(x[i]) + dynamics_.shape().stateNominal[i]);
        const int last = std::min(sample + mostIntervals, static_cast<int>(time.size()) - 1);
        for (int k = sample; k <= last; ++k) {
            const double t = time[static_cast<std::size_t>(k)];
            if (!hasOutputs(t, x)) return at(t, x);
            if (k == last) break;
            if (n_ == 0) continue;  // there is nothing on the way to the next sample
            const double h = (time[static_cast<std::size_t>(k) + 1] - t) / steps;
            for (int s = 0; s < steps; ++s) {
                if (!step(t + s * h, h, x)) return isNear(stage_, far) ? at(stageTime_, stage_) : Text();
                if (!isNear(x, far)) return {};
            }
        }
        return {};
    }

private:
    void slotsAt(double t) { slots_.at(slots_.intervals() > 0 ? slots_.intervalOf(t, 0) : 0, t, u_.data()); }

    static bool isNear(const std::vector<double>& x, const std::vector<double>& far) {
        for (std::size_t i = 0; i < x.size(); ++i)
            if (!(std::abs(x[i]) <= far[i])) return false;
        return true;
    }

    bool hasOutputs(double t, const std::vector<double>& x) {
        std::vector<double> y(static_cast<std::size_t>(dynamics_.shape().outputs)),
            taps(static_cast<std::size_t>(dynamics_.shape().taps));
        slotsAt(t);
        return dynamics_.outputs(t, x.data(), u_.data(), y.data(), taps.empty() ? nullptr : taps.data());
    }

    bool rate(double t, const std::vector<double>& x, std::vector<double>& slope) {
        stageTime_ = t;
        stage_ = x;
        slotsAt(t);
        return dynamics_.derivatives(t, x.data(), u_.data(), slope.data());
    }

    /// The classic Runge-Kutta step. False: a rate has no value at the stage that is kept.
    bool step(double t, double h, std::vector<double>& x) {
        std::vector<double> slope(n_), sum(n_, 0.0), there = x;
        constexpr double at[] = {0, 0.5, 0.5, 1}, weight[] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
        for (int stage = 0; stage < 4; ++stage) {
            for (std::size_t i = 0; i < n_ && stage > 0; ++i) there[i] = x[i] + at[stage] * h * slope[i];
            if (!rate(t + at[stage] * h, there, slope)) return false;
            for (std::size_t i = 0; i < n_; ++i) sum[i] += weight[stage] * slope[i];
        }
        for (std::size_t i = 0; i < n_; ++i) x[i] += h * sum[i];
        return true;
    }

    const SimulationTask& task_;
    SystemDynamics& dynamics_;
    InputSlots slots_;
    std::vector<double> u_, stage_;
    double stageTime_{};
    std::size_t n_{};
};

/// The last sample before the failure with a state; -1: none.
int lastReached(const SimulationTask& task, const SimulationOptions& options, const Progress& progress,
                Eigen::VectorXd& state) {
    SimulationTask run = task;
    run.directions.resize(0, 0);
    run.observe.clear();
    run.keepStates = true;
    const Trajectory reached = simulateGrid(run, planGrid(run, options, progress), options, progress);
    int last = -1;
    for (Eigen::Index k = 0; k < reached.states.cols() && reached.states.col(k).allFinite(); ++k)
        last = static_cast<int>(k);
    if (last >= 0) state = reached.states.col(last);
    return last;
}

int lastBefore(const SampledInputs& inputs, double time) {
    const auto at = std::lower_bound(inputs.time.begin(), inputs.time.end(), time);
    return std::max(0, static_cast<int>(at - inputs.time.begin()) - 1);
}

}  // namespace

Text causeOf(const SimulationTask& task, const SimulationFailure& failure, const SimulationOptions& options,
             const Progress& progress) {
    const bool hasCause =
        failure.failed && (failure.reason == "not finite" || failure.reason.find("convergence") != std::string::npos);
    if (!failure.cause.empty()) return failure.cause;
    if (!hasCause || task.system->events() || task.inputs->time.empty() || progress.stopRequested()) return {};
    SimulationTask values = task;
    values.directions.resize(0, 0);
    values.observe.clear();
    values.execution = Execution::Interpreted;
    SystemDynamics dynamics(values, false);
    FailureSearch search(values, dynamics);
    const double begin = task.inputs->time.front();
    std::vector<double> x(static_cast<std::size_t>(dynamics.shape().states), std::numeric_limits<double>::quiet_NaN());
    std::vector<double> u(static_cast<std::size_t>(dynamics.shape().slots), 0.0);
    InputSlots(dynamics, *task.inputs).at(0, begin, u.data());
    if (!dynamics.isReady()) return search.at(begin, x);
    if (x.empty()) return search.after(lastBefore(*task.inputs, failure.time), {});
    if (!dynamics.initialise(begin, u.data(), nullptr, x.data(), nullptr)) return search.at(begin, x);
    Eigen::VectorXd state;
    const int sample = lastReached(task, options, progress, state);
    if (sample >= 0) std::copy(state.begin(), state.end(), x.begin());
    return search.after(std::max(sample, 0), std::move(x));
}

}  // namespace analogon
