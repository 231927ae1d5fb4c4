#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <cmath>
#include <optional>

#include "core/fit/misfit.hpp"

namespace analogon {

namespace {

/// Levenberg (1944) and Marquardt (1963) in coordinates z with bounds: the damping follows Nielsen (IMM-REP-1999-05),
/// the scale of each coordinate is the largest its column has had (Moré 1978). A step is projected into the bounds and
/// judged there; what presses against a bound is held for that step. A bent valley is followed with the geodesic
/// acceleration of Transtrum and Sethna (2012, arXiv:1201.5885): a step is a parabola, whose bend one simulation shows.
class LevenbergMarquardt {
public:
    LevenbergMarquardt(Misfit& misfit, const Coordinates& coordinates, const FitOptions& options, int iterationsLeft,
                       bool beginsNear, std::optional<double> dampingInValley)
        : misfit_(misfit),
          coordinates_(coordinates),
          options_(options),
          iterationsLeft_(iterationsLeft),
          beginsNear_(beginsNear),
          K_(coordinates.size()) {
        if (beginsNear) damping_ = 1e-8;  // the slopes hold as far as the optimum
        if (dampingInValley) damping_ = *dampingInValley;
        isInValley_ = dampingInValley && options.goesOnInValleys;
        z_ = lower_ = upper_ = scale_ = Eigen::VectorXd::Zero(K_);
        for (int i = 0; i < K_; ++i) {
            lower_[i] = coordinates.lower(i);
            upper_[i] = coordinates.upper(i);
        }
    }

    Minimum run() {
        Minimum minimum;
        here_ = misfit_.reduced(coordinates_.values(z_));
        while (!isOver(minimum)) {
            if (!descend(minimum)) break;
            ++iterations_;
        }
        minimum.iterations = iterations_;
        if (isInValley_) minimum.dampingInValley = damping_;
        minimum.values = misfit_.hasBest() ? misfit_.best() : coordinates_.values(z_);
        minimum.cost = misfit_.bestCost();
        for (int i = 0; i < K_; ++i) minimum.atBound.push_back(z_[i] <= lower_[i] || z_[i] >= upper_[i]);
        return minimum;
    }

private:
    /// Slopes, gradient and what is held at the point reached; true when the search ends here.
    bool isOver(Minimum& minimum) {
        const auto end = [&](FitStatus status, Text message) {
            minimum.status = status;
            minimum.message = std::move(message);
            return true;
        };
        if (misfit_.isCancelled())
            return end(FitStatus::Cancelled, phrase("cancelled; the best parameters so far are kept"));
        if (!here_.ok) return end(FitStatus::Failed, misfit_.failure());
        misfit_.report(phrase("iteration {}", iterations_), iterations_ / static_cast<double>(options_.maxIterations));
        slopes_ = here_.jacobian * coordinates_.slopes(coordinates_.values(z_)).asDiagonal();
        gradient_ = slopes_.transpose() * here_.residuals;
        scale_ = scale_.cwiseMax(slopes_.colwise().norm().transpose());
        free_.clear();
        for (int i = 0; i < K_; ++i) {
            const bool presses =
                (z_[i] <= lower_[i] && gradient_[i] >= 0.0) || (z_[i] >= upper_[i] && gradient_[i] <= 0.0);
            if (!presses && scale_[i] > 0.0) free_.push_back(i);
        }
        if (free_.empty())
            return end(FitStatus::Converged,
                       gradient_.isZero(0.0) ? phrase("converged") : phrase("all parameters rest at their bounds"));
        const double cost = here_.cost();
        if (misfit_.isRounding(cost)) return end(FitStatus::Converged, phrase("converged"));
        const Eigen::VectorXd full = step(1e-12);
        expected_ = predictedFall(full);
        full_ = full;
        // what is flat to a coarse tolerance is not yet the end of a valley
        const double tolerance = isInValley_ ? std::min(options_.costTolerance, 1e-6) : options_.costTolerance;
        if (expected_ <= tolerance * cost || isWithin(full, 1e-12))
            return end(FitStatus::Converged, phrase("converged"));
        if (mayStepUnseen(full)) {
            misfit_.stepUnseen(coordinates_.values(z_), coordinates_.values(z_ + full));
            z_ += full;
            return end(FitStatus::Converged, phrase("converged"));
        }
        if (flatSteps_ >= 3 && expected_ <= 1e-6 * cost) return end(FitStatus::Converged, phrase("converged"));
        minimum.isAtKink = isCreeping();
        if (flatSteps_ >= 8 || minimum.isAtKink)
            return end(FitStatus::IterationLimit,
                       phrase("stopped after {} iterations in a flat valley: the cost hardly falls any more, and the "
                              "parameters still move",
                              iterations_));
        if (iterations_ >= iterationsLeft_)
            return end(FitStatus::IterationLimit,
                       phrase("stopped at the limit of {} iterations while the cost still fell", iterations_));
        return false;
    }

