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

/// Established is then the class, and what is stored is the likelier name of it where structure remains.
TEST(Storage, TakesThePlaceOfAnEstablishedDeadTimeThatCannotBeToldFromIt) {
    EstimationTask task = laggingBody(3);
    addDraught(task, 0.1);
    WarmSearch of(task);
    Node node = withDeadTime(of);
    node.steps.front().prediction.reset();
    const std::string at = node.null.variant.effects.front().place.at;
    node.steps.front().alternatives = {{"sensor.lag", at, 0, true}};
    EXPECT_TRUE(storageForDeadTimes(of.search, node));
    EXPECT_EQ(node.null.variant.effects.front().effect.kind, "sensor.lag");
    EXPECT_FALSE(node.steps.front().prediction) << "established is the class";
}

TEST(Storage, LeavesAnEstablishedDeadTimeThatIsToldFromItAsItIs) {
    EstimationTask task = laggingBody(3);
    addDraught(task, 0.1);
    WarmSearch of(task);
    Node node = withDeadTime(of);
    node.steps.front().prediction.reset();
    for (Alternative& each : node.steps.front().alternatives) each.equivalent = false;
    EXPECT_FALSE(storageForDeadTimes(of.search, node));
}

}  // namespace
}  // namespace analogon
