#include <ceres/ceres.h>

#include <cmath>
#include <memory>

#include "core/fit/misfit.hpp"

namespace analogon {

namespace {

/// The reduced misfit as one residual block over one block per coordinate, so that single coordinates can be held.
class ReducedCost final : public ceres::CostFunction {
public:
    ReducedCost(Misfit& misfit, const Coordinates& coordinates) : misfit_(misfit), coordinates_(coordinates) {
        const int K = coordinates.size();
        set_num_residuals(K + 1);
        mutable_parameter_block_sizes()->assign(static_cast<std::size_t>(K), 1);
    }

    bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
        const int K = coordinates_.size();
        Eigen::VectorXd z(K);
        for (int i = 0; i < K; ++i) z[i] = *parameters[i];
        const Eigen::VectorXd values = coordinates_.values(z);  // projected into the bounds
        // Slopes at every trial step: nearly all are accepted, and then they are at hand.
        const ReducedMisfit& reduced = misfit_.reduced(values);
        if (!reduced.ok) return false;
        Eigen::Map<Eigen::VectorXd>(residuals, K + 1) = reduced.residuals;
        if (!jacobians) return true;
        Eigen::VectorXd slopes = coordinates_.slopes(values);
        for (int i = 0; i < K; ++i) {
            if (z[i] < coordinates_.lower(i) || z[i] > coordinates_.upper(i)) slopes[i] = 0.0;
            if (jacobians[i]) Eigen::Map<Eigen::VectorXd>(jacobians[i], K + 1) = slopes[i] * reduced.jacobian.col(i);
        }
        return true;
    }

private:
    Misfit& misfit_;
    const Coordinates& coordinates_;
};

/// Levenberg-Marquardt in coordinates z with bounds. A step is cut at the bounds by projection and judged there.
/// (Ceres' own bounds search along each step instead of shrinking the region, which takes three times as many
/// simulations in a curved valley.) What presses against a bound is held (active set) and let go when the gradient
/// pulls it back.
class BoundedMinimiser final : public ceres::IterationCallback {
public:
    BoundedMinimiser(Misfit& misfit, Coordinates& coordinates, const FitOptions& options, int iterationsLeft)
        : misfit_(misfit), coordinates_(coordinates), options_(options), iterationsLeft_(iterationsLeft) {
        const int K = coordinates.size();
        z_ = lower_ = upper_ = Eigen::VectorXd::Zero(K);
        for (int i = 0; i < K; ++i) {
            lower_[i] = coordinates.lower(i);
            upper_[i] = coordinates.upper(i);
        }
        isHeld_.assign(static_cast<std::size_t>(K), false);
    }

    Minimum run() {
        Minimum minimum;
        for (bool isFirst = true; isFirst || iterations_ < iterationsLeft_; isFirst = false) {
            const bool changed = updateHeld(!isFirst && !leftBounds_);
            if (!isFirst && !changed && !leftBounds_) break;
            leftBounds_ = false;
            solve(minimum);
            z_ = z_.cwiseMax(lower_).cwiseMin(upper_);
            if (minimum.status != FitStatus::Converged) break;
        }
        if (leftBounds_ && minimum.status == FitStatus::Converged) minimum.status = limit(minimum.message);
        minimum.iterations = iterations_;
        minimum.values = misfit_.hasBest() ? misfit_.best() : coordinates_.values(z_);
        minimum.cost = misfit_.bestCost();
        for (int i = 0; i < coordinates_.size(); ++i) minimum.atBound.push_back(boundSide(i) != 0);
        return minimum;
    }

    ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
        if (misfit_.isCancelled()) return ceres::SOLVER_ABORT;
        misfit_.report(phrase("iteration {}", iterations_ + summary.iteration),
                       (iterations_ + summary.iteration) / static_cast<double>(options_.maxIterations));
        radius_ = summary.trust_region_radius;
        if (summary.iteration > 0 && ((z_.array() < lower_.array()) || (z_.array() > upper_.array())).any()) {
            leftBounds_ = true;
            return ceres::SOLVER_TERMINATE_SUCCESSFULLY;
        }
        return ceres::SOLVER_CONTINUE;
    }

private:
    /// -1 at the lower bound, 1 at the upper, else 0.
    int boundSide(int i) const {
        if (z_[i] <= lower_[i]) return -1;
        return z_[i] >= upper_[i] ? 1 : 0;
    }

    /// Gradient in z at the current point; empty when it could not be evaluated.
    Eigen::VectorXd gradient() {
        const Eigen::VectorXd values = coordinates_.values(z_);
        const ReducedMisfit& reduced = misfit_.reduced(values);
        if (!reduced.ok) return {};
        return reduced.gradient().cwiseProduct(coordinates_.slopes(values));
    }

