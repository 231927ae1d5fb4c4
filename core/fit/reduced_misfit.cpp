#include "core/fit/reduced_misfit.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace analogon {

ReducedMisfit reduce(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residuals) {
    const Eigen::Index K = jacobian.cols(), rows = jacobian.rows();
    constexpr Eigen::Index blockRows = 256;  // stays in the cache
    Eigen::MatrixXd stack(K + 1 + blockRows, K + 1);
    Eigen::MatrixXd triangle = Eigen::MatrixXd::Zero(K + 1, K + 1);
    Eigen::HouseholderQR<Eigen::MatrixXd> qr;
    for (Eigen::Index row = 0; row < rows; row += blockRows) {
        const Eigen::Index count = std::min(blockRows, rows - row);
        if (count != blockRows) stack.resize(K + 1 + count, K + 1);
        stack.topRows(K + 1) = triangle;
        stack.bottomRows(count).leftCols(K) = jacobian.middleRows(row, count);
        stack.bottomRows(count).col(K) = residuals.segment(row, count);
        qr.compute(stack);
        triangle = qr.matrixQR().topRows(K + 1).triangularView<Eigen::Upper>();
    }
    ReducedMisfit result;
    result.ok = triangle.allFinite();
    result.jacobian = triangle.leftCols(K);
    result.residuals = triangle.col(K);
    return result;
}

}  // namespace analogon
