#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/structure/structure.hpp"

namespace analogon {

struct CCode;
struct EventParts;
struct StatePattern;

/// A named quantity of the compiled system.
struct SignalInfo {
    std::string name;
    std::string unit;
    double nominal{1};  // magnitude for tolerances; 1 when not given
    std::optional<double> min, max;
    double value{};  // parameters: the model's own value; states: start value for the model's own parameters
};

/// What runs a system. Machine code serves what is evaluated often, where the processor allows it; Avx2 is for tests of
/// code that processors with wider vectors would not run. Results agree to rounding.
enum class Execution : std::uint8_t { Fastest, Avx2, Interpreted };

/// A `delay(z, T)` of the model. The value of z is taken at t - T from what was simulated before; a delay
/// never feeds a state unless z is a top-level input.
struct DelayInfo {
    int input{-1};  // z is this input; -1: z is tap number `tap`
    int tap{-1};
};

/// Values and tangents of one evaluation thread. Made by System::workspace for a number K of directions.
/// Tangent blocks are row-major: quantity i, direction k at [i * K + k].
class Workspace {
public:
    Workspace();
    Workspace(Workspace&&) noexcept;
    Workspace& operator=(Workspace&&) noexcept;
    ~Workspace();
    int directions() const { return directions_; }

private:
    friend class System;
    struct Data;
    std::unique_ptr<Data> data_;
    int directions_{};
};

/// Where the numbers of a row of steps, and of what comes out of it, stand (in doubles). A row is a step: time and
/// length, u at its begin, what depends on u alone at its begin and its middle. The end of a step is the begin of the
/// next row.
struct RowLayout {
    static constexpr int time = 0, step = 1, firstSlot = 2;
    int slots{};
    int rateTerms{}, outputTerms{};  // of u alone, looked up instead of computed
    int outputs{}, states{};
    int lanes{};  // tangents are padded to these

    int slot() const { return firstSlot; }
    int terms() const { return rateTerms + outputTerms; }  // at the begin: those of the rates, those of the outputs
    int rateTerm(int point) const { return firstSlot + slots + (point == 0 ? 0 : terms()); }  // begin or middle
    int outputTerm() const { return firstSlot + slots + rateTerms; }
    int size() const { return firstSlot + slots + terms() + rateTerms; }

    int tangent(int output) const { return output * lanes; }
    int value(int output) const { return outputs * lanes + output; }
    int state(int i) const { return outputs * (lanes + 1) + i; }
    int resultSize() const { return (outputs * (lanes + 1) + states + 7) / 8 * 8; }
};

/// The executable model x' = f(t, x, u, p), y = g(t, x, u, p), const and shared between threads.
///
/// Inputs u come in this order: the sampled inputs; then for each sampled input its time derivative when the
/// model needs it (`needsInputDerivative`); then the delayed values. Use `slots()` for the total.
///
/// Every method returns false when an evaluation failed: a value is not finite or an algebraic block did not
/// converge; `Workspace` then remembers which variable (failure()).
class System {
public:
    /// Lowers a structure to a program.
    static Outcome<std::shared_ptr<const System>> build(const Structure& structure);
    /// Of a model with events: `structure` is of HybridModel::outside, `events` are what runs in its place. Its own
    /// programs serve for names and sizes alone.
    static Outcome<std::shared_ptr<const System>> build(const Structure& structure,
                                                        std::shared_ptr<const EventParts> events);
    /// Null: nothing but relations makes events.
    const EventParts* events() const;

    int stateCount() const;
    int inputCount() const;  // sampled inputs
    int slotCount() const;   // length of u
    int outputCount() const;
    int parameterCount() const;
    int tapCount() const;   // signals that are delayed somewhere
    int rootCount() const;  // relations outside noEvent
    const std::vector<SignalInfo>& states() const;
    const std::vector<SignalInfo>& inputs() const;
    const std::vector<SignalInfo>& outputs() const;
    const std::vector<SignalInfo>& parameters() const;
    const std::vector<DelayInfo>& delays() const;
    bool needsInputDerivative() const;
    bool isDifferentiated(int input) const;           // by the model
    int parameterIndex(std::string_view name) const;  // -1 when unknown
    int inputIndex(std::string_view name) const;
    int outputIndex(std::string_view name) const;

    /// K tangent directions; 0: values only.
    Workspace workspace(int directions, Execution execution = Execution::Fastest) const;

    /// Takes the parameters (and, with K > 0, their directions: parameterCount x K) and evaluates all that
    /// depends on nothing else. Must be called first, and again when p changes.
    bool setParameters(Workspace& w, std::span<const double> p, std::span<const double> dp = {}) const;

    /// Consistent start: x0 (and its tangents) from u(t0) and the model's start values and initial equations.
    bool initialise(Workspace& w, double t0, std::span<const double> u, std::span<double> x, std::span<double> dx = {},
                    std::span<const double> du = {}) const;

    bool derivatives(Workspace& w, double t, std::span<const double> x, std::span<const double> u,
                     std::span<double> xdot) const;
    /// With directions: dx is stateCount x K, du slotCount x K (empty: zero), dxdot stateCount x K.
    bool derivatives(Workspace& w, double t, std::span<const double> x, std::span<const double> dx,
                     std::span<const double> u, std::span<const double> du, std::span<double> xdot,
                     std::span<double> dxdot) const;

