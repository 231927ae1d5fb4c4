#pragma once

#include <memory>
#include <optional>

#include "core/base/progress.hpp"
#include "core/effect/model/score.hpp"
#include "core/effect/model/variant.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using threshold::acceptance::equivalenceMargin;
using threshold::acceptance::largeResidual;
using threshold::acceptance::leastLike;
using threshold::acceptance::whiteSignificance;

/// How what is simulated beside a fitted model passes over the fitted experiments, one plan for each, and the states
/// of the model itself.
struct StepsBeside {
    /// Those of the fit, or, where it passes by its recurrence, those that the model would take without.
    std::vector<GridPlan> fine;
    std::vector<GridPlan> coarse;               // as coarse as will do for what is only compared
    std::vector<std::string> states;            // of the model whose parameters are held
    std::vector<Eigen::MatrixXd> atTheSamples;  // states (rows) at the samples of each experiment; empty: it failed
};

/// What the parameters of a fitted model leave of a trace, and its residual, with the noise made white.
struct ScoresBeside {
    OrthogonalProjector plain, white;
    Eigen::VectorXd whiteResidual;
};

/// Where a model had to be fitted from other start values than its own, which it cannot be simulated at.
struct OtherBeginning {
    std::vector<ParameterValue> values;  // that the first fit ended with
    Text remark;
};

/// A fitted model against which candidates are held: its residual, Jacobian and noise.
struct NullModel {
    Variant variant;
    FitResult fit;
    std::vector<Eigen::VectorXd> noise;  // standard deviation per recording and output of the system
    std::vector<ResidualChannel> channels;
    Whitener whitener;  // from the residual of this model
    double period{};    // [s] at which the residual repeats most strongly, see dominantPeriod
    std::optional<OtherBeginning> beginning;

    double sumOfSquares() const { return fit.optimum.residuals.squaredNorm(); }
    int parameterCount() const { return static_cast<int>(fit.estimates.size()); }

    /// Found when first asked for, by any thread.
    const StepsBeside& steps(const SimulationOptions& simulation, const Progress& progress) const;
    /// The plans of the fit, as they serve a system that does the same: a recurrence only where it is linear, too.
    std::vector<GridPlan> plansOf(const System& system, const SimulationOptions& simulation,
                                  const Progress& progress) const;

    /// The same, of the fit.
    const ScoresBeside& scores() const;
    /// Another variant and its fit, beside the same noise.
    NullModel with(Variant other, FitResult fitOfIt) const;

    struct FoundOnce;
    static std::shared_ptr<FoundOnce> nothingYet();
    std::shared_ptr<FoundOnce> found{nothingYet()};  // what is found when first asked for; of this variant and fit
};

/// The period at which a residual repeats most strongly (peak of the periodogram of the innovations), at least twice
/// in a recording. [s]
double dominantPeriod(const NullModel& null);

/// Variables of a model whose parameters are held (`held`: of the same recordings) at the samples of the fitted
/// experiments: Trajectory::observed, in the order of `names`.
std::vector<Trajectory> observe(const NullModel& null, const PreparedTask& held, const std::vector<std::string>& names,
                                const SimulationOptions& simulation);

/// How exactly what is only compared is simulated.
SimulationOptions coarse(SimulationOptions simulation);

/// Whether a fit keeps the noise level it is given, or finds it anew from what it leaves.
enum class NoiseLevel { Keep, Estimate };

/// Fits a variant from its values. `noise`: standard deviations as in NullModel; empty: not known yet.
Outcome<NullModel> fitNull(const Variant& start, const std::vector<Eigen::VectorXd>& noise, NoiseLevel level,
                           const FitOptions& options, const Progress& progress);

/// The same from what `null` holds, which keeps the best values that were found where the fit is stopped
/// (core/base/stop).
Outcome<Done> fitNull(NullModel& null, NoiseLevel level, const FitOptions& options, const Progress& progress);

/// A variant fitted beside the noise of a model; nothing where that cannot be done.
std::optional<FitResult> fitBeside(const NullModel& null, const Variant& variant, const FitOptions& options,
                                   const Progress& progress);

/// What a fit leaves, in units of the noise.
double reducedChi(const FitResult& fit);

/// Whether a residual, in units of the noise, stands off by a good part of it and by more than chance: what stays the
/// same throughout has no autocorrelation, and is no noise for that.
bool standsOff(const Eigen::VectorXd& residual);

/// Whether a channel of a residual passes for white, but for what its converter rounds off; whether all do.
bool isNoise(const ResidualChannel& channel, const Eigen::VectorXd& residuals);
bool isNoise(const std::vector<ResidualChannel>& channels, const FitResult& fit);
bool isNoise(const NullModel& null);

/// Of the samples, those that speak for themselves: neighbours in a slow residual say the same, and beside much that
/// nothing explains a small part of it tells nothing apart (it is the model that is wrong there, not the noise).
double independentShare(const NullModel& null, const FitResult& fit);

/// What a model leaves above the noise, as a sum of squares.
double excess(const NullModel& null);

/// Sum of squares that a model leaves, in units of the noise that another one stands beside.
double sumInUnitsOf(const NullModel& units, const NullModel& model);

/// Smallest noise of a fitted channel over the range of its measurement.
double quietest(const NullModel& null);

/// Whether the data fix the strength of an effect: a standard error, and so many of them less than the value.
bool isDetermined(const NullModel& null, std::size_t effect);
bool isDetermined(const PlacedEffect& effect, const std::vector<FitEstimate>& estimates, double deviations = 1);

/// Whether a parameter of the model itself is not determined either: all of them may then be known but for a common
/// factor, and the standard error of an effect's strength tells nothing.
bool isScaleOpen(const PlacedEffect& effect, const std::vector<FitEstimate>& estimates);

/// Whether an equation without a name is among the effects of the model.
bool hasProposal(const NullModel& null);

}  // namespace analogon
