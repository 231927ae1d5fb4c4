#include "core/effect/search/prune.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/base/work.hpp"
#include "core/effect/judge/judgement.hpp"
#include "core/effect/model/model_state.hpp"
#include "tests/core/effect/search/warm_nodes.hpp"

namespace analogon {
namespace {

TEST(Prune, KeepsWhatIsMissedAndTakesOutWhatIsNot) {
    WarmSearch of(laggingBody(3));
    Node node = nodeThatChose(of, "sensor.lag");
    WarmSearch alone(laggingBody(0, 2));
    Node other = nodeThatChose(alone, "sensor.offset");
    std::vector<PlacedEffect> both = node.null.variant.effects;
    both.push_back(other.null.variant.effects.front());
    std::optional<NullModel> with = refittedWith(of.search, node.null, both);
    ASSERT_TRUE(with);
    node.null = std::move(*with);
    node.steps.push_back(other.steps.front());
    removeUnneeded(of.search, node, 0);
    ASSERT_EQ(node.steps.size(), 1u);
    EXPECT_EQ(node.null.variant.effects.front().effect.kind, "sensor.lag");
    EXPECT_GT(node.steps.front().chi2Decrease, 100);
    EXPECT_GT(node.steps.front().errorWithout, of.search.frontier.bestError);
}

TEST(Prune, CountsTheSameWorkWhateverTheThreads) {
    const auto work = [](int threads) {
        DiscoverOptions options;
        options.threads = threads;
        WarmSearch of(laggingBody(3), options);
        Node node = nodeThatChose(of, "sensor.lag");
        WarmSearch alone(laggingBody(0, 2));
        Node other = nodeThatChose(alone, "sensor.offset");
        std::vector<PlacedEffect> both = other.null.variant.effects;  // what is taken out is judged first
        both.push_back(node.null.variant.effects.front());
        std::optional<NullModel> with = refittedWith(of.search, node.null, both);
        EXPECT_TRUE(with);
        node.null = std::move(*with);
        node.steps.insert(node.steps.begin(), other.steps.front());
        const WorkCount count;
        removeUnneeded(of.search, node, 0, true);
        EXPECT_EQ(node.steps.size(), 1u);
        return count.done();
    };
    const double alone = work(1);
    EXPECT_GT(alone, 0);
    EXPECT_EQ(work(4), alone);
}

TEST(Prune, NeverTakesTheLastOfSoMany) {
    WarmSearch of(laggingBody(0)), other(laggingBody(3));
    Node node = nodeThatChose(other, "sensor.lag");
    std::optional<NullModel> with = refittedWith(of.search, of.base, node.null.variant.effects);
    ASSERT_TRUE(with);
    node.null = std::move(*with);
    Node kept = node;
    removeUnneeded(of.search, kept, 1);
    EXPECT_EQ(kept.steps.size(), 1u);
    removeUnneeded(of.search, node, 0);
    EXPECT_TRUE(node.steps.empty()) << "noise alone needs no lag";
}

TEST(RemoveOutweighed, TakesOutWhatExplainsLittleAgainstWhatIsLeft) {
    const auto kept = [](double share) {
        WarmSearch of(laggingBody(3));
        Node node = nodeThatChose(of, "sensor.lag");
        node.null.fit.optimum.residuals *= 2;
        node.steps.front().chi2Decrease = share * excess(node.null);
        removeOutweighed(of.search, node, leastOfRest);
        return node.steps.size();
    };
    EXPECT_EQ(kept(0.51), 1u);
    EXPECT_EQ(kept(0.49), 0u);
}

TEST(DropIndistinct, TakesOutWhatTheReportWouldNotTellFromZero) {
    const auto isDropped = [](double standardError) {
        WarmSearch of(laggingBody(3));
        Node node = nodeThatChose(of, "sensor.lag");
        ModelState state;
        state.parameters = node.null.fit.estimates;
        state.parameters.back().value = 3;
        state.parameters.back().standardError = standardError;
        state.parameters.front().standardError = 0.001;
        const NullModel last = node.null;
        const bool is = dropIndistinct(of.search, last, state, node);
        EXPECT_EQ(node.steps.size(), is ? 0u : 1u);
        return is;
    };
    EXPECT_FALSE(isDropped(2.9));
    EXPECT_TRUE(isDropped(3.1));
}

TEST(DropUnmissed, AsksOnAllSamplesForWhatMeansOfThemMissed) {
    WarmSearch of(laggingBody(3));
    Node node = nodeThatChose(of, "sensor.lag");
    const NullModel last = node.null;
    EXPECT_FALSE(dropUnmissed(of.search, last, node));
    EXPECT_GT(node.steps.front().errorWithout, of.search.frontier.bestError);
    WarmSearch noise(laggingBody(0));
    std::optional<NullModel> needless = refittedWith(noise.search, noise.base, last.variant.effects);
    ASSERT_TRUE(needless);
    Node other{*needless, node.steps};
    EXPECT_TRUE(dropUnmissed(noise.search, *needless, other));
    EXPECT_TRUE(other.steps.empty());
}

TEST(IsColouredNoise, IsNoiseWithAMemoryThatMovesWithNothing) {
    EstimationTask task = laggingBody(0);
    std::mt19937 random(7);
    std::normal_distribution<double> normal(0, 0.1);
    double course = 0;
    Recording& r = task.recordings.edit().front();
    for (Eigen::Index k = 0; k < r.outputs.cols(); ++k) r.outputs(0, k) += course = 0.6 * course + normal(random);
    WarmSearch coloured(task), white(laggingBody(0)), lagging(laggingBody(3));
    EXPECT_TRUE(isColouredNoise(coloured.search, coloured.base));
    EXPECT_FALSE(isColouredNoise(white.search, white.base)) << "it has no memory";
    EXPECT_FALSE(isColouredNoise(lagging.search, lagging.base)) << "it moves with the input";
}

}  // namespace
}  // namespace analogon
