#include "core/effect/judge/settled_flows.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

namespace analogon {
namespace {

constexpr int pieces = 4, perRecording = 30, rows = 2 * perRecording;
constexpr double ofNeighbours[] = {0.2, 0.8, 0.97};

Eigen::MatrixXd random(Eigen::Index count, Eigen::Index columns, unsigned seed) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> normal;
    Eigen::MatrixXd m(count, columns);
    for (double& x : m.reshaped()) x = normal(engine);
    return m;
}

/// Two nodes that are felt in both recordings, and a sensor whose channel is half of the second one.
std::vector<FlowResponse> responses() {
    std::vector<FlowResponse> all;
    for (unsigned i = 0; i < 2; ++i)
        all.push_back({i == 0 ? "a" : "b",
                       true,
                       {{0, 0, random(perRecording, pieces + 1, 10 + i)},
                        {1, perRecording, random(perRecording, pieces + 1, 20 + i)}}});
    all.push_back({"output y", false, {{1, rows - perRecording / 2, random(perRecording / 2, pieces + 1, 30)}}});
    return all;
}

Eigen::MatrixXd dense(const FlowResponse& response) {
    const auto count = static_cast<Eigen::Index>(response.blocks.size());
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(rows, count * (pieces + 1));
    for (Eigen::Index b = 0; b < count; ++b) {
        const ResponseBlock& block = response.blocks[static_cast<std::size_t>(b)];
        columns.block(block.begin, b * (pieces + 1), block.columns.rows(), pieces + 1) = block.columns;
    }
    return columns;
}

/// q A C A', with the correlation of pieces of one recording.
Eigen::MatrixXd covariance(const FlowResponse& response, const SettledFlows::Flow& flow) {
    const Eigen::MatrixXd columns = dense(response);
    Eigen::MatrixXd c = Eigen::MatrixXd::Zero(columns.cols(), columns.cols());
    for (Eigen::Index i = 0; i < c.rows(); ++i)
        for (Eigen::Index j = 0; j < c.cols(); ++j)
            if (i / (pieces + 1) == j / (pieces + 1))
                c(i, j) = std::pow(ofNeighbours[flow.correlation], std::abs(static_cast<double>(i - j)));
    return flow.variance * columns * c * columns.transpose();
}

/// All that is asked for is what the covariance itself gives.
TEST(SettledFlows, AreTheInverseOfTheirCovariance) {
    const std::vector<FlowResponse> all = responses();
    SettledFlows flows(all, pieces);
    Eigen::MatrixXd b = Eigen::MatrixXd::Identity(rows, rows);
    const Eigen::MatrixXd x = random(rows, 3, 1);
    for (const SettledFlows::Flow& flow : {SettledFlows::Flow{1, 2, 0.3}, {2, 0, 4.0}, {0, 1, 0.02}}) {
        flows.add(flow);
        b += covariance(all[flow.response], flow);
        const Eigen::MatrixXd inverse = b.inverse();
        EXPECT_NEAR(flows.spread(), std::log(b.determinant()), 1e-9);
        const SettledFlows::Projected seen = flows.project(x);
        EXPECT_LT((seen.inner - x.transpose() * inverse * x).norm(), 1e-9 * x.squaredNorm());
        EXPECT_LT((flows.weighed(x.col(0)) - inverse * x.col(0)).norm(), 1e-9 * x.norm());
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (flows.has(i)) continue;
            const Eigen::MatrixXd columns = dense(all[i]);
            EXPECT_LT((flows.pieces(seen, i) - columns.transpose() * inverse * x).norm(), 1e-9 * columns.norm());
        }
    }
    EXPECT_EQ(flows.count(), 3u);
}

/// One more flow is turned into amplitudes that are independent beside those before.
TEST(SettledFlows, TurnAFurtherOneIntoOrthogonalTraces) {
    const std::vector<FlowResponse> all = responses();
    SettledFlows flows(all, pieces);
    flows.add({1, 2, 0.3});
    const auto source = flows.source(0, 1);
    ASSERT_TRUE(source);
    const Eigen::MatrixXd columns = dense(all[0]),
                          inverse = (Eigen::MatrixXd::Identity(rows, rows) + covariance(all[1], {1, 2, 0.3})).inverse();
    const Eigen::MatrixXd squares = columns.transpose() * inverse * columns;
    Eigen::MatrixXd traces(squares.rows(), squares.cols());
    for (Eigen::Index j = 0; j < squares.cols(); ++j)
        traces.col(j) = source->piecesOf(Eigen::VectorXd::Unit(squares.cols(), j));
    const Eigen::MatrixXd turned = traces.transpose() * squares * traces;
    EXPECT_LT((turned - Eigen::MatrixXd(source->squares.asDiagonal())).norm(), 1e-9 * turned.norm());
    EXPECT_LT((source->turned(squares * traces) - turned).norm(), 1e-9 * turned.norm());
}

TEST(SettledFlows, OfWhatIsNotFeltChangeNothing) {
    FlowResponse silent{"c", true, {{0, 0, Eigen::MatrixXd::Zero(perRecording, pieces + 1)}}};
    SettledFlows flows({silent}, pieces);
    EXPECT_FALSE(flows.source(0, 0));
    flows.add({0, 0, 1.0});
    EXPECT_EQ(flows.count(), 0u);
    EXPECT_EQ(flows.spread(), 0);
}

}  // namespace
}  // namespace analogon
