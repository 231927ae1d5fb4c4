#include "core/study/time_shift.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace analogon {
namespace {

struct Recorded {
    std::vector<double> time, values;
    ComparedCourse course() const { return {time, values}; }
};

/// A quantity as a logger writes it whose clock is ahead by `clock`.
Recorded record(const std::function<double(double)>& truth, double from, double to, double step, double clock,
                double noise = 0, unsigned seed = 1) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal(0, 1);
    Recorded recorded;
    for (int i = 0; from + i * step <= to; ++i) {
        const double stamp = from + i * step;
        recorded.time.push_back(stamp);
        recorded.values.push_back(truth(stamp - clock) + noise * normal(generator));
    }
    return recorded;
}

/// The speed of a bench: run-ups and steps that do not repeat, with a bandwidth of some hertz.
double speed(double t) {
    double value = 0;
    for (const auto& [at, height] : {std::pair{2.0, 1.0}, {3.1, -0.4}, {5.7, 0.8}, {6.2, 0.3}, {8.4, -1.1}})
        value += height / (1 + std::exp(-(t - at) / 0.05));
    return value;
}

TEST(TimeShift, IsFoundToAFractionOfASample) {
    const Recorded reference = record(speed, 0, 10, 0.01, 0);
    for (const double clock : {0.0, 0.0037, -0.0061, 0.25, -1.2345}) {
        const Outcome<TimeShift> found = timeShift(reference.course(), record(speed, 0, 10, 0.01, clock).course());
        ASSERT_TRUE(found.hasValue()) << format(found.diagnostics());
        EXPECT_NEAR(found->shift, clock, 2e-4) << clock;
    }
}

TEST(TimeShift, IsFoundInNoiseAndItsDeviationIsHonest) {
    double worst = 0;
    int within = 0;
    constexpr int runs = 40;
    for (unsigned seed = 0; seed < runs; ++seed) {
        const double clock = 0.0123 + 0.0007 * seed;
        const Recorded reference = record(speed, 0, 10, 0.01, 0, 0.05, 2 * seed + 1),
                       other = record(speed, 0, 10, 0.01, clock, 0.05, 2 * seed + 2);
        const Outcome<TimeShift> found = timeShift(reference.course(), other.course());
        ASSERT_TRUE(found.hasValue()) << format(found.diagnostics());
        worst = std::max(worst, std::abs(found->shift - clock));
        within += std::abs(found->shift - clock) < 2 * found->deviation;
        EXPECT_LT(found->deviation, 0.004);
    }
    EXPECT_LT(worst, 0.008) << "of 10 ms from sample to sample, in noise of a tenth of a step";
    EXPECT_GE(within, runs * 8 / 10);
}

TEST(TimeShift, RastersScalesStartsAndGapsMayDiffer) {
    const Recorded reference = record(speed, 0, 10, 0.01, 0);
    Recorded other = record(speed, 1.3, 12, 0.0137, 0.4321);
    for (double& value : other.values) value = 9.5 * value + 40;
    for (std::size_t i = 300; i < 310; ++i) other.values[i] = NAN;
    const Outcome<TimeShift> found = timeShift(reference.course(), other.course());
    ASSERT_TRUE(found.hasValue()) << format(found.diagnostics());
    EXPECT_NEAR(found->shift, 0.4321, 1e-3);
    const Outcome<TimeShift> back = timeShift(other.course(), reference.course());
    ASSERT_TRUE(back.hasValue());
    EXPECT_NEAR(back->shift, -0.4321, 1e-3);
}

TEST(TimeShift, StampsOfTwoEpochsAreTold) {
    const Recorded reference = record(speed, 0, 10, 0.01, 0);
    Recorded other = reference;
    for (double& stamp : other.time) stamp += 86'400.25;
    const Outcome<TimeShift> found = timeShift(reference.course(), other.course());
    ASSERT_TRUE(found.hasValue()) << format(found.diagnostics());
    EXPECT_NEAR(found->shift, 86'400.25, 1e-4);
}

std::string faultOf(const Recorded& a, const Recorded& b) {
    const Outcome<TimeShift> found = timeShift(a.course(), b.course());
    EXPECT_FALSE(found.hasValue()) << "told as " << (found ? found->shift : 0);
    return found ? "" : found.diagnostics().front().message.english();
}

TEST(TimeShift, SaysWhenItCannotBeTold) {
    const auto sine = [](double t) { return std::sin(2 * M_PI * t); };
    for (const double noise : {0.0, 0.02})
        EXPECT_NE(
            faultOf(record(sine, 0, 20, 0.01, 0, noise, 1), record(sine, 0, 20, 0.01, 0.3, noise, 2)).find("repeats"),
            std::string::npos);
    const auto ramp = [](double t) { return 3 * t; };
    for (const double noise : {0.0, 0.1})
        EXPECT_NE(
            faultOf(record(ramp, 0, 10, 0.01, 0, noise, 1), record(ramp, 0, 10, 0.01, 0.5, noise, 2)).find("slowly"),
            std::string::npos);
    const auto still = [](double) { return 4.2; };
    EXPECT_NE(faultOf(record(speed, 0, 10, 0.01, 0), record(still, 0, 10, 0.01, 0)).find("does not change"),
              std::string::npos);
    EXPECT_NE(faultOf(record(speed, 0, 10, 0.01, 0), record(still, 0, 10, 0.01, 0, 1.0)).find("not alike"),
              std::string::npos);
    EXPECT_NE(faultOf(record(speed, 0, 0.05, 0.01, 0), record(speed, 0, 10, 0.01, 0)).find("samples"),
              std::string::npos);
}

TEST(TimeShift, LongRecordingsTakeMoments) {
    const auto busy = [](double t) { return std::sin(t * t / 50) + std::cos(0.7 * t); };
    const Recorded reference = record(busy, 0, 100, 1e-4, 0), other = record(busy, 0, 100, 1e-4, 0.04321);
    const Outcome<TimeShift> found = timeShift(reference.course(), other.course());
    ASSERT_TRUE(found.hasValue()) << format(found.diagnostics());
    EXPECT_NEAR(found->shift, 0.04321, 2e-4);
}

}  // namespace
}  // namespace analogon
