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

/// Entries by a pattern into the first columns of a row-major matrix with `stride` numbers a row.
void spread(const StatePattern& pattern, const std::vector<double>& entries, double* to, int stride) {
    const int n = pattern.states();
    for (int i = 0; i < n; ++i) std::fill_n(to + static_cast<std::ptrdiff_t>(i) * stride, n, 0.0);
    for (int j = 0; j < n; ++j)
        for (auto e = static_cast<std::size_t>(pattern.starts[static_cast<std::size_t>(j)]);
             e < static_cast<std::size_t>(pattern.starts[static_cast<std::size_t>(j) + 1]); ++e)
            to[static_cast<std::ptrdiff_t>(pattern.rows[e]) * stride + j] = entries[e];
}

}  // namespace

SystemDynamics::SystemDynamics(const SimulationTask& task, bool withDirections)
    : system_(*task.system),
      pattern_(system_.statePattern()),
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
    const int n = shape_.states, K = parameterDirections, columns = pattern_ ? pattern_->groups : n;
    const auto width = static_cast<std::size_t>(columns + K);
    slot->width = columns + K;
    slot->workspace = system_.workspace(columns + K, execution_);
    std::vector<double> seeds(parameters_.size() * width, 0.0);
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
        for (int k = 0; k < K; ++k) {
            seeds[i * width + static_cast<std::size_t>(columns + k)] =
                directions_[i * static_cast<std::size_t>(K) + static_cast<std::size_t>(k)];
        }
    }
    noted(system_.setParameters(slot->workspace, parameters_, seeds), slot->workspace);
    slot->stateSeeds.assign(static_cast<std::size_t>(n) * width, 0.0);
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i)
        slot->stateSeeds[i * width + (pattern_ ? static_cast<std::size_t>(pattern_->groupOf[i]) : i)] = 1.0;
    slot->slotSeeds.assign(static_cast<std::size_t>(shape_.slots) * width, 0.0);
    if (pattern_) slot->rates.resize(static_cast<std::size_t>(n) * width);
    return *slot;
}

bool SystemDynamics::jacobian(double t, const double* x, const double* u, double* xdot, double* jacobian) {
    if (isStopped()) return false;
    const int n = shape_.states;
    if (pattern_) {
        std::vector<double> entries(pattern_->entries());
        if (!sparseJacobian(t, x, u, xdot, entries.data())) return false;
        spread(*pattern_, entries, jacobian, n);
        return true;
    }
    Partials& p = partials(byState_, 0);
    return noted(system_.derivatives(p.workspace, t, view(x, n), p.stateSeeds, view(u, shape_.slots), {}, view(xdot, n),
                                     view(jacobian, n * n)),
                 p.workspace);
}

bool SystemDynamics::linearised(double t, const double* x, const double* u, const double* du, double* xdot,
                                double* result) {
    if (isStopped()) return false;
    const int n = shape_.states, K = shape_.directions;
    if (pattern_) {
        std::vector<double> entries(pattern_->entries()), held(static_cast<std::size_t>(n * K));
        if (!sparseLinearised(t, x, u, du, xdot, entries.data(), held.data())) return false;
        spread(*pattern_, entries, result, n + K);
        for (int i = 0; i < n; ++i)
            std::copy_n(held.data() + static_cast<std::ptrdiff_t>(i) * K, K,
                        result + static_cast<std::ptrdiff_t>(i) * (n + K) + n);
        return true;
    }
    Partials& p = partials(byStateAndParameter_, K);
    const double* const slotSeeds = seedSlots(p, du);
    return noted(system_.derivatives(p.workspace, t, view(x, n), p.stateSeeds, view(u, shape_.slots),
                                     view(slotSeeds, shape_.slots * p.width), view(xdot, n), view(result, n * p.width)),
                 p.workspace);
}

/// Null: the slots do not depend on the parameters.
const double* SystemDynamics::seedSlots(Partials& p, const double* du) {
    if (!du) return nullptr;
    const int K = shape_.directions;
    for (int i = 0; i < shape_.slots; ++i) std::copy_n(du + i * K, K, p.slotSeeds.data() + i * p.width + (p.width - K));
    return p.slotSeeds.data();
}

/// No two columns of a group have a row in common: what a group makes of a rate is of one of them alone.
void SystemDynamics::takeEntries(const Partials& p, double* entries) const {
    for (std::size_t j = 0; j < pattern_->groupOf.size(); ++j)
        for (auto e = static_cast<std::size_t>(pattern_->starts[j]);
             e < static_cast<std::size_t>(pattern_->starts[j + 1]); ++e)
            entries[e] = p.rates[static_cast<std::size_t>(pattern_->rows[e]) * static_cast<std::size_t>(p.width) +
                                 static_cast<std::size_t>(pattern_->groupOf[j])];
}

bool SystemDynamics::sparseJacobian(double t, const double* x, const double* u, double* xdot, double* entries) {
    if (isStopped()) return false;
    const int n = shape_.states;
    Partials& p = partials(byState_, 0);
    if (!noted(system_.derivatives(p.workspace, t, view(x, n), p.stateSeeds, view(u, shape_.slots), {}, view(xdot, n),
                                   p.rates),
               p.workspace))
        return false;
    takeEntries(p, entries);
    return true;
}

bool SystemDynamics::sparseLinearised(double t, const double* x, const double* u, const double* du, double* xdot,
                                      double* entries, double* held) {
    if (isStopped()) return false;
    const int n = shape_.states, K = shape_.directions;
    Partials& p = partials(byStateAndParameter_, K);
    const double* const slotSeeds = seedSlots(p, du);
    if (!noted(system_.derivatives(p.workspace, t, view(x, n), p.stateSeeds, view(u, shape_.slots),
                                   view(slotSeeds, shape_.slots * p.width), view(xdot, n), p.rates),
               p.workspace))
        return false;
    takeEntries(p, entries);
    for (int i = 0; i < n; ++i)
        std::copy_n(p.rates.data() + static_cast<std::ptrdiff_t>(i) * p.width + (p.width - K), K,
                    held + static_cast<std::ptrdiff_t>(i) * K);
    return true;
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