    /// Holds what presses outward, lets go what is pulled inward. True when something changed.
    bool updateHeld(bool mayRelease) {
        const Eigen::VectorXd slope = gradient();
        bool changed = false;
        for (int i = 0; i < slope.size(); ++i) {
            const auto index = static_cast<std::size_t>(i);
            const bool presses = boundSide(i) != 0 && boundSide(i) * slope[i] < 0.0;
            if (!isHeld_[index] && presses) {
                isHeld_[index] = changed = true;
            } else if (isHeld_[index] && mayRelease && boundSide(i) * slope[i] > 0.0 && !wasReleased(index)) {
                isHeld_[index] = false;
                released_.push_back(index);
                changed = true;
            }
        }
        return changed;
    }

    /// Each coordinate is let go twice at most: no endless round between two faces.
    bool wasReleased(std::size_t i) const { return std::count(released_.begin(), released_.end(), i) >= 2; }

    /// Ceres shrinks its region ever faster while evaluations fail, until it gives up or takes the shortness of its
    /// steps for convergence: then it begins again from where it got to.
    void solve(Minimum& minimum) {
        constexpr int mostRestarts = 30;
        for (int restarts = 0; restarts <= mostRestarts; ++restarts) {
            const int failedBefore = misfit_.failedSimulations();
            solveOnce(minimum);
            if (misfit_.failedSimulations() == failedBefore || misfit_.isCancelled()) return;
            radius_ = wide_;
        }
    }

    void solveOnce(Minimum& minimum) {
        const int K = coordinates_.size();
        if (std::all_of(isHeld_.begin(), isHeld_.end(), [](bool held) { return held; })) {
            minimum.status = FitStatus::Converged;
            minimum.message = phrase("all parameters rest at their bounds");
            return;
        }
        ceres::Problem::Options ownership;
        ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
        ReducedCost cost(misfit_, coordinates_);
        ceres::Problem problem(ownership);
        std::vector<double*> blocks;
        for (int i = 0; i < K; ++i) blocks.push_back(&z_[i]);
        problem.AddResidualBlock(&cost, nullptr, blocks);
        for (int i = 0; i < K; ++i) {
            if (isHeld_[static_cast<std::size_t>(i)]) problem.SetParameterBlockConstant(&z_[i]);
        }
        ceres::Solver::Options options;
        options.minimizer_type = ceres::TRUST_REGION;
        options.trust_region_strategy_type = ceres::LEVENBERG_MARQUARDT;
        options.linear_solver_type = ceres::DENSE_QR;
        options.logging_type = ceres::SILENT;
        options.num_threads = 1;
        options.max_num_iterations = std::max(1, iterationsLeft_ - iterations_);
        options.max_num_consecutive_invalid_steps = 60;
        options.function_tolerance = options_.costTolerance;
        options.parameter_tolerance = 1e-11;
        options.gradient_tolerance = 1e-14;
        options.initial_trust_region_radius = std::clamp(radius_, 1e-2, 1e12);
        options.update_state_every_iteration = true;
        options.callbacks.push_back(this);
        ceres::Solver::Summary summary;
        ceres::Solve(options, &problem, &summary);
        iterations_ += static_cast<int>(summary.iterations.empty() ? 0 : summary.iterations.size() - 1);
        judge(summary, minimum);
    }

    FitStatus limit(Text& message) const {
        message = phrase("stopped at the limit of {} iterations while the cost still fell", iterations_);
        return FitStatus::IterationLimit;
    }

    void judge(const ceres::Solver::Summary& summary, Minimum& minimum) const {
        if (misfit_.isCancelled()) {
            minimum.status = FitStatus::Cancelled;
            minimum.message = phrase("cancelled; the best parameters so far are kept");
        } else if (summary.termination_type == ceres::CONVERGENCE || summary.termination_type == ceres::USER_SUCCESS) {
            minimum.status = FitStatus::Converged;
            minimum.message = phrase("converged");
        } else if (summary.termination_type == ceres::NO_CONVERGENCE) {
            minimum.status = limit(minimum.message);
        } else if (misfit_.isRounding(misfit_.bestCost())) {
            minimum.status = FitStatus::Converged;
            minimum.message = phrase("converged");
        } else {
            minimum.status = FitStatus::Failed;
            minimum.message = misfit_.failure().empty() ? phrase("no step lowers the cost") : misfit_.failure();
        }
    }

    Misfit& misfit_;
    Coordinates& coordinates_;
    const FitOptions& options_;
    int iterationsLeft_{}, iterations_{};
    static constexpr double wide_ = 1e4;
    double radius_{wide_};
    Eigen::VectorXd z_, lower_, upper_;
    std::vector<bool> isHeld_;
    std::vector<std::size_t> released_;
    bool leftBounds_{};
};

}  // namespace

Minimum leastSquares(Misfit& misfit, Coordinates& coordinates, const FitOptions& options, int iterationsLeft) {
    return BoundedMinimiser(misfit, coordinates, options, iterationsLeft).run();
}

}  // namespace analogon
