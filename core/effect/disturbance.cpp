#include "core/effect/disturbance.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/effect/score.hpp"

namespace analogon {
namespace {

constexpr int piecesOfADisturbance = 100;
constexpr double correlations[] = {0.2, 0.8, 0.97};         // of neighbouring pieces
constexpr double leastVariance = 1e-3, varianceFactor = 3;  // of the flow's strongest trace, in units of the noise
constexpr int varianceSteps = 24;
constexpr double leastInformation = 1e-10;  // of the best known direction of the parameters

/// Root of the correlation of pieces that follow each other by a first-order Markov process.
Eigen::MatrixXd correlationRoot(Eigen::Index count, double neighbours) {
    Eigen::MatrixXd c(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
        for (Eigen::Index j = 0; j < count; ++j) c(i, j) = std::pow(neighbours, static_cast<double>(std::abs(i - j)));
    return Eigen::LLT<Eigen::MatrixXd>(c).matrixL();
}

}  // namespace

Disturbance::Disturbance(const NullModel& null, const SimulationOptions& simulation, const Progress& progress)
    : Disturbance(null.channels, flowResponses(null, piecesOfADisturbance, simulation, progress),
                  piecesOfADisturbance) {}

Disturbance::Disturbance(std::vector<ResidualChannel> channels, const std::vector<FlowResponse>& responses, int pieces)
    : channels_(std::move(channels)) {
    const Eigen::Index count = pieces + 1;
    for (const FlowResponse& r : responses) {
        for (const double correlation : correlations) {
            const Eigen::MatrixXd root = correlationRoot(count, correlation);
            Eigen::MatrixXd columns = r.columns;
            for (Eigen::Index k = 0; k + count <= columns.cols(); k += count)
                columns.middleCols(k, count) = r.columns.middleCols(k, count) * root;
            const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(columns.transpose() * columns);
            if (!(eigen.eigenvalues().maxCoeff() > 0)) continue;
            sources_.push_back({columns * eigen.eigenvectors(), eigen.eigenvalues().cwiseMax(0)});
        }
    }
}

namespace {

/// A model's residual (first column) and Jacobian, the latter of unit columns.
Eigen::MatrixXd residualAndJacobian(const Linearisation& model) {
    Eigen::MatrixXd both(model.residuals.size(), 1 + model.jacobian.cols());
    both.col(0) = model.residuals;
    both.rightCols(model.jacobian.cols()) = model.jacobian;
    for (Eigen::Index j = 1; j < both.cols(); ++j) {
        const double n = both.col(j).norm();
        if (n > 0) both.col(j) /= n;
    }
    return both;
}

/// How the parameters follow, from the products of residual and Jacobian in the metric of the noise, and the sum of
/// squares that is left.
struct Followed {
    Eigen::VectorXd coefficients;  // of the residual (1) and the columns of the Jacobian
    double sumOfSquares{};
};

Followed follow(const Eigen::MatrixXd& products) {
    const Eigen::Index count = products.cols() - 1;
    Followed f{Eigen::VectorXd::Ones(count + 1), products(0, 0)};
    if (count == 0) return f;
    Eigen::MatrixXd normal = products.bottomRightCorner(count, count);
    normal.diagonal().array() += leastInformation * std::max(normal.diagonal().maxCoeff(), 1e-300);
    const Eigen::VectorXd right = products.bottomLeftCorner(count, 1);
    f.coefficients.tail(count) = -normal.ldlt().solve(right);
    f.sumOfSquares += right.dot(f.coefficients.tail(count));
    return f;
}

}  // namespace

Disturbance::Estimate Disturbance::estimate(const Linearisation& model) const {
    const Eigen::MatrixXd both = residualAndJacobian(model);
    const Eigen::MatrixXd products = both.transpose() * both;
    const double rows = static_cast<double>(both.rows());
    const auto misfitOf = [&](const Followed& f) {
        return rows * std::log(std::max(f.sumOfSquares, std::numeric_limits<double>::min()) / rows);
    };
    Followed best = follow(products);
    Estimate estimate{misfitOf(best), 1};
    const Source* likeliest = nullptr;
    Eigen::VectorXd taken;  // of each column of the source, the part that is the flow's
    for (const Source& source : sources_) {
        const Eigen::MatrixXd onto = source.columns.transpose() * both;
        double variance = leastVariance / source.squares.maxCoeff();
        for (int step = 0; step < varianceSteps; ++step, variance *= varianceFactor) {
            // (I + q A A')^-1 = I - A q/(1 + q s) A' where A'A is diagonal, s
            const Eigen::VectorXd part = variance / (1 + variance * source.squares.array());
            const Followed followed = follow(products - onto.transpose() * part.asDiagonal() * onto);
            const double misfit = misfitOf(followed) + (variance * source.squares.array()).log1p().sum();
            if (!(misfit < estimate.misfit)) continue;
            estimate.misfit = misfit;
            best = followed;
            likeliest = &source;
            taken = part;
        }
    }
    Eigen::VectorXd rest = both * best.coefficients;
    if (likeliest) rest -= likeliest->columns * taken.cwiseProduct(likeliest->columns.transpose() * rest);
    estimate.independent = effectiveCount(channels_, rest) / rows;
    return estimate;
}

double Disturbance::evidence(const Linearisation& without, const Linearisation& with, int more) const {
    const Estimate one = estimate(without), other = estimate(with);
    const double count = other.independent * static_cast<double>(with.residuals.size());
    return other.independent * (one.misfit - other.misfit) - more * std::log(count);
}

}  // namespace analogon
