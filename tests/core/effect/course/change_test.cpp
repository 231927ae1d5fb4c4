#include "core/effect/course/change.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stop_token>

#include "tests/core/effect/warm_body.hpp"

namespace analogon {
namespace {

constexpr int samples = 400, change = 200;

/// A body whose joint to the surroundings conducts otherwise from the change on, in small steps of the exact solution.
Recording recorded(const std::string& name, double before, double after, int at = change) {
    Recording r = warmBodyRecording(name, samples);
    double x = 0;
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(k);
        r.inputs(0, k) = 3 + 2 * std::sin(0.1 * k);
        r.outputs(0, k) = 300 + x + 0.05 * ((k * 7919) % 13 - 6) / 6.0;
        constexpr int pieces = 200;
        for (int i = 0; i < pieces; ++i) {
            const double t = k + (i + 0.5) / pieces;
            const double p = 3 + 2 * ((1 - (t - k)) * std::sin(0.1 * k) + (t - k) * std::sin(0.1 * (k + 1)));
            const double G = k < at ? before : after, decay = std::exp(-G / 4 / pieces);
            x = x * decay + p / G * (1 - decay);
        }
    }
    return r;
}

NullModel changed(double before, double after, std::vector<Recording> checks = {}, int at = change) {
    FitParameter g;
    g.name = "joint.G";
    g.unit = "W/K";
    g.start = 0.2;
    EstimationTask task = warmBody({g});
    task.recordings = {recorded("bench", before, after, at)};
    for (Recording& check : checks) {
        check.role = Role::Validate;
        task.recordings.push_back(std::move(check));
    }
    Outcome<NullModel> null = fitNull({task, {}, {}}, {}, NoiseLevel::Estimate, {}, {});
    EXPECT_TRUE(null) << format(null.diagnostics());
    return null ? std::move(*null) : NullModel{};
}

TEST(Change, IsFoundWithItsMomentAndItsSize) {
    const std::optional<Change> found = bestChange(changed(0.2, 0.3), {}, 1, {});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->parameter, "joint.G");
    EXPECT_NEAR(found->before, 0.2, 0.002);
    EXPECT_NEAR(found->after, 0.3, 0.002);
    EXPECT_NEAR(found->time, change, 2);
}

TEST(Change, NeverTakesAQuantityOfOneSignToTheOther) {
    // heat that comes out of the surroundings is no change of a conductance
    const std::optional<Change> found = bestChange(changed(0.2, -0.002), {}, 1, {});
    ASSERT_TRUE(found);
    EXPECT_GT(found->after, 0);
}

TEST(Change, IsNoneAtEitherEndOfARecording) {
    const std::optional<Change> found = bestChange(changed(0.2, 0.3, {}, samples / 100), {}, 1, {});
    ASSERT_TRUE(found);
    EXPECT_GE(found->time, 0.039 * samples) << "a break in the first samples is a wrong start";
    EXPECT_LT(found->time, 0.1 * samples);
}

/// A motor against a spring whose winding has 8 % more resistance from that sample on, driven by levels of voltage: its
/// current follows at once, its angle does not.
EstimationTask motorWithAJump(int at) {
    constexpr int count = 3000, within = 20;
    constexpr double interval = 2e-3, k = 0.022, J = 1.5e-5, c = 1.2e-3, b = 1e-5;
    EstimationTask task = taskOf(R"(model Motor
  Analogon.Interfaces.RealInput v(unit="V");
  Analogon.Interfaces.RealOutput i(unit="A");
  Analogon.Interfaces.RealOutput phi(unit="rad");
  parameter Real R(unit="Ohm") = 3;
  parameter Real k(unit="N.m/A") = 0.02;
  parameter Real J(unit="kg.m2") = 2e-5;
  parameter Real c(unit="N.m/rad") = 1e-3;
  parameter Real b(unit="N.m.s/rad") = 1e-5;
  Real w(unit="rad/s");
equation
  der(phi) = w;
  v = R*i + k*w;
  J*der(w) = k*i - b*w - c*phi;
end Motor;
)",
                                 "Motor");
    task.parameters = {{"R", "Ohm", 3, 0.05, 50},
                       {"k", "N.m/A", 0.02, 0.002, 0.5},
                       {"J", "kg.m2", 2e-5, 1e-7, 1e-3},
                       {"c", "N.m/rad", 1e-3, 1e-5, 1}};
    Recording r = blankRecording("run", {"v"}, {"i", "phi"}, count);
    std::mt19937 random(3);
    std::normal_distribution<double> noise;
    const auto voltage = [](int n) {
        constexpr double levels[] = {0.3, 1.5, 0.9, 2.0, 0.8, 0.4, 1.6, 0.7, 2.1, 0.2, 1.3, 2.0, 1.9, 2.4, 0.7};
        return levels[n / 200 % 15];
    };
    double w = 0, phi = 0;
    for (int n = 0; n < count; ++n) {
        const double R = n < at ? 2.13 : 2.13 * 1.08;
        r.time.push_back(interval * n);
        r.inputs(0, n) = voltage(n);
        r.outputs(0, n) = (voltage(n) - k * w) / R + 0.01 * noise(random);
        r.outputs(1, n) = phi + 0.1 * noise(random);
        for (int m = 0; m < within; ++m) {
            const double part = (m + 0.5) / within, v = (1 - part) * voltage(n) + part * voltage(n + 1);
            w += interval / within * (k * (v - k * w) / R - b * w - c * phi) / J;
            phi += interval / within * w;
        }
    }
    task.recordings = {r};
    return task;
}

