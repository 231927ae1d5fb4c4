#include "core/effect/reading/held_command.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/core/effect/warm_body.hpp"

namespace analogon {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// So many steps, each of `height` and ten samples long, up and down.
Eigen::VectorXd steps(int count, double height = 1) {
    Eigen::VectorXd u((count + 1) * 10);
    for (Eigen::Index k = 0; k < u.size(); ++k) u[k] = k / 10 % 2 == 0 ? 0 : height;
    return u;
}

TEST(LooksHeld, IsACommandOfStepsBetweenNeighbours) {
    EXPECT_TRUE(looksHeld(steps(4)));
    EXPECT_FALSE(looksHeld(Eigen::VectorXd::Constant(40, 3))) << "it never moves";
    EXPECT_FALSE(looksHeld(Eigen::VectorXd::LinSpaced(40, 0, 1))) << "a ramp";
}

TEST(LooksHeld, NeedsThreeJumps) {
    EXPECT_TRUE(looksHeld(steps(3)));
    EXPECT_FALSE(looksHeld(steps(2)));
}

TEST(LooksHeld, CountsAsJumpWhatIsTwoPercentOfTheRange) {
    const auto withSmall = [](double height) {
        Eigen::VectorXd u = steps(2, 1);
        Eigen::VectorXd more = steps(3, height);
        Eigen::VectorXd all(u.size() + more.size());
        all << u, more;
        return all;
    };
    EXPECT_TRUE(looksHeld(withSmall(0.021)));
    EXPECT_FALSE(looksHeld(withSmall(0.019)));
}

/// Ten moves, of which so many are steps alone and the others steps that were logged on their way.
TEST(LooksHeld, HasMostOfItsMovesAlone) {
    const auto logged = [](int alone) {
        std::vector<double> u(10, 0);
        double now = 0;
        for (int k = 0; k < alone; ++k) u.insert(u.end(), 10, now = 1 - now);
        for (int k = 0; k < 10 - alone; k += 2) {
            u.push_back(0.5);
            u.insert(u.end(), 9, now = 1 - now);
        }
        return Eigen::VectorXd(Eigen::Map<Eigen::VectorXd>(u.data(), static_cast<Eigen::Index>(u.size())));
    };
    EXPECT_TRUE(looksHeld(logged(6)));
    EXPECT_FALSE(looksHeld(logged(4)));
}

TEST(AnyLooksHeld, AsksOfInputsOnLinesInAllFittedRecordings) {
    EstimationTask task;
    Recording one = warmBodyRecording("one", 50);
    one.inputs.row(0) = steps(4).transpose();
    task.recordings = {one};
    EXPECT_TRUE(anyLooksHeld(task));
    holdInputs(task, {"P"});
    EXPECT_FALSE(anyLooksHeld(task)) << "it is held already";
    Recording ramp = one;
    ramp.inputs.row(0) = Eigen::RowVectorXd::LinSpaced(50, 0, 1);
    task.recordings = {one, ramp};
    EXPECT_FALSE(anyLooksHeld(task));
    ramp.role = Role::Validate;
    task.recordings = {one, ramp};
    EXPECT_TRUE(anyLooksHeld(task));
}

TEST(HoldInputs, HoldsThemInEveryRecordingOnce) {
    EstimationTask task;
    task.recordings = {warmBodyRecording("one", 3), warmBodyRecording("two", 3)};
    holdInputs(task, {"P"});
    holdInputs(task, {"P"});
    for (const Recording& r : task.recordings) EXPECT_THAT(r.held, ElementsAre("P"));
}

/// A body of little heat capacity whose power is switched every three samples; held or on straight lines.
EstimationTask switchedBody(bool isHeld) {
    constexpr int samples = 300, within = 100;
    EstimationTask task = warmBody({{"body.C", "J/K", 4, 1, 20}, {"joint.G", "W/K", 0.3, 0.01, 10}});
    Recording r = warmBodyRecording("run", samples);
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0, 0.02);
    const auto power = [](int k) { return k / 3 % 2 == 0 ? 8.0 : 2.0; };
    double T = 300;
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(2.0 * k);
        r.inputs(0, k) = power(k);
        r.outputs(0, k) = T + noise(random);
        for (int i = 0; i < within; ++i) {
            const double part = (i + 0.5) / within;
            const double now = isHeld ? power(k) : (1 - part) * power(k) + part * power(k + 1);
            T += 2.0 / within * (now - 0.2 * (T - 300)) / 4;
        }
    }
    task.recordings = {r};
    return task;
}

std::optional<HeldReading> readingOf(const EstimationTask& task) {
    const Outcome<NullModel> onLines = fitNull({task, {}, {}}, {}, NoiseLevel::Estimate, {}, {});
    EXPECT_TRUE(onLines) << format(onLines.diagnostics());
    return onLines ? heldReading(*onLines, {}, {}) : std::nullopt;
}

TEST(HeldReading, IsToldByWhatTheOutputsSay) {
    const std::optional<HeldReading> reading = readingOf(switchedBody(true));
    ASSERT_TRUE(reading);
    EXPECT_THAT(reading->inputs, ElementsAre("P"));
    EXPECT_LT(reading->errorPercent, 1);
    EXPECT_FALSE(readingOf(switchedBody(false))) << "the lines leave noise";
}

