#pragma once

#include <cstdint>
#include <vector>

#include "core/eval/machine.hpp"

namespace analogon {

/// Scratch of the solvers for a block of n unknowns.
inline void reserveScratch(Registers& r, std::size_t n) {
    if (r.matrix.size() < n * n) r.matrix.resize(n * n);
    if (r.vector.size() < n) {
        r.vector.resize(n);
        r.trial.resize(n);
        r.start.resize(n);
        r.rowScale.resize(n);
        r.scale.resize(n);
        r.pivots.resize(n);
    }
    r.rows.resize(std::max(r.rows.size(), n * static_cast<std::size_t>(r.lanes)));
}

/// The factors that are kept of a block of n unknowns, of so many blocks; null: it is too small for that.
inline BlockFactors* keptOf(std::vector<BlockFactors>& all, std::size_t number, std::size_t count, std::size_t n) {
    if (n < BlockFactors::fewestUnknowns) return nullptr;
    if (all.size() < count) all.resize(count);
    return &all[number];
}

/// The matrix of a block that stands in these registers, row-major; of a large one only the `entries` are looked at.
class BlockMatrix {
public:
    BlockMatrix(const std::vector<std::uint32_t>& matrix, const std::vector<std::uint32_t>& entries, std::size_t n,
                BlockFactors* kept, Registers& registers)
        : matrix_(matrix), entries_(entries), n_(n), kept_(kept), r_(registers) {
        reserveScratch(r_, n_);
    }

    void load() {
        if (kept_)
            for (std::size_t k = 0; k < entries_.size(); ++k) r_.matrix[k] = r_.values[matrix_[entries_[k]]];
        else
            for (std::size_t i = 0; i < n_ * n_; ++i) r_.matrix[i] = r_.values[matrix_[i]];
    }
    /// each(row, column, value) of what was loaded.
    template <class Each>
    void visit(const Each& each) const {
        const std::size_t count = kept_ ? entries_.size() : n_ * n_;
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t at = kept_ ? entries_[k] : k;
            each(at / n_, at % n_, r_.matrix[k]);
        }
    }
    bool factorise() {
        return kept_ ? kept_->factorise(n_, entries_, {r_.matrix.data(), entries_.size()})
                     : analogon::factorise({r_.matrix.data(), n_ * n_}, {r_.pivots.data(), n_}, {r_.scale.data(), n_});
    }
    /// In place, for `width` right-hand sides, row-major.
    void solve(double* right, int width) const {
        if (kept_)
            kept_->solve(right, width);
        else
            substitute({r_.matrix.data(), n_ * n_}, {r_.pivots.data(), n_}, right, width, width);
    }

private:
    const std::vector<std::uint32_t>&matrix_, &entries_;
    std::size_t n_;
    BlockFactors* kept_;
    Registers& r_;
};

}  // namespace analogon
