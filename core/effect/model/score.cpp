#include "core/effect/model/score.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/base/stop.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::screen;

namespace {

constexpr double rankThreshold = 1e-9;
constexpr double rounding = 1e-9;  // of a column: no more is left of what the parameters imitate
constexpr int maxAutoregressiveOrder = 12;

/// Columns scaled to unit norm, so that parameters of any magnitude weigh alike in a rank decision.
Eigen::MatrixXd unitColumns(const Eigen::MatrixXd& columns) {
    Eigen::MatrixXd scaled = columns;
    for (Eigen::Index j = 0; j < scaled.cols(); ++j) {
        const double n = scaled.col(j).norm();
        if (n > 0) scaled.col(j) /= n;
    }
    return scaled;
}

Eigen::MatrixXd orthonormalBasis(const Eigen::MatrixXd& columns, double threshold) {
    if (columns.cols() == 0 || columns.rows() == 0) return Eigen::MatrixXd(columns.rows(), 0);
    stopPoint();
    Eigen::MatrixXd unit = unitColumns(columns);
    Eigen::ColPivHouseholderQR<Eigen::Ref<Eigen::MatrixXd>> qr(unit);  // in place: they may take much room
    qr.setThreshold(threshold);
    const Eigen::Index rank = qr.rank();
    Eigen::MatrixXd basis = Eigen::MatrixXd::Identity(columns.rows(), rank);
    basis.applyOnTheLeft(qr.householderQ());
    return basis;
}

}  // namespace

Eigen::VectorXd besideRounding(const ResidualChannel& channel, const Eigen::VectorXd& residual, double step) {
    constexpr int harmonics = 5;
    const Eigen::VectorXd own = residual.segment(channel.begin, channel.end - channel.begin);
    const Eigen::ArrayXd turns = 2 * std::numbers::pi * (channel.measured + own).array() / step;
    Eigen::MatrixXd waves(own.size(), 2 * harmonics);
    for (int k = 1; k <= harmonics; ++k) {
        waves.col(2 * k - 2) = (k * turns).sin();
        waves.col(2 * k - 1) = (k * turns).cos();
    }
    return own - waves * waves.colPivHouseholderQr().solve(own);
}

std::vector<ResidualChannel> residualChannels(const FitProblem& problem) {
    std::vector<ResidualChannel> channels;
    int row = 0;
    for (std::size_t e = 0; e < problem.experiments.size(); ++e) {
        const FitExperiment& experiment = problem.experiments[e];
        for (Eigen::Index o = 0; o < experiment.measured.rows(); ++o) {
            if (experiment.weights[o] <= 0) continue;
            ResidualChannel channel{static_cast<int>(e), static_cast<int>(o), row, row, {}};
            for (Eigen::Index k = 0; k < experiment.measured.cols(); ++k)
                if (!std::isnan(experiment.measured(o, k))) channel.samples.push_back(static_cast<int>(k));
            row += static_cast<int>(channel.samples.size());
            channel.end = row;
            channel.measured = experiment.weights[o] * experiment.measured.row(o)(channel.samples).transpose();
            if (channel.end > channel.begin) channels.push_back(std::move(channel));
        }
    }
    return channels;
}

Whitener::Whitener(const std::vector<ResidualChannel>& channels, const Eigen::VectorXd& residual)
    : channels_(channels) {
    for (const ResidualChannel& c : channels) {
        models_.push_back(fitAutoregressive(residual.segment(c.begin, c.end - c.begin), maxAutoregressiveOrder));
        if (!(models_.back().innovation > 0)) models_.back().innovation = 1;
    }
}

Eigen::VectorXd Whitener::operator()(const Eigen::VectorXd& rows) const {
    Eigen::VectorXd white = rows;
    for (std::size_t c = 0; c < channels_.size(); ++c) {
        const int begin = channels_[c].begin, count = channels_[c].end - channels_[c].begin;
        white.segment(begin, count) = models_[c].whiten(rows.segment(begin, count)) / models_[c].innovation;
    }
    return white;
}

Eigen::MatrixXd Whitener::operator()(const Eigen::MatrixXd& rows) const {
    Eigen::MatrixXd white(rows.rows(), rows.cols());
    stopPoint();
    for (Eigen::Index j = 0; j < rows.cols(); ++j) white.col(j) = (*this)(Eigen::VectorXd(rows.col(j)));
    return white;
}

