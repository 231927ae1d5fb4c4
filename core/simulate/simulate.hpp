#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/eval/system.hpp"
#include "core/simulate/sampled_inputs.hpp"

namespace analogon {

/// Which integration engine; `Auto` chooses the grid method from an error estimate.
enum class Engine { Auto, Grid, Adaptive };
/// One-step methods of the grid engine. Steps end on the samples; `substeps` of them per sample. `Exact` is the
/// recurrence of a linear, time-invariant model on equidistant samples; where it does not apply, the choice is among
/// the others.
enum class GridMethod { Auto, RungeKutta4, Esdirk, Exact };

struct SimulationOptions {
    Engine engine{Engine::Auto};
    GridMethod method{GridMethod::Auto};
    int substeps{};  // per sample interval; 0: chosen by step doubling
    double relativeTolerance{1e-6};
    double absoluteTolerance{1e-9};       // times a state's nominal value
    bool byRecurrence{true};              // whether a linear model may take exact steps
    bool isGlance{};                      // only compared: steps that are known are judged on parts of a record
    double wallClockLimit{60};            // [s]
    long stepLimit{20'000'000};           // adaptive engine
    long evaluationLimit{2'000'000'000};  // of the model, in one grid run or in planning one
    /// Told now and then which part of a run over the samples is done, 0 … 1; each run that chooses the steps begins
    /// anew. Empty: nobody asks.
    std::function<void(double)> reached{};
};

/// Terms of the model that depend on the inputs alone, for every explicit step of a plan: computed once, then looked
/// up.
struct InputTerms {
    std::shared_ptr<const void> owner;  // System::identity() of the system they belong to
    int count{};                        // terms a point
    std::vector<char> held;             // SampledInputs::held
    std::vector<double> begin, middle;  // of each step, those of the rates alone in its middle
};

/// Error of an output that a plan may make, in parts of its range, times SimulationOptions::relativeTolerance.
inline constexpr double plannedError = 10.0;

/// What a grid run was found to need; chosen once per experiment, then kept so that a misfit stays smooth.
struct GridPlan {
    GridMethod method{GridMethod::RungeKutta4};
    int substeps{1};
    double errorEstimate{};  // max over outputs of |difference to the reference| / output range
    /// Where the sample intervals need different steps: for each, how many explicit (> 0) or implicit (< 0) ones;
    /// above is then the most demanding of them. Null: all alike.
    std::shared_ptr<const std::vector<std::int16_t>> steps{};
    std::shared_ptr<const InputTerms> terms{};  // null: computed on the way

    GridMethod methodIn(int interval) const {
        if (!steps) return method;
        return (*steps)[static_cast<std::size_t>(interval)] < 0 ? GridMethod::Esdirk : GridMethod::RungeKutta4;
    }
    int substepsIn(int interval) const {
        return steps ? std::abs((*steps)[static_cast<std::size_t>(interval)]) : substeps;
    }
    /// What an interval costs on the average, in explicit steps.
    double work() const;
    friend bool operator==(const GridPlan& a, const GridPlan& b);  // the same steps
};

/// A plan with these steps, > 0 explicit and < 0 implicit, for each sample interval.
GridPlan planOf(std::vector<std::int16_t> steps);

/// The plan with at least as many steps in each sample interval as are needed there, by the method it has there.
GridPlan refined(const GridPlan& plan, const std::vector<int>& needed);

struct SimulationFailure {
    bool failed{};
    double time{};         // [s] where it stopped
    std::string variable;  // the variable that was not finite, or did not converge; may be empty
    std::string reason;  // "not finite", "step limit", "time limit", "no convergence of an algebraic loop", "cancelled"
    Text cause{};        // which operation of which equation (causeOf()); empty: not asked, or not found
};

/// Outputs at the samples, with tangents in the asked directions.
struct Trajectory {
    Eigen::MatrixXd outputs;                // rows: outputs of the system, columns: samples; NaN from a failure on
    std::vector<Eigen::MatrixXd> tangents;  // one per output: rows: samples, columns: directions
    Eigen::MatrixXd states;                 // rows: states, columns: samples (kept when asked)
    Eigen::MatrixXd observed;               // rows: asked variables, columns: samples
    SimulationFailure failure;
    GridPlan plan;
    Engine engine{Engine::Grid};
    /// What a reader should know though nothing failed: where a switch holds the model between its two sides.
    std::vector<Text> remarks;

