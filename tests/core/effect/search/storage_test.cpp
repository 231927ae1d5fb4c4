#include "core/effect/search/storage.hpp"

#include <gtest/gtest.h>

#include "core/effect/search/verdicts.hpp"
#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

/// A draught that nobody recorded, on the output.
void addDraught(EstimationTask& task, double size) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    Recording& r = task.recordings.edit().front();
    double course = 0;
    for (Eigen::Index k = 0; k < r.outputs.cols(); ++k) {
        course = 0.98 * course + size * normal(random);
        r.outputs(0, k) += course;
    }
}

/// The model with a dead time at its sensor that is only indicated.
Node withDeadTime(WarmSearch& of) {
    Node node{of.base, {}};
    Round round = tryAll(of.search, of.base);
    for (std::size_t i = 0; i < round.trials.size() && !round.chosen; ++i)
        if (round.candidate(i).effect.kind == "sensor.delay" && round.trials[i].ok) round.chosen = i;
    if (!round.chosen) {
        ADD_FAILURE() << "no dead time was tried";
        return node;
    }
    node.steps.push_back(stepOf(of.search, of.base, round));
    node.steps.back().prediction.emplace();
    Outcome<NullModel> fitted =
        fitNull(node.steps.back().winner.variant, of.base.noise, NoiseLevel::Keep, of.search.fit, of.search.progress);
    EXPECT_TRUE(fitted) << format(fitted.diagnostics());
    if (fitted) node.null = std::move(*fitted);
    return node;
}

TEST(Storage, TakesThePlaceOfALongDeadTime) {
    EstimationTask task = laggingBody(3);
    addDraught(task, 0.1);
    WarmSearch of(task);
    Node node = withDeadTime(of);
    EXPECT_TRUE(storageForDeadTimes(of.search, node));
    ASSERT_EQ(node.null.variant.effects.size(), 1u);
    EXPECT_EQ(node.null.variant.effects.front().effect.kind, "sensor.lag");
    EXPECT_EQ(node.steps.size(), 1u);
}

TEST(Storage, LeavesADeadTimeThatItCannotStandInFor) {
    EstimationTask task = laggingBody(0);
    Eigen::MatrixXd& outputs = task.recordings.edit().front().outputs;
    const Eigen::MatrixXd prompt = outputs;
    for (Eigen::Index k = 0; k < prompt.cols(); ++k) outputs(0, k) = prompt(0, std::max<Eigen::Index>(0, k - 40));
    addDraught(task, 0.02);
    WarmSearch of(task);
    Node node = withDeadTime(of);
    EXPECT_FALSE(storageForDeadTimes(of.search, node));
    ASSERT_EQ(node.null.variant.effects.size(), 1u);
    EXPECT_EQ(node.null.variant.effects.front().effect.kind, "sensor.delay");
}

TEST(Storage, LeavesAnEstablishedDeadTimeAsItIs) {
    EstimationTask task = laggingBody(3);
    addDraught(task, 0.1);
    WarmSearch of(task);
    Node node = withDeadTime(of);
    node.steps.front().prediction.reset();
    EXPECT_FALSE(storageForDeadTimes(of.search, node));
}

}  // namespace
}  // namespace analogon