    /// y has outputCount values; taps (may be empty) tapCount values.
    bool outputs(Workspace& w, double t, std::span<const double> x, std::span<const double> u, std::span<double> y,
                 std::span<double> taps = {}) const;
    bool outputs(Workspace& w, double t, std::span<const double> x, std::span<const double> dx,
                 std::span<const double> u, std::span<const double> du, std::span<double> y, std::span<double> dy,
                 std::span<double> taps = {}, std::span<double> dtaps = {}) const;

    // Steps on a state that stays in the workspace. The slots must not depend on the parameters (no `du`).

    /// Makes machine code of the classic Runge-Kutta method ready; false where there is none.
    bool prepareSteps(Workspace& w) const;
    void loadState(Workspace& w, std::span<const double> x, std::span<const double> dx) const;
    void storeState(const Workspace& w, std::span<double> x, std::span<double> dx) const;
    /// From t to t + h; u at the begin, the middle and the end of it. False: an algebraic block has no solution. What
    /// is not finite stays so: ask isStateFinite() at the end.
    bool step(Workspace& w, double t, double h, const double* uBegin, const double* uMiddle, const double* uEnd) const;
    /// The same for a linear, time-invariant system and inputs that run linearly: exact steps of length h, set up by
    /// prepareRecurrence(). False: the system is not of that kind or too large.
    bool prepareRecurrence(Workspace& w, double h) const;
    void recur(Workspace& w, const double* uBegin, const double* uEnd) const;
    bool isStateFinite(const Workspace& w) const;

    // Whole stretches of such steps in one go, over a table of rows that the caller fills.

    /// Makes the code ready: exact steps of length h, or Runge-Kutta steps where h is 0. `held`: the inputs that keep
    /// their values from row to row and jump there (empty: none). Null: there is none.
    const RowLayout* prepareRows(Workspace& w, double h, const std::vector<char>& held = {}) const;
    /// What depends on slots alone: `count` times slotCount() values in, RowLayout::terms() out.
    void tabulate(Workspace& w, const double* slots, double* terms, std::int64_t count) const;
    /// Over `count` rows, with one more behind them: outputs and states at their begins into `results`
    /// (RowLayout::resultSize() each), the state goes on to the end of the last. False as step().
    bool walk(Workspace& w, const double* rows, double* results, std::int64_t count) const;
    /// The same for Runge-Kutta steps that nobody looks at.
    bool stepOver(Workspace& w, const double* rows, std::int64_t count) const;
    /// Outputs at the state in the workspace; y outputCount, dy outputCount x K (may be null).
    bool outputsOfState(Workspace& w, double t, const double* u, double* y, double* dy) const;

    /// Delay times in force (one per delay), with tangents delays x K.
    void delayTimes(const Workspace& w, std::span<double> times, std::span<double> dtimes = {}) const;

    /// Values of the root functions (event indicators), rootCount.
    bool roots(Workspace& w, double t, std::span<const double> x, std::span<const double> u,
               std::span<double> values) const;

    /// Values of any variables of the flat model at a point, for plots and for shapes of effects: names in,
    /// values out (NaN for names that are not known). Slow path (interpreted on the graph or the program).
    std::vector<int> observe(std::span<const std::string> names) const;  // handle per name, -1 unknown
    bool observed(Workspace& w, double t, std::span<const double> x, std::span<const double> u,
                  std::span<const int> handles, std::span<double> values) const;

    /// The variable at which the last evaluation in this workspace failed.
    std::string failure(const Workspace& w) const;
    /// Whether that was an algebraic loop without a solution; otherwise a value that is not finite.
    bool failedToSolve(const Workspace& w) const;

    /// Which operation of which equation has no value at a point, in words; empty: none. Slow path, from scratch.
    Text senselessOperation(double t, std::span<const double> p, std::span<const double> x,
                            std::span<const double> u) const;

    /// x' affine in x and u (input derivatives and delayed values are entries of u), with coefficients that are
    /// constant for fixed p, and free of time: the exact recurrence applies.
    bool isLinearTimeInvariant() const;

    /// Where df/dx may differ from 0; null: it is small, or full.
    const StatePattern* statePattern() const;

    /// Whether the rates are made of operations without kinks, jumps or thresholds (a steep tanh counts as one).
    bool isSmooth() const;

    /// Lives as long as the system, or longer: what is kept for a system is kept with it.
    const std::shared_ptr<const void>& identity() const;

    /// The program, one instruction a line.
    std::string print() const;

    /// The programs as C source, for whoever simulates the model without us.
    CCode cCode() const;

    ~System();

private:
    struct Impl;
    explicit System(std::unique_ptr<Impl> impl);
    std::unique_ptr<const Impl> impl_;
};

using SystemPtr = std::shared_ptr<const System>;

/// Text to system in one call: flatten, analyse, build.
Outcome<SystemPtr> compile(const Library& library, std::string_view className, const StructureOptions& options = {});

}  // namespace analogon
