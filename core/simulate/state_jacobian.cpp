#include "core/simulate/state_jacobian.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/eval/state_pattern.hpp"
#include "core/simulate/step_schedule.hpp"

namespace analogon {

namespace {

constexpr double kAlike = 1e-12;  // relative difference of two lengths of a step that are the same but for rounding
constexpr int kMostSquared = 40;  // states with which the square of a full matrix costs no more than its powers' action

}  // namespace

StepPattern::StepPattern(const StatePattern& pattern) {
    starts.push_back(0);
    for (int j = 0; j < pattern.states(); ++j) {
        int diagonal = -1;
        const auto putDiagonal = [&] {
            diagonal = static_cast<int>(rows.size());
            rows.push_back(j);
        };
        for (auto e = static_cast<std::size_t>(pattern.starts[static_cast<std::size_t>(j)]);
             e < static_cast<std::size_t>(pattern.starts[static_cast<std::size_t>(j) + 1]); ++e) {
            if (pattern.rows[e] >= j && diagonal < 0) putDiagonal();
            places.push_back(pattern.rows[e] == j ? diagonal : static_cast<int>(rows.size()));
            if (pattern.rows[e] != j) rows.push_back(pattern.rows[e]);
        }
        if (diagonal < 0) putDiagonal();
        diagonals.push_back(diagonal);
        starts.push_back(static_cast<int>(rows.size()));
    }
}

StateJacobian::StateJacobian(Dynamics& dynamics)
    : dynamics_(dynamics), n_(dynamics.shape().states), K_(dynamics.shape().directions), pattern_(dynamics.pattern()) {
    const auto n = static_cast<std::size_t>(n_), K = static_cast<std::size_t>(K_);
    if (!pattern_) {
        entries_.resize(n * (n + K));
        dense_.resize(n_);
        return;
    }
    isConstant_ = dynamics.isLinear();
    entries_.resize(pattern_->entries());
    held_.resize(n * K);
    if (isConstant_) still_.resize(n * K);
    step_ = std::make_unique<StepPattern>(*pattern_);
    matrix_.resize(step_->rows.size());
}

bool StateJacobian::evaluate(double t, const double* x, const double* u, double* xdot) {
    stride_ = n_;
    if (!pattern_) return dynamics_.jacobian(t, x, u, xdot, entries_.data());
    if (isKnown()) return dynamics_.derivatives(t, x, u, xdot);
    return isEvaluated_ = dynamics_.sparseJacobian(t, x, u, xdot, entries_.data());
}

bool StateJacobian::linearise(double t, const double* x, const double* u, const double* du, double* xdot) {
    stride_ = n_ + K_;
    if (!pattern_) return dynamics_.linearised(t, x, u, du, xdot, entries_.data());
    if (isKnown() && K_ > 0) return dynamics_.derivatives(t, x, still_.data(), u, du, xdot, held_.data());
    return isEvaluated_ = dynamics_.sparseLinearised(t, x, u, du, xdot, entries_.data(), held_.data());
}

bool StateJacobian::factorise(double c) {
    if (pattern_) return factoriseSparse(c);
    double* m = dense_.matrix();
    for (int j = 0; j < n_; ++j) {
        for (int i = 0; i < n_; ++i)
            m[j * n_ + i] = (i == j ? 1.0 : 0.0) - c * entries_[static_cast<std::size_t>(i * stride_ + j)];
    }
    denseFor_ = c;
    return hasDense_ = dense_.factorise();
}

bool StateJacobian::factoriseSparse(double c) {
    if (hasFactors(c)) {
        if (isConstant_) return true;
    } else {
        inForce_ = next_;
        next_ = (next_ + 1) % kept_.size();
    }
    Factors& own = kept_[inForce_];
    if (!own.factors) own.factors = std::make_unique<SparseFactors>(n_, step_->starts.data(), step_->rows.data());
    std::fill(matrix_.begin(), matrix_.end(), 0.0);
    for (std::size_t e = 0; e < entries_.size(); ++e)
        matrix_[static_cast<std::size_t>(step_->places[e])] = -c * entries_[e];
    for (const int diagonal : step_->diagonals) matrix_[static_cast<std::size_t>(diagonal)] += 1.0;
    own.c = c;
    if (own.factors->factorise(matrix_.data())) return true;
    own.factors.reset();
    return false;
}

bool StateJacobian::hasFactors(double c) {
    if (!pattern_) return hasDense_ && denseFor_ == c;
    for (std::size_t i = 0; i < kept_.size(); ++i) {
        if (!kept_[i].factors || std::abs(kept_[i].c - c) > kAlike * std::abs(c)) continue;
        inForce_ = i;
        return true;
    }
    return false;
}

void StateJacobian::solve(double* b, int width) const {
    if (pattern_) {
        kept_[inForce_].factors->solve(b, width);
    } else {
        dense_.solve(b, width);
    }
}

double StateJacobian::radius(double enough) {
    if (pattern_ || n_ > kMostSquared) return radiusByVector(enough);
    scratch_.resize(static_cast<std::size_t>(n_) * static_cast<std::size_t>(n_));
    return spectralRadius(entries_.data(), scratch_.data(), n_, enough);
}

void StateJacobian::multiply(const std::vector<double>& x, std::vector<double>& to) const {
    std::fill(to.begin(), to.end(), 0.0);
    if (!pattern_) {
        for (int i = 0; i < n_; ++i)
            for (int j = 0; j < n_; ++j)
                to[static_cast<std::size_t>(i)] +=
                    entries_[static_cast<std::size_t>(i * stride_ + j)] * x[static_cast<std::size_t>(j)];
        return;
    }
    for (std::size_t j = 0; j < x.size(); ++j)
        for (int e = pattern_->starts[j]; e < pattern_->starts[j + 1]; ++e)
            to[static_cast<std::size_t>(pattern_->rows[static_cast<std::size_t>(e)])] +=
                entries_[static_cast<std::size_t>(e)] * x[j];
}

/// The largest sum of magnitudes of a row or of a column, whichever is less: both lie above the radius.
double StateJacobian::leastNorm() {
    std::fill(image_.begin(), image_.end(), 0.0);
    std::fill(vector_.begin(), vector_.end(), 0.0);
    const auto add = [&](int i, std::size_t j, double entry) {
        image_[static_cast<std::size_t>(i)] += std::abs(entry);
        vector_[j] += std::abs(entry);
    };
    for (std::size_t j = 0; j < vector_.size(); ++j) {
        if (pattern_) {
            for (int e = pattern_->starts[j]; e < pattern_->starts[j + 1]; ++e)
                add(pattern_->rows[static_cast<std::size_t>(e)], j, entries_[static_cast<std::size_t>(e)]);
        } else {
            for (int i = 0; i < n_; ++i)
                add(i, j, entries_[static_cast<std::size_t>(i) * static_cast<std::size_t>(stride_) + j]);
        }
    }
    return std::min(*std::max_element(image_.begin(), image_.end()), *std::max_element(vector_.begin(), vector_.end()));
}

double StateJacobian::radiusByVector(double enough) {
    if (judged_ == entries_ && radius_ >= 0 && (!isBound_ || radius_ <= enough)) return radius_;
    judged_ = entries_;
    vector_.resize(static_cast<std::size_t>(n_));
    image_.resize(vector_.size());
    radius_ = leastNorm();
    isBound_ = radius_ > 0;
    if (radius_ <= enough || radius_ == 0) return radius_;
    isBound_ = false;
    std::uint64_t random = 0x9e3779b97f4a7c15u;  // signs that no model is built upon
    for (double& entry : vector_) {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        entry = (random & 1) != 0 ? 1.0 : -1.0;
    }
    constexpr int power = 64;
    double logarithm = 0.0;
    for (int k = 0; k < power; ++k) {
        multiply(vector_, image_);
        double squares = 0.0;
        for (const double entry : image_) squares += entry * entry;
        const double length = std::sqrt(squares);
        if (length == 0.0) return radius_ = 0.0;
        logarithm += std::log(length);
        for (std::size_t i = 0; i < image_.size(); ++i) vector_[i] = image_[i] / length;
    }
    return radius_ = std::min(radius_, std::exp(logarithm / power));
}

}  // namespace analogon
