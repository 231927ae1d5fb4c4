#include "core/simulate/dynamics.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/stop.hpp"

namespace analogon {

namespace {

std::span<const double> view(const double* data, int count) {
    return data ? std::span<const double>(data, static_cast<std::size_t>(count)) : std::span<const double>{};
}

std::span<double> view(double* data, int count) {
    return data ? std::span<double>(data, static_cast<std::size_t>(count)) : std::span<double>{};
}

}  // namespace

SystemDynamics::SystemDynamics(const SimulationTask& task, bool withDirections)
    : system_(*task.system),
      execution_(task.execution),
      parameters_(task.parameters),
      held_(task.inputs->held),
      stop_(stopInForce()) {
    shape_.states = system_.stateCount();
    shape_.inputs = system_.inputCount();
    shape_.slots = system_.slotCount();
    shape_.outputs = system_.outputCount();
    shape_.taps = system_.tapCount();
    shape_.roots = system_.rootCount();
    shape_.directions = withDirections ? static_cast<int>(task.directions.cols()) : 0;
    shape_.needsInputDerivative = system_.needsInputDerivative();
    shape_.delays = system_.delays();
    for (const SignalInfo& state : system_.states()) {
        shape_.stateNominal.push_back(state.nominal > 0 ? state.nominal : 1.0);
        shape_.stateNames.push_back(state.name);
    }
    for (const SignalInfo& output : system_.outputs()) {
        shape_.outputNominal.push_back(output.nominal > 0 ? output.nominal : 1.0);
    }
    if (!task.observe.empty()) handles_ = system_.observe(task.observe);

    const int K = shape_.directions;
    for (int i = 0; K > 0 && i < system_.parameterCount(); ++i) {
        for (int k = 0; k < K; ++k) directions_.push_back(task.directions(i, k));
    }
    for (int k = 0; k < K; ++k) {
        double scale = 0.0;
        for (int i = 0; i < system_.parameterCount(); ++i) {
            const double component = std::abs(task.directions(i, k));
            if (component > 0.0)
                scale = std::max(scale, std::abs(parameters_[static_cast<std::size_t>(i)]) / component);
        }
        shape_.directionScale.push_back(scale > 0.0 ? scale : 1.0);
    }
    values_ = system_.workspace(0, task.execution);
    isReady_ = noted(system_.setParameters(values_, parameters_), values_);
    if (isReady_ && K > 0) {
        tangents_ = system_.workspace(K, task.execution);
        isReady_ = noted(system_.setParameters(tangents_, parameters_, directions_), tangents_);
    }
}

bool SystemDynamics::noted(bool ok, const Workspace& workspace) {
    ++evaluations_;
    if (!ok) failed_ = &workspace;
    return ok;
}

std::string SystemDynamics::failure() const { return failed_ ? system_.failure(*failed_) : std::string{}; }

bool SystemDynamics::initialise(double t, const double* u, const double* du, double* x, double* dx) {
    if (isStopped()) return false;
    const int n = shape_.states, m = shape_.slots, K = shape_.directions;
    if (K > 0 && dx) {
        return noted(system_.initialise(tangents_, t, view(u, m), view(x, n), view(dx, n * K), view(du, m * K)),
                     tangents_);
    }
    return noted(system_.initialise(values_, t, view(u, m), view(x, n)), values_);
}

bool SystemDynamics::derivatives(double t, const double* x, const double* u, double* xdot) {
    if (isStopped()) return false;
    const int n = shape_.states;
    return noted(system_.derivatives(values_, t, view(x, n), view(u, shape_.slots), view(xdot, n)), values_);
}

bool SystemDynamics::derivatives(double t, const double* x, const double* dx, const double* u, const double* du,
                                 double* xdot, double* dxdot) {
    if (isStopped()) return false;
    const int n = shape_.states, m = shape_.slots, K = shape_.directions;
    return noted(system_.derivatives(tangents_, t, view(x, n), view(dx, n * K), view(u, m), view(du, m * K),
                                     view(xdot, n), view(dxdot, n * K)),
                 tangents_);
}

SystemDynamics::Partials& SystemDynamics::partials(std::unique_ptr<Partials>& slot, int parameterDirections) {
    if (slot) return *slot;
    slot = std::make_unique<Partials>();
    const int n = shape_.states, K = parameterDirections;
    const auto width = static_cast<std::size_t>(n + K);
    slot->width = n + K;
    slot->workspace = system_.workspace(n + K, execution_);
    std::vector<double> seeds(parameters_.size() * width, 0.0);
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
        for (int k = 0; k < K; ++k) {
            seeds[i * width + static_cast<std::size_t>(n + k)] =
                directions_[i * static_cast<std::size_t>(K) + static_cast<std::size_t>(k)];
        }
    }
    noted(system_.setParameters(slot->workspace, parameters_, seeds), slot->workspace);
    slot->stateSeeds.assign(static_cast<std::size_t>(n) * width, 0.0);
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) slot->stateSeeds[i * width + i] = 1.0;
    slot->slotSeeds.assign(static_cast<std::size_t>(shape_.slots) * width, 0.0);
    return *slot;
}

