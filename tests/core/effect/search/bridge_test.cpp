#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/work.hpp"
#include "core/effect/model/place.hpp"
#include "core/effect/model/variant.hpp"
#include "core/effect/search/discover.hpp"
#include "tests/core/effect/heated_board.hpp"

namespace analogon {
namespace {

using testing::ElementsAre;

std::vector<std::string> placesOf(const std::string& kind) {
    const EstimationTask task = taskOf(boardText, "Board");
    Outcome<FlatModel> flat = flatten(task.library, "Board");
    Outcome<Structure> structure = analyse(std::make_shared<FlatModel>(std::move(*flat)));
    Outcome<Diagram> diagram = readDiagram(task.library, "Board");
    const Outcome<std::vector<EffectClass>> catalogue = effectCatalogue(task.library);
    std::vector<std::string> names;
    for (const EffectClass& e : *catalogue)
        if (e.kind == kind)
            for (const EffectPlace& p : ModelNodes(task.library, *diagram, *structure).placesFor(e, {}))
                names.push_back(p.at);
    return names;
}

TEST(BridgePlaces, ArePairsOfNodesThatNoBlockJoins) {
    EXPECT_THAT(placesOf("thermal.bridge"), ElementsAre("heater1.port <-> heater2.port"));
}

TEST(SourcePlaces, AreWhereABlockTurnsSomethingElseIntoHeat) {
    EXPECT_THAT(placesOf("thermal.source_mass"), ElementsAre("heater1.port", "heater2.port"));
}

TEST(DiscoveryOnABoard, NamesTheExchangeOfHeatBetweenTwoBodies) {
    const WorkCount work;
    const Outcome<Finding> finding = discover(heatedBoard(0.08, 0));
    EXPECT_NEAR(work.done(), 3.46e6, 0.35e6) << "steps";
    ASSERT_TRUE(finding) << format(finding.diagnostics());
    ASSERT_EQ(finding->effects.size(), 1u);
    const AddedEffect& bridge = finding->effects.front();
    EXPECT_EQ(bridge.kind, "thermal.bridge");
    EXPECT_EQ(bridge.at, "heater1.port <-> heater2.port");
    EXPECT_EQ(bridge.wired.way, Way::Bridge);
    EXPECT_EQ(bridge.confidence, Confidence::Established);
    EXPECT_EQ(finding->kind, FindingKind::Effect);
    ASSERT_FALSE(bridge.parameters.empty());
    EXPECT_NEAR(bridge.parameters.front().value, 0.08, 4 * bridge.parameters.front().standardError);
}

TEST(DiscoveryOnABoard, NamesTheMassOfTheHeatedElementsWhereItIsAskedFor) {
    DiscoverOptions options;
    options.kinds = {"thermal.source_mass"};
    const Outcome<Finding> finding = discover(heatedBoard(0, 6), options);
    ASSERT_TRUE(finding) << format(finding.diagnostics());
    ASSERT_EQ(finding->effects.size(), 2u);
    EXPECT_EQ(finding->kind, FindingKind::Effect);
    for (const AddedEffect& e : finding->effects) {
        EXPECT_EQ(e.kind, "thermal.source_mass");
        EXPECT_NEAR(e.parameters.front().value, 6, 4 * e.parameters.front().standardError) << e.at;
    }
}

TEST(DiscoveryOnABoard, TellsADraughtAsTheFlowThatItIs) {
    const Outcome<Finding> finding = discover(heatedBoard(0, 0, {0.05, 0.05}, {0.5, 20}));
    ASSERT_TRUE(finding) << format(finding.diagnostics());
    EXPECT_TRUE(finding->effects.empty());
    EXPECT_EQ(finding->kind, FindingKind::Unexplained);
    ASSERT_TRUE(finding->unexplained.disturbance);
    EXPECT_EQ(finding->unexplained.disturbance->node, "heater1.port");
    EXPECT_EQ(finding->unexplained.disturbance->unit, "W");
    EXPECT_NEAR(finding->unexplained.disturbance->size, 0.5, 0.2);
    EXPECT_GT(finding->unexplained.disturbance->timeConstant, 8);
    EXPECT_LT(finding->unexplained.disturbance->timeConstant, 50);
}

TEST(DiscoveryOnABoard, TellsAnEffectBesideADraught) {
    const Outcome<Finding> finding = discover(heatedBoard(0.08, 0, {0.05, 0.05}, {0.3, 20}));
    ASSERT_TRUE(finding) << format(finding.diagnostics());
    ASSERT_EQ(finding->effects.size(), 1u);
    EXPECT_EQ(finding->effects.front().kind, "thermal.bridge");
    EXPECT_EQ(finding->kind, FindingKind::Partial);
    ASSERT_TRUE(finding->unexplained.disturbance);
    EXPECT_EQ(finding->unexplained.disturbance->node, "heater1.port");
}

/// A lag of the command is the same where the power is proportional to it: one name stands for both.
TEST(DiscoveryOnABoard, TakesTheLagOfACommandForTheMassBehindIt) {
    const Outcome<Finding> finding = discover(heatedBoard(0, 6));
    ASSERT_TRUE(finding) << format(finding.diagnostics());
    ASSERT_EQ(finding->effects.size(), 2u);
    for (const AddedEffect& e : finding->effects) EXPECT_EQ(e.kind, "actuator.lag") << e.at;
}

}  // namespace
}  // namespace analogon