TEST(Change, IsFoundToTheSampleWhereAnOutputFollowsAtOnce) {
    for (const int at : {361, 1154, 2069}) {
        const Outcome<NullModel> null = fitNull({motorWithAJump(at), {}, {}}, {}, NoiseLevel::Estimate, {}, {});
        ASSERT_TRUE(null) << format(null.diagnostics());
        const std::optional<Change> found = bestChange(*null, {}, 1, {});
        ASSERT_TRUE(found);
        EXPECT_EQ(found->parameter, "R");
        EXPECT_NEAR(found->time, 2e-3 * at, 0.006);
        EXPECT_TRUE(isNoise(null->channels, found->fit)) << "all that was left";
    }
}

TEST(Change, IsHeldAgainstChecksOfEitherCondition) {
    const NullModel null = changed(
        0.2, 0.3, {recorded("new", 0.2, 0.2), recorded("worn", 0.3, 0.3), recorded("another that wears", 0.2, 0.3)});
    const std::optional<Change> found = bestChange(null, {}, 1, {});
    ASSERT_TRUE(found);
    const Outcome<ErrorsOfChange> errors = errorsOf(*found, null.variant.task.recordings, {}, {});
    ASSERT_TRUE(errors) << format(errors.diagnostics());
    EXPECT_LT(errors->fitted, 0.5);
    ASSERT_EQ(errors->checks.size(), 3u);
    EXPECT_EQ(errors->checks[1].experiment, "worn");
    const double suits[] = {errors->checks[0].before, errors->checks[1].after, errors->checks[2].alike};
    for (int i = 0; i < 3; ++i) {
        const CheckOfChange& check = errors->checks[static_cast<std::size_t>(i)];
        EXPECT_EQ(check.least(), suits[i]) << check.experiment;
        EXPECT_LT(check.least(), 0.5) << check.experiment;
        EXPECT_GT(check.before + check.after + check.alike, 10) << check.experiment;
    }
}

TEST(Change, TellsNothingOfChecksThatWereNotSimulatedToTheirEnd) {
    const NullModel null = changed(0.2, 0.3, {recorded("new", 0.2, 0.2)});
    const std::optional<Change> found = bestChange(null, {}, 1, {});
    ASSERT_TRUE(found);
    std::stop_source stop;
    stop.request_stop();
    const Outcome<ErrorsOfChange> errors =
        errorsOf(*found, null.variant.task.recordings, {}, Progress(stop.get_token(), {}));
    EXPECT_TRUE(!errors || errors->checks.empty());
}

TEST(StepsOf, ReachTheEndsOfTheRangeButNeverNextToNothing) {
    const std::vector<FitParameter> parameters{{"R", "Ohm", 2, 0, 10}, {"k", "1", -2, -10, 0}, {"b", "1", 2, -10, 10}};
    EXPECT_NEAR(stepsOf(parameters, "R", 2).low, 0.05 * 2 - 2, 1e-12);
    EXPECT_NEAR(stepsOf(parameters, "R", 2).high, 8, 1e-12);
    EXPECT_NEAR(stepsOf(parameters, "k", -2).high, 2 - 0.05 * 2, 1e-12);
    EXPECT_NEAR(stepsOf(parameters, "b", 2).low, -12, 1e-12);
}

}  // namespace
}  // namespace analogon