Eigen::MatrixXd Whitener::through(std::size_t channel, const Eigen::MatrixXd& rows) const {
    if (channel >= models_.size()) return rows;
    Eigen::MatrixXd white(rows.rows(), rows.cols());
    for (Eigen::Index j = 0; j < rows.cols(); ++j)
        white.col(j) = models_[channel].whiten(Eigen::VectorXd(rows.col(j))) / models_[channel].innovation;
    return white;
}

Eigen::VectorXd Whitener::noise(std::mt19937_64& random) const {
    Eigen::VectorXd rows(channels_.empty() ? 0 : channels_.back().end);
    for (std::size_t c = 0; c < channels_.size(); ++c) {
        const int begin = channels_[c].begin, count = channels_[c].end - channels_[c].begin;
        rows.segment(begin, count) = models_[c].simulate(count, random);
    }
    return rows;
}

OrthogonalProjector::OrthogonalProjector(const Eigen::MatrixXd& jacobian)
    : basis_(orthonormalBasis(jacobian, rankThreshold)), jacobian_(jacobian) {}

Eigen::MatrixXd OrthogonalProjector::operator()(const Eigen::MatrixXd& columns) const {
    Eigen::MatrixXd rest = columns - basis_ * (basis_.transpose() * columns);
    rest -= basis_ * (basis_.transpose() * rest);  // once more: what is left may be small against what was taken
    return rest;
}

Eigen::VectorXd OrthogonalProjector::coefficients(const Eigen::VectorXd& column) const {
    if (jacobian_.cols() == 0) return {};
    Eigen::VectorXd norms = jacobian_.colwise().norm().transpose();
    for (double& n : norms)
        if (n == 0) n = 1;
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(unitColumns(jacobian_));
    qr.setThreshold(rankThreshold);
    return qr.solve(column).cwiseQuotient(norms);
}

const Eigen::MatrixXf& SharedColumns::operator*() const {
    static const Eigen::MatrixXf none;
    return columns_ ? *columns_ : none;
}

ColumnScore scoreColumns(const OrthogonalProjector& complement, const Eigen::VectorXd& residual,
                         const Eigen::MatrixXd& columns, bool oneSided) {
    ColumnScore score;
    score.strengths = Eigen::VectorXd::Zero(columns.cols());
    score.directions = Eigen::MatrixXd(columns.rows(), 0);
    const double length = columns.col(0).norm();
    if (!(length > 0) || !std::isfinite(length)) return score;
    Eigen::MatrixXd rest = complement(columns);
    score.visible = rest.col(0).norm() / length;
    for (Eigen::Index j = 1; j < rest.cols(); ++j)
        if (!(rest.col(j).norm() > rounding * columns.col(j).norm())) rest.col(j).setZero();  // any strength would do
    Eigen::VectorXd norms = rest.colwise().norm().transpose();
    for (double& n : norms)
        if (!(n > 0)) n = 1;
    const Eigen::MatrixXd unit = rest * norms.cwiseInverse().asDiagonal();
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(unit);
    qr.setThreshold(1e-6);
    score.strengths = (-qr.solve(residual)).cwiseQuotient(norms);
    score.wrongSign = oneSided && score.strengths[0] < 0;
    Eigen::MatrixXd directions = orthonormalBasis(rest, 1e-6);
    score.along = directions.transpose() * residual;
    score.explained = score.along.squaredNorm();
    score.directions = directions;
    return score;
}

Explained explainedBy(const Eigen::VectorXd& residual, const Eigen::MatrixXd& columns) {
    constexpr double apart = 1e-6;
    Explained found;
    if (columns.allFinite()) {
        found.directions = orthonormalBasis(columns, apart);
    } else {
        Eigen::MatrixXd finite = columns;
        for (Eigen::Index j = 0; j < finite.cols(); ++j)
            if (!finite.col(j).allFinite()) finite.col(j).setZero();
        found.directions = orthonormalBasis(finite, apart);
    }
    found.explained = (found.directions.transpose() * residual).squaredNorm();
    return found;
}

SharedColumns atSomeRows(const SharedColumns& directions, Eigen::Index most) {
    const Eigen::Index rows = directions->rows(), piece = (rows + most - 1) / most;
    if (piece <= 1) return directions;
    std::mt19937_64 random(1);  // the same rows of all candidates
    std::uniform_int_distribution<Eigen::Index> within(0, piece - 1);
    Eigen::MatrixXd some((rows + piece - 1) / piece, directions->cols());
    for (Eigen::Index i = 0; i < some.rows(); ++i)
        some.row(i) = directions->row(std::min(i * piece + within(random), rows - 1)).cast<double>();
    return Eigen::MatrixXd(some.colwise().normalized());
}

