#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/effect/model/score.hpp"

namespace analogon {

/// The basis of a Jacobian's columns by channels: QR factors of its rows in each, of which those of all but one give
/// what it has in the other rows.
struct ChannelwiseBasis {
    struct Part {
        Eigen::Index begin{}, count{};
        Eigen::MatrixXd basis;   // orthonormal, of these rows
        Eigen::MatrixXd factor;  // triangular: basis * factor is the Jacobian's basis in these rows
    };
    ChannelwiseBasis(const OrthogonalProjector& complement, const std::vector<ResidualChannel>& channels);

    Eigen::MatrixXd whole;    // of the Jacobian, orthonormal
    std::vector<Part> parts;  // the channels in their order, and what rows there are behind them
};

/// Columns that stand in the rows of one channel alone, less what a Jacobian of all rows explains of them, in fewer
/// coordinates than there are rows: those of the channel, and one for each direction that the Jacobian has elsewhere.
/// Lengths and products are what they are in all rows.
class ChannelRows {
public:
    /// `channel`: its place among those of the basis, which must outlive this.
    ChannelRows(const ChannelwiseBasis& basis, std::size_t channel);

    /// What is left of columns (the rows of the channel) beside the Jacobian.
    Eigen::MatrixXd rest(const Eigen::MatrixXd& columns) const;
    /// A vector of all rows that is orthogonal to the Jacobian: its products with what is left of columns are what they
    /// are in all rows.
    Eigen::VectorXd operator()(const Eigen::VectorXd& vector) const;

private:
    const ChannelwiseBasis& of_;
    std::size_t channel_;
    Eigen::MatrixXd elsewhere_;  // orthonormal basis of the other parts' factors, one upon the other
    Eigen::MatrixXd basis_;      // of the Jacobian, orthonormal, in these coordinates
};

}  // namespace analogon
