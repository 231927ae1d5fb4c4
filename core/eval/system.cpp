#include "core/eval/system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <mutex>

#include "core/eval/system_builder.hpp"

namespace analogon {

struct Workspace::Data {
    Registers registers;
};

Workspace::Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;
Workspace::~Workspace() = default;

/// The programs of a system, and the observation program that is made when somebody asks for it.
struct System::Impl {
    SystemPrograms programs;
    mutable std::once_flag observeOnce;
    mutable Observation observation;

    const Observation& observe() const {
        std::call_once(observeOnce, [this] { observation = buildObservation(programs); });
        return observation;
    }
};

System::System(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
System::~System() = default;

Outcome<std::shared_ptr<const System>> System::build(const Structure& structure) {
    auto impl = std::make_unique<Impl>();
    if (Diagnostics faults = buildPrograms(structure, impl->programs); hasError(faults)) return faults;
    return std::shared_ptr<const System>(new System(std::move(impl)));
}

int System::stateCount() const { return static_cast<int>(impl_->programs.states.size()); }
int System::inputCount() const { return static_cast<int>(impl_->programs.inputs.size()); }
int System::slotCount() const { return impl_->programs.layout.slots; }
int System::outputCount() const { return static_cast<int>(impl_->programs.outputs.size()); }
int System::parameterCount() const { return static_cast<int>(impl_->programs.parameters.size()); }
int System::tapCount() const { return static_cast<int>(impl_->programs.layout.taps.size()); }
int System::rootCount() const { return static_cast<int>(impl_->programs.rootRegisters.size()); }
const std::vector<SignalInfo>& System::states() const { return impl_->programs.states; }
const std::vector<SignalInfo>& System::inputs() const { return impl_->programs.inputs; }
const std::vector<SignalInfo>& System::outputs() const { return impl_->programs.outputs; }
const std::vector<SignalInfo>& System::parameters() const { return impl_->programs.parameters; }
const std::vector<DelayInfo>& System::delays() const { return impl_->programs.delays; }
bool System::needsInputDerivative() const { return impl_->programs.layout.hasDerivatives; }
bool System::isLinearTimeInvariant() const { return impl_->programs.isLinearTimeInvariant; }
std::string System::print() const { return analogon::print(impl_->programs); }

namespace {

int indexOf(const std::vector<SignalInfo>& signals, std::string_view name) {
    for (std::size_t i = 0; i < signals.size(); ++i)
        if (signals[i].name == name) return static_cast<int>(i);
    return -1;
}

/// Values and, with tangents, rows of `source` (count x directions) into consecutive places of the registers.
void load(Registers& r, std::uint32_t first, std::span<const double> from) {
    std::copy(from.begin(), from.end(), r.values.begin() + first);
}

void loadTangents(Registers& r, std::uint32_t first, std::size_t count, std::span<const double> from) {
    const auto lanes = static_cast<std::size_t>(r.lanes), directions = static_cast<std::size_t>(r.directions);
    double* to = r.tangents.data() + first * lanes;
    if (from.empty()) {
        std::fill_n(to, count * lanes, 0.0);
        return;
    }
    assert(from.size() >= count * directions);
    for (std::size_t i = 0; i < count; ++i, to += lanes) std::copy_n(from.data() + i * directions, directions, to);
}

bool storeTangents(const Registers& r, const std::vector<ResultRegister>& from, TangentMode mode,
                   std::span<double> to) {
    const auto lanes = static_cast<std::size_t>(r.lanes), directions = static_cast<std::size_t>(r.directions);
    double sum = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        double* out = to.data() + i * directions;
        if (!from[i].active[static_cast<std::size_t>(mode)]) {
            std::fill_n(out, directions, 0.0);
            continue;
        }
        const double* in = r.tangents.data() + from[i].place * lanes;
        for (std::size_t k = 0; k < directions; ++k) {
            out[k] = in[k];
            sum += in[k] - in[k];
        }
    }
    return sum == 0;
}

/// Reads results; false when one is not finite.
bool storeValues(const Registers& r, const std::vector<ResultRegister>& from, std::span<double> to) {
    double sum = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        to[i] = r.values[from[i].place];
        sum += to[i] - to[i];  // 0, or NaN
    }
    return sum == 0;
}

/// The first named unknown of a program that is not finite; else the first result that is not, or whose
/// tangents are not.
void blame(Registers& r, const Program& program, const std::vector<ResultRegister>& results,
           const std::vector<SignalInfo>& signals) {
    r.failedToSolve = false;
    for (const auto& [reg, name] : program.watched)
        if (!std::isfinite(r.values[reg])) {
            r.failure = name;
            return;
        }
    r.failure = "?";
    for (std::size_t i = 0; i < results.size() && i < signals.size(); ++i) {
        bool isFinite = std::isfinite(r.values[results[i].place]);
        for (int k = 0; k < r.directions && isFinite; ++k)
            isFinite = std::isfinite(
                r.tangents[results[i].place * static_cast<std::size_t>(r.lanes) + static_cast<std::size_t>(k)]);
        if (isFinite) continue;
        r.failure = signals[i].name;
        return;
    }
}

}  // namespace

