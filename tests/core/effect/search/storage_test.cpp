#include "core/effect/search/storage.hpp"

#include <gtest/gtest.h>

#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

/// The model with a dead time at its sensor that is only indicated.
Node withDeadTime(WarmSearch& of) {
    Node node = nodeWith(of, "sensor.delay");
    if (!node.steps.empty()) node.steps.back().prediction.emplace();
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
