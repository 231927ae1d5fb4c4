#include "core/fit/uncertainty.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

namespace analogon {

namespace {

// Directions that change the residuals less than this, against the best determined one with all columns scaled to
// the same length, are not determined.
constexpr double kNull = 1e-7;

/// A basis of the same space with as few parameters in each direction as can be: reduced row echelon form.
Eigen::MatrixXd sparseBasis(Eigen::MatrixXd basis) {
    std::vector<bool> isPivot(static_cast<std::size_t>(basis.cols()), false);
    for (Eigen::Index r = 0; r < basis.rows(); ++r) {
        Eigen::Index pivotRow = r, pivot = 0;
        basis.bottomRows(basis.rows() - r).cwiseAbs().maxCoeff(&pivotRow, &pivot);
        pivotRow += r;
        if (std::abs(basis(pivotRow, pivot)) < 1e-12) break;
        basis.row(r).swap(basis.row(pivotRow));
        basis.row(r) /= basis(r, pivot);
        for (Eigen::Index i = 0; i < basis.rows(); ++i) {
            if (i != r) basis.row(i) -= basis(i, pivot) * basis.row(r);
        }
    }
    return basis;
}

}  // namespace

Uncertainty uncertaintyOf(const Eigen::MatrixXd& jacobian, double variance, const std::vector<std::string>& names) {
    const Eigen::Index K = jacobian.cols();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Uncertainty result;
    result.standardErrors = Eigen::VectorXd::Constant(K, nan);
    result.covariance = Eigen::MatrixXd::Constant(K, K, nan);
    result.correlation = Eigen::MatrixXd::Constant(K, K, nan);
    result.seen = Eigen::MatrixXd::Zero(K, K);

    std::vector<Eigen::Index> seen;  // parameters that change anything at all
    const Eigen::VectorXd lengths = jacobian.colwise().norm();
    for (Eigen::Index i = 0; i < K; ++i) {
        if (lengths[i] > 0.0 && std::isfinite(lengths[i])) {
            seen.push_back(i);
        } else {
            result.remarks.push_back(
                phrase("{} has no influence on what was measured here: fix it", names[static_cast<std::size_t>(i)]));
        }
    }
    if (seen.empty()) return result;

    const auto count = static_cast<Eigen::Index>(seen.size());
    Eigen::MatrixXd scaled(jacobian.rows(), count);
    for (Eigen::Index j = 0; j < count; ++j) {
        const Eigen::Index i = seen[static_cast<std::size_t>(j)];
        scaled.col(j) = jacobian.col(i) / lengths[i];
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeFullV);
    const Eigen::VectorXd& sigma = svd.singularValues();
    Eigen::Index rank = 0;
    while (rank < sigma.size() && sigma[rank] > kNull * sigma[0]) ++rank;

    const Eigen::MatrixXd determined = svd.matrixV().leftCols(rank);
    const Eigen::MatrixXd inverse =
        determined * sigma.head(rank).cwiseAbs2().cwiseInverse().asDiagonal() * determined.transpose();
    const Eigen::MatrixXd null = svd.matrixV().rightCols(count - rank);
    const Eigen::VectorXd own = lengths(seen).cwiseInverse();
    result.seen(seen, seen) = variance * own.asDiagonal() * inverse * own.asDiagonal();
    for (Eigen::Index a = 0; a < count; ++a) {
        if (null.cols() > 0 && null.row(a).norm() > 1e-3) continue;
        for (Eigen::Index b = 0; b < count; ++b) {
            if (null.cols() > 0 && null.row(b).norm() > 1e-3) continue;
            const Eigen::Index i = seen[static_cast<std::size_t>(a)], j = seen[static_cast<std::size_t>(b)];
            result.covariance(i, j) = variance * inverse(a, b) / (lengths[i] * lengths[j]);
            result.correlation(i, j) = inverse(a, b) / std::sqrt(inverse(a, a) * inverse(b, b));
        }
        const Eigen::Index i = seen[static_cast<std::size_t>(a)];
        result.standardErrors[i] = std::sqrt(result.covariance(i, i));
    }

    if (null.cols() > 0) {
        const Eigen::MatrixXd basis = sparseBasis(null.transpose());
        for (Eigen::Index r = 0; r < basis.rows(); ++r) {
            std::vector<std::string> involved;
            Eigen::VectorXd change = Eigen::VectorXd::Zero(K);
            for (Eigen::Index a = 0; a < count; ++a) {
                if (std::abs(basis(r, a)) > 0.02 * basis.row(r).cwiseAbs().maxCoeff()) {
                    const Eigen::Index i = seen[static_cast<std::size_t>(a)];
                    involved.push_back(names[static_cast<std::size_t>(i)]);
                    change[i] = basis(r, a) / lengths[i];
                }
            }
            if (involved.size() > 1) result.unseen.push_back(std::move(change));
            result.remarks.push_back(involved.size() > 1
                                         ? phrase("{} cannot be told apart from these data: fix one", listed(involved))
                                         : phrase("{} is not determined by these data: fix it", listed(involved)));
        }
    }
    for (Eigen::Index i = 0; i < K; ++i) {
        for (Eigen::Index j = i + 1; j < K; ++j) {
            if (std::abs(result.correlation(i, j)) > hardlyToldApart) {
                result.remarks.push_back(phrase("{} and {} can hardly be told apart (correlation {:.5f})",
                                                names[static_cast<std::size_t>(i)], names[static_cast<std::size_t>(j)],
                                                result.correlation(i, j)));
            }
        }
    }
    return result;
}

namespace {

/// Jᵀr of each sample of an experiment, of all outputs together: rows: samples, columns: parameters.
Eigen::MatrixXd scoresOf(const FitExperiment& experiment, const Linearisation& optimum, Eigen::Index& row) {
    Eigen::MatrixXd scores = Eigen::MatrixXd::Zero(experiment.measured.cols(), optimum.jacobian.cols());
    for (Eigen::Index o = 0; o < experiment.measured.rows(); ++o) {
        if (!experiment.isFitted(o)) continue;
        for (Eigen::Index k = 0; k < scores.rows(); ++k) {
            if (std::isnan(experiment.measured(o, k))) continue;
            scores.row(k) += optimum.residuals[row] * optimum.jacobian.row(row);
            ++row;
        }
    }
    return scores;
}

}  // namespace

Eigen::MatrixXd longRunCovariance(const Eigen::MatrixXd& rows, Eigen::Index window) {
    // Products of sums over sliding windows, rows beyond the ends taken as zero, add up to just that weighted sum
    // (overlapping batch means: Meketon & Schmeiser 1984), whatever the window costs.
    const Eigen::Index count = rows.rows(), K = rows.cols();
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(K, K);
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(K);
    for (Eigen::Index end = 0; end < count + window - 1; ++end) {
        if (end < count) sum += rows.row(end);
        if (end >= window) sum -= rows.row(end - window);
        covariance.noalias() += sum.transpose() * sum;
    }
    return covariance / static_cast<double>(window);
}

double suitableWindow(const Eigen::MatrixXd& rows) {
    const Eigen::Index count = rows.rows();
    if (count < 3) return 1.0;
    double above = 0.0, below = 0.0;
    for (Eigen::Index i = 0; i < rows.cols(); ++i) {
        const auto now = rows.col(i).tail(count - 1), before = rows.col(i).head(count - 1);
        const double square = before.squaredNorm();
        if (square == 0.0) continue;
        const double rho = std::clamp(now.dot(before) / square, -0.99, 0.99);
        // Each column weighs alike: its innovations are taken as 1.
        above += 4.0 * rho * rho / (std::pow(1.0 - rho, 6) * std::pow(1.0 + rho, 2));
        below += 1.0 / std::pow(1.0 - rho, 4);
    }
    if (below == 0.0) return 1.0;
    return 1.1447 * std::cbrt(above / below * static_cast<double>(count));
}

Eigen::VectorXd robustErrorsOf(const FitProblem& problem, const Linearisation& optimum, const Eigen::MatrixXd& inverse,
                               double scatter) {
    const Eigen::Index K = inverse.rows();
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(K, K);
    Eigen::Index row = 0;
    for (const FitExperiment& experiment : problem.experiments) {
        const Eigen::MatrixXd scores = scoresOf(experiment, optimum, row);
        const double most = std::max(1.0, static_cast<double>(scores.rows() / 4));
        const double window = std::clamp(std::ceil(suitableWindow(scores)), 1.0, most);
        sum += longRunCovariance(scores, static_cast<Eigen::Index>(window));
    }
    // The score of a prior scatters as its mean may lie elsewhere: by one standard deviation.
    for (Eigen::Index i = 0; i < K; ++i)
        if (const auto& prior = problem.parameters[static_cast<std::size_t>(i)].prior)
            sum(i, i) += std::pow(scatter, 4) / (prior->deviation * prior->deviation);
    const Eigen::MatrixXd known = inverse.array().isNaN().select(0.0, inverse);
    Eigen::VectorXd errors = (known * sum * known).diagonal().cwiseMax(0.0).cwiseSqrt();
    for (Eigen::Index i = 0; i < K; ++i)
        if (std::isnan(inverse(i, i))) errors[i] = std::numeric_limits<double>::quiet_NaN();
    return errors;
}

Eigen::MatrixXd predictionBand(const FitProblem& problem, int experiment, const Eigen::VectorXd& values,
                               const Eigen::MatrixXd& covariance, const GridPlan* plan,
                               const SimulationOptions& options, const Progress& progress) {
    // One experiment at a time, and of its parameters alone: the slopes of all would take too much memory.
    FitProblem one;
    one.beforeSimulation = problem.beforeSimulation;
    one.experiments.push_back(problem.experiments[static_cast<std::size_t>(experiment)]);
    FitExperiment& only = one.experiments.front();
    only.measured.setZero();
    for (double& weight : only.weights) weight = weight > 0.0 ? 1.0 : 0.0;
    std::vector<Eigen::Index> acting;
    for (std::size_t i = 0; i < problem.parameters.size(); ++i) {
        FitParameter p = problem.parameters[i];
        if (p.experiment >= 0 && p.experiment != experiment) continue;
        if (p.experiment >= 0) p.experiment = 0;
        acting.push_back(static_cast<Eigen::Index>(i));
        one.parameters.push_back(std::move(p));
    }
    const Eigen::MatrixXd own = covariance(acting, acting);
    std::vector<GridPlan> plans;
    if (plan) plans.push_back(*plan);
    const Linearisation line = linearise(one, values(acting), true, plans, options, progress);
    Eigen::MatrixXd band(only.measured.rows(), only.measured.cols());
    band.setConstant(std::numeric_limits<double>::quiet_NaN());
    Eigen::Index row = 0;
    for (Eigen::Index o = 0; line.ok && o < band.rows(); ++o) {
        if (!only.isFitted(o)) continue;
        const auto slopes = line.jacobian.middleRows(row, band.cols());
        band.row(o) = (slopes * own).cwiseProduct(slopes).rowwise().sum().cwiseSqrt().transpose();
        row += band.cols();
    }
    return band;
}

}  // namespace analogon
