#include "core/eval/system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <tuple>

#include "core/base/guard.hpp"
#include "core/eval/c_code.hpp"
#include "core/eval/program_code.hpp"
#include "core/eval/recurrence.hpp"
#include "core/eval/row_code.hpp"
#include "core/eval/senseless.hpp"
#include "core/eval/state_pattern.hpp"
#include "core/eval/system_builder.hpp"

namespace analogon {

struct Workspace::Data {
    Registers registers;
};

Workspace::Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;
Workspace::~Workspace() = default;

namespace {

/// The scratch memory of a function as it expects it.
void prepare(LineVector& scratch, const CompiledProgram& program) {
    scratch.assign(program.scratchSize, 0.0);
    for (const auto& [offset, value] : program.constants) scratch[offset] = value;
}

}  // namespace

/// The programs of a system, and the observation program that is made when somebody asks for it.
struct System::Impl {
    SystemPrograms programs;
    std::shared_ptr<const EventParts> events;  // null: none of its own
    mutable std::once_flag observeOnce;
    mutable Observation observation;

    const Observation& observe() const {
        std::call_once(observeOnce, [this] { observation = buildObservation(programs); });
        return observation;
    }

    mutable std::once_flag patternOnce;
    mutable std::optional<StatePattern> pattern;

    const StatePattern* statePattern() const {
        std::call_once(patternOnce, [this] { pattern = statePatternOf(programs); });
        return pattern ? &*pattern : nullptr;
    }

    std::shared_ptr<const void> identity = std::make_shared<char>();

    mutable std::mutex codeMutex;
    mutable std::map<std::tuple<int, TangentMode, VectorTarget>, std::shared_ptr<const SystemCode>>
        codes;  // null: not to be had

    std::shared_ptr<const SystemCode> codeFor(int lanes, TangentMode mode, VectorTarget target) const {
        const std::lock_guard lock(codeMutex);
        const auto [at, isNew] = codes.try_emplace({lanes, mode, target});
        if (isNew) at->second = compileCode(programs, lanes, mode, target);
        return at->second;
    }

    mutable std::map<std::pair<int, VectorTarget>, std::shared_ptr<const RecurrenceCode>> recurrences;

    std::shared_ptr<const RecurrenceCode> recurrenceFor(int lanes, VectorTarget target) const {
        const std::lock_guard lock(codeMutex);
        const auto [at, isNew] = recurrences.try_emplace({lanes, target});
        if (isNew) at->second = compileRecurrence(programs, lanes, target);
        return at->second;
    }

    // bool: exact; the inputs that are held
    mutable std::map<std::tuple<int, bool, VectorTarget, std::vector<char>>, std::shared_ptr<const RowCode>> rows;

    std::shared_ptr<const RowCode> rowsFor(int lanes, bool isExact, VectorTarget target,
                                           const std::vector<char>& held) const {
        const std::lock_guard lock(codeMutex);
        const auto [at, isNew] = rows.try_emplace({lanes, isExact, target, held});
        if (isNew) at->second = compileRows(programs, lanes, isExact, target, held);
        return at->second;
    }

