#include "core/effect/search/ending.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/effect/model/model_state.hpp"
#include "tests/core/effect/search/warm_nodes.hpp"

namespace analogon {
namespace {

Finding told(WarmSearch& of, const Node& node, std::vector<HeldInstead> heldWrongly = {}) {
    const auto state = [&](const NullModel& model) {
        Outcome<ModelState> s = stateOf(model.variant, model.fit, of.search.fit.simulation, {});
        EXPECT_TRUE(s) << format(s.diagnostics());
        return s ? std::move(*s) : ModelState();
    };
    Ending end;
    end.finding.baseline = state(of.base);
    end.finding.final = state(node.null);
    end.node = node;
    end.base = of.base;
    end.heldWrongly = std::move(heldWrongly);
    return tellEnding(of.search, std::move(end));
}

TEST(TellEnding, IsAnEffectWhereNoiseIsLeftBehindOne) {
    WarmSearch of(laggingBody(3));
    const Finding finding = told(of, lagFound(of));
    EXPECT_EQ(finding.kind, FindingKind::Effect);
    ASSERT_EQ(finding.effects.size(), 1u);
    EXPECT_EQ(finding.effects[0].kind, "sensor.lag");
    EXPECT_TRUE(finding.unexplained.remainders.empty());
    EXPECT_TRUE(std::any_of(finding.candidates.begin(), finding.candidates.end(),
                            [](const CandidateResult& c) { return c.verdict == Verdict::Chosen; }));
}

TEST(TellEnding, IsAdequateWhereTheModelLeavesNoise) {
    WarmSearch of(laggingBody(0));
    const Finding finding = told(of, {of.base, {}});
    EXPECT_EQ(finding.kind, FindingKind::Adequate);
    EXPECT_TRUE(finding.effects.empty());
    EXPECT_TRUE(finding.unexplained.remainders.empty());
}

TEST(TellEnding, IsUnexplainedWhereStructureIsLeftAndSaysWhere) {
    WarmSearch of(laggingBody(3));
    const Finding finding = told(of, {of.base, {}});
    EXPECT_EQ(finding.kind, FindingKind::Unexplained);
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    EXPECT_EQ(finding.unexplained.remainders[0].output, "T");
    EXPECT_EQ(finding.unexplained.remainders[0].experiment, "warm-up");
}

TEST(TellEnding, OffersTheValueOfWhatIsHeldWronglyFirst) {
    WarmSearch of(laggingBody(3));
    HeldInstead held;
    held.parameter = "body.C";
    held.unit = "J/K";
    held.held = 4;
    held.value = 6;
    held.explained = 500;
    const Finding finding = told(of, {of.base, {}}, {held});
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    EXPECT_NE(finding.unexplained.remainders[0].proposal.equation.find("body.C"), std::string::npos)
        << finding.unexplained.remainders[0].proposal.equation;
}

}  // namespace
}  // namespace analogon
