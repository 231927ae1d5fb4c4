#include "core/effect/block/probe_score.hpp"

#include <gtest/gtest.h>

#include "tests/core/effect/block/candidates_of.hpp"
#include "tests/core/effect/lagging_body.hpp"

namespace analogon {
namespace {

TEST(Imitators, AreTheParametersThatATraceFollows) {
    const NullModel null = fittedModel(laggingBody(0));
    EXPECT_EQ(imitators(null, 2 * null.fit.optimum.jacobian.col(0)), std::vector<std::string>{"joint.G"});
}

TEST(ProbeScore, IsThatOfWhatTheParametersLeaveOfATrace) {
    const NullModel null = fittedModel(laggingBody(0, 2));
    const Eigen::VectorXd slope = null.fit.optimum.jacobian.col(0),
                          offset = Eigen::VectorXd::Constant(slope.size(), 1 / null.noise[0][0]);
    Probe absorbed, seen, wrong;
    scoreProbe(null, true, slope, absorbed);
    scoreProbe(null, true, offset, seen);
    scoreProbe(null, true, -offset, wrong);
    EXPECT_LT(absorbed.plain.visible, 1e-6);
    EXPECT_EQ(scoreOf(absorbed.plain), 0);
    EXPECT_GT(scoreOf(seen.plain), 0.5 * null.sumOfSquares());
    EXPECT_TRUE(wrong.plain.wrongSign);
    EXPECT_EQ(scoreOf(wrong.plain), 0) << "an effect of one sign";
    Probe same;
    scoreProbe(null, true, offset + slope, same);
    EXPECT_NEAR(same.plain.explained, seen.plain.explained, 1e-6 * seen.plain.explained);
}

TEST(SecantTrace, IsNoneWhereTheSimulationDiffersByRoundingAlone) {
    const NullModel null = fittedModel(laggingBody(0, 2));
    const Eigen::VectorXd& own = null.fit.optimum.residuals;
    const Eigen::VectorXd rounded = own * (1 + 1e-9), moved = own * 1.01;
    EXPECT_EQ(secantTrace(null, rounded, 0.5), Eigen::VectorXd::Zero(own.size()));
    EXPECT_TRUE(secantTrace(null, moved, 0.5).isApprox(0.02 * own, 1e-9));
}

}  // namespace
}  // namespace analogon
