#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "tests/verification/model_runs.hpp"

/// Relations that switch: located events, exact rest, and an end to what would chatter.
namespace analogon {
namespace {

using test::compiled;
using test::evenly;
using test::modelLibrary;
using test::run;

SystemPtr eventModel(const std::string& name) {
    static const Library library = modelLibrary("Events.mo");
    return compiled(library, "Events." + name);
}

SimulationOptions tight() {
    SimulationOptions options;
    options.relativeTolerance = 1e-8;
    options.absoluteTolerance = 1e-11;
    return options;
}

TEST(Event, BouncesAreLocated) {
    const double g = 9.81;
    const double exact[] = {0.451523640985730904, 1.08365673836575417, 1.52614990653177046, 1.83589512424798186,
                            2.05271677664932984,  2.20449193333027342, 2.31073454300693393, 2.38510436978059629};
    const SystemPtr system = eventModel("BouncingBall");
    ASSERT_TRUE(system);
    // From just before each bounce the flight is known: its end is the time of the event.
    std::vector<double> times{0};
    for (const double t : exact) times.push_back(t - 1e-3);
    const Trajectory ball = run(*system, times, tight());
    ASSERT_FALSE(ball.failure.failed) << ball.failure.reason;
    double worst = 0;
    for (std::size_t i = 0; i < std::size(exact); ++i) {
        const double h = ball.outputs(0, static_cast<Eigen::Index>(i) + 1);
        const double v = ball.outputs(1, static_cast<Eigen::Index>(i) + 1);
        const double bounce = times[i + 1] + (v + std::sqrt(v * v + 2 * g * h)) / g;
        worst = std::max(worst, std::fabs(bounce / exact[i] - 1));
    }
    std::printf("bounces: largest relative error of a time %.1e\n", worst);
    EXPECT_LT(worst, 1e-6);
}

/// Infinitely many bounces before t = 2.5586: the ball lies still afterwards, or the run says why it ends.
TEST(Event, BouncesThatPileUpEnd) {
    const SystemPtr system = eventModel("BouncingBall");
    ASSERT_TRUE(system);
    const auto start = std::chrono::steady_clock::now();
    const Trajectory ball = run(*system, {0, 1, 3}, tight());
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    EXPECT_LT(spent.count(), 5);
    if (ball.failure.failed) {
        EXPECT_EQ(ball.failure.reason, "events without end");
        EXPECT_NEAR(ball.failure.time, 2.55863, 1e-3);
    } else {
        EXPECT_NEAR(ball.outputs(0, 2), 0, 1e-9);
    }
}

TEST(Event, DryFrictionTurnsAndHolds) {
    const double turns[][2] = {{0.314159265358979324, -0.44}, {0.628318530717958648, 0.38},
                               {0.942477796076937972, -0.32}, {1.2566370614359173, 0.26},
                               {1.57079632679489662, -0.2},   {1.88495559215387594, 0.14},
                               {2.19911485751285527, -0.08},  {2.51327412287183459, 0.02}};
    const SystemPtr system = eventModel("CoulombOscillator");
    ASSERT_TRUE(system);
    std::vector<double> times{0};
    for (const auto& turn : turns) times.push_back(turn[0]);
    for (int i = 0; i <= 1000; ++i) times.push_back(2.6 + i * 0.1);
    const Trajectory mass = run(*system, times, tight());
    ASSERT_FALSE(mass.failure.failed) << mass.failure.reason;
    for (std::size_t i = 0; i < std::size(turns); ++i)
        EXPECT_NEAR(mass.outputs(0, static_cast<Eigen::Index>(i) + 1), turns[i][1], 1e-6);
    const Eigen::Index rest = 1 + static_cast<Eigen::Index>(std::size(turns));
    const double drift = (mass.outputs.row(0).tail(1001).array() - mass.outputs(0, rest)).abs().maxCoeff();
    std::printf("stuck oscillator: rest off by %.1e, drift over 100 s %.1e\n", std::fabs(mass.outputs(0, rest) - 0.02),
                drift);
    EXPECT_LT(drift, 1e-9);
    ASSERT_FALSE(mass.remarks.empty());
    EXPECT_NE(mass.remarks.back().find("relation of v holds"), std::string::npos) << mass.remarks.back();
}

/// While it sticks the mass moves with the belt exactly; it slips when the spring pulls with 3 N, at x = 0.03.
TEST(Event, ABeltCarriesUntilItSlips) {
    const SystemPtr system = eventModel("StickSlip");
    ASSERT_TRUE(system);
    const Trajectory mass = run(*system, evenly(0, 3, 3001), tight());
    ASSERT_FALSE(mass.failure.failed) << mass.failure.reason;
    for (int k = 0; k <= 299; ++k) {
        ASSERT_NEAR(mass.outputs(1, k), 0.1, 1e-9);
        ASSERT_NEAR(mass.outputs(0, k), 1e-4 * k, 1e-9);
    }
    EXPECT_LT(mass.outputs.row(1).tail(2600).minCoeff(), 0.0);  // it has slipped back
    int stuck = 0;
    for (Eigen::Index k = 400; k < 3001; ++k) stuck += std::fabs(mass.outputs(1, k) - 0.1) < 1e-9;
    EXPECT_GT(stuck, 300);  // and sticks again
}

/// Stuck together and to the ground until the pull is 3; the upper one slips off the lower at 2.
TEST(Event, TwoFrictionsHoldAtATime) {
    const SystemPtr system = eventModel("TwoBrakes");
    ASSERT_TRUE(system);
    const Trajectory t = run(*system, evenly(0, 6, 601), tight());
    ASSERT_FALSE(t.failure.failed) << t.failure.reason;
    // v1 = 1 - 2t + t^2/2 reaches 0 at t = 2 - sqrt(2); the ground holds with 3 against 2 throughout.
    EXPECT_NEAR(t.outputs(0, 50), 1 - 1 + 0.125, 1e-7);
    for (Eigen::Index k = 60; k <= 199; ++k) {
        ASSERT_NEAR(t.outputs(0, k), 0, 1e-10);
        ASSERT_NEAR(t.outputs(1, k), 0, 1e-10);
    }
    EXPECT_NEAR(t.outputs(0, 600), 0.5 * 16, 1e-6);
    EXPECT_NEAR(t.outputs(1, 600), 0, 1e-10);
}

TEST(Event, ChatteringIsHeldInTheMean) {
    const SystemPtr system = eventModel("Thermostat");
    ASSERT_TRUE(system);
    const auto start = std::chrono::steady_clock::now();
    const Trajectory t = run(*system, evenly(0, 100, 101), tight());
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    EXPECT_LT(spent.count(), 2);
    ASSERT_FALSE(t.failure.failed) << t.failure.reason;
    EXPECT_NEAR(t.outputs(0, 100), 300, 1e-9);
    ASSERT_EQ(t.remarks.size(), 1u);
    EXPECT_NE(t.remarks[0].find("holds the model between its two sides"), std::string::npos);
}

/// Free between the stops: the speed is 1 exactly there, and the period is known.
TEST(Event, ContactIsExact) {
    const SystemPtr system = eventModel("DeadZone");
    ASSERT_TRUE(system);
    const double period = 4 * 0.2 + 2 * 3.14159265358979323846 / 100;
    const Trajectory t = run(*system, {0, 0.1, 0.2, 10 * period}, tight());
    ASSERT_FALSE(t.failure.failed) << t.failure.reason;
    EXPECT_NEAR(t.outputs(1, 1), 1, 1e-12);
    EXPECT_NEAR(t.outputs(0, 3), 0, 1e-5);
    EXPECT_NEAR(t.outputs(1, 3), 1, 1e-5);
}

/// Steps that would pass over a pulse are repeated shorter: each of 318 pulses counts.
TEST(Event, PulsesBetweenTheStepsAreFound) {
    const SystemPtr chopper = eventModel("Chopper");
    ASSERT_TRUE(chopper);
    const double period = 2 * 3.14159265358979323846 / 1000;
    const Trajectory t = run(*chopper, {0, 100 * period, 318.5 * period}, tight());
    ASSERT_FALSE(t.failure.failed) << t.failure.reason;
    EXPECT_NEAR(t.outputs(0, 1), 50 * period, 1e-6);
    EXPECT_NEAR(t.outputs(0, 2), 159.5 * period, 1e-6);
    const SystemPtr rare = eventModel("RareAndShort");
    ASSERT_TRUE(rare);
    const Trajectory once = run(*rare, {0, 10}, tight());
    ASSERT_FALSE(once.failure.failed) << once.failure.reason;
    EXPECT_NEAR(once.outputs(0, 1), 1.6, 1e-6);
}

TEST(Event, WhatSwitchesTooFastIsNamedSoon) {
    Library library = modelLibrary("Events.mo");
    const auto source = std::make_shared<const Source>("Fast.mo",
                                                       "model Fast extends Events.Chopper(f = 1e9); end Fast; model "
                                                       "Many extends Events.Chopper(f = 1.5e5); end Many;");
    const Outcome<Library> wider = library.withSource(source);
    ASSERT_TRUE(wider) << format(wider.diagnostics());
    const std::pair<const char*, const char*> cases[] = {{"Fast", "events faster than the steps"},
                                                         {"Many", "more than 100000 events"},
                                                         {"Events.Dithered", "events faster than the steps"}};
    for (const auto& [name, reason] : cases) {
        const SystemPtr system = compiled(*wider, name);
        ASSERT_TRUE(system);
        SimulationOptions options = tight();
        options.wallClockLimit = 300;  // the number of events is to end it, however busy the machine
        const auto start = std::chrono::steady_clock::now();
        const Trajectory t = run(*system, {0, 1, 2.5}, options);
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
        ASSERT_TRUE(t.failure.failed) << name;
        EXPECT_EQ(t.failure.reason, reason) << name;
        EXPECT_EQ(t.failure.variable, "x") << name;
        std::printf("%s: '%s' after %.2f s\n", name, t.failure.reason.c_str(), spent.count());
    }
}

/// Small models that are hard on the numerics: each ends soon, in values or in a message.
TEST(Event, HardNumericsEndInValuesOrWords) {
    const std::string folder = ANALOGON_ROOT "/../shared/verification/hostile/numeric/";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
    const auto result = [&](const std::string& name, double end) {
        std::ifstream stream(folder + name, std::ios::binary);
        std::string text((std::istreambuf_iterator<char>(stream)), {});
        const auto library = Library().withSource(std::make_shared<const Source>(name, std::move(text)));
        EXPECT_TRUE(library) << format(library.diagnostics());
        const SystemPtr system = compiled(*library, "A");
        SimulationOptions options;
        options.wallClockLimit = 2;
        return system ? run(*system, {0, end}, options) : Trajectory();
    };
    const Trajectory chatter = result("chatter.mo", 2);
    EXPECT_FALSE(chatter.failure.failed) << chatter.failure.reason;
    ASSERT_FALSE(chatter.remarks.empty());
    EXPECT_NE(chatter.remarks[0].find("from t = 1 s a relation of x holds the model"), std::string::npos)
        << chatter.remarks[0];
    const Trajectory blowup = result("blowup.mo", 2);
    EXPECT_TRUE(blowup.failure.failed);
    EXPECT_NEAR(blowup.failure.time, 1, 1e-3);
    EXPECT_EQ(blowup.failure.variable, "x");
    const Trajectory root = result("sqrt_neg.mo", 3);
    EXPECT_TRUE(root.failure.failed);
    EXPECT_NEAR(root.failure.time, 2, 1e-2);
    EXPECT_TRUE(result("log0.mo", 1).failure.failed);
    EXPECT_FALSE(result("init_two.mo", 1).failure.failed);
    const Trajectory fast = result("long_osc.mo", 1000);
    EXPECT_TRUE(fast.failure.failed);
    EXPECT_EQ(fast.failure.reason, "time limit");
}

}  // namespace
}  // namespace analogon
