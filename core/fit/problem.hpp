#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/simulate/simulate.hpp"

namespace analogon {

enum class ParameterScale { Automatic, Linear, Logarithmic };

/// What was known of a parameter beforehand: normally distributed in its own unit, on whatever scale it is searched.
struct NormalPrior {
    double mean{};
    double deviation{};  // standard deviation, > 0

    static constexpr double contradiction = 3.0;  // standard deviations beyond which data and prior contradict

    /// How many standard deviations a value lies from the mean.
    double distance(double value) const { return (value - mean) / deviation; }
    friend bool operator==(const NormalPrior&, const NormalPrior&) = default;
};

/// One unknown of a fit. Its value enters the system parameter of the same name in every experiment, or, when
/// `experiment` >= 0, in that one alone (a fitted start value).
struct FitParameter {
    std::string name;
    std::string unit;
    double start{};
    double min{-1e300};
    double max{1e300};
    ParameterScale scale{ParameterScale::Automatic};  // automatic: logarithmic where min > 0 and max/min > 10
    int experiment{-1};
    std::optional<NormalPrior> prior{};
};

/// The clock of one output's own logger, ahead by this; a fit parameter of the name clockOf(output) overrides it.
struct ChannelClock {
    int output{};
    double offset{};  // [s]
};

/// One recording against which the system is simulated.
struct FitExperiment {
    std::string name;
    SystemPtr system;
    SampledInputs inputs;
    Eigen::MatrixXd measured;            // rows: system outputs, columns: samples; NaN: not measured there
    Eigen::VectorXd weights;             // per output: 1/sigma (0: output is not fitted)
    std::vector<double> parameters;      // the system's parameters; fitted ones are overwritten
    bool isInterpreted{};                // never run machine code
    std::vector<ChannelClock> clocks{};  // of the outputs that do not share the clock of the inputs

    bool isFitted(Eigen::Index output) const { return output < weights.size() && weights[output] > 0.0; }
    /// Samples at which this output was measured.
    Eigen::Index measuredCount(Eigen::Index output) const;
    bool hasGaps(Eigen::Index output) const { return measuredCount(output) != measured.cols(); }
    /// Samples of all outputs that are fitted.
    Eigen::Index residualCount() const;
};

/// minimise 1/2 sum ((y - measured) * weight)^2 over all experiments, outputs and samples
/// (mean square error, eqs. 11 to 13 of the 2014 paper, with one weight per channel), plus one more square
/// (scatter * (p - mean) / deviation)^2 for each parameter with a prior.
struct FitProblem {
    std::vector<FitExperiment> experiments;
    std::vector<FitParameter> parameters;
    /// The weights are 1 / (standard deviation of the noise). False: they only balance the channels, so the
    /// scatter is judged by the residuals themselves.
    bool weightsAreNoise{true};
    /// Standard deviation of a weighted residual, against which priors weigh. 0: the fit finds it (1 where the weights
    /// are the noise and the model leaves no more than that).
    double scatter{};
    /// Steps that served near the start before, one an experiment: judged before they are taken. Empty: none are known.
    std::vector<GridPlan> knownPlans{};
    /// Sees every simulation before it runs, from any thread: may change it, or refuse it by throwing.
    std::function<void(SimulationTask&, SimulationOptions&)> beforeSimulation{};

    int residualCount() const;            // measured values that are not NaN, with weight > 0
    Eigen::VectorXd startValues() const;  // of the parameters
    bool hasPriors() const;
    bool hasClocks() const;
    const GridPlan* knownPlan(int experiment) const;  // null: none
};

/// All residuals and, when asked, their Jacobian with respect to the parameters in their own units (not
/// transformed) at a point. Rows in the order experiment, output, sample; unmeasured values are left out.
struct Linearisation {
    bool ok{};
    Eigen::VectorXd residuals;             // weight * (simulated - measured)
    Eigen::MatrixXd jacobian;              // rows: residuals, columns: parameters
    std::vector<Trajectory> trajectories;  // one per experiment, without tangents
    Text failure;                          // which experiment, when, which variable
};

/// The simulation of one experiment with its own parameters; it must outlive the task.
SimulationTask taskOf(const FitExperiment& experiment);

/// The grid plan of one experiment at these values of the fit parameters.
GridPlan planFor(const FitProblem& problem, int experiment, const Eigen::VectorXd& values,
                 const SimulationOptions& options = {}, const Progress& progress = {},
                 const GridPlan* inForce = nullptr);
/// The plan of one explicit step from sample to sample, which is known to be this exact.
GridPlan singleStepsFor(const FitProblem& problem, int experiment, const Eigen::VectorXd& values, double errorEstimate,
                        const Progress& progress = {});

/// Why one experiment cannot be simulated at these values of the fit parameters: causeOf().
Text causeOf(const FitProblem& problem, int experiment, const Eigen::VectorXd& values, const SimulationFailure& failure,
             const SimulationOptions& options = {}, const Progress& progress = {});
/// Which experiment cannot be simulated at these values, when, and why; empty: all can.
Text failureAt(const FitProblem& problem, const Eigen::VectorXd& values, const SimulationOptions& options = {},
               const Progress& progress = {});

/// What a least-squares step needs of all residuals r and their Jacobian J, without keeping them.
struct MisfitSums {
    bool ok{};
    Eigen::MatrixXd hessian;   // JᵀJ
    Eigen::VectorXd gradient;  // Jᵀr
    double squares{};          // rᵀr
    Text failure;
};

/// `plans`: one per experiment, from planFor; empty: made here. `sums`: filled on the way as by sumUp(), where that is
/// possible. Experiments run side by side on up to `threads` threads; the result does not depend on their number.
Linearisation linearise(const FitProblem& problem, const Eigen::VectorXd& values, bool withJacobian,
                        const std::vector<GridPlan>& plans, const SimulationOptions& options = {},
                        const Progress& progress = {}, MisfitSums* sums = nullptr, int threads = 1);

/// As linearise(), sample by sample (not for the adaptive engine, nor for clocks of their own).
MisfitSums sumUp(const FitProblem& problem, const Eigen::VectorXd& values, bool withJacobian,
                 const std::vector<GridPlan>& plans, const SimulationOptions& options = {},
                 const Progress& progress = {}, int threads = 1);

}  // namespace analogon
