#include "core/effect/search/verdicts.hpp"

#include <gtest/gtest.h>

#include "tests/core/effect/hand_made.hpp"
#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

CandidateResult line(const std::string& kind, Verdict verdict) {
    CandidateResult c;
    c.kind = c.className = kind;
    c.at = "x";
    c.verdict = verdict;
    return c;
}

Candidate candidate(const std::string& kind) {
    Candidate c;
    c.effect.kind = c.effect.className = kind;
    c.place.at = "x";
    return c;
}

TEST(Verdicts, OfWhatIsTakenOutGoToTheLineThatWasChosen) {
    WarmSearch of(laggingBody(0));
    Node node;
    node.candidates = {line("a", Verdict::Chosen), line("a", Verdict::Weaker), line("b", Verdict::Weaker)};
    setVerdict(of.search, node, candidate("a"), Verdict::NotSignificant, Text("not missed"));
    EXPECT_EQ(node.candidates[0].verdict, Verdict::NotSignificant);
    EXPECT_EQ(node.candidates[0].reason.english(), "not missed");
    EXPECT_EQ(node.candidates[1].verdict, Verdict::Weaker);
    setVerdict(of.search, node, candidate("a"), Verdict::Chosen, {});
    EXPECT_EQ(node.candidates[1].verdict, Verdict::Chosen) << "what is chosen is so in its last round";
    setVerdict(of.search, node, candidate("c"), Verdict::Chosen, {});  // no line, no change
    EXPECT_EQ(node.candidates.size(), 3u);
}

TEST(Verdicts, OfWhatWasChosenOnTheWayAndIsNotInTheEndAreSettled) {
    Finding finding;
    AddedEffect kept;
    kept.kind = "a";
    kept.at = "x";
    kept.instead.effects = {{"c", "x", 3, true}};
    finding.effects = {kept};
    std::vector<CandidateResult> candidates = {line("a", Verdict::Chosen), line("b", Verdict::Chosen),
                                               line("c", Verdict::Equivalent), line("d", Verdict::Equivalent)};
    settleVerdicts(finding, candidates);
    EXPECT_EQ(candidates[0].verdict, Verdict::Chosen);
    EXPECT_EQ(candidates[1].verdict, Verdict::NotSignificant);
    EXPECT_EQ(candidates[2].verdict, Verdict::Equivalent);
    EXPECT_EQ(candidates[3].verdict, Verdict::Weaker);
    EXPECT_FALSE(candidates[1].reason.empty());
    EXPECT_FALSE(candidates[3].reason.empty());
}

/// Trials beside a model that leaves noise: the first is chosen, each of the others at a place of its own does a little
/// worse.
TEST(StepOf, KeepsFiveRivalsBesideTheChoiceAndThoseAtItsOwnPlace) {
    constexpr int samples = 200;
    WarmSearch of(laggingBody(0));
    const NullModel null = modelThatLeaves(whiteNoise(samples), Eigen::MatrixXd(samples, 0));
    Round round;
    for (int i = 0; i < 20; ++i) {
        Trial t;
        t.ok = true;
        t.evidence = 100 - i;
        t.screened.candidate = candidate("effect " + std::to_string(i));
        t.screened.candidate.place.at = t.screened.candidate.place.connector = "place " + std::to_string(i);
        t.variant.effects.resize(1);
        t.fit.optimum.residuals = whiteNoise(samples);
        round.trials.push_back(t);
    }
    round.chosen = 0;
    EXPECT_EQ(stepOf(of.search, null, round).rivals.size(), 5u);
    round.trials.back().screened.candidate.place.connector = "place 0";
    EXPECT_EQ(stepOf(of.search, null, round).rivals.size(), 6u);
}

}  // namespace
}  // namespace analogon
