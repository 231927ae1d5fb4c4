#include "core/effect/reading/mistaken_wiring.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/effect/driven_rotor.hpp"
#include "tests/core/effect/hand_made.hpp"
#include "tests/core/effect/heated_board.hpp"

namespace analogon {
namespace {

using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

using Names = std::vector<std::string>;

std::vector<MistakenWiring> wiringsIn(const EstimationTask& task) {
    const Outcome<NullModel> null = fitNull({task, {}, {}}, {}, NoiseLevel::Estimate, {}, {});
    EXPECT_TRUE(null) << format(null.diagnostics());
    return null ? mistakenWirings(*null, {task, {}, {}}, {}, {}) : std::vector<MistakenWiring>();
}

std::vector<Names> channelsOf(const std::vector<MistakenWiring>& wirings) {
    std::vector<Names> channels;
    for (const MistakenWiring& w : wirings) channels.push_back(w.channels);
    return channels;
}

void exchangeOutputs(Recording& r) { r.outputs.row(0).swap(r.outputs.row(1)); }

TEST(MistakenWirings, AreThoseWithWhichTheModelAsItIsLeavesNoise) {
    EstimationTask task = heatedBoard(0, 0, {0.05, 0.2});
    exchangeOutputs(task.recordings.edit().front());
    const std::vector<MistakenWiring> found = wiringsIn(task);
    EXPECT_THAT(channelsOf(found), UnorderedElementsAre(Names{"T1", "T2"}, Names{"P1", "P2"}))
        << "of two like bodies either the thermometers or the heaters are exchanged";
    for (const MistakenWiring& w : found) {
        EXPECT_EQ(w.recordings, std::vector<int>{0});
        EXPECT_FALSE(w.isOfSign());
        EXPECT_TRUE(isNoise(w.read));
        EXPECT_NEAR(w.read.fit.find("loss1.G")->value, 0.1, 0.005);
        EXPECT_NEAR(w.read.noise[0][w.channels.front() == "T1" ? 1 : 0], 0.2, 0.03) << "it belongs to what is measured";
    }
}

TEST(MistakenWirings, AreNoneWhereTheRecordingsAreRight) {
    EXPECT_TRUE(wiringsIn(heatedBoard(0, 0)).empty());
    EXPECT_TRUE(wiringsIn(heatedBoard(0.05, 0)).empty()) << "what flows between the bodies is no exchange of channels";
    EXPECT_TRUE(wiringsIn(heatedBoard(0, 8)).empty()) << "nor is a lag of the heaters";
    EstimationTask offset = heatedBoard(0, 0);
    offset.recordings.edit().front().outputs.row(0).array() += 2;
    EXPECT_TRUE(wiringsIn(offset).empty()) << "nor an offset";
}

TEST(MistakenWirings, ByASignAreToldWhereTheParametersCannotMakeUpForIt) {
    EstimationTask task = heatedBoard(0, 0);
    task.recordings.edit().front().inputs.row(1) *= -1;
    const std::vector<MistakenWiring> found = wiringsIn(task);
    ASSERT_THAT(channelsOf(found), ElementsAre(Names{"P2"}));
    EXPECT_TRUE(found.front().isOfSign());
    EXPECT_TRUE(isNoise(found.front().read));
}

/// A rotor that a torque drives against a damper; its speed is measured with the opposite sign.
EstimationTask turningTheOtherWay() {
    constexpr int samples = 300;
    Recording r = blankRecording("run", {"tau"}, {"w"}, samples);
    const Eigen::VectorXd noise = whiteNoise(samples);
    double w = 0;
    const auto torqueAt = [](int k) { return k % 100 < 50 ? 1.0 : 0.2; };
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(k);
        r.inputs(0, k) = torqueAt(k);
        r.outputs(0, k) = -w + 0.05 * noise[k];
        for (int i = 0; i < 100; ++i) {
            const double part = (i + 0.5) / 100;
            w += 0.01 / 1.5 * ((1 - part) * torqueAt(k) + part * torqueAt(k + 1) - 0.08 * w);
        }
    }
    return drivenRotor(std::move(r));
}

TEST(MistakenWirings, ByASignMayBeOfWhatDrivesOrOfWhatIsMeasured) {
    EXPECT_THAT(channelsOf(wiringsIn(turningTheOtherWay())), UnorderedElementsAre(Names{"tau"}, Names{"w"}));
}

TEST(MistakenWirings, MayBeOfOneRecordingOfSeveral) {
    EstimationTask task = heatedBoard(0, 0);
    Recording next = task.recordings.front();
    next.name = "next steps";
    exchangeOutputs(next);
    next.units = {{"T1", "TC1", "K", "K"}, {"T2", "TC2", "K", "K"}};
    task.recordings.push_back(next);
    const std::vector<MistakenWiring> found = wiringsIn(task);
    ASSERT_EQ(found.size(), 2u);
    std::vector<std::string> said;
    for (const MistakenWiring& w : found) said.push_back(wiringWords(task, w).english());
    EXPECT_THAT(said, UnorderedElementsAre("T1 ('TC1') and T2 ('TC2') seem to be exchanged in 'next steps'",
                                           "P1 and P2 seem to be exchanged in 'next steps'"));
}

TEST(MistakenWirings, AreNoneOfChannelsThatCannotStandInForEachOther) {
    EstimationTask task = heatedBoard(0, 0);
    Recording& r = task.recordings.edit().front();
    exchangeOutputs(r);
    for (Eigen::Index k = 1; k < r.outputs.cols(); k += 2) r.outputs(0, k) = std::nan("");
    EXPECT_THAT(channelsOf(wiringsIn(task)), ElementsAre(Names{"P1", "P2"})) << "T1 is measured half as often";
}

TEST(ReadAsMeant, TakesStartValuesFromTheColumnsAsTheyAreMeant) {
    EstimationTask task = heatedBoard(0, 0);
    Recording& r = task.recordings.edit().front();
    r.outputs.row(0).array() += 10;
    r.units = {{"T1", "TC1", "K", "K"}, {"T2", "TC2", "K", "K"}, {"P1", "heater", "W", "W"}};
    r.starts = {{"body1.T_start", r.outputs(0, 0), false, "TC1"}, {"body2.T_start", r.outputs(1, 0), false, "TC2"}};
    const Recording read = readAsMeant(task, {{0}, {"T1", "T2"}, {}}).recordings[0];
    EXPECT_EQ(read.outputs.row(0), r.outputs.row(1));
    EXPECT_EQ(read.outputs.row(1), r.outputs.row(0));
    EXPECT_DOUBLE_EQ(read.starts[0].value, r.outputs(1, 0));
    EXPECT_DOUBLE_EQ(read.starts[1].value, r.outputs(0, 0));
    const Recording turned = readAsMeant(task, {{0}, {"P1"}, {}}).recordings[0];
    EXPECT_EQ(turned.inputs.row(0), -r.inputs.row(0));
    EXPECT_EQ(turned.inputs.row(1), r.inputs.row(1));
    EXPECT_EQ(turned.starts[0].value, r.starts[0].value);
}

TEST(WiringWords, SayWhatIsWrongWithWhichChannel) {
    EstimationTask task = heatedBoard(0, 0);
    EXPECT_EQ(wiringWords(task, {{0}, {"T1", "T2"}, {}}), "T1 and T2 seem to be exchanged");
    EXPECT_EQ(wiringWords(task, {{0}, {"P1"}, {}}), "P1 seems to be recorded with the wrong sign");
    task.recordings.push_back(task.recordings.front());
    EXPECT_EQ(wiringWords(task, {{0}, {"P1"}, {}}), "P1 seems to be recorded with the wrong sign in 'steps'");
}

}  // namespace
}  // namespace analogon