int System::parameterIndex(std::string_view name) const { return indexOf(impl_->programs.parameters, name); }
int System::inputIndex(std::string_view name) const { return indexOf(impl_->programs.inputs, name); }
int System::outputIndex(std::string_view name) const { return indexOf(impl_->programs.outputs, name); }

Workspace System::workspace(int directions) const {
    const SystemPrograms& s = impl_->programs;
    Workspace w;
    w.directions_ = directions;
    w.data_ = std::make_unique<Workspace::Data>();
    Registers& r = w.data_->registers;
    r.directions = directions;
    r.lanes = (directions + 3) / 4 * 4;
    r.resize(s.registerCount, s.guessCount);
    for (const auto& [reg, value] : s.preloads) r.values[reg] = value;
    return w;
}

bool System::setParameters(Workspace& w, std::span<const double> p, std::span<const double> dp) const {
    const SystemPrograms& s = impl_->programs;
    Registers& r = w.data_->registers;
    assert(p.size() >= s.parameters.size());
    load(r, s.firstParameter, p.first(s.parameters.size()));
    std::fill(r.hasGuess.begin(), r.hasGuess.end(), 0);  // what follows depends on p alone, not on what was before
    if (r.directions == 0) return runValues(s.prelude, s.tables, r);
    loadTangents(r, s.firstParameter, s.parameters.size(), dp);
    return runTangents(s.prelude, s.tables, r, InputsConstant);
}

namespace {

/// One evaluation: t, x, u and their tangents into the registers, then the program. dx without directions in
/// the workspace is not looked at.
struct Evaluation {
    const SystemPrograms& s;
    Registers& r;
    bool hasTangents;
    TangentMode mode;

    Evaluation(const SystemPrograms& programs, Registers& registers, bool tangents, std::span<const double> du)
        : s(programs),
          r(registers),
          hasTangents(tangents && registers.directions > 0),
          mode(du.empty() ? InputsConstant : InputsVary) {}

    void at(double t, std::span<const double> x, std::span<const double> u) {
        r.values[s.timeRegister] = t;
        if (!x.empty()) load(r, s.firstState, x.first(s.states.size()));
        load(r, s.firstSlot, u.first(static_cast<std::size_t>(s.layout.slots)));
    }
    void along(std::span<const double> dx, std::span<const double> du) {
        if (!hasTangents) return;
        loadTangents(r, s.firstState, s.states.size(), dx);
        if (mode == InputsVary) loadTangents(r, s.firstSlot, static_cast<std::size_t>(s.layout.slots), du);
    }
    bool run(const Program& program) {
        return hasTangents ? runTangents(program, s.tables, r, mode) : runValues(program, s.tables, r);
    }
    bool store(const Program& program, const std::vector<ResultRegister>& results,
               const std::vector<SignalInfo>& signals, std::span<double> values, std::span<double> tangents) {
        const bool isFinite = storeValues(r, results, values) &&
                              (!hasTangents || tangents.empty() || storeTangents(r, results, mode, tangents));
        if (!isFinite) blame(r, program, results, signals);
        return isFinite;
    }
};

}  // namespace

bool System::initialise(Workspace& w, double t0, std::span<const double> u, std::span<double> x, std::span<double> dx,
                        std::span<const double> du) const {
    const SystemPrograms& s = impl_->programs;
    Registers& r = w.data_->registers;
    std::fill(r.hasGuess.begin(), r.hasGuess.end(), 0);
    Evaluation evaluation(s, r, !dx.empty(), du);
    evaluation.at(t0, {}, u);
    evaluation.along({}, du);
    return evaluation.run(s.initial) && evaluation.store(s.initial, s.initialStates, s.states, x, dx);
}

