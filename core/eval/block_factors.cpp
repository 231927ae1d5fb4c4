#include "core/eval/block_factors.hpp"

#include <algorithm>

#include "core/eval/machine.hpp"
#include "core/eval/sparse_factors.hpp"

namespace analogon {
namespace {

/// Of fewer unknowns, or with more than one entry in so many, a matrix is as well taken as dense.
constexpr std::size_t fewestOfSparse = 24, mostOfSparse = 4;

/// Smallest over largest pivot below which dense elimination, which sees what rounding leaves of a column, decides
/// whether a matrix is singular.
constexpr double leastPivot = 1e-12;

/// What is left of a block once its other unknowns are eliminated has no diagonal to speak of: digits go before
/// fill-in.
constexpr double partialPivoting = 1;

}  // namespace

struct BlockFactors::Pattern {
    std::vector<int> starts, rows;
    std::vector<std::size_t> order;  // of the values, by columns
    std::vector<double> byColumns;
    std::unique_ptr<SparseFactors> factors;

    Pattern(std::size_t n, std::span<const std::uint32_t> entries) : starts(n + 1, 0) {
        for (const std::uint32_t e : entries) ++starts[e % n + 1];
        for (std::size_t j = 0; j < n; ++j) starts[j + 1] += starts[j];
        std::vector<int> next(starts.begin(), starts.end() - 1);
        rows.resize(entries.size());
        order.resize(entries.size());
        byColumns.resize(entries.size());
        for (std::size_t k = 0; k < entries.size(); ++k) {
            const auto at = static_cast<std::size_t>(next[entries[k] % n]++);
            rows[at] = static_cast<int>(entries[k] / n);
            order[at] = k;
        }
        factors = std::make_unique<SparseFactors>(static_cast<int>(n), starts.data(), rows.data(), partialPivoting);
    }
};

BlockFactors::BlockFactors() = default;
BlockFactors::BlockFactors(const BlockFactors&) : BlockFactors() {}
BlockFactors& BlockFactors::operator=(const BlockFactors&) { return *this = BlockFactors(); }
BlockFactors::BlockFactors(BlockFactors&&) noexcept = default;
BlockFactors& BlockFactors::operator=(BlockFactors&&) noexcept = default;
BlockFactors::~BlockFactors() = default;

bool BlockFactors::factorise(std::size_t n, std::span<const std::uint32_t> entries, std::span<const double> values) {
    // another program that runs on the same registers numbers its blocks anew
    const bool isSamePattern = n == n_ && std::equal(entries.begin(), entries.end(), entries_.begin(), entries_.end());
    if (isSamePattern && std::equal(values.begin(), values.end(), values_.begin(), values_.end())) return true;
    if (!isSamePattern) {
        n_ = n;
        entries_.assign(entries.begin(), entries.end());
        pattern_ = n >= fewestOfSparse && entries.size() * mostOfSparse <= n * n ? std::make_unique<Pattern>(n, entries)
                                                                                 : nullptr;
    }
    values_.assign(values.begin(), values.end());
    if (pattern_ && factoriseSparse()) return true;
    if (factoriseDense()) return true;
    values_.clear();
    return false;
}

bool BlockFactors::factoriseSparse() {
    Pattern& p = *pattern_;
    for (std::size_t k = 0; k < p.order.size(); ++k) p.byColumns[k] = values_[p.order[k]];
    isSparse_ = p.factors->factorise(p.byColumns.data()) && p.factors->pivotRatio() > leastPivot;
    return isSparse_;
}

bool BlockFactors::factoriseDense() {
    isSparse_ = false;
    dense_.assign(n_ * n_, 0.0);
    scale_.resize(n_);
    pivots_.resize(n_);
    for (std::size_t k = 0; k < entries_.size(); ++k) dense_[entries_[k]] = values_[k];
    return analogon::factorise(dense_, pivots_, scale_);
}

void BlockFactors::solve(double* right, int width) const {
    if (isSparse_)
        pattern_->factors->solve(right, width);
    else
        substitute(dense_, pivots_, right, width, width);
}

}  // namespace analogon
