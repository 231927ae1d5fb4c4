#pragma once

#include <memory>
#include <optional>

#include "core/simulate/dynamics.hpp"
#include "core/simulate/simulate.hpp"

namespace analogon {

class Gaps;

/// A stretch of samples to run over with a plan.
struct GridRun {
    GridPlan plan;
    int first{};                 // sample to start at
    int last{-1};                // sample to end at; -1: the last one
    const double* startState{};  // null: the model's consistent start
    bool keepStates{};
    SampleSink* sink{};  // null: all goes into the trajectory
    bool isTrial{};      // nobody looks at it when it is cancelled
    const Gaps* gaps{};  // of the inputs; null: they are looked for when they are asked for

    /// Which part of the stretch up to `end` is done at a sample.
    double part(int sample, int end) const {
        return end > first ? static_cast<double>(sample - first) / (end - first) : 1.0;
    }
    /// Whether samples that were not reached are marked: in a long record that costs more than what was simulated.
    bool marksUnreached(const Progress& progress) const { return !isTrial || !progress.stopRequested(); }
};

/// One pass of the grid engine. Columns of the result are the samples first … last.
Trajectory runGrid(Dynamics& dynamics, const SampledInputs& inputs, const GridRun& run,
                   const SimulationOptions& options = {}, const Progress& progress = {});

/// The same by machine code, for exact steps and the classic Runge-Kutta method, and models without delays. False: not
/// possible, or a value was not finite; runGrid knows where and why.
bool runCompiled(Dynamics& dynamics, const SampledInputs& inputs, const GridRun& run, const SimulationOptions& options,
                 const Progress& progress, Trajectory& result);

/// The same where whole stretches of the record are one piece of machine code: no slots that jump at the samples, and
/// nothing but outputs and states to record. False as above.
bool runRows(Dynamics& dynamics, const SampledInputs& inputs, const GridRun& run, const SimulationOptions& options,
             const Progress& progress, Trajectory& result);

/// The terms of the inputs alone for runRows() with this plan; null: there are none, or no time to look them up.
std::shared_ptr<const InputTerms> tabulateTerms(Dynamics& dynamics, const SampledInputs& inputs, const GridPlan& plan,
                                                const Progress& progress);

/// The length of the sample intervals where all are the same, within rounding.
std::optional<double> equidistantStep(const SampledInputs& inputs);

/// Whether runCompiled() can take exact steps: the dynamics are made ready for them.
bool canBeExact(Dynamics& dynamics, const SampledInputs& inputs);

/// The cheapest plan whose outputs move by less than the tolerance when the steps are halved. `taken`: receives the run
/// with these steps, or finer ones, where the choice took one.
GridPlan choosePlan(Dynamics& dynamics, const SampledInputs& inputs, const SimulationOptions& options = {},
                    const Progress& progress = {}, const GridPlan* inForce = nullptr,
                    std::optional<Trajectory>* taken = nullptr);

/// The reference engine on the same abstraction.
Trajectory runAdaptive(Dynamics& dynamics, const SampledInputs& inputs, bool keepStates,
                       const SimulationOptions& options = {}, const Progress& progress = {});

}  // namespace analogon
