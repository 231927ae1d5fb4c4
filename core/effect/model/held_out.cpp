#include "core/effect/model/held_out.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>

#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::screen;

namespace {

/// A part of the record, all but the directions of its rows that are `kept` (columns, orthonormal).
Eigen::MatrixXd beside(const Eigen::MatrixXd& kept, const Eigen::MatrixXd& part) {
    return part - kept * (kept.transpose() * part);
}

/// Residual on the left-out part after one Gauss-Newton refit to the rest.
Eigen::VectorXd leftOutResidual(const Linearisation& model, const Eigen::MatrixXd& normal, const Eigen::VectorXd& scale,
                                const std::vector<Eigen::Index>& rows, const Eigen::MatrixXd& kept) {
    const Eigen::VectorXd residual = beside(kept, model.residuals(rows));
    if (normal.cols() == 0) return residual;
    const Eigen::MatrixXd block = beside(kept, model.jacobian(rows, Eigen::all) * scale.asDiagonal());
    Eigen::MatrixXd rest = normal - block.transpose() * block;
    rest.diagonal().array() +=
        1e-6;  // columns are scaled to unit norm: keeps a direction seen in this block alone in place
    return residual + block * rest.ldlt().solve(block.transpose() * residual);
}

/// What these rows alone tell of the parameters, as directions of the rows (columns, orthonormal): those of which the
/// rest of the record has next to no information.
Eigen::MatrixXd toldHereAlone(const Linearisation& model, const Eigen::MatrixXd& normal, const Eigen::VectorXd& scale,
                              const std::vector<Eigen::Index>& rows) {
    const auto count = static_cast<Eigen::Index>(rows.size());
    if (normal.cols() == 0) return Eigen::MatrixXd(count, 0);
    const Eigen::MatrixXd block = model.jacobian(rows, Eigen::all) * scale.asDiagonal();
    Eigen::MatrixXd whole = normal;
    whole.diagonal().array() += 1e-9;  // unit columns: a direction that nothing tells of loses nothing
    const Eigen::LLT<Eigen::MatrixXd> root(whole);
    const Eigen::MatrixXd own = root.matrixL().solve(block.transpose());  // of parameters in which all rows count 1
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> shares(own * own.transpose());
    const Eigen::Index alone = (shares.eigenvalues().array() > 1 - leastSharedInformation).count();
    return own.transpose() * shares.eigenvectors().rightCols(alone) *
           shares.eigenvalues().tail(alone).cwiseSqrt().cwiseInverse().asDiagonal();
}

}  // namespace

HeldOut::Model::Model(const Linearisation& l) : linear(l), scale(l.jacobian.colwise().norm().transpose()) {
    for (double& s : scale) s = s > 0 ? 1 / s : 0;
    const Eigen::MatrixXd unit = l.jacobian * scale.asDiagonal();
    normal = unit.transpose() * unit;
}

HeldOut::HeldOut(const Linearisation& without, const Linearisation& with) : without_(without), with_(with) {}

LeftOutPart HeldOut::part(const std::vector<Eigen::Index>& rows) const {
    // what only this part of the record says of an effect is not left out; what it claims there is unconfirmed
    const Eigen::MatrixXd alone = toldHereAlone(with_.linear, with_.normal, with_.scale, rows);
    const auto left = [&](const Model& m) { return leftOutResidual(m.linear, m.normal, m.scale, rows, alone); };
    const Eigen::VectorXd difference = with_.linear.residuals(rows) - without_.linear.residuals(rows);
    return {left(without_), left(with_), (alone.transpose() * difference).squaredNorm()};
}

double heldOutGain(const std::vector<ResidualChannel>& channels, const Linearisation& without,
                   const Linearisation& with, int blocks, int folds) {
    const HeldOut heldOut(without, with);
    double gained = 0, moved = 0;
    for (int fold = 0; fold < std::min(folds, blocks); ++fold) {
        std::vector<Eigen::Index> rows;
        for (const ResidualChannel& c : channels) {
            const int last = c.samples.back() + 1;
            for (int row = c.begin; row < c.end; ++row)
                if (static_cast<long>(c.samples[static_cast<std::size_t>(row - c.begin)]) * blocks / last % folds ==
                    fold)
                    rows.push_back(row);
        }
        if (rows.empty()) continue;
        const LeftOutPart part = heldOut.part(rows);
        gained += part.without.squaredNorm() - part.with.squaredNorm();
        moved += part.unconfirmed;
        moved += (part.with - part.without).squaredNorm();
    }
    return moved > 0 ? gained / moved : 0;
}

}  // namespace analogon