    /// Marks the last samples as not reached: NaN.
    void leaveOpen(Eigen::Index samples);
};

/// What to simulate: one experiment of one system. The referenced objects must outlive the call.
struct SimulationTask {
    const System* system{};
    const SampledInputs* inputs{};   // rows in the order of system->inputs()
    std::vector<double> parameters;  // system->parameterCount()
    /// Directions in parameter space: parameterCount x K; K tangents are carried along. Empty: values only.
    Eigen::MatrixXd directions;
    bool keepStates{};
    std::vector<std::string> observe;  // variables to record at the samples
    Execution execution{};
};

/// Sees the samples of a simulation one after the other, where the whole of them would take too much memory.
class SampleSink {
public:
    virtual ~SampleSink() = default;
    /// Samples first, first + 1 … in rows of `layout` (RowLayout::tangent, value), of K directions.
    virtual void takeRows(int first, int count, const double* rows, const RowLayout& layout, int directions);
    /// Outputs at a sample and their tangents (outputs x K, row-major; null when K = 0).
    virtual void take(int sample, const double* y, const double* dy) = 0;
    /// All samples so far are void: they come again from the first one.
    virtual void restart() = 0;
};

/// Hands a trajectory on to a sink, from its first sample; outputs and tangents (K directions) are gone from it then.
void pour(Trajectory& trajectory, int directions, SampleSink& sink);

/// The plan an experiment needs at these parameters: explicit or implicit, and the number of substeps, from
/// step doubling (chosen once, rechecked at the optimum). A plan in force is returned when it still holds. `taken`:
/// receives the run with these steps, or finer ones, where the choice took one and the task asks for no more than its
/// outputs.
GridPlan planGrid(const SimulationTask& task, const SimulationOptions& options = {}, const Progress& progress = {},
                  const GridPlan* inForce = nullptr, std::optional<Trajectory>* taken = nullptr);

/// The plan of one explicit step from sample to sample, where these are known to be this exact; only what depends on
/// the inputs alone is looked up.
GridPlan singleSteps(const SimulationTask& task, double errorEstimate, const Progress& progress = {});

/// One pass with a given plan (grid engine), values and tangents together. Its tangents are those of the
/// discrete solution.
/// With a sink, outputs and tangents go there and are left out of the trajectory.
Trajectory simulateGrid(const SimulationTask& task, const GridPlan& plan, const SimulationOptions& options = {},
                        const Progress& progress = {}, SampleSink* sink = nullptr);

/// The variables asked for, as Trajectory::observed, of a run whose states (rows) at the samples (columns) are known.
/// Nothing: the model has other states, or what it delays must be run through.
std::optional<Eigen::MatrixXd> observeAlong(const SimulationTask& task, const Eigen::MatrixXd& states);

/// SUNDIALS CVODES between the true kinks of the inputs, with root finding for events: the reference.
/// Tangents, when asked for, by CVODES forward sensitivities.
Trajectory simulateAdaptive(const SimulationTask& task, const SimulationOptions& options = {},
                            const Progress& progress = {});

/// Which operation has no value where a simulation fails at these parameters, in which equation and at which values;
/// empty: none was found. It is simulated again up to there.
Text causeOf(const SimulationTask& task, const SimulationFailure& failure, const SimulationOptions& options = {},
             const Progress& progress = {});

/// Engine and plan chosen by the options.
Trajectory simulate(const SimulationTask& task, const SimulationOptions& options = {}, const Progress& progress = {});

}  // namespace analogon
