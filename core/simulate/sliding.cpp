#include "core/simulate/sliding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace analogon {

namespace {

/// A surface is left when its share is this far beyond the end: the field then clearly leads away.
constexpr double leaveBeyond = 1e-8;
/// How many distances away a surface that was left lies, so that looking beside the others does not touch it.
constexpr double clearOf = 256;
/// What is left of r by rounding dies away at this rate [1/s].
constexpr double decay = 100;

Eigen::Map<const Eigen::VectorXd> vectorOf(const double* data, int n) { return {data, n}; }

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace

Sliding::Sliding(Dynamics& dynamics, std::function<void(double)> setSlots, const std::vector<double>& u)
    : dynamics_(dynamics),
      setSlots_(std::move(setSlots)),
      u_(u),
      n_(dynamics.shape().states),
      roots_(dynamics.shape().roots) {}

bool Sliding::holds(int root) const { return std::find(surfaces_.begin(), surfaces_.end(), root) != surfaces_.end(); }

bool Sliding::roots(double t, const Eigen::VectorXd& x, Eigen::VectorXd& values) {
    values.resize(roots_);
    return dynamics_.roots(t, x.data(), u_.data(), values.data());
}

/// Central differences: exact but for rounding where r is linear in the states, as it mostly is.
bool Sliding::gradientOf(double t, const Eigen::VectorXd& x, Eigen::MatrixXd& gradient) {
    gradient.resize(static_cast<Eigen::Index>(surfaces_.size()), n_);
    Eigen::VectorXd moved = x, above, below;
    for (int i = 0; i < n_; ++i) {
        const double scale = std::max(std::fabs(x[i]), dynamics_.shape().stateNominal[static_cast<std::size_t>(i)]);
        const double step = std::exp2(std::round(std::log2(scale)) - 10);
        moved[i] = x[i] + step;
        if (!roots(t, moved, above)) return false;
        moved[i] = x[i] - step;
        if (!roots(t, moved, below)) return false;
        moved[i] = x[i];
        for (std::size_t j = 0; j < surfaces_.size(); ++j)
            gradient(static_cast<Eigen::Index>(j), i) = (above[surfaces_[j]] - below[surfaces_[j]]) / (2 * step);
    }
    return true;
}

/// Beside all surfaces on the side r > 0; beside one of them on the other.
Eigen::VectorXd Sliding::beside(const Field& field, int other) const {
    Eigen::VectorXd x = field.onto;
    for (std::size_t j = 0; j < surfaces_.size(); ++j) {
        const double side = static_cast<int>(j) == other ? -1.0 : 1.0;
        x += side * distance_[j] * field.back.col(static_cast<Eigen::Index>(j));
    }
    return x;
}

/// Distances at which every relation is seen from its side in spite of rounding.
bool Sliding::setDistances(double t, const Field& field) {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    Eigen::VectorXd values;
    for (std::size_t j = 0; j < surfaces_.size(); ++j) {
        double size = 0;
        for (int i = 0; i < n_; ++i)
            size += std::fabs(field.gradient(static_cast<Eigen::Index>(j), i)) *
                    (std::fabs(field.onto[i]) + dynamics_.shape().stateNominal[static_cast<std::size_t>(i)]);
        distance_[j] = 64 * epsilon * size;
    }
    for (int tries = 0; tries < 8; ++tries) {
        bool isClear = true;
        for (int other = -1; other < static_cast<int>(surfaces_.size()); ++other) {
            if (!roots(t, beside(field, other), values)) return false;
            for (std::size_t j = 0; j < surfaces_.size(); ++j) {
                const double side = static_cast<int>(j) == other ? -1.0 : 1.0;
                if (side * values[surfaces_[j]] >= 0.25 * distance_[j]) continue;
                isClear = false;
                distance_[j] *= 8;
            }
        }
        if (isClear) return true;
    }
    return false;
}

bool Sliding::field(double t, const double* state, Field& out) {
    setSlots_(t);
    const auto m = static_cast<Eigen::Index>(surfaces_.size());
    const Eigen::VectorXd x = vectorOf(state, n_);
    Eigen::VectorXd values, later, earlier;
    if (!gradientOf(t, x, out.gradient) || !roots(t, x, values)) return false;
    const Eigen::Map<const Eigen::VectorXd> nominal = vectorOf(dynamics_.shape().stateNominal.data(), n_);
    const Eigen::MatrixXd weighted = nominal.cwiseAbs2().asDiagonal() * out.gradient.transpose();
    out.back = weighted * (out.gradient * weighted).inverse();
    if (!out.back.allFinite()) return false;
    Eigen::VectorXd r(m);
    for (Eigen::Index j = 0; j < m; ++j) r[j] = values[surfaces_[static_cast<std::size_t>(j)]];
    out.onto = x - out.back * r;
    if (distance_.size() != surfaces_.size()) {
        distance_.assign(surfaces_.size(), 0);
        if (!setDistances(t, out)) {
            distance_.clear();
            return false;
        }
    }
    const double step = 1e-6 * std::max(std::fabs(t), 1e-3);
    setSlots_(t + step);
    if (!roots(t + step, x, later)) return false;
    setSlots_(t - step);
    if (!roots(t - step, x, earlier)) return false;
    setSlots_(t);
    out.along.resize(m);
    for (Eigen::Index j = 0; j < m; ++j) {
        const int root = surfaces_[static_cast<std::size_t>(j)];
        out.along[j] = (later[root] - earlier[root]) / (2 * step);
    }

    Eigen::VectorXd above(n_), across(n_);
    if (!dynamics_.derivatives(t, beside(out, -1).data(), u_.data(), above.data())) return false;
    out.change.resize(n_, m);
    for (Eigen::Index j = 0; j < m; ++j) {
        if (!dynamics_.derivatives(t, beside(out, static_cast<int>(j)).data(), u_.data(), across.data())) return false;
        out.change.col(j) = across - above;
    }
    const Eigen::MatrixXd crossing = out.gradient * out.change;
    out.crossing.compute(crossing);
    out.shares = out.crossing.solve(-(out.gradient * above + out.along));
    if (!out.shares.allFinite()) return false;
    for (Eigen::Index j = 0; j < m; ++j)
        if (!(crossing(j, j) > 0)) return false;  // leads away: no motion on the surface
    out.mean = above + out.change * out.shares - decay * (out.back * r);
    return true;
}

bool Sliding::join(double t, double* x, const std::vector<int>& candidates) {
    bool any = false;
    for (const int root : candidates) {
        if (holds(root)) continue;
        const std::vector<int> before = surfaces_;
        const std::vector<double> distances = distance_;
        surfaces_.push_back(root);
        distance_.clear();
        Field f;
        const bool isHeld = field(t, x, f) && f.shares.minCoeff() > 0 && f.shares.maxCoeff() < 1;
        if (!isHeld) {
            surfaces_ = before;
            distance_ = distances;
            continue;
        }
        Eigen::Map<Eigen::VectorXd>(x, n_) = f.onto;
        any = true;
    }
    return any;
}

void Sliding::release() {
    surfaces_.clear();
    distance_.clear();
}

void Sliding::leave(double t, double* x) {
    Field f;
    if (!field(t, x, f)) return release();
    std::vector<int> kept;
    for (std::size_t j = 0; j < surfaces_.size(); ++j) {
        const auto column = static_cast<Eigen::Index>(j);
        const double share = f.shares[column];
        // Rounding in the location of the event: the nearer end is the one that is meant.
        if (share > 0 && share < 1) {
            kept.push_back(surfaces_[j]);
            continue;
        }
        const double side = share <= 0 ? 1.0 : -1.0;
        Eigen::Map<Eigen::VectorXd>(x, n_) += side * clearOf * distance_[j] * f.back.col(column);
    }
    surfaces_ = kept;
    distance_.clear();
}

bool Sliding::derivatives(double t, const double* x, double* xdot) {
    Field f;
    if (!field(t, x, f)) return false;
    std::copy_n(f.mean.data(), n_, xdot);
    return true;
}

/// The sides' derivatives in the shares of the mean; what would lead off the surface is taken out along the changes.
bool Sliding::jacobian(double t, const double* x, double* jacobian) {
    Field f;
    if (!field(t, x, f)) return false;
    Eigen::VectorXd rates(n_);
    RowMajor side(n_, n_), mean(n_, n_);
    if (!dynamics_.jacobian(t, beside(f, -1).data(), u_.data(), rates.data(), side.data())) return false;
    mean = (1 - f.shares.sum()) * side;
    for (Eigen::Index j = 0; j < f.shares.size(); ++j) {
        if (!dynamics_.jacobian(t, beside(f, static_cast<int>(j)).data(), u_.data(), rates.data(), side.data()))
            return false;
        mean += f.shares[j] * side;
    }
    mean -= f.change * f.crossing.solve(f.gradient * mean);
    mean -= decay * (f.back * f.gradient);
    Eigen::Map<RowMajor>(jacobian, n_, n_) = mean;
    return true;
}

bool Sliding::derivatives(double t, const double* x, const double* dx, const double* du, double* xdot, double* dxdot) {
    Field f;
    if (!field(t, x, f)) return false;
    const int K = dynamics_.shape().directions;
    Eigen::VectorXd rates(n_);
    RowMajor side(n_, K), mean(n_, K);
    if (!dynamics_.derivatives(t, beside(f, -1).data(), dx, u_.data(), du, rates.data(), side.data())) return false;
    mean = (1 - f.shares.sum()) * side;
    for (Eigen::Index j = 0; j < f.shares.size(); ++j) {
        if (!dynamics_.derivatives(t, beside(f, static_cast<int>(j)).data(), dx, u_.data(), du, rates.data(),
                                   side.data()))
            return false;
        mean += f.shares[j] * side;
    }
    mean -= f.change * f.crossing.solve(f.gradient * mean);
    mean -= decay * (f.back * (f.gradient * Eigen::Map<const RowMajor>(dx, n_, K)));
    std::copy_n(f.mean.data(), n_, xdot);
    Eigen::Map<RowMajor>(dxdot, n_, K) = mean;
    return true;
}

bool Sliding::exits(double t, const double* x, double* values) {
    Field f;
    if (!field(t, x, f)) return false;
    for (std::size_t j = 0; j < surfaces_.size(); ++j) {
        const double share = f.shares[static_cast<Eigen::Index>(j)];
        values[surfaces_[j]] = std::min(share, 1 - share) + leaveBeyond;
    }
    return true;
}

}  // namespace analogon