    /// Gives the registers machine code; false where there is none.
    bool equip(Registers& r, TangentMode mode = InputsConstant) const {
        Registers::Code& code = r.code[mode];
        if (code.made) return true;
        if (r.target == VectorTarget::Interpreter) return false;
        code.made = codeFor(r.lanes, mode, r.target);
        if (!code.made) r.target = VectorTarget::Interpreter;
        if (!code.made) return false;
        const CompiledProgram* const functions[] = {&code.made->derivative, &code.made->output, &code.made->step};
        for (std::size_t f = 0; f < code.scratch.size(); ++f) prepare(code.scratch[f], *functions[f]);
        code.bodies.resize(code.made->bodies.size());
        for (std::size_t i = 0; i < code.bodies.size(); ++i) {
            prepare(code.bodies[i].values, code.made->bodies[i].values);
            prepare(code.bodies[i].tangents, code.made->bodies[i].tangents);
        }
        return true;
    }
};

System::System(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
System::~System() = default;

Outcome<std::shared_ptr<const System>> System::build(const Structure& structure) { return build(structure, nullptr); }

Outcome<std::shared_ptr<const System>> System::build(const Structure& structure,
                                                     std::shared_ptr<const EventParts> events) {
    return guardedOutcome([&]() -> Outcome<std::shared_ptr<const System>> {
        auto impl = std::make_unique<Impl>();
        if (Diagnostics faults = buildPrograms(structure, impl->programs); hasError(faults)) return faults;
        impl->events = std::move(events);
        return std::shared_ptr<const System>(new System(std::move(impl)));
    });
}

const EventParts* System::events() const { return impl_->events.get(); }

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
bool System::isDifferentiated(int input) const {
    const std::vector<char>& differentiated = impl_->programs.layout.differentiated;
    const auto i = static_cast<std::size_t>(input);
    return i < differentiated.size() && differentiated[i] != 0;
}
bool System::isLinearTimeInvariant() const { return impl_->programs.isLinearTimeInvariant && !impl_->events; }
const StatePattern* System::statePattern() const { return impl_->statePattern(); }
bool System::isSmooth() const {
    if (impl_->events) return false;
    const auto isPlain = [](const Instruction& i) {
        switch (i.opcode) {
            case Opcode::LoadConstant:
            case Opcode::Copy:
            case Opcode::Negate:
            case Opcode::Add:
            case Opcode::Subtract:
            case Opcode::Multiply:
            case Opcode::Divide:
            case Opcode::Power:
            case Opcode::Square:
            case Opcode::Sqrt:
            case Opcode::Exp:
            case Opcode::Log:
            case Opcode::Log10:
            case Opcode::Sin:
            case Opcode::Cos:
            case Opcode::SolveLinear:
                return true;
            default:
                return false;
        }
    };
    const auto& code = impl_->programs.derivative.code;
    return std::all_of(code.begin(), code.end(), isPlain);
}
const std::shared_ptr<const void>& System::identity() const { return impl_->identity; }
std::string System::print() const { return analogon::print(impl_->programs); }
CCode System::cCode() const { return analogon::cCode(impl_->programs); }

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

VectorTarget targetOf(Execution execution) {
    if (execution == Execution::Interpreted) return VectorTarget::Interpreter;
    const VectorTarget fastest = VectorCode::fastest();
    return execution == Execution::Avx2 ? std::min(fastest, VectorTarget::Avx2) : fastest;
}

}  // namespace

int System::parameterIndex(std::string_view name) const { return indexOf(impl_->programs.parameters, name); }
int System::inputIndex(std::string_view name) const { return indexOf(impl_->programs.inputs, name); }
int System::outputIndex(std::string_view name) const { return indexOf(impl_->programs.outputs, name); }

Workspace System::workspace(int directions, Execution execution) const {
    const SystemPrograms& s = impl_->programs;
    Workspace w;
    w.directions_ = directions;
    w.data_ = std::make_unique<Workspace::Data>();
    Registers& r = w.data_->registers;
    r.directions = directions;
    r.target = targetOf(execution);
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
    bool isByCode{};

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
    /// The same by machine code (`number` among the functions of the code) once it pays.
    template <class Impl>
    bool run(const Impl& impl, const Program& program, const CompiledProgram SystemCode::*function,
             std::size_t number) {
        constexpr int runsBefore = 100;
        Registers::Code& code = r.code[mode];
        const bool fits = hasTangents || r.directions == 0;
        isByCode = fits && r.target != VectorTarget::Interpreter &&
                   (code.made || (++code.runs > runsBefore && impl.equip(r, mode)));
        if (!isByCode) return run(program);
        return (*((*code.made).*function).function)(r.values.data(), r.tangents.data(), code.scratch[number].data(),
                                                    &r);
    }
    bool store(const Program& program, const std::vector<ResultRegister>& results,
               const std::vector<SignalInfo>& signals, std::span<double> values, std::span<double> tangents) {
        const bool isFinite = storeValues(r, results, values) &&
                              (!hasTangents || tangents.empty() || storeTangents(r, results, mode, tangents));
        if (!isFinite) {
            if (isByCode) run(program);  // the names are those of the interpreter's registers
            blame(r, program, results, signals);
        }
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
    return evaluation.run(*impl_, s.derivative, &SystemCode::derivative, 0) &&
           evaluation.store(s.derivative, s.stateDerivatives, s.states, xdot, {});
}

bool System::derivatives(Workspace& w, double t, std::span<const double> x, std::span<const double> dx,
                         std::span<const double> u, std::span<const double> du, std::span<double> xdot,
                         std::span<double> dxdot) const {
    const SystemPrograms& s = impl_->programs;
    Evaluation evaluation(s, w.data_->registers, true, du);
    evaluation.at(t, x, u);
    evaluation.along(dx, du);
    return evaluation.run(*impl_, s.derivative, &SystemCode::derivative, 0) &&
           evaluation.store(s.derivative, s.stateDerivatives, s.states, xdot, dxdot);
}

bool System::outputs(Workspace& w, double t, std::span<const double> x, std::span<const double> u, std::span<double> y,
                     std::span<double> taps) const {
    const SystemPrograms& s = impl_->programs;
    Evaluation evaluation(s, w.data_->registers, false, {});
    evaluation.at(t, x, u);
    if (!evaluation.run(*impl_, s.output, &SystemCode::output, 1) ||
        !evaluation.store(s.output, s.outputResults, s.outputs, y, {}))
        return false;
    return taps.empty() || evaluation.store(s.output, s.tapResults, s.tapSignals, taps, {});
}

bool System::outputs(Workspace& w, double t, std::span<const double> x, std::span<const double> dx,
                     std::span<const double> u, std::span<const double> du, std::span<double> y, std::span<double> dy,
                     std::span<double> taps, std::span<double> dtaps) const {
    const SystemPrograms& s = impl_->programs;
    Evaluation evaluation(s, w.data_->registers, true, du);
    evaluation.at(t, x, u);
    evaluation.along(dx, du);
    if (!evaluation.run(*impl_, s.output, &SystemCode::output, 1) ||
        !evaluation.store(s.output, s.outputResults, s.outputs, y, dy))
        return false;
    return taps.empty() || evaluation.store(s.output, s.tapResults, s.tapSignals, taps, dtaps);
}

bool System::prepareSteps(Workspace& w) const { return impl_->equip(w.data_->registers); }

void System::loadState(Workspace& w, std::span<const double> x, std::span<const double> dx) const {
    const SystemPrograms& s = impl_->programs;
    Registers& r = w.data_->registers;
    load(r, s.firstState, x.first(s.states.size()));
    if (r.directions > 0) loadTangents(r, s.firstState, s.states.size(), dx);
}

void System::storeState(const Workspace& w, std::span<double> x, std::span<double> dx) const {
    const SystemPrograms& s = impl_->programs;
    const Registers& r = w.data_->registers;
    std::copy_n(r.values.begin() + s.firstState, s.states.size(), x.begin());
    for (std::size_t i = 0; i < s.states.size() && !dx.empty(); ++i)
        std::copy_n(r.tangents.data() + (s.firstState + i) * static_cast<std::size_t>(r.lanes), r.directions,
                    dx.data() + i * static_cast<std::size_t>(r.directions));
}

bool System::step(Workspace& w, double t, double h, const double* uBegin, const double* uMiddle,
                  const double* uEnd) const {
    const SystemPrograms& s = impl_->programs;
    Registers& r = w.data_->registers;
    Registers::Code& code = r.code[InputsConstant];
    const StepArguments& to = code.made->arguments;
    double* const scratch = code.scratch[2].data();
    scratch[to.fullStep] = h;
    scratch[to.halfStep] = 0.5 * h;
    scratch[to.thirdStep] = h / 3;
    scratch[to.sixthStep] = h / 6;
    const double times[] = {t, t + 0.5 * h, t + h};
    const double* const slots[] = {uBegin, uMiddle, uEnd};
    for (int p = 0; p < 3; ++p) {
        scratch[to.time[p]] = times[p];
        std::copy_n(slots[p], s.layout.slots, scratch + to.slots[p]);
    }
    return (*code.made->step.function)(r.values.data(), r.tangents.data(), scratch, &r);
}

namespace {

/// A, B and c from what the rates are at unit states and inputs; false when they are not affine there.
bool probe(const System& system, Workspace& w, LinearRates& rates) {
    const auto n = static_cast<std::size_t>(rates.states), m = static_cast<std::size_t>(rates.slots);
    const auto K = static_cast<std::size_t>(rates.directions), columns = n + m + 1;
    std::vector<double> x(n), u(m), dx(n * K), f(n), df(n * K);
    const auto evaluate = [&] {
        return K > 0 ? system.derivatives(w, 0, x, dx, u, {}, f, df) : system.derivatives(w, 0, x, u, f);
    };
    rates.matrix.assign(n * columns, 0);
    rates.tangents.assign(n * columns * K, 0);
    const auto put = [&](std::size_t column, double sign, const std::vector<double>& from,
                         const std::vector<double>& tangents) {
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t entry = i * columns + column;
            rates.matrix[entry] += sign * from[i];
            for (std::size_t k = 0; k < K; ++k) rates.tangents[entry * K + k] += sign * tangents[i * K + k];
        }
    };
    if (!evaluate()) return false;
    put(n + m, 1, f, df);
    const std::vector<double> f0 = f, df0 = df;
    for (std::size_t j = 0; j < n + m; ++j) {
        double& unit = j < n ? x[j] : u[j - n];
        unit = 1;
        if (!evaluate()) return false;
        put(j, 1, f, df);
        put(j, -1, f0, df0);
        unit = 0;
    }
    for (std::size_t j = 0; j < n; ++j) x[j] = 1.7 - 0.9 * static_cast<double>(j % 3);
    for (std::size_t j = 0; j < m; ++j) u[j] = 2.3 - 0.8 * static_cast<double>(j % 4);
    if (!evaluate()) return false;
    for (std::size_t i = 0; i < n; ++i) {
        double sum = rates.matrix[i * columns + n + m], size = std::fabs(sum);
        for (std::size_t j = 0; j < n + m; ++j) {
            const double term = rates.matrix[i * columns + j] * (j < n ? x[j] : u[j - n]);
            sum += term;
            size += std::fabs(term);
        }
        if (!(std::fabs(sum - f[i]) <= 1e-9 * size)) return false;
    }
    return true;
}

}  // namespace

namespace {

/// The matrices of exact steps at the parameters in force; nothing: the system is not of that kind.
std::optional<LinearRecurrence> exactSteps(const System& system, Workspace& w, double h) {
    constexpr int mostColumns = 24, mostLanes = 32;  // beyond, steps of a general method are no dearer
    const int size = system.stateCount() + 2 * system.slotCount() + 1;
    if (!system.isLinearTimeInvariant() || system.stateCount() == 0 || size > mostColumns ||
        w.directions() > mostLanes) {
        return std::nullopt;
    }
    LinearRates rates{system.stateCount(), system.slotCount(), w.directions(), {}, {}};
    if (!probe(system, w, rates)) return std::nullopt;
    LinearRecurrence exact = recurrenceOf(rates, h);
    for (const double entry : exact.matrix)
        if (!std::isfinite(entry)) return std::nullopt;
    return exact;
}

void putMatrices(const LinearRecurrence& exact, std::size_t K, std::size_t lanes,
                 const std::vector<std::uint32_t>& entries, const std::vector<std::uint32_t>& tangents,
                 LineVector& scratch) {
    for (std::size_t e = 0; e < exact.matrix.size(); ++e) {
        scratch[entries[e]] = exact.matrix[e];
        for (std::size_t k = 0; k < K; ++k) scratch[tangents[e * lanes + k]] = exact.tangents[e * K + k];
    }
}

}  // namespace

bool System::prepareRecurrence(Workspace& w, double h) const {
    Registers& r = w.data_->registers;
    if (!impl_->programs.isLinearTimeInvariant) return false;
    const std::optional<LinearRecurrence> exact = exactSteps(*this, w, h);
    if (!exact || !(r.recurrence = impl_->recurrenceFor(r.lanes, r.target))) return false;
    prepare(r.recurrenceScratch, r.recurrence->program);
    putMatrices(*exact, static_cast<std::size_t>(r.directions), static_cast<std::size_t>(r.lanes),
                r.recurrence->entries, r.recurrence->tangents, r.recurrenceScratch);
    return true;
}

const RowLayout* System::prepareRows(Workspace& w, double h, const std::vector<char>& held) const {
    Registers& r = w.data_->registers;
    const bool isExact = h > 0.0;
    impl_->equip(r);
    std::optional<LinearRecurrence> exact;
    if (isExact && !(exact = exactSteps(*this, w, h))) return nullptr;
    if (exact) holdInputs(*exact, static_cast<std::size_t>(stateCount()), static_cast<std::size_t>(slotCount()), held);
    r.rowCode = impl_->rowsFor(r.lanes, isExact, r.target, isExact ? std::vector<char>() : held);
    if (!r.rowCode) return nullptr;
    prepare(r.rowScratch[0], r.rowCode->walk);
    prepare(r.rowScratch[1], r.rowCode->step);
    prepare(r.rowScratch[2], r.rowCode->tabulation);
    if (exact)
        putMatrices(*exact, static_cast<std::size_t>(r.directions), static_cast<std::size_t>(r.lanes),
                    r.rowCode->entries, r.rowCode->tangents, r.rowScratch[0]);
    return &r.rowCode->layout;
}

void System::tabulate(Workspace& w, const double* slots, double* terms, std::int64_t count) const {
    Registers& r = w.data_->registers;
    if (count > 0 && r.rowCode->layout.terms() > 0)
        r.rowCode->tabulation.function->run(r.values.data(), r.tangents.data(), r.rowScratch[2].data(), &r, slots,
                                            terms, count);
}

bool System::walk(Workspace& w, const double* rows, double* results, std::int64_t count) const {
    Registers& r = w.data_->registers;
    return count <= 0 || r.rowCode->walk.function->run(r.values.data(), r.tangents.data(), r.rowScratch[0].data(), &r,
                                                       rows, results, count);
}

bool System::stepOver(Workspace& w, const double* rows, std::int64_t count) const {
    Registers& r = w.data_->registers;
    return count <= 0 || r.rowCode->step.function->run(r.values.data(), r.tangents.data(), r.rowScratch[1].data(), &r,
                                                       rows, nullptr, count);
}

void System::recur(Workspace& w, const double* uBegin, const double* uEnd) const {
    Registers& r = w.data_->registers;
    const auto m = static_cast<std::size_t>(slotCount());
    double* const scratch = r.recurrenceScratch.data();
    std::copy_n(uBegin, m, scratch + r.recurrence->begin);
    std::copy_n(uEnd, m, scratch + r.recurrence->end);
    (*r.recurrence->program.function)(r.values.data(), r.tangents.data(), scratch, &r);
}

bool System::isStateFinite(const Workspace& w) const {
    const SystemPrograms& s = impl_->programs;
    const Registers& r = w.data_->registers;
    const auto lanes = static_cast<std::size_t>(r.lanes);
    const auto isFinite = [](double value) { return std::isfinite(value); };
    const auto* x = r.values.data() + s.firstState;
    const auto* dx = r.tangents.data() + s.firstState * lanes;
    return std::all_of(x, x + s.states.size(), isFinite) && std::all_of(dx, dx + s.states.size() * lanes, isFinite);
}

bool System::outputsOfState(Workspace& w, double t, const double* u, double* y, double* dy) const {
    const SystemPrograms& s = impl_->programs;
    Registers& r = w.data_->registers;
    r.values[s.timeRegister] = t;
    std::copy_n(u, s.layout.slots, r.values.begin() + s.firstSlot);
    Registers::Code& code = r.code[InputsConstant];
    const bool isSolved =
        impl_->equip(r) ? (*code.made->output.function)(r.values.data(), r.tangents.data(), code.scratch[1].data(), &r)
        : r.directions > 0 ? runTangents(s.output, s.tables, r, InputsConstant)
                           : runValues(s.output, s.tables, r);
    if (!isSolved) return false;
    const std::size_t count = s.outputResults.size();
    return storeValues(r, s.outputResults, {y, count}) &&
           (!dy ||
            storeTangents(r, s.outputResults, InputsConstant, {dy, count * static_cast<std::size_t>(r.directions)}));
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

Text System::senselessOperation(double t, std::span<const double> p, std::span<const double> x,
                                std::span<const double> u) const {
    const SystemPrograms& s = impl_->programs;
    const Observation& observation = impl_->observe();
    Registers r;
    r.target = VectorTarget::Interpreter;
    r.resize(std::max<std::size_t>(s.registerCount, observation.program.registerCount),
             std::max(s.guessCount, observation.guessCount));
    // where a block cannot be solved, what follows is not computed
    std::fill(r.values.begin(), r.values.end(), std::numeric_limits<double>::quiet_NaN());
    for (const auto& [reg, value] : s.preloads) r.values[reg] = value;
    load(r, s.firstParameter, p.first(s.parameters.size()));
    Evaluation evaluation(s, r, false, {});
    evaluation.at(t, x, u);
    if (runValues(s.prelude, s.tables, r)) runValues(observation.program, observation.tables, r);
    return analogon::senselessOperation(s, observation, t, r.values);
}

std::string System::failure(const Workspace& w) const { return w.data_ ? w.data_->registers.failure : std::string(); }

bool System::failedToSolve(const Workspace& w) const { return w.data_ && w.data_->registers.failedToSolve; }

}  // namespace analogon