    /// Damps until a step lowers the cost. Simulations that fail one after the other say little about how far the
    /// slopes hold: most of the damping they ask for is forgotten once one succeeds.
    bool descend(Minimum& minimum) {
        constexpr int mostTries = 60, many = 3, manyDamped = 3;
        const double little = beginsNear_ ? 1e-3 : 1e-6;  // of the cost: the next point is all but the optimum
        const double cost = here_.cost(), before = std::max(damping_, 1e-8);
        if (options_.goesOnInValleys && dampedSteps_ >= manyDamped && misfit_.mayKeepSlopes()) isInValley_ = true;
        misfit_.expectLast(expected_ <= little * cost || isInValley_);
        int failures = 0;
        for (int tries = 0; tries < mostTries && damping_ < 1e20; ++tries) {
            const Eigen::VectorXd straight = inside(z_ + limited(step(damping_)));
            const double predicted = predictedFall(straight - z_);
            const std::optional<Eigen::VectorXd> bend =
                isInValley_ && predicted > 0.0 ? bendAlong(straight - z_) : Eigen::VectorXd::Zero(K_);
            if (misfit_.isCancelled()) return true;
            if (bend && predicted > 0.0) {
                const Eigen::VectorXd there = inside(straight + *bend);
                const Eigen::VectorXd values = coordinates_.values(there);
                // slopes from differences take many simulations: only where the cost falls are they worth it
                const double known = misfit_.takesDifferences() || isInValley_ ? misfit_.cost(values) : 0.0;
                const bool rises = std::isfinite(known) && known >= cost;
                ReducedMisfit found;
                if (known < cost) found = misfit_.reduced(values);
                if (misfit_.isCancelled()) return true;
                const double fall = found.ok ? cost - found.cost() : -1.0;
                if (fall > 0.0) {
                    if (failures >= many) damping_ = before * std::cbrt(damping_ / before);
                    const double quality = 2.0 * fall / predicted - 1.0;
                    held_ = std::abs(quality - 1.0) <= 0.2 && predicted >= 0.9 * expected_ ? expected_ : 0.0;
                    damping_ = std::max(1e-12, damping_ * std::max(1.0 / 9.0, 1.0 - quality * quality * quality));
                    growth_ = 2.0;
                    if (failures == 0) flatSteps_ = fall <= options_.costTolerance * cost ? flatSteps_ + 1 : 0;
                    dampedSteps_ = predicted < 0.5 * expected_ ? dampedSteps_ + 1 : 0;
                    if (damping_ < 1.0) dampedCosts_.clear();
                    dampedCosts_.push_back(found.cost());
                    z_ = there;
                    here_ = found;
                    return true;
                }
                failures += !found.ok && !rises;
            }
            damping_ = std::max(damping_, isInValley_ ? 1e-12 : 1e-8) * growth_;
            if (failures < many) growth_ *= 2.0;
        }
        // Rounding, or a kink, hides the last digits of the cost.
        const bool isDone = expected_ <= 1e-8 * cost || isWithin(full_, 1e-8);
        minimum.isAtKink = !isDone && misfit_.failure().empty();
        minimum.status = isDone ? FitStatus::Converged : FitStatus::Failed;
        minimum.message = isDone                      ? phrase("converged")
                          : misfit_.failure().empty() ? phrase("no step lowers the cost")
                                                      : misfit_.failure();
        return false;
    }

    /// Along a kink (a body that sticks or slides) slopes hold for next to no step: the damping stays large however
    /// many steps succeed, and all of them together lower the cost by next to nothing.
    bool isCreeping() const {
        constexpr std::size_t many = 10;
        constexpr double nextToNothing = 1e-7;  // of the cost
        if (dampedCosts_.size() <= many) return false;
        return dampedCosts_[dampedCosts_.size() - 1 - many] - dampedCosts_.back() <=
               nextToNothing * dampedCosts_.back();
    }

    /// Half the acceleration that keeps a step in its valley, of the residuals' second derivative along it; nothing: it
    /// bends too much for the step to be that long.
    std::optional<Eigen::VectorXd> bendAlong(const Eigen::VectorXd& step) {
        constexpr double part = 0.1;   // of the step: the difference that shows the bend
        constexpr double most = 0.75;  // acceleration over step (eq. 15)
        const std::optional<Eigen::VectorXd> change =
            misfit_.slopesTimesChange(coordinates_.values(z_), coordinates_.values(z_ + part * step));
        if (!change) return Eigen::VectorXd::Zero(K_);
        const Eigen::VectorXd toZ = coordinates_.slopes(coordinates_.values(z_));
        const Eigen::VectorXd curvature =
            2.0 / (part * part) *
            (toZ.cwiseProduct(*change) - part * (slopes_.transpose() * (slopes_ * step)));  // Jᵀ d²r/dt²
        const auto count = static_cast<Eigen::Index>(free_.size());
        const Eigen::VectorXd scale = scale_(free_);
        Eigen::MatrixXd hessian = (slopes_.transpose() * slopes_)(free_, free_);
        hessian.array() /= (scale * scale.transpose()).array();
        hessian += damping_ * Eigen::MatrixXd::Identity(count, count);
        const Eigen::VectorXd scaled = -hessian.ldlt().solve(curvature(free_).cwiseQuotient(scale));
        if (!(scaled.norm() <= most * scale_.cwiseProduct(step).norm())) return std::nullopt;
        Eigen::VectorXd bend = Eigen::VectorXd::Zero(K_);
        bend(free_) = 0.5 * scaled.cwiseQuotient(scale);
        return bend;
    }

