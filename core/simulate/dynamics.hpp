#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "core/eval/state_pattern.hpp"
#include "core/eval/system.hpp"
#include "core/simulate/simulate.hpp"

namespace analogon {

/// What the integrators see of a model: x' = f(t, x, u), y = g(t, x, u) with the parameters and their directions
/// already set. One object a thread. Tangent blocks are row-major, quantity i and direction k at [i * K + k];
/// a null `du` means that the slots do not depend on the parameters. Every evaluation returns false when a
/// value is not finite or an algebraic block did not converge; failure() then names the variable.
class Dynamics {
public:
    struct Shape {
        int states{};
        int inputs{};  // sampled inputs
        int slots{};   // length of u: inputs, their slopes when needed, delayed values
        int outputs{};
        int taps{};  // delayed signals of the model's own
        int roots{};
        int directions{};  // K
        bool needsInputDerivative{};
        std::vector<DelayInfo> delays;
        std::vector<double> stateNominal;
        std::vector<double> outputNominal;
        std::vector<std::string> stateNames;
        std::vector<double> directionScale;  // length of a step along each direction that doubles a parameter
    };

    virtual ~Dynamics() = default;
    const Shape& shape() const { return shape_; }

    virtual bool initialise(double t, const double* u, const double* du, double* x, double* dx) = 0;
    virtual bool derivatives(double t, const double* x, const double* u, double* xdot) = 0;
    /// Values and K tangents.
    virtual bool derivatives(double t, const double* x, const double* dx, const double* u, const double* du,
                             double* xdot, double* dxdot) = 0;
    /// Values and df/dx, row-major n x n.
    virtual bool jacobian(double t, const double* x, const double* u, double* xdot, double* jacobian) = 0;
    /// Values and, row-major n x (n + K), df/dx followed by the K tangents with the states held.
    virtual bool linearised(double t, const double* x, const double* u, const double* du, double* xdot,
                            double* partials) = 0;
    /// Where df/dx may differ from 0; null: it is small, or full.
    virtual const StatePattern* pattern() const { return nullptr; }
    /// Values and df/dx by its pattern.
    virtual bool sparseJacobian(double /*t*/, const double* /*x*/, const double* /*u*/, double* /*xdot*/,
                                double* /*entries*/) {
        return false;
    }
    /// The same with the K tangents with the states held, n x K.
    virtual bool sparseLinearised(double /*t*/, const double* /*x*/, const double* /*u*/, const double* /*du*/,
                                  double* /*xdot*/, double* /*entries*/, double* /*held*/) {
        return false;
    }
    virtual bool outputs(double t, const double* x, const double* u, double* y, double* taps) = 0;
    virtual bool outputs(double t, const double* x, const double* dx, const double* u, const double* du, double* y,
                         double* dy, double* taps, double* dtaps) = 0;
    /// Delay times in force, with their tangents (delays x K) when K > 0.
    virtual void delayTimes(double* times, double* dtimes) = 0;
    virtual bool roots(double t, const double* x, const double* u, double* values) = 0;
    // Runge-Kutta steps on a state that stays inside, as machine code (System::step). Offered when prepareSteps() says
    // so, and the slots must not depend on the parameters.
    virtual bool prepareSteps() { return false; }
    virtual void loadState(const double*, const double*) {}
    virtual void storeState(double*, double*) {}
    virtual bool step(double /*t*/, double /*h*/, const double* /*uBegin*/, const double* /*uMiddle*/,
                      const double* /*uEnd*/) {
        return false;
    }
    /// Exact steps of length h (System::prepareRecurrence).
    virtual bool prepareRecurrence(double /*h*/) { return false; }
    virtual void recur(const double* /*uBegin*/, const double* /*uEnd*/) {}
    virtual bool isStateFinite() { return false; }
    virtual bool outputsOfState(double /*t*/, const double* /*u*/, double* /*y*/, double* /*dy*/) { return false; }

    /// Whole stretches of steps (System::prepareRows and on); null: not possible.
    virtual const RowLayout* prepareRows(double /*h*/) { return nullptr; }
    virtual void tabulate(const double* /*slots*/, double* /*terms*/, std::int64_t /*count*/) {}
    virtual bool walk(const double* /*rows*/, double* /*results*/, std::int64_t /*count*/) { return false; }
    virtual bool stepOver(const double* /*rows*/, std::int64_t /*count*/) { return false; }
    virtual std::shared_ptr<const void> identity() const { return nullptr; }  // of the system

    /// Whether df/dx is the same everywhere and at all times.
    virtual bool isLinear() const { return false; }
    /// Whether the rates have no kinks, jumps or thresholds.
    virtual bool isSmooth() const { return false; }

