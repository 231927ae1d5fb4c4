#include "core/effect/search/experiments.hpp"

#include <gtest/gtest.h>

#include "tests/core/effect/search/warm_nodes.hpp"

namespace analogon {
namespace {

TEST(Experiments, AreProposedForWhatIsOpenAlone) {
    WarmSearch of(laggingBody(3));
    Node node = lagFound(of);
    std::erase_if(node.steps.front().alternatives, [](const Alternative& a) { return a.equivalent; });
    EXPECT_TRUE(proposeExperiments(of.search, node).empty());
}

TEST(Experiments, TellTheEffectFromWhatTheRecordingsLeaveOpen) {
    WarmSearch of(laggingBody(3));
    Node node = nodeThatChose(of, "sensor.lag");
    const Node delay = nodeThatChose(of, "sensor.delay");
    const PlacedEffect& other = delay.null.variant.effects.front();
    Step& step = node.steps.front();
    step.alternatives = {{"sensor.delay", "output T", 3, true}};
    step.rivals = {{other.effect, other.place}};
    const Text text = proposeExperiments(of.search, node);
    EXPECT_NE(text.find("input P as "), std::string::npos) << text;
    EXPECT_NE(text.find("would tell sensor.lag at output T from sensor.delay at output T by"), std::string::npos)
        << text;
    step.rivals.clear();
    EXPECT_TRUE(proposeExperiments(of.search, node).empty()) << "it was not tried";
}

TEST(WhatItTells, IsHowFarApartTheEffectsAreOrThatMoreMustBeMeasured) {
    const auto said = [](double separation) {
        ProposedExperiment next;
        next.programme = "a step";
        next.separation = separation;
        return whatItTells(next, Text("a from b")).english();
    };
    EXPECT_NE(said(4.4).find("no programme"), std::string::npos);
    EXPECT_NE(said(4.6).find("would tell a from b by 5 standard deviations"), std::string::npos) << said(4.6);
    EXPECT_NE(said(300).find("by more than 100"), std::string::npos);
}

}  // namespace
}  // namespace analogon
