#include "core/eval/rank_deficient.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <utility>

namespace analogon {
namespace {

constexpr double rounding = 1e-11;      // of rows that repeat each other, beside their largest entry
constexpr double contradiction = 1e-9;  // of what they say

thread_local UndecidedScope* innermost = nullptr;

}  // namespace

std::optional<RankDeficientSolution> solveRankDeficient(std::span<const double> matrix, std::span<const double> right,
                                                        double shift) {
    const auto n = static_cast<Eigen::Index>(right.size());
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::MatrixXd a = Eigen::Map<const RowMajor>(matrix.data(), n, n);
    Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(right.data(), n);
    if (!a.allFinite() || !b.allFinite()) return std::nullopt;
    for (Eigen::Index row = 0; row < n; ++row) {
        const double largest = a.row(row).cwiseAbs().maxCoeff();
        if (!(largest > 0)) continue;
        a.row(row) /= largest;
        b[row] /= largest;
    }
    Eigen::FullPivLU<Eigen::MatrixXd> lu(a);
    lu.setThreshold(rounding);
    if (lu.rank() == n) return std::nullopt;
    Eigen::VectorXd x = lu.solve(b);
    const double size = std::max(b.cwiseAbs().maxCoeff(), x.cwiseAbs().maxCoeff());
    if (!((a * x - b).cwiseAbs().maxCoeff() <= contradiction * size)) return std::nullopt;
    const Eigen::MatrixXd open = lu.kernel();  // columns: by how much all change with one that is left free
    x -= open * (open.transpose() * open).ldlt().solve(open.transpose() * x);
    x += open * Eigen::VectorXd::Constant(open.cols(), shift);
    RankDeficientSolution solution{{x.begin(), x.end()}, {}};
    for (Eigen::Index i = 0; i < n; ++i)
        solution.isUndecided.push_back(open.row(i).cwiseAbs().maxCoeff() > rounding ? 1 : 0);
    return solution;
}

UndecidedScope::UndecidedScope() : around_(std::exchange(innermost, this)) {}

UndecidedScope::~UndecidedScope() { innermost = around_; }

UndecidedScope* UndecidedScope::inForce() { return innermost; }

}  // namespace analogon