    /// The variables asked for in the task.
    virtual int observedCount() const { return 0; }
    virtual bool observed(double, const double*, const double*, double*) { return true; }
    virtual std::string failure() const = 0;
    /// Whether the last failure was an algebraic loop without a solution.
    virtual bool failedToSolve() const { return false; }
    /// How often the model was evaluated since this object was made: the measure of effort that is the same on
    /// any machine.
    long evaluations() const { return evaluations_; }

protected:
    Shape shape_;
    long evaluations_{};
};

/// A compiled system at the parameters of a task. Once what it is made for is asked to stop (the scope in force,
/// core/base/stop), nothing is evaluated any more: whatever integrates fails at once.
class SystemDynamics final : public Dynamics {
public:
    /// `directions`: as in SimulationTask, or none for values only.
    SystemDynamics(const SimulationTask& task, bool withDirections);

    /// False when what depends on the parameters alone could not be evaluated.
    bool isReady() const { return isReady_; }

    bool initialise(double t, const double* u, const double* du, double* x, double* dx) override;
    bool derivatives(double t, const double* x, const double* u, double* xdot) override;
    bool derivatives(double t, const double* x, const double* dx, const double* u, const double* du, double* xdot,
                     double* dxdot) override;
    bool jacobian(double t, const double* x, const double* u, double* xdot, double* jacobian) override;
    bool linearised(double t, const double* x, const double* u, const double* du, double* xdot,
                    double* partials) override;
    const StatePattern* pattern() const override { return pattern_; }
    bool sparseJacobian(double t, const double* x, const double* u, double* xdot, double* entries) override;
    bool sparseLinearised(double t, const double* x, const double* u, const double* du, double* xdot, double* entries,
                          double* held) override;
    bool outputs(double t, const double* x, const double* u, double* y, double* taps) override;
    bool outputs(double t, const double* x, const double* dx, const double* u, const double* du, double* y, double* dy,
                 double* taps, double* dtaps) override;
    void delayTimes(double* times, double* dtimes) override;
    bool roots(double t, const double* x, const double* u, double* values) override;
    bool prepareSteps() override;
    void loadState(const double* x, const double* dx) override;
    void storeState(double* x, double* dx) override;
    bool step(double t, double h, const double* uBegin, const double* uMiddle, const double* uEnd) override;
    bool prepareRecurrence(double h) override {
        return system_.isLinearTimeInvariant() && system_.prepareRecurrence(stepping(), h);
    }
    void recur(const double* uBegin, const double* uEnd) override {
        ++evaluations_;
        system_.recur(stepping(), uBegin, uEnd);
    }
    bool isStateFinite() override { return system_.isStateFinite(stepping()); }
    bool outputsOfState(double t, const double* u, double* y, double* dy) override;
    const RowLayout* prepareRows(double h) override { return system_.prepareRows(stepping(), h, held_); }
    void tabulate(const double* slots, double* terms, std::int64_t count) override {
        system_.tabulate(stepping(), slots, terms, count);
    }
    bool walk(const double* rows, double* results, std::int64_t count) override {
        evaluations_ += 5 * count;
        return !isStopped() && system_.walk(stepping(), rows, results, count);
    }
    bool stepOver(const double* rows, std::int64_t count) override {
        evaluations_ += 4 * count;
        return !isStopped() && system_.stepOver(stepping(), rows, count);
    }
    std::shared_ptr<const void> identity() const override { return system_.identity(); }
    bool isLinear() const override { return system_.isLinearTimeInvariant(); }
    bool isSmooth() const override { return system_.isSmooth(); }
    int observedCount() const override { return static_cast<int>(handles_.size()); }
    bool observed(double t, const double* x, const double* u, double* values) override;
    std::string failure() const override;
    bool failedToSolve() const override { return failed_ && system_.failedToSolve(*failed_); }

private:
    /// A workspace whose directions are the n states (identity, added by dx), or the groups of those that no rate tells
    /// apart, and then the parameters' own.
    struct Partials {
        Workspace workspace;
        std::vector<double> stateSeeds;  // n x width
        std::vector<double> slotSeeds;   // slots x width
        std::vector<double> rates;       // n x width, where states are grouped
        int width{};
    };
    Partials& partials(std::unique_ptr<Partials>& slot, int parameterDirections);
    void takeEntries(const Partials& partials, double* entries) const;
    const double* seedSlots(Partials& partials, const double* du);
    bool noted(bool ok, const Workspace& workspace);
    bool isStopped() const { return stop_.stop_requested(); }
    Workspace& stepping() { return shape_.directions > 0 ? tangents_ : values_; }

    const System& system_;
    const StatePattern* pattern_{};
    Execution execution_{};
    std::vector<double> parameters_;
    std::vector<double> directions_;  // parameters x K, row-major
    std::vector<char> held_;          // SampledInputs::held
    Workspace values_;
    Workspace tangents_;
    std::unique_ptr<Partials> byState_;
    std::unique_ptr<Partials> byStateAndParameter_;
    std::vector<int> handles_;
    const Workspace* failed_{};
    bool isReady_{};
    std::stop_token stop_;
};

}  // namespace analogon
