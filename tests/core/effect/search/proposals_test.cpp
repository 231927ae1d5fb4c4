#include "core/effect/search/proposals.hpp"

#include <gtest/gtest.h>

#include "core/effect/model/model_state.hpp"
#include "tests/core/effect/search/warm_nodes.hpp"

namespace analogon {
namespace {

/// The node of a lag that has no name: an equation.
Node lagAsEquation(WarmSearch& of) {
    for (EffectClass& e : of.search.catalogue)
        if (e.kind == "sensor.lag") {
            e.kind = "proposal.sensor.lag";
            e.proposal = "T*der(y) = u - y";
        }
    return nodeThatChose(of, "proposal.sensor.lag");
}

TEST(TakeOutProposals, OffersTheEquationAndEndsWithoutIt) {
    WarmSearch of(laggingBody(3));
    Node node = lagAsEquation(of);
    const Conclusion end = takeOutProposals(of.search, node);
    EXPECT_TRUE(node.steps.empty());
    EXPECT_TRUE(node.null.variant.effects.empty());
    ASSERT_EQ(end.proposed.size(), 1u);
    EXPECT_EQ(end.proposed[0].node, "output T");
    EXPECT_EQ(end.proposed[0].proposal.className, "Analogon.Effects.Sensor.Lag");
    EXPECT_NE(end.proposed[0].proposal.equation.find("with T = "), std::string::npos)
        << end.proposed[0].proposal.equation;
    EXPECT_LT(end.proposed[0].proposal.errors.fit, 1);
    ASSERT_TRUE(end.with);
    EXPECT_LT(end.with->sumOfSquares(), node.null.sumOfSquares());
    ASSERT_TRUE(end.model);
    EXPECT_NE(end.model->state.modelText.find("Lag"), std::string::npos);
}

TEST(TakeOutProposals, LeavesNamesAlone) {
    WarmSearch of(laggingBody(3));
    Node node = nodeThatChose(of, "sensor.lag");
    const Conclusion end = takeOutProposals(of.search, node);
    EXPECT_EQ(node.steps.size(), 1u);
    EXPECT_TRUE(end.proposed.empty());
    EXPECT_FALSE(end.with);
}

/// A name that was chosen behind an equation, and is missed for so many times what is left above the noise.
Node nameBehindEquation(WarmSearch& of, double timesWhatIsLeft) {
    Node equation = lagAsEquation(of);
    WarmSearch alone(laggingBody(0, 2));
    Node node = together(of, std::move(equation), nodeThatChose(alone, "sensor.offset"));
    node.null.fit.optimum.residuals *= 2;
    node.steps.back().chi2Decrease = timesWhatIsLeft * excess(node.null);
    of.search.journal.choices = node.steps.back().order;
    return node;
}

TEST(SetAside, IsWhatMayOnlyMendTheEquationBeforeIt) {
    WarmSearch of(laggingBody(3));
    Node node = nameBehindEquation(of, 4.9);
    setAsideBehindProposal(of.search, node);
    ASSERT_EQ(node.steps.size(), 1u);
    EXPECT_TRUE(hasProposal(node.null));
    ASSERT_EQ(node.displaced.size(), 1u);
    EXPECT_EQ(node.displaced[0].effect.effect.kind, "sensor.offset");
}

TEST(SetAside, IsNothingThatExplainsFarMoreThanAllThatIsLeft) {
    WarmSearch of(laggingBody(3));
    Node node = nameBehindEquation(of, 5.1);
    setAsideBehindProposal(of.search, node);
    EXPECT_EQ(node.steps.size(), 2u);
    EXPECT_TRUE(node.displaced.empty());
}

TEST(BringBack, IsOfWhatIsMissedWithoutTheEquationAlone) {
    for (const double leftByEquations : {1e6, -1e6}) {
        WarmSearch of(laggingBody(3));
        const Node lag = nodeThatChose(of, "sensor.lag");
        Node node{of.base, {}};
        node.candidates = lag.candidates;
        node.displaced = {{lag.null.variant.effects.front(), lag.steps.front()}};
        bringBackDisplaced(of.search, node, leftByEquations);
        EXPECT_TRUE(node.displaced.empty());
        EXPECT_EQ(node.steps.size(), leftByEquations > 0 ? 1u : 0u)
            << "where the equations left next to nothing, a name that leaves more only imitates them";
    }
    WarmSearch noise(laggingBody(0)), other(laggingBody(3));
    const Node lag = nodeThatChose(other, "sensor.lag");
    Node node{noise.base, {}};
    node.displaced = {{lag.null.variant.effects.front(), lag.steps.front()}};
    bringBackDisplaced(noise.search, node, 1e6);
    EXPECT_TRUE(node.steps.empty()) << "it is not missed";
}

}  // namespace
}  // namespace analogon