bool System::derivatives(Workspace& w, double t, std::span<const double> x, std::span<const double> u,
                         std::span<double> xdot) const {
    Evaluation evaluation(impl_->programs, w.data_->registers, false, {});
    evaluation.at(t, x, u);
    const SystemPrograms& s = impl_->programs;
    return evaluation.run(s.derivative) && evaluation.store(s.derivative, s.stateDerivatives, s.states, xdot, {});
}

bool System::derivatives(Workspace& w, double t, std::span<const double> x, std::span<const double> dx,
                         std::span<const double> u, std::span<const double> du, std::span<double> xdot,
                         std::span<double> dxdot) const {
    const SystemPrograms& s = impl_->programs;
    Evaluation evaluation(s, w.data_->registers, true, du);
    evaluation.at(t, x, u);
    evaluation.along(dx, du);
    return evaluation.run(s.derivative) && evaluation.store(s.derivative, s.stateDerivatives, s.states, xdot, dxdot);
}

bool System::outputs(Workspace& w, double t, std::span<const double> x, std::span<const double> u, std::span<double> y,
                     std::span<double> taps) const {
    const SystemPrograms& s = impl_->programs;
    Evaluation evaluation(s, w.data_->registers, false, {});
    evaluation.at(t, x, u);
    if (!evaluation.run(s.output) || !evaluation.store(s.output, s.outputResults, s.outputs, y, {})) return false;
    return taps.empty() || evaluation.store(s.output, s.tapResults, s.tapSignals, taps, {});
}

bool System::outputs(Workspace& w, double t, std::span<const double> x, std::span<const double> dx,
                     std::span<const double> u, std::span<const double> du, std::span<double> y, std::span<double> dy,
                     std::span<double> taps, std::span<double> dtaps) const {
    const SystemPrograms& s = impl_->programs;
    Evaluation evaluation(s, w.data_->registers, true, du);
    evaluation.at(t, x, u);
    evaluation.along(dx, du);
    if (!evaluation.run(s.output) || !evaluation.store(s.output, s.outputResults, s.outputs, y, dy)) return false;
    return taps.empty() || evaluation.store(s.output, s.tapResults, s.tapSignals, taps, dtaps);
}

void System::delayTimes(const Workspace& w, std::span<double> times, std::span<double> dtimes) const {
    const SystemPrograms& s = impl_->programs;
    const Registers& r = w.data_->registers;
    storeValues(r, s.delayTimes, times);
    if (!dtimes.empty() && r.directions > 0) storeTangents(r, s.delayTimes, InputsConstant, dtimes);
}

bool System::roots(Workspace& w, double t, std::span<const double> x, std::span<const double> u,
                   std::span<double> values) const {
    const SystemPrograms& s = impl_->programs;
    Evaluation evaluation(s, w.data_->registers, false, {});
    evaluation.at(t, x, u);
    return evaluation.run(s.root) && evaluation.store(s.root, s.rootRegisters, {}, values, {});
}

std::vector<int> System::observe(std::span<const std::string> names) const {
    const Observation& observation = impl_->observe();
    std::vector<int> handles;
    for (const std::string& name : names) {
        const auto at = observation.handleOf.find(name);
        handles.push_back(at == observation.handleOf.end() ? -1 : at->second);
    }
    return handles;
}

bool System::observed(Workspace& w, double t, std::span<const double> x, std::span<const double> u,
                      std::span<const int> handles, std::span<double> values) const {
    const SystemPrograms& s = impl_->programs;
    const Observation& observation = impl_->observe();
    Registers& r = w.data_->registers;
    r.resize(observation.program.registerCount, observation.guessCount);
    Evaluation evaluation(s, r, false, {});
    evaluation.at(t, x, u);
    if (!runValues(observation.program, observation.tables, r)) return false;
    for (std::size_t i = 0; i < handles.size(); ++i)
        values[i] = handles[i] < 0 ? std::numeric_limits<double>::quiet_NaN()
                                   : r.values[observation.results[static_cast<std::size_t>(handles[i])]];
    return true;
}

std::string System::failure(const Workspace& w) const { return w.data_ ? w.data_->registers.failure : std::string(); }

bool System::failedToSolve(const Workspace& w) const { return w.data_ && w.data_->registers.failedToSolve; }

}  // namespace analogon
