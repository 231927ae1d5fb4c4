#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/fit/coordinates.hpp"
#include "core/fit/fit.hpp"
#include "core/fit/priors.hpp"
#include "core/fit/reduced_misfit.hpp"

namespace analogon {

/// How much larger the integration error may be where a fit is still far from its optimum.
inline constexpr double farLooseness = 30.0;

/// The misfit of a problem as its minimisers see it: counts what it costs, remembers the best point, survives
/// failed simulations. One object a run; not shared between threads.
class Misfit {
public:
    Misfit(const FitProblem& problem, const FitOptions& options, const Progress& progress);

    /// Residuals and Jacobian (in own units) squeezed into a triangle; the last few points are remembered.
    const ReducedMisfit& reduced(const Eigen::VectorXd& values);
    /// The same where it is remembered; null: it is not.
    const ReducedMisfit* remembered(const Eigen::VectorXd& values) const;
    /// Cost alone; +inf when the simulation failed.
    double cost(const Eigen::VectorXd& values);

    /// Grid plans for these parameters, with an integration error that much larger than the options ask for. What
    /// was in force is replaced: true when something changed.
    bool plan(const Eigen::VectorXd& values, double looseness = 1.0);
    /// Plans that were made elsewhere, with that looseness.
    void adopt(std::vector<GridPlan> plans, double looseness);
    /// As plan(), but only where these parameters need finer steps than those in force.
    bool refinePlan(const Eigen::VectorXd& values);
    /// Steps whose error is at most this share of the scatter of the residuals here; true when those in force were
    /// coarser.
    bool planWithin(double share, const Eigen::VectorXd& values);
    /// The next point is likely to be the optimum: its residuals and slopes are kept, where they are asked for, so that
    /// nobody has to simulate it again.
    void expectLast(bool isExpected) { isLast_ = isExpected; }
    /// Whether the slopes at the best point can be kept beside everything else.
    bool mayKeepSlopes() const;
    /// Jᵀ(r(to) - r(from)) in own units, with the slopes J at `from`; nothing: they were not kept, or there is no
    /// simulation there.
    std::optional<Eigen::VectorXd> slopesTimesChange(const Eigen::VectorXd& from, const Eigen::VectorXd& to);
    /// Goes from one point that is remembered to another so close to it that its slopes tell what is met there.
    void stepUnseen(const Eigen::VectorXd& from, const Eigen::VectorXd& to);
    /// Robust losses are measured against the scatter of the residuals here.
    void rescaleLoss(const Eigen::VectorXd& values);
    /// Priors weigh against the scatter of the residuals here; true when it has changed.
    bool rescalePriors(const Eigen::VectorXd& values);

    bool hasBest() const { return bestCost_ < std::numeric_limits<double>::infinity(); }
    const Eigen::VectorXd& best() const { return best_; }
    double bestCost() const { return bestCost_; }
    /// What was simulated at the best point; not ok when only its cost is known or a robust loss has changed it.
    Linearisation takeBestLinearisation() { return std::move(bestLine_); }
    /// Costs under another plan or loss do not compare.
    void forgetBest();

    /// Whether the slopes here promise far more than changes of the parameters do (core/fit/difference_slopes.hpp).
    bool slopesMislead(const Eigen::VectorXd& values);
    /// From here on slopes are differences.
    void takeDifferences();
    bool takesDifferences() const { return takesDifferences_; }

