#include "core/study/practice_recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace analogon {
namespace {

/// A jump from 1 to 5 at 0.5 s, beside a ramp, over 2000 s.
ExperimentState run() {
    ExperimentState state;
    state.time = {0, 0.5, 0.5, 2000};
    state.outputs.resize(2);
    state.outputs[0].name = "y";
    state.outputs[0].unit = "K";
    state.outputs[0].simulated = Eigen::Vector4d(1, 1, 5, 5);
    state.outputs[1].name = "z";
    state.outputs[1].simulated = Eigen::Vector4d(0, 0.5, 0.5, 2000);
    return state;
}

PracticeOptions every(double sampleTime, std::map<std::string, double> noise = {}, std::uint64_t seed = 1) {
    return {sampleTime, seed, std::move(noise)};
}

TEST(PracticeRecording, SamplesTheRunOnARaster) {
    const Outcome<Table> table = practiceRecording(run(), every(0.25));
    ASSERT_TRUE(table) << format(table.diagnostics());
    ASSERT_EQ(table->names(), (std::vector<std::string>{"time", "y", "z"}));
    EXPECT_EQ(table->columns[0].unit, "s");
    EXPECT_EQ(table->columns[1].unit, "K");
    const std::vector<double>& y = table->columns[1].values;
    ASSERT_EQ(y.size(), 8001u) << "the last sample is that of the end";
    EXPECT_EQ(y[1], 1);
    EXPECT_EQ(y[2], 5) << "at a jump the value behind it";
    EXPECT_NEAR(table->columns[2].values[3], 0.75, 1e-12);
    EXPECT_DOUBLE_EQ(table->columns[0].values.back(), 2000);
}

TEST(PracticeRecording, NoiseHasTheDeviationThatWasAskedFor) {
    const Outcome<Table> plain = practiceRecording(run(), every(0.1));
    const Outcome<Table> noisy = practiceRecording(run(), every(0.1, {{"y", 0.3}}));
    ASSERT_TRUE(plain && noisy);
    double sum = 0, squares = 0, products = 0, last = 0;
    const auto count = static_cast<double>(plain->columns[1].values.size());
    for (std::size_t k = 0; k < plain->columns[1].values.size(); ++k) {
        const double e = noisy->columns[1].values[k] - plain->columns[1].values[k];
        sum += e;
        squares += e * e;
        products += e * std::exchange(last, e);
    }
    EXPECT_NEAR(sum / count, 0, 0.01);
    EXPECT_NEAR(std::sqrt(squares / count), 0.3, 0.01);
    EXPECT_NEAR(products / squares, 0, 0.03) << "no sample knows of the one before";
    EXPECT_EQ(noisy->columns[2].values, plain->columns[2].values) << "of z none was asked for";
}

TEST(PracticeRecording, IsTheSameWithTheSameSeedAlone) {
    const auto yOf = [](const PracticeOptions& options, ExperimentState state = run()) {
        return practiceRecording(state, options)->columns[1].values;
    };
    EXPECT_EQ(yOf(every(1, {{"y", 1}})), yOf(every(1, {{"y", 1}, {"z", 2}})));
    EXPECT_NE(yOf(every(1, {{"y", 1}})), yOf(every(1, {{"y", 1}}, 2)));
    const Outcome<Table> both = practiceRecording(run(), every(1, {{"y", 1}, {"z", 1}}));
    const Outcome<Table> none = practiceRecording(run(), every(1));
    EXPECT_NE(both->columns[1].values[0] - none->columns[1].values[0],
              both->columns[2].values[0] - none->columns[2].values[0])
        << "each output has noise of its own";
}

TEST(PracticeRecording, RefusesWhatCannotBeSampled) {
    for (const double wrong : {0.0, -1.0, 3000.0, 1e-9, std::nan("")})
        EXPECT_FALSE(practiceRecording(run(), every(wrong))) << wrong;
    const Outcome<Table> negative = practiceRecording(run(), every(1, {{"y", -0.1}}));
    ASSERT_FALSE(negative);
    EXPECT_THAT(format(negative.diagnostics()), ::testing::HasSubstr("'y'"));
    EXPECT_FALSE(practiceRecording({}, every(1)));
}

}  // namespace
}  // namespace analogon
