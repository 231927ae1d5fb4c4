#include "core/effect/model/channel_rows.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace analogon {

namespace {

struct ThinFactors {
    Eigen::MatrixXd basis, factor;
};

/// QR factors, the orthonormal one with as many columns as there are directions.
ThinFactors thinFactors(const Eigen::MatrixXd& rows) {
    const Eigen::Index rank = std::min(rows.rows(), rows.cols());
    ThinFactors f{Eigen::MatrixXd::Identity(rows.rows(), rank), Eigen::MatrixXd::Zero(rank, rows.cols())};
    if (rank == 0) return f;
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(rows);
    f.basis.applyOnTheLeft(qr.householderQ());
    f.factor = qr.matrixQR().topRows(rank).triangularView<Eigen::Upper>();
    return f;
}

}  // namespace

ChannelwiseBasis::ChannelwiseBasis(const OrthogonalProjector& complement, const std::vector<ResidualChannel>& channels)
    : whole(complement.basis()) {
    const auto add = [&](Eigen::Index begin, Eigen::Index end) {
        ThinFactors f = thinFactors(whole.middleRows(begin, end - begin));
        parts.push_back({begin, end - begin, std::move(f.basis), std::move(f.factor)});
    };
    for (const ResidualChannel& c : channels) add(c.begin, c.end);
    const Eigen::Index end = channels.empty() ? 0 : channels.back().end;
    if (end < whole.rows()) add(end, whole.rows());
}

ChannelRows::ChannelRows(const ChannelwiseBasis& basis, std::size_t channel) : of_(basis), channel_(channel) {
    Eigen::Index rows = 0, at = 0;
    for (std::size_t p = 0; p < of_.parts.size(); ++p) rows += p == channel ? 0 : of_.parts[p].factor.rows();
    Eigen::MatrixXd factors(rows, of_.whole.cols());
    for (std::size_t p = 0; p < of_.parts.size(); ++p) {
        if (p == channel) continue;
        factors.middleRows(at, of_.parts[p].factor.rows()) = of_.parts[p].factor;
        at += of_.parts[p].factor.rows();
    }
    ThinFactors other = thinFactors(factors);
    elsewhere_ = std::move(other.basis);
    const ChannelwiseBasis::Part& own = of_.parts[channel];
    basis_.resize(own.count + other.factor.rows(), of_.whole.cols());
    basis_ << of_.whole.middleRows(own.begin, own.count), other.factor;
}

Eigen::MatrixXd ChannelRows::rest(const Eigen::MatrixXd& columns) const {
    Eigen::MatrixXd rest = Eigen::MatrixXd::Zero(basis_.rows(), columns.cols());
    rest.topRows(columns.rows()) = columns;
    for (int pass = 0; pass < 2; ++pass)  // what is left may be small against what was taken
        rest -= basis_ * (basis_.transpose() * rest).eval();
    return rest;
}

Eigen::VectorXd ChannelRows::operator()(const Eigen::VectorXd& vector) const {
    Eigen::VectorXd along(elsewhere_.rows());
    Eigen::Index at = 0;
    for (std::size_t p = 0; p < of_.parts.size(); ++p) {
        if (p == channel_) continue;
        const ChannelwiseBasis::Part& part = of_.parts[p];
        along.segment(at, part.factor.rows()) = part.basis.transpose() * vector.segment(part.begin, part.count);
        at += part.factor.rows();
    }
    const ChannelwiseBasis::Part& own = of_.parts[channel_];
    Eigen::VectorXd reduced(own.count + elsewhere_.cols());
    reduced << vector.segment(own.begin, own.count), elsewhere_.transpose() * along;
    return reduced;
}

}  // namespace analogon
