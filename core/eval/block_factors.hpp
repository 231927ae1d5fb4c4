#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace analogon {

class SparseFactors;

/// LU factors of the matrix of a large block of equations, kept from one evaluation to the next while its entries stay
/// the same (a network of resistances). Where few entries are other than zero they are sparse, by KLU; dense ones
/// decide where a matrix is nearly singular. A copy begins without them.
class BlockFactors {
public:
    /// Smaller matrices are factored anew as fast as they would be compared.
    static constexpr std::size_t fewestUnknowns = 8;

    BlockFactors();
    BlockFactors(const BlockFactors&);
    BlockFactors& operator=(const BlockFactors&);
    BlockFactors(BlockFactors&&) noexcept;
    BlockFactors& operator=(BlockFactors&&) noexcept;
    ~BlockFactors();

    /// Of an n x n matrix, its `values` at these `entries` (row * n + column, ascending) and 0 elsewhere. False: it is
    /// singular to working precision.
    bool factorise(std::size_t n, std::span<const std::uint32_t> entries, std::span<const double> values);
    /// Solves in place for `width` right-hand sides, row-major n x width.
    void solve(double* right, int width) const;

private:
    struct Pattern;  // compressed by columns, with the sparse factors

    bool factoriseSparse();
    bool factoriseDense();

    std::size_t n_{};
    std::vector<std::uint32_t> entries_;
    std::vector<double> values_;  // of which these are the factors; empty: of none
    std::unique_ptr<Pattern> pattern_;
    bool isSparse_{};
    std::vector<double> dense_, scale_;
    std::vector<int> pivots_;
};

}  // namespace analogon