/// Two thermometers at a body whose power runs on straight lines from sample to sample, the first so many samples late.
EstimationTask withALateThermometer(double late) {
    constexpr int samples = 300, within = 100;
    EstimationTask task = taskOf(R"(model Body
  Analogon.Interfaces.RealInput P(unit="W");
  Analogon.Interfaces.RealOutput T1(unit="K");
  Analogon.Interfaces.RealOutput T2(unit="K");
  Analogon.Sources.PrescribedHeatFlow heater;
  Analogon.Thermal.HeatCapacitor body(C=4, T_start=300);
  Analogon.Thermal.ThermalConductor joint(G=0.2);
  Analogon.Sources.FixedTemperature surroundings(T=300);
  Analogon.Sensors.TemperatureSensor sensor1;
  Analogon.Sensors.TemperatureSensor sensor2;
equation
  connect(P, heater.Q_flow);
  connect(heater.port, body.port);
  connect(body.port, joint.port_a);
  connect(joint.port_b, surroundings.port);
  connect(body.port, sensor1.port);
  connect(body.port, sensor2.port);
  connect(sensor1.T, T1);
  connect(sensor2.T, T2);
end Body;
)",
                                 "Body");
    task.parameters = {{"body.C", "J/K", 4, 1, 20}, {"joint.G", "W/K", 0.3, 0.01, 10}};
    Recording r = blankRecording("run", {"P"}, {"T1", "T2"}, samples);
    std::mt19937 random(5);
    std::normal_distribution<double> noise;
    std::vector<double> T{300};
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(2.0 * k);
        r.inputs(0, k) = 5 + 3 * noise(random);
    }
    for (int k = 0; k + 1 < samples; ++k)
        for (int i = 0; i < within; ++i) {
            const double part = (i + 0.5) / within;
            const double now = (1 - part) * r.inputs(0, k) + part * r.inputs(0, k + 1);
            T.push_back(T.back() + 2.0 / within * (now - 0.2 * (T.back() - 300)) / 4);
        }
    for (int k = 0; k < samples; ++k) {
        const auto then = static_cast<std::size_t>(std::max(0.0, k - late) * within);
        r.outputs(0, k) = T[then] + 0.02 * noise(random);
        r.outputs(1, k) = T[static_cast<std::size_t>(k * within)] + 0.2 * noise(random);
    }
    task.recordings = {r};
    return task;
}

TEST(HeldReading, IsNoneWhereOneSensorIsLate) {
    EXPECT_FALSE(readingOf(withALateThermometer(0.5))) << "held, the first thermometer alone is right";
    EXPECT_FALSE(readingOf(withALateThermometer(0.75)));
}

TEST(HeldRemarks, SayWhatToWriteIntoTheStudy) {
    EstimationTask task = switchedBody(true);
    task.recordings.edit().front().asHeld["P"] = R"({"column": "power", "interpolation": "hold"})";
    const std::vector<Text> remarks = heldRemarks(task, {{"P"}, 0.5, false}, 12.25, false);
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_THAT(remarks[0].english(), HasSubstr("0.50 %, on straight lines one of 12.25 %"));
    EXPECT_THAT(remarks[0].english(), HasSubstr(R"(write "P": {"column": "power", "interpolation": "hold"})"));
    EXPECT_THAT(heldRemarks(task, {{"P"}, 0.5, true}, 12.25, false)[0].english(), HasSubstr("half a sample late"));
    EXPECT_THAT(heldRemarks(task, {{"P"}, 0.5, false}, 12.25, true)[0].english(), HasSubstr("is with it held"));
}

TEST(InputsToAsk, AreSixAtMostAndNoneOfVeryLongRecords) {
    const auto asked = [](int inputs, std::size_t samples) {
        EstimationTask task;
        std::vector<std::string> names;
        for (int i = 0; i < inputs; ++i) names.push_back("u" + std::to_string(i));
        Recording r = blankRecording("run", names, {"T"}, 2);
        r.inputs.col(0).setZero();
        r.inputs.col(1).setOnes();
        r.time.resize(samples);
        task.recordings = {r};
        return inputsToAsk(task).size();
    };
    EXPECT_EQ(asked(5, 2), 5u);
    EXPECT_EQ(asked(9, 2), 6u);
    EXPECT_EQ(asked(5, 200'000), 5u);
    EXPECT_EQ(asked(5, 200'001), 0u) << "half a sample of so many is next to nothing";
}

TEST(IsPromising, IsWhatWouldTakeAwayThreeTenths) {
    EXPECT_TRUE(isPromising(0.69, 1));
    EXPECT_FALSE(isPromising(0.71, 1));
}

TEST(IsBetterThanDelay, AsksLessWhereTheShapeOfTheColumnTells) {
    EXPECT_TRUE(isBetterThanDelay(1.04, 1, true));
    EXPECT_FALSE(isBetterThanDelay(1.06, 1, true));
    EXPECT_TRUE(isBetterThanDelay(0.89, 1, false));
    EXPECT_FALSE(isBetterThanDelay(0.91, 1, false));
}

}  // namespace
}  // namespace analogon