    Eigen::VectorXd inside(const Eigen::VectorXd& z) const { return z.cwiseMax(lower_).cwiseMin(upper_); }

    /// In a long record, after a full step that did what its slopes promised, a far smaller one will too: where the
    /// step after it would promise no more than the tolerance, a pass over all samples would only confirm it.
    bool mayStepUnseen(const Eigen::VectorXd& full) const {
        constexpr double nextToNothing = 1e-7;  // of the cost: the slopes there are those here
        const Eigen::VectorXd there = z_ + full;
        const bool isInside = (there.array() > lower_.array()).all() && (there.array() < upper_.array()).all();
        const double cost = here_.cost(), afterwards = expected_ * expected_ / held_;
        return beginsNear_ && held_ > 0.0 && isInside && !misfit_.takesDifferences() &&
               expected_ <= nextToNothing * cost && afterwards <= options_.costTolerance * cost;
    }

    /// Minimises |slopes z + residuals|² + damping |scale z|² over what is free.
    Eigen::VectorXd step(double damping) const {
        const auto count = static_cast<Eigen::Index>(free_.size()), rows = slopes_.rows();
        Eigen::MatrixXd stack = Eigen::MatrixXd::Zero(rows + count, count);
        Eigen::VectorXd right = Eigen::VectorXd::Zero(rows + count);
        for (Eigen::Index j = 0; j < count; ++j) {
            const int i = free_[static_cast<std::size_t>(j)];
            stack.col(j).head(rows) = slopes_.col(i) / scale_[i];
            stack(rows + j, j) = std::sqrt(damping);
        }
        right.head(rows) = -here_.residuals;
        const Eigen::VectorXd solution = stack.householderQr().solve(right);
        Eigen::VectorXd result = Eigen::VectorXd::Zero(K_);
        for (Eigen::Index j = 0; j < count; ++j) {
            const int i = free_[static_cast<std::size_t>(j)];
            result[i] = solution[j] / scale_[i];
        }
        return result;
    }

    /// No parameter grows or falls more than about fivefold in a step.
    Eigen::VectorXd limited(Eigen::VectorXd z) const {
        constexpr double most = 1.5;
        const Eigen::VectorXd values = coordinates_.values(z_), slopes = coordinates_.slopes(values);
        for (int i = 0; i < K_; ++i) {
            if (!coordinates_.isLogarithmic(i)) continue;
            const double perUnit = slopes[i] / values[i];
            z[i] = std::clamp(perUnit * z[i], -most, most) / perUnit;
        }
        return z;
    }

    double predictedFall(const Eigen::VectorXd& z) const {
        return -gradient_.dot(z) - 0.5 * (slopes_ * z).squaredNorm();
    }

    /// Whether a step changes no parameter by more than this part of it.
    bool isWithin(const Eigen::VectorXd& z, double part) const {
        const Eigen::VectorXd values = coordinates_.values(z_), slopes = coordinates_.slopes(values);
        return (slopes.cwiseProduct(z).array().abs() <= part * values.array().abs()).all();
    }

    Misfit& misfit_;
    const Coordinates& coordinates_;
    const FitOptions& options_;
    bool isInValley_{};
    int iterationsLeft_{}, iterations_{}, flatSteps_{};
    int dampedSteps_{};  // one after the other, each far from what a full one promises
    bool beginsNear_{};
    int K_{};
    double damping_{1e-3}, growth_{2.0}, expected_{};
    double held_{};                    // what a full step promised and did just now; 0: it did not
    std::vector<double> dampedCosts_;  // since the damping was last small
    Eigen::VectorXd z_, lower_, upper_, scale_, gradient_, full_;
    Eigen::MatrixXd slopes_;
    ReducedMisfit here_;
    std::vector<int> free_;
};

}  // namespace

Minimum levenbergMarquardt(Misfit& misfit, const Coordinates& coordinates, const FitOptions& options,
                           int iterationsLeft, bool beginsNear, std::optional<double> dampingInValley) {
    return LevenbergMarquardt(misfit, coordinates, options, iterationsLeft, beginsNear, dampingInValley).run();
}

}  // namespace analogon