double explainedTogether(const ColumnScore& a, const ColumnScore& b) {
    Eigen::MatrixXd both(a.directions->rows(), a.directions->cols() + b.directions->cols());
    both << a.directions->cast<double>(), b.directions->cast<double>();
    Eigen::VectorXd along(both.cols());
    along << a.along, b.along;
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> gram;
    gram.setThreshold(leastApart);
    gram.compute(both.transpose() * both);
    return along.dot(gram.solve(along));
}

namespace {

/// Products of all columns with each other: the lower triangle.
Eigen::MatrixXd gramOf(const std::vector<SharedColumns>& columns, Eigen::Index total) {
    constexpr Eigen::Index part = 1024;
    const Eigen::Index rows = columns.front()->rows();
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(total, total);
    for (Eigen::Index from = 0; from < rows; from += part) {
        const Eigen::Index count = std::min(part, rows - from);
        Eigen::MatrixXd some(count, total);
        Eigen::Index at = 0;
        for (const SharedColumns& each : columns) {
            some.middleCols(at, each->cols()) = each->middleRows(from, count).cast<double>();
            at += each->cols();
        }
        gram.selfadjointView<Eigen::Lower>().rankUpdate(some.transpose());
    }
    return gram;
}

/// L with L L' = `gram` (lower triangle) but for a hundredth of a column, and no more columns than that takes: pivoted
/// Cholesky, Higham 1990 (Reliable Numerical Computation, chapter 9).
Eigen::MatrixXd rootOf(const Eigen::MatrixXd& gram) {
    constexpr double negligible = 1e-4;  // of the largest square of a column
    const Eigen::Index total = gram.rows();
    Eigen::VectorXd left = gram.diagonal(), next(total);
    const double least = negligible * left.maxCoeff();
    Eigen::MatrixXd root(total, 0);
    Eigen::Index rank = 0, pivot = 0;
    while (rank < total && left.maxCoeff(&pivot) > least) {
        if (rank == root.cols()) root.conservativeResize(Eigen::NoChange, std::min(total, 2 * rank + 16));
        next << gram.row(pivot).head(pivot).transpose(), gram.col(pivot).tail(total - pivot);
        next.noalias() -= root.leftCols(rank) * root.row(pivot).head(rank).transpose();
        root.col(rank) = next / std::sqrt(left[pivot]);
        left = (left - root.col(rank).cwiseAbs2()).cwiseMax(0);
        left[pivot] = 0;
        ++rank;
    }
    return root.leftCols(rank);
}

}  // namespace

double noiseThreshold(const std::vector<SharedColumns>& directions, double logRows, double quantile,
                      std::uint64_t seed) {
    Eigen::Index total = 0;
    std::vector<Eigen::Index> starts;
    for (const SharedColumns& d : directions) {
        starts.push_back(total);
        total += d->cols();
    }
    if (total == 0) return 0;
    // alike candidates share few directions: the others have no part in what is drawn
    const Eigen::MatrixXd root = rootOf(gramOf(directions, total));

    constexpr int draws = 5000, drawnAtOnce = 50;
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal;
    std::vector<double> largest;
    Eigen::MatrixXd z(root.cols(), drawnAtOnce), v(total, drawnAtOnce);
    while (largest.size() < draws) {
        for (double& x : z.reshaped()) x = normal(generator);
        v.noalias() = root * z;
        for (Eigen::Index draw = 0; draw < drawnAtOnce; ++draw) {
            double most = -1e300;
            for (std::size_t k = 0; k < directions.size(); ++k)
                if (const Eigen::Index columns = directions[k]->cols(); columns > 0)
                    most = std::max(most, v.col(draw).segment(starts[k], columns).squaredNorm() -
                                              static_cast<double>(columns) * logRows);
            largest.push_back(most);
        }
    }
    std::sort(largest.begin(), largest.end());
    return largest[static_cast<std::size_t>(quantile * (draws - 1))];
}

double effectiveCount(const std::vector<ResidualChannel>& channels, const Eigen::VectorXd& residual) {
    double count = 0;
    for (const ResidualChannel& c : channels) {
        const int n = c.end - c.begin;
        const ResidualSummary s = summarise(residual.segment(c.begin, n));
        count += n / std::max(1.0, s.autocorrelationTime);
    }
    return std::max(2.0, count);
}

}  // namespace analogon
