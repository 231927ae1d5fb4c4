#include "core/effect/model/channel_rows.hpp"

#include <gtest/gtest.h>

#include <random>

namespace analogon {
namespace {

Eigen::MatrixXd random(Eigen::Index rows, Eigen::Index columns, std::uint64_t seed) {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal;
    Eigen::MatrixXd x(rows, columns);
    for (double& v : x.reshaped()) v = normal(generator);
    return x;
}

std::vector<ResidualChannel> channelsEndingAt(const std::vector<int>& ends) {
    std::vector<ResidualChannel> channels;
    for (int begin = 0; const int end : ends) {
        channels.push_back({0, static_cast<int>(channels.size()), begin, end, {}});
        begin = end;
    }
    return channels;
}

struct Case {
    std::vector<int> ends;  // of the channels
    int rows{};             // of the Jacobian
};

class ChannelRowsOf : public testing::TestWithParam<Case> {};

/// Against columns that are written out in all rows.
TEST_P(ChannelRowsOf, KeepLengthsAndProducts) {
    const auto [ends, rows] = GetParam();
    const std::vector<ResidualChannel> channels = channelsEndingAt(ends);
    const OrthogonalProjector complement(random(rows, 4, 1));
    const ChannelwiseBasis basis(complement, channels);
    const Eigen::VectorXd residual = complement(random(rows, 1, 2));
    for (std::size_t c = 0; c < channels.size(); ++c) {
        const int begin = channels[c].begin, count = channels[c].end - begin;
        const Eigen::MatrixXd own = random(count, 3, 3);
        Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(rows, 3);
        columns.middleRows(begin, count) = own;
        const Eigen::MatrixXd whole = complement(columns);
        const ChannelRows through(basis, c);
        const Eigen::MatrixXd rest = through.rest(own);
        EXPECT_LE(rest.rows(), count + 4);
        EXPECT_LT((rest.transpose() * rest - whole.transpose() * whole).norm(), 1e-12 * whole.squaredNorm()) << c;
        EXPECT_LT((rest.transpose() * through(residual) - whole.transpose() * residual).norm(), 1e-12 * whole.norm())
            << c;
        EXPECT_LT((rest.topRows(count) - whole.middleRows(begin, count)).norm(), 1e-12 * whole.norm()) << c;
    }
}

INSTANTIATE_TEST_SUITE_P(Recordings, ChannelRowsOf,
                         testing::Values(Case{{40}, 40},            // one channel
                                         Case{{40, 70, 100}, 100},  // several
                                         Case{{40, 42, 100}, 100},  // one of them shorter than there are parameters
                                         Case{{40, 70}, 73}));      // and rows of priors behind them

/// What the parameters imitate in the channel alone leaves nothing, to rounding.
TEST(ChannelRows, LeaveNothingOfWhatTheJacobianHasInThatChannelAlone) {
    const std::vector<ResidualChannel> channels = channelsEndingAt({30, 60});
    Eigen::MatrixXd jacobian = random(60, 3, 1);
    jacobian.col(1).head(30).setZero();
    const ChannelwiseBasis basis(OrthogonalProjector(jacobian), channels);
    const Eigen::MatrixXd imitated = jacobian.col(1).tail(30);
    EXPECT_LT(ChannelRows(basis, 1).rest(imitated).norm(), 1e-14 * imitated.norm());
    const Eigen::MatrixXd shared = jacobian.col(0).tail(30);  // moves the other channel as well
    EXPECT_GT(ChannelRows(basis, 1).rest(shared).norm(), 0.1 * shared.norm());
}

}  // namespace
}  // namespace analogon
