#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace analogon {

/// LU factors with partial pivoting of a small dense matrix, column-major; for n up to a few tens faster than a
/// general library because nothing is allocated after resize() (Golub & Van Loan, algorithm 3.4.1). Substitution goes
/// by columns: the entries that one unknown is taken from do not wait for each other.
class DenseFactors {
public:
    void resize(int n) {
        n_ = n;
        entries_.assign(static_cast<std::size_t>(n * n), 0.0);
        pivots_.assign(static_cast<std::size_t>(n), 0);
        inverses_.assign(static_cast<std::size_t>(n), 0.0);
    }
    double* matrix() { return entries_.data(); }  // column-major, filled by the caller before factorise()

    /// False for a singular or non-finite matrix.
    bool factorise() {
        for (int k = 0; k < n_; ++k) {
            int pivot = k;
            double* const factors = column(k);
            for (int i = k + 1; i < n_; ++i) {
                if (std::abs(factors[i]) > std::abs(factors[pivot])) pivot = i;
            }
            pivots_[static_cast<std::size_t>(k)] = pivot;
            const double diagonal = factors[pivot];
            if (!std::isfinite(diagonal) || diagonal == 0.0) return false;
            if (pivot != k)
                for (int j = 0; j < n_; ++j) std::swap(column(j)[k], column(j)[pivot]);
            const double inverse = inverses_[static_cast<std::size_t>(k)] = 1.0 / diagonal;
            for (int i = k + 1; i < n_; ++i) factors[i] *= inverse;
            for (int j = k + 1; j < n_; ++j) {
                double* const to = column(j);
                const double factor = to[k];
                if (factor == 0.0) continue;
                for (int i = k + 1; i < n_; ++i) to[i] -= factor * factors[i];
            }
        }
        return true;
    }

    /// Solves in place for `width` right-hand sides, row-major n x width.
    void solve(double* b, int width) const {
        if (width == 1) return solveOne(b);
        const auto line = [&](int i) { return b + static_cast<std::ptrdiff_t>(i) * width; };
        for (int k = 0; k < n_; ++k) {
            const int pivot = pivots_[static_cast<std::size_t>(k)];
            if (pivot != k) std::swap_ranges(line(k), line(k) + width, line(pivot));
        }
        for (int i = 0; i < n_; ++i) {
            for (int k = 0; k < i; ++k) subtract(line(i), column(k)[i], line(k), width);
        }
        for (int i = n_ - 1; i >= 0; --i) {
            for (int k = i + 1; k < n_; ++k) subtract(line(i), column(k)[i], line(k), width);
            const double inverse = inverses_[static_cast<std::size_t>(i)];
            for (int j = 0; j < width; ++j) line(i)[j] *= inverse;
        }
    }

private:
    void solveOne(double* b) const {
        for (int k = 0; k < n_; ++k) std::swap(b[k], b[pivots_[static_cast<std::size_t>(k)]]);
        for (int k = 0; k + 1 < n_; ++k) {
            const double* const factors = column(k);
            for (int i = k + 1; i < n_; ++i) b[i] -= factors[i] * b[k];
        }
        for (int k = n_ - 1; k >= 0; --k) {
            const double* const factors = column(k);
            b[k] *= inverses_[static_cast<std::size_t>(k)];
            for (int i = 0; i < k; ++i) b[i] -= factors[i] * b[k];
        }
    }
    double* column(int k) { return entries_.data() + static_cast<std::ptrdiff_t>(k) * n_; }
    const double* column(int k) const { return entries_.data() + static_cast<std::ptrdiff_t>(k) * n_; }
    static void subtract(double* to, double factor, const double* from, int width) {
        if (factor == 0.0) return;
        for (int j = 0; j < width; ++j) to[j] -= factor * from[j];
    }

    int n_{};
    std::vector<double> entries_, inverses_;
    std::vector<int> pivots_;
};

}  // namespace analogon
