#include "core/effect/block/missing_flow.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/core/effect/heated_runs.hpp"

namespace analogon {
namespace {

constexpr int samples = HeatedRuns::samples, pieces = 40;
constexpr double interval = HeatedRuns::interval, capacity = HeatedRuns::capacity;

/// What a flow out of the body does to the reading, of hats that sum to 1 W: of each recording its own, in order.
TEST(FlowResponses, AreThoseOfEachPieceOfAFlow) {
    const NullModel null = HeatedRuns::fitted(2);
    const double G = null.fit.estimates.front().value;
    const std::vector<FlowResponse> responses = flowResponses(null, pieces, {}, {});
    const auto ofFlow = std::find_if(responses.begin(), responses.end(), [](const auto& r) { return r.isFlow; });
    ASSERT_TRUE(ofFlow != responses.end());
    EXPECT_EQ(ofFlow->unit, "W");
    EXPECT_NEAR(ofFlow->spacing, interval * (samples - 1) / pieces, 1e-9);
    ASSERT_EQ(ofFlow->blocks.size(), 2u);
    for (int run = 0; run < 2; ++run) {
        const ResponseBlock& block = ofFlow->blocks[static_cast<std::size_t>(run)];
        EXPECT_EQ(block.recording, run);
        EXPECT_EQ(block.begin, run * samples);
        const Eigen::MatrixXd& felt = block.columns;
        ASSERT_EQ(felt.rows(), samples) << "nothing is felt in the other recording";
        ASSERT_EQ(felt.cols(), pieces + 1);
        const double noise = null.noise[static_cast<std::size_t>(run)][0];
        for (int k = 0; k < samples; ++k)
            EXPECT_NEAR(-felt.row(k).sum() * noise, (1 - std::exp(-interval * k * G / capacity)) / G, 1e-4) << k;
        const double width = interval * (samples - 1) / pieces;
        for (int j = 1; j < pieces; ++j) {
            Eigen::Index latest = 0;
            felt.col(j).cwiseAbs().maxCoeff(&latest);
            EXPECT_NEAR(interval * static_cast<double>(latest), (j + 1) * width, width) << j;
        }
    }
}

TEST(FlowResponses, OfASensorsErrorShowOnItsOwnChannelAlone) {
    const NullModel null = HeatedRuns::fitted(2);
    const std::vector<FlowResponse> responses = flowResponses(null, pieces, {}, {}, {"output T"});
    ASSERT_EQ(responses.size(), 1u) << "no other was wanted";
    EXPECT_EQ(responses[0].place, "output T");
    EXPECT_FALSE(responses[0].isFlow);
    ASSERT_NE(responses[0].of(1), nullptr);
    EXPECT_EQ(responses[0].of(2), nullptr);
    const Eigen::MatrixXd& hats = responses[0].of(1)->columns;
    EXPECT_TRUE(hats.rowwise().sum().isOnes(1e-12)) << "all hats at 1 are a constant error";
    EXPECT_EQ(hats(0, 0), 1);
    EXPECT_EQ(hats(samples - 1, pieces), 1);
}

}  // namespace
}  // namespace analogon
