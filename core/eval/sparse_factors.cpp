#include "core/eval/sparse_factors.hpp"

#include <suitesparse/klu.h>

#include <vector>

namespace analogon {

namespace {

/// Pivots of an earlier matrix serve while what they leave grows by no more than this.
constexpr double kLeastGrowth = 1e-3;

}  // namespace

struct SparseFactors::Klu {
    int n{};
    int *starts{}, *rows{};
    klu_common common{};
    klu_symbolic* symbolic{};
    klu_numeric* numeric{};
    std::vector<double> columns;  // scratch of solve()

    bool refactorise(double* entries) {
        return numeric && klu_refactor(starts, rows, entries, symbolic, numeric, &common) != 0 &&
               common.status == KLU_OK && klu_rgrowth(starts, rows, entries, symbolic, numeric, &common) != 0 &&
               common.rgrowth >= kLeastGrowth;
    }
};

SparseFactors::SparseFactors(int n, const int* starts, const int* rows, double leastDiagonal)
    : klu_(std::make_unique<Klu>()) {
    klu_->n = n;
    klu_->starts = const_cast<int*>(starts);  // only read
    klu_->rows = const_cast<int*>(rows);
    klu_defaults(&klu_->common);
    klu_->common.tol = leastDiagonal;
    klu_->symbolic = klu_analyze(n, klu_->starts, klu_->rows, &klu_->common);
}

SparseFactors::~SparseFactors() {
    klu_free_numeric(&klu_->numeric, &klu_->common);
    klu_free_symbolic(&klu_->symbolic, &klu_->common);
}

bool SparseFactors::factorise(const double* entries) {
    Klu& k = *klu_;
    if (!k.symbolic) return false;
    double* const values = const_cast<double*>(entries);  // only read
    if (k.refactorise(values)) return true;
    klu_free_numeric(&k.numeric, &k.common);
    k.numeric = klu_factor(k.starts, k.rows, values, k.symbolic, &k.common);
    if (k.numeric && k.common.status != KLU_OK) klu_free_numeric(&k.numeric, &k.common);
    return k.numeric != nullptr;
}

double SparseFactors::pivotRatio() const {
    Klu& k = *klu_;
    return klu_rcond(k.symbolic, k.numeric, &k.common) != 0 ? k.common.rcond : 0;
}

void SparseFactors::solve(double* b, int width) const {
    Klu& k = *klu_;
    if (width == 1) {
        klu_solve(k.symbolic, k.numeric, k.n, 1, b, &k.common);
        return;
    }
    const auto n = static_cast<std::size_t>(k.n), count = static_cast<std::size_t>(width);
    k.columns.resize(n * count);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < count; ++j) k.columns[j * n + i] = b[i * count + j];
    klu_solve(k.symbolic, k.numeric, k.n, width, k.columns.data(), &k.common);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < count; ++j) b[i * count + j] = k.columns[j * n + i];
}

}  // namespace analogon