bool SystemDynamics::jacobian(double t, const double* x, const double* u, double* xdot, double* jacobian) {
    if (isStopped()) return false;
    const int n = shape_.states;
    Partials& p = partials(byState_, 0);
    return noted(system_.derivatives(p.workspace, t, view(x, n), p.stateSeeds, view(u, shape_.slots), {}, view(xdot, n),
                                     view(jacobian, n * n)),
                 p.workspace);
}

bool SystemDynamics::linearised(double t, const double* x, const double* u, const double* du, double* xdot,
                                double* result) {
    if (isStopped()) return false;
    const int n = shape_.states, m = shape_.slots, K = shape_.directions;
    Partials& p = partials(byStateAndParameter_, K);
    std::span<const double> slotSeeds;
    if (du) {
        for (int i = 0; i < m; ++i) std::copy_n(du + i * K, K, p.slotSeeds.data() + i * p.width + n);
        slotSeeds = p.slotSeeds;
    }
    return noted(system_.derivatives(p.workspace, t, view(x, n), p.stateSeeds, view(u, m), slotSeeds, view(xdot, n),
                                     view(result, n * p.width)),
                 p.workspace);
}

bool SystemDynamics::outputs(double t, const double* x, const double* u, double* y, double* taps) {
    if (isStopped()) return false;
    return noted(system_.outputs(values_, t, view(x, shape_.states), view(u, shape_.slots), view(y, shape_.outputs),
                                 view(taps, shape_.taps)),
                 values_);
}

bool SystemDynamics::outputs(double t, const double* x, const double* dx, const double* u, const double* du, double* y,
                             double* dy, double* taps, double* dtaps) {
    if (isStopped()) return false;
    const int n = shape_.states, m = shape_.slots, K = shape_.directions;
    return noted(
        system_.outputs(tangents_, t, view(x, n), view(dx, n * K), view(u, m), view(du, m * K), view(y, shape_.outputs),
                        view(dy, shape_.outputs * K), view(taps, shape_.taps), view(dtaps, shape_.taps * K)),
        tangents_);
}

void SystemDynamics::delayTimes(double* times, double* dtimes) {
    const int count = static_cast<int>(shape_.delays.size());
    if (shape_.directions > 0) {
        system_.delayTimes(tangents_, view(times, count), view(dtimes, count * shape_.directions));
    } else {
        system_.delayTimes(values_, view(times, count));
    }
}

bool SystemDynamics::roots(double t, const double* x, const double* u, double* values) {
    if (isStopped()) return false;
    return noted(system_.roots(values_, t, view(x, shape_.states), view(u, shape_.slots), view(values, shape_.roots)),
                 values_);
}

bool SystemDynamics::prepareSteps() { return system_.prepareSteps(stepping()); }

void SystemDynamics::loadState(const double* x, const double* dx) {
    system_.loadState(stepping(), view(x, shape_.states), view(dx, shape_.states * shape_.directions));
}

void SystemDynamics::storeState(double* x, double* dx) {
    system_.storeState(stepping(), view(x, shape_.states), view(dx, shape_.states * shape_.directions));
}

bool SystemDynamics::step(double t, double h, const double* uBegin, const double* uMiddle, const double* uEnd) {
    if (isStopped()) return false;
    evaluations_ += 4;
    return system_.step(stepping(), t, h, uBegin, uMiddle, uEnd);
}

bool SystemDynamics::outputsOfState(double t, const double* u, double* y, double* dy) {
    ++evaluations_;
    return system_.outputsOfState(stepping(), t, u, y, dy);
}

bool SystemDynamics::observed(double t, const double* x, const double* u, double* values) {
    return system_.observed(values_, t, view(x, shape_.states), view(u, shape_.slots), handles_,
                            view(values, observedCount()));
}

}  // namespace analogon
