#include "core/effect/reading/misread.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/effect/hand_made.hpp"

namespace analogon {
namespace {

using ::testing::ElementsAre;

/// What a speed that is measured with the wrong sign leaves of a parameter p1: twice its trace, and noise 1.
NullModel modelThatMisses(double amplitude) {
    constexpr int samples = 400;
    const Eigen::VectorXd wave = sineWave(samples, 5);
    return modelThatLeaves(amplitude * wave + whiteNoise(samples), sineWave(samples, 40));
}

Recording recorded() {
    Recording r;
    r.name = "run";
    r.inputNames = {"u"};
    r.outputNames = {"T", "w"};
    r.time = {0, 1, 2};
    r.inputs = Eigen::MatrixXd::Constant(1, 3, 5);
    r.outputs = Eigen::MatrixXd{{1, 2, 3}, {4, 5, 6}};
    r.units = {{"w", "speed [rpm]", "rpm", "rad/s"}};
    return r;
}

TEST(ChannelRow, IsOfAnInputOrOfAnOutput) {
    const Recording r = recorded();
    ASSERT_TRUE(channelRow(r, "u"));
    EXPECT_TRUE(channelRow(r, "u")->isInput);
    EXPECT_EQ(channelRow(r, "u")->of(r)(0, 1), 5);
    ASSERT_TRUE(channelRow(r, "w"));
    EXPECT_FALSE(channelRow(r, "w")->isInput);
    EXPECT_EQ(channelRow(r, "w")->of(r)(0, 2), 6);
    EXPECT_FALSE(channelRow(r, "x"));
}

TEST(NameWithColumn, SaysTheColumnWhereItIsKnown) {
    EXPECT_EQ(nameWithColumn(recorded(), "w"), "w ('speed [rpm]')");
    EXPECT_EQ(nameWithColumn(recorded(), "T"), "T");
    EXPECT_EQ(columnBehind(recorded(), "T"), "");
}

TEST(WhereMisread, IsInAllRecordingsOrInOneOfTheFittedOnes) {
    EstimationTask task;
    task.recordings = {recorded()};
    EXPECT_THAT(whereMisread(task), ElementsAre(ElementsAre(0)));
    Recording validation = recorded();
    validation.role = Role::Validate;
    task.recordings.push_back(validation);
    EXPECT_THAT(whereMisread(task), ElementsAre(ElementsAre(0, 1))) << "alone it would be all that is fitted";
    task.recordings.push_back(recorded());
    EXPECT_THAT(whereMisread(task), ElementsAre(ElementsAre(0, 1, 2), ElementsAre(0), ElementsAre(2)));
}

TEST(MayBeMisread, IsWhatLeavesFarMoreThanAnEffectWould) {
    EXPECT_FALSE(mayBeMisread(modelThatMisses(0))) << "noise alone";
    EXPECT_FALSE(mayBeMisread(modelThatMisses(1))) << "200 in units of the noise: an effect may be all of that";
    EXPECT_TRUE(mayBeMisread(modelThatMisses(2)));
}

/// Whether a reading with which so much of a wave is left instead of so much is all that is wrong.
bool isAll(double without, double with, double otherWave = 0) {
    constexpr int samples = 400;
    const Eigen::VectorXd noise = whiteNoise(samples) + otherWave * sineWave(samples, 3);
    const Eigen::MatrixXd columns = sineWave(samples, 40);
    const NullModel null = modelThatLeaves(noise + without * sineWave(samples, 5), columns);
    return explainsAll(null, modelThatLeaves(noise + with * sineWave(samples, 5), columns).fit);
}

TEST(ExplainsAll, IsFarMoreThanAnEffectBrings) {
    EXPECT_TRUE(isAll(3, 0));
    EXPECT_TRUE(isAll(2, 0)) << "400 in units of the noise";
    EXPECT_FALSE(isAll(1, 0)) << "100: look for an effect";
}

TEST(ExplainsAll, LeavesNoiseOrASmallPartOfWhatWasLeft) {
    EXPECT_TRUE(isAll(20, 2)) << "a hundredth of the squares";
    EXPECT_FALSE(isAll(20, 6)) << "a tenth: an effect may look like a scale";
    EXPECT_TRUE(isAll(40, 0, 5)) << "structure may be left beside it";
}

TEST(LeavesAsLittle, IsWhatTheDataDoNotTellFromTheBest) {
    const NullModel best = modelThatMisses(0);
    EXPECT_TRUE(leavesAsLittle(best, best));
    EXPECT_TRUE(leavesAsLittle(modelThatMisses(0.15), best)) << "4.5 in units of the noise";
    EXPECT_FALSE(leavesAsLittle(modelThatMisses(0.5), best)) << "50";
}

TEST(ExplainsAll, IsThreeTimesWhatStaysUnexplained) {
    constexpr int samples = 400;
    const Eigen::VectorXd wave = sineWave(samples, 5);
    Eigen::VectorXd noise = 1.3 * whiteNoise(samples);  // of a sensor louder than it was told
    noise -= wave * (wave.dot(noise) / wave.squaredNorm());
    const double unexplained = noise.squaredNorm() - samples;
    const Eigen::MatrixXd columns = sineWave(samples, 40);
    const auto isAll = [&](double times) {
        const double amplitude = std::sqrt(times * unexplained / (samples / 2));
        const NullModel null = modelThatLeaves(noise + amplitude * wave, columns);
        const double explained = null.sumOfSquares() - noise.squaredNorm();
        EXPECT_NEAR(explained / unexplained, times, 1e-6);
        return explainsAll(null, modelThatLeaves(noise, columns).fit);
    };
    EXPECT_FALSE(isAll(2.7));
    EXPECT_TRUE(isAll(3.3));
}

}  // namespace
}  // namespace analogon
