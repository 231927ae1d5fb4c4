#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/fit/problem.hpp"

namespace analogon {

/// Least squares by Levenberg-Marquardt (our own, or Ceres' for comparison), or searches without slopes by NLopt: near
/// the start (the paper's simplex, SBPLX, BOBYQA), or all over the bounds (controlled random search, improved
/// stochastic ranking, and the evolutionary search ESCH, which is the paper's outlook), ended by a simplex.
enum class FitMethod { LeastSquares, LeastSquaresByCeres, NelderMead, Sbplx, Bobyqa, Crs2, Isres, Esch };
/// Whether a method goes without slopes.
constexpr bool isDirect(FitMethod method) { return method >= FitMethod::NelderMead; }
enum class RobustLoss { None, Huber, Cauchy };

struct FitOptions {
    FitMethod method{FitMethod::LeastSquares};
    RobustLoss loss{RobustLoss::None};
    int maxIterations{100};       // least squares
    int maxSimulations{20000};    // methods without slopes
    double costTolerance{1e-10};  // relative fall of the cost at which the fit has converged
    int starts{1};                // > 1: further starts from a Latin hypercube within the bounds, best one kept
    double startsWithin{};        // > 1: these lie within this factor of the start values, of whatever bounds
    /// > 0: where the model cannot be simulated at its start values, so many others from the Latin hypercube are looked
    /// at, and the fit begins at the best of them.
    int otherStarts{};
    std::uint64_t seed{1};
    int threads{1};
    bool beginsWithPart{
        true};  // long records: least squares goes most of the way on a part (core/fit/partial_records.hpp)
    /// False: FitResult::optimum stays empty; the fit then needs no memory that grows with the record.
    bool keepsOptimum{true};
    /// Where the misfit has kinks the fit goes on without slopes (core/fit/kink.hpp).
    bool goesOnAtKinks{};
    /// A flat valley in which the coarse steps of the beginning end is followed with fine ones.
    bool goesOnInValleys{};
    /// > 0: least squares takes its last steps with an integration error of at most this share of the scatter of the
    /// residuals, where the tolerances ask for less; the misfit is then its minimum but for a share of the square.
    double integrationShare{};
    /// Fills FitEstimate::robustError (keepsOptimum must hold).
    bool findsRobustErrors{};
    SimulationOptions simulation;

    /// The same without what only a fit that stands alone is worth: fits that are compared with each other, or lead to
    /// another one, all end where their slopes do.
    FitOptions besideOthers() const {
        FitOptions options = *this;
        options.goesOnAtKinks = options.goesOnInValleys = false;
        options.integrationShare = 0;
        return options;
    }
};

enum class FitStatus { Converged, IterationLimit, Cancelled, Failed };

/// Where the profile of the likelihood crosses the 95 % threshold (core/fit/profile.hpp).
struct ConfidenceInterval {
    double lower{}, upper{};            // as far as was looked where the threshold is not crossed
    bool isOpenBelow{}, isOpenAbove{};  // it is not crossed on that side
    std::vector<double> values, rises;  // the profile: fall of twice the log-likelihood from the optimum
    std::string remark;                 // what a reader should know: "these data set no upper limit …"
};

/// What one parameter came to.
struct FitEstimate {
    std::string name;
    std::string unit;
    double value{};
    double standardError{};  // NaN when the data do not determine it
    bool atBound{};
    int experiment{-1};
    double robustError{std::numeric_limits<double>::quiet_NaN()};  // holds for residuals correlated in time, too
    std::optional<ConfidenceInterval> interval{};                  // where it was asked for
    std::optional<NormalPrior> prior{};                            // what was known of it
    /// Where the robust error has taken the place of the standard error: what this would be of white residuals.
    double whiteError{std::numeric_limits<double>::quiet_NaN()};
};

struct FitResult {
    FitStatus status{FitStatus::Failed};
    Text message;  // why it stopped, for people
    std::vector<FitEstimate> estimates;
    Eigen::VectorXd values;
    Eigen::MatrixXd covariance;  // of the values; NaN rows where not determined
    Eigen::MatrixXd correlation;
    double cost{};       // 1/2 sum of squares, priors among them
    double variance{1};  // of a weighted residual, as the standard errors take it
    double scatter{1};   // of a weighted residual, as the priors weigh against it
    /// What fits compare by: the cost, or, where priors weighed against a scatter that each found itself, the negative
    /// logarithm of the posterior.
    double objective{};
    double startCost{};  // NaN where the fit began with a part of the records: nobody has simulated all from there
    int iterations{};
    int simulations{};  // of all records
    int failedSimulations{};
    int partIterations{}, partSimulations{};  // before them, of parts of the records
    double seconds{};                         // that it took
    Linearisation optimum;                    // residuals, Jacobian, trajectories at the optimum
    std::vector<GridPlan> plans;
    bool takesDifferences{};    // the tangents of this model mislead (core/fit/difference_slopes.hpp)
    bool beganElsewhere{};      // the model cannot be simulated at its start values (FitOptions::otherStarts)
    std::vector<Text> remarks;  // "R and k only appear as k/R here: fix one"

    /// nullptr: not fitted. `experiment`: -1 of a parameter that all share.
    const FitEstimate* find(const std::string& name, int experiment = -1) const;
};

/// Checks the problem before it starts: bounds in order, start inside, no empty data.
Diagnostics validate(const FitProblem& problem);

/// Levenberg-Marquardt (Ceres) in bounded and logarithmic coordinates, or the paper's Nelder-Mead (NLopt).
/// Never throws and never aborts: a failed simulation costs one step.
FitResult fit(const FitProblem& problem, const FitOptions& options = {}, const Progress& progress = {});

/// Error figures of one output (contract, section 6). NaN samples are left out.
struct ErrorFigures {
    double rmse{};
    /// 100 RMSE / (max - min of the measured channel); of a channel that stands still, over its magnitude. NaN: it is 0
    /// throughout, and only the RMSE tells anything.
    double errorPercent{};
    double relativeRmsPercent{};  // 100 |y - m| / |m|
    double fitPercent{};          // 100 (1 - |y - m| / |m - mean m|)
    double maxAbs{};

    /// Whether there is something that an error in percent could be a part of.
    bool hasScale() const { return !(std::isnan(errorPercent) && std::isfinite(rmse)); }
};
ErrorFigures errorFigures(const Eigen::Ref<const Eigen::RowVectorXd>& simulated,
                          const Eigen::Ref<const Eigen::RowVectorXd>& measured);

/// Error of several outputs or experiments (contract, section 6): the root of their mean square over those that
/// `counts` does not leave out; 0 of none, NaN where all are left out.
template <class Parts, class ErrorOf, class Counts>
double meanError(const Parts& parts, ErrorOf errorOf, Counts counts) {
    double squares = 0;
    int count = 0;
    for (const auto& part : parts) {
        if (!std::invoke(counts, part)) continue;
        const double each = std::invoke(errorOf, part);
        squares += each * each;
        ++count;
    }
    return std::empty(parts) ? 0 : std::sqrt(squares / count);
}

}  // namespace analogon
