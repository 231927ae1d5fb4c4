#include "core/eval/rank_deficient.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace analogon {
namespace {

constexpr double rounding = 1e-11;      // of rows that repeat each other, beside their largest entry
constexpr double contradiction = 1e-9;  // of what they say

/// A x = b, brought to x_basic + N x_free = c.
class Elimination {
public:
    Elimination(std::span<const double> matrix, std::span<const double> right)
        : n_(right.size()), a_(matrix.begin(), matrix.end()), b_(right.begin(), right.end()), order_(n_) {
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        for (std::size_t row = 0; row < n_; ++row) {
            double largest = 0;
            for (std::size_t k = 0; k < n_; ++k) largest = std::max(largest, std::fabs(at(row, k)));
            if (!(largest > 0)) continue;
            for (std::size_t k = 0; k < n_; ++k) at(row, k) /= largest;
            b_[row] /= largest;
        }
        for (const double value : b_) size_ = std::max(size_, std::fabs(value));
    }

    void run() {
        for (rank_ = 0; rank_ < n_ && pivot(); ++rank_) {
            const double inverse = 1 / at(rank_, rank_);
            for (std::size_t k = rank_; k < n_; ++k) at(rank_, k) *= inverse;
            b_[rank_] *= inverse;
            size_ = std::max(size_, std::fabs(b_[rank_]));
            for (std::size_t row = 0; row < n_; ++row) {
                const double factor = at(row, rank_);
                if (row == rank_ || factor == 0) continue;
                for (std::size_t k = rank_; k < n_; ++k) at(row, k) -= factor * at(rank_, k);
                b_[row] -= factor * b_[rank_];
            }
        }
    }
    std::size_t rank() const { return rank_; }
    bool isContradictory() const {
        return std::any_of(b_.begin() + static_cast<std::ptrdiff_t>(rank_), b_.end(),
                           [this](double left) { return !(std::fabs(left) <= contradiction * size_); });
    }
    RankDeficientSolution smallest(double shift);

private:
    double& at(std::size_t row, std::size_t column) { return a_[row * n_ + column]; }

    /// The largest entry that is left to the diagonal; false when there are only zeros.
    bool pivot() {
        std::size_t row = rank_, column = rank_;
        for (std::size_t i = rank_; i < n_; ++i)
            for (std::size_t k = rank_; k < n_; ++k)
                if (std::fabs(at(i, k)) > std::fabs(at(row, column))) row = i, column = k;
        if (!(std::fabs(at(row, column)) > rounding)) return false;
        for (std::size_t k = 0; k < n_; ++k) std::swap(at(rank_, k), at(row, k));
        std::swap(b_[rank_], b_[row]);
        for (std::size_t i = 0; i < n_; ++i) std::swap(at(i, rank_), at(i, column));
        std::swap(order_[rank_], order_[column]);
        return true;
    }

    std::size_t n_, rank_{};
    std::vector<double> a_, b_;
    std::vector<std::size_t> order_;  // of the unknowns: the basic ones first
    double size_{};                   // of what the rows say
};

/// (1 + N'N) x_free = N'c makes |c - N x_free|^2 + |x_free|^2 smallest. The matrix is symmetric and at least 1: it
/// needs no pivots.
RankDeficientSolution Elimination::smallest(double shift) {
    const std::size_t free = n_ - rank_;
    std::vector<double> normal(free * free), x(free);
    for (std::size_t i = 0; i < free; ++i) {
        for (std::size_t k = 0; k < free; ++k) {
            normal[i * free + k] = i == k ? 1 : 0;
            for (std::size_t row = 0; row < rank_; ++row)
                normal[i * free + k] += at(row, rank_ + i) * at(row, rank_ + k);
        }
        for (std::size_t row = 0; row < rank_; ++row) x[i] += at(row, rank_ + i) * b_[row];
    }
    for (std::size_t pivot = 0; pivot < free; ++pivot)
        for (std::size_t row = pivot + 1; row < free; ++row) {
            const double factor = normal[row * free + pivot] / normal[pivot * free + pivot];
            for (std::size_t k = pivot; k < free; ++k) normal[row * free + k] -= factor * normal[pivot * free + k];
            x[row] -= factor * x[pivot];
        }
    for (std::size_t row = free; row-- > 0;) {
        for (std::size_t k = row + 1; k < free; ++k) x[row] -= normal[row * free + k] * x[k];
        x[row] /= normal[row * free + row];
    }
    for (double& value : x) value += shift;
    RankDeficientSolution solution{std::vector<double>(n_), std::vector<char>(n_)};
    for (std::size_t k = 0; k < n_; ++k) {
        double value = k < rank_ ? b_[k] : x[k - rank_];
        bool isOpen = k >= rank_;
        for (std::size_t i = 0; k < rank_ && i < free; ++i) {
            value -= at(k, rank_ + i) * x[i];
            isOpen = isOpen || std::fabs(at(k, rank_ + i)) > rounding;
        }
        solution.values[order_[k]] = value;
        solution.isUndecided[order_[k]] = isOpen;
    }
    return solution;
}

thread_local UndecidedScope* innermost = nullptr;

}  // namespace

std::optional<RankDeficientSolution> solveRankDeficient(std::span<const double> matrix, std::span<const double> right,
                                                        double shift) {
    const auto isFinite = [](double value) { return std::isfinite(value); };
    if (!std::all_of(matrix.begin(), matrix.end(), isFinite) || !std::all_of(right.begin(), right.end(), isFinite))
        return std::nullopt;
    Elimination elimination(matrix, right);
    elimination.run();
    if (elimination.rank() == right.size() || elimination.isContradictory()) return std::nullopt;
    return elimination.smallest(shift);
}

UndecidedScope::UndecidedScope() : around_(std::exchange(innermost, this)) {}

UndecidedScope::~UndecidedScope() { innermost = around_; }

UndecidedScope* UndecidedScope::inForce() { return innermost; }

}  // namespace analogon
