#include "core/effect/search/conclude.hpp"

#include <gtest/gtest.h>

#include "core/effect/search/best_path.hpp"
#include "core/effect/search/course_search.hpp"
#include "core/effect/search/experiments.hpp"
#include "core/effect/search/held_values.hpp"
#include "core/effect/search/laws.hpp"
#include "core/effect/search/path.hpp"
#include "core/effect/search/refine.hpp"
#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

Node lagFound(WarmSearch& of) {
    Node path{of.base, {}};
    goOn(of.search, path, of.decided());
    EXPECT_EQ(path.steps.size(), 1u);
    return path;
}

TEST(Conclude, KeepsAnEffectThatLeavesNoise) {
    WarmSearch of(laggingBody(3));
    Node node = lagFound(of);
    const Conclusion end = conclude(of.search, node, of.base, true);
    EXPECT_EQ(node.steps.size(), 1u);
    EXPECT_TRUE(end.proposed.empty());
    EXPECT_FALSE(end.leavesMuch);
    EXPECT_LT(end.misfit, misfitIn(of.base, of.base));
}

TEST(Conclude, TakesAllOutWhereAnotherAccountIsBetter) {
    WarmSearch of(laggingBody(3));
    Node node = lagFound(of);
    takeOutAll(of.search, node, of.base, Text("another account is better"));
    EXPECT_TRUE(node.steps.empty());
    EXPECT_TRUE(node.null.variant.effects.empty());
    for (const CandidateResult& c : node.candidates) EXPECT_NE(c.verdict, Verdict::Chosen);
}

TEST(Misfit, CountsWhatAParameterCosts) {
    WarmSearch of(laggingBody(3));
    const Node node = lagFound(of);
    const double rows = static_cast<double>(of.base.fit.optimum.residuals.size());
    EXPECT_NEAR(misfitIn(of.base, of.base), of.base.sumOfSquares() + std::log(rows), 1e-6 * of.base.sumOfSquares());
    EXPECT_EQ(node.null.parameterCount(), of.base.parameterCount() + 1);
}

TEST(IsExplained, IsNoiseBehindFewNames) {
    WarmSearch of(laggingBody(3));
    const Node node = lagFound(of);
    EXPECT_TRUE(isExplained(node, 1));
    EXPECT_FALSE(isExplained(node, 0));
    EXPECT_FALSE(isExplained({of.base, {}}, 1));
}

TEST(BestPath, OfNoiseIsTheModelAsGiven) {
    WarmSearch of(laggingBody(0));
    const Outcome<Node> best = bestPathFrom(of.search, of.base);
    ASSERT_TRUE(best);
    EXPECT_TRUE(best->steps.empty());
    EXPECT_FALSE(best->candidates.empty()) << "what was tried is told";
}

TEST(CourseSearch, SeeksNoChangeBehindNoise) {
    WarmSearch of(laggingBody(0));
    seekChange(of.search, of.base);
    EXPECT_FALSE(of.search.courses.isSought);
    EXPECT_FALSE(isChangeAll(of.search, of.base, of.base));
    settleChange(of.search, of.base, of.base);
    EXPECT_TRUE(of.search.courses.areEmpty());
}

TEST(CourseSearch, KeepsNoChangeThatExplainsNoMoreThanAnEffect) {
    WarmSearch of(laggingBody(3));
    const Node node = lagFound(of);
    seekChange(of.search, of.base);
    EXPECT_TRUE(of.search.courses.isSought);
    settleChange(of.search, of.base, node.null);
    EXPECT_TRUE(of.search.courses.areEmpty());
}

TEST(Laws, CountAsTheirTerms) {
    WarmSearch of(laggingBody(3));
    Node node = lagFound(of);
    EXPECT_EQ(termsIn(of.search, node.null), 1u);
    PlacedEffect& placed = node.null.variant.effects.front();
    placed.freed.push_back(placed.freed.front());
    of.search.laws[placed.effect.className] = "a law of two terms";
    EXPECT_EQ(termsIn(of.search, node.null), 2u);
}

TEST(HeldValues, AreNoneWhereNothingIsHeldThatCouldBeWrong) {
    EstimationTask task = laggingBody(3);
    task.parameters.push_back({"body.C", "J/K", 4, 1, 10});
    WarmSearch of(task);
    Node node = lagFound(of);
    for (const auto& [order, values] : heldValues(of.search, node)) EXPECT_TRUE(values.empty()) << order;
    EXPECT_TRUE(takeOutForHeld(of.search, node, {}).empty());
    EXPECT_TRUE(takeOutAllForHeld(of.search, node, of.base).empty());
    EXPECT_EQ(node.steps.size(), 1u);
}

TEST(Experiments, AreProposedForWhatIsOpenAlone) {
    WarmSearch of(laggingBody(3));
    Node node = lagFound(of);
    std::erase_if(node.steps.front().alternatives, [](const Alternative& a) { return a.equivalent; });
    EXPECT_TRUE(proposeExperiments(of.search, node).empty());
}

TEST(Refine, LeavesAloneWhatRoundsNothingOff) {
    WarmSearch of(laggingBody(3));
    Node node = lagFound(of);
    const double before = node.null.sumOfSquares();
    sharpen(of.search, node);
    treatAlike(of.search, node);
    EXPECT_EQ(node.null.sumOfSquares(), before);
}

}  // namespace
}  // namespace analogon