    const std::vector<GridPlan>& plans() const { return plans_; }
    int simulations() const { return simulations_; }
    int failedSimulations() const { return failedSimulations_; }
    const Text& failure() const { return failure_; }  // of the last simulation that failed
    double lossScale() const { return lossScale_; }
    double scatter() const { return scatter_; }  // against which priors weigh
    /// Whether no more than rounding is left at this cost.
    bool isRounding(double cost) const { return cost <= 0.5 * rounding_ * rounding_; }
    bool isCancelled() const { return progress_.stopRequested(); }
    /// How far a minimiser is, with the best values so far.
    void report(Text detail, double fraction) const;

private:
    struct Point {
        Eigen::VectorXd values;
        ReducedMisfit reduced;
    };
    void evaluate(const Eigen::VectorXd& values, ReducedMisfit& reduced);
    void evaluateSlopes(const Eigen::VectorXd& values, ReducedMisfit& reduced);
    bool arousesDoubt(const Eigen::VectorXd& values, const ReducedMisfit& reduced) const;
    bool mislead(const Eigen::VectorXd& values, const ReducedMisfit& reduced);
    Linearisation simulate(const Eigen::VectorXd& values, bool withJacobian, MisfitSums* sums = nullptr);
    /// Without a robust loss and in records of some length, sums do where they are exact enough.
    bool maySumUp() const;
    bool isLimited() const;
    bool summed(const Eigen::VectorXd& values, ReducedMisfit& reduced);
    std::optional<ReducedMisfit> squeezed(MisfitSums& sums, const Eigen::VectorXd& values);
    PriorResiduals priorsAt(const Eigen::VectorXd& values) const { return priorResiduals(problem_, values, scatter_); }
    template <class Evaluate>
    auto attempt(const Eigen::VectorXd& values, const Evaluate& evaluate);
    MisfitSums sum(const Eigen::VectorXd& values, bool withJacobian);
    void applyLoss(Eigen::VectorXd& residuals, Eigen::MatrixXd* jacobian) const;
    void note(const Eigen::VectorXd& values, double cost, Linearisation line = {});
    std::vector<GridPlan> plansFor(const Eigen::VectorXd& values, double looseness,
                                   GridMethod method = GridMethod::Auto) const;
    bool take(std::vector<GridPlan> plans);

    const FitProblem& problem_;
    const FitOptions& options_;
    const Progress& progress_;
    std::vector<GridPlan> plans_;
    double plannedWith_{1};        // looseness of plans_
    std::array<Point, 6> memory_;  // a line search comes back to points
    std::size_t oldest_{};
    Eigen::VectorXd best_;
    double bestCost_{std::numeric_limits<double>::infinity()};
    Linearisation bestLine_;
    double lossScale_{1};
    double scatter_{1};
    bool isLong_{};  // and every output can be summed up sample by sample
    bool isIllConditioned_{}, isLast_{};
    bool maySwitch_{}, takesDifferences_{};
    int doubts_{}, misled_{};  // how often slopes were looked at, and were wrong
    double signal_{};          // the size of the data, in residuals
    double rounding_{};        // what it leaves of them
    int threads_{1};
    int simulations_{}, failedSimulations_{};
    Text failure_;
};

/// What one run of a minimiser came to.
struct Minimum {
    FitStatus status{FitStatus::Failed};
    Text message;
    Eigen::VectorXd values;
    double cost{std::numeric_limits<double>::infinity()};
    std::vector<bool> atBound;
    int iterations{};
    bool isAtKink{};                        // the slopes promise a fall that no step along them brings
    std::optional<double> dampingInValley;  // of Levenberg-Marquardt, where it followed a bent valley
};

/// Levenberg-Marquardt of our own (near the optimum it begins with the full Gauss-Newton step, in a valley that was
/// followed before with the damping that was left); the same by Ceres with an active set for the bounds.
Minimum levenbergMarquardt(Misfit& misfit, const Coordinates& coordinates, const FitOptions& options,
                           int iterationsLeft, bool beginsNear, std::optional<double> dampingInValley = {});
Minimum leastSquares(Misfit& misfit, Coordinates& coordinates, const FitOptions& options, int iterationsLeft);
/// The simplex of Nelder and Mead (1965), the 2014 paper's method, restarted until it stays where it is.
Minimum directSearch(Misfit& misfit, Coordinates& coordinates, const FitOptions& options);

}  // namespace analogon
