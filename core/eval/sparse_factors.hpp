#pragma once

#include <memory>

namespace analogon {

/// LU factors of matrices with one pattern, by SuiteSparse KLU (Davis & Palamadai Natarajan, ACM Trans. Math. Softw.
/// 37:36 (2010)): the order of elimination is found once, the pivots are kept from matrix to matrix while they serve.
class SparseFactors {
public:
    /// The pattern, compressed by columns with ascending rows: it must outlive the factors. The diagonal is taken for
    /// the pivot where it is at least that part of the largest entry of its column; 1: partial pivoting.
    SparseFactors(int n, const int* starts, const int* rows, double leastDiagonal = 1e-3);
    ~SparseFactors();
    SparseFactors(const SparseFactors&) = delete;
    SparseFactors& operator=(const SparseFactors&) = delete;

    /// By the entries of the pattern. False for a singular matrix.
    bool factorise(const double* entries);
    /// Of the factors: the smallest over the largest pivot, rows scaled (a cheap bound of the condition).
    double pivotRatio() const;
    /// Solves in place for `width` right-hand sides, row-major n x width.
    void solve(double* b, int width) const;

private:
    struct Klu;
    std::unique_ptr<Klu> klu_;
};

}  // namespace analogon
