#include "core/fit/problem.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "tests/core/fit/motor_problem.hpp"

namespace analogon {
namespace {

/// Recordings of different lengths.
FitProblem recordings(int count) {
    FitProblem problem = test::motorProblem(200, 0.01);
    for (int e = 1; e < count; ++e) {
        problem.experiments.push_back(test::motorProblem(200 + 50 * e, 0.01).experiments.front());
        problem.experiments.back().name = "recording " + std::to_string(e + 1);
    }
    return problem;
}

TEST(Linearise, IsTheSameWhateverTheThreads) {
    FitProblem problem = recordings(5);
    problem.experiments[2].measured.row(0).segment(20, 30).setConstant(std::nan(""));
    MisfitSums sums;
    const Linearisation one = linearise(problem, problem.startValues(), true, {}, {}, {}, &sums);
    ASSERT_TRUE(one.ok) << one.failure;
    ASSERT_EQ(one.residuals.size(), 2 * (200 + 250 + 300 + 350 + 400) - 30);
    EXPECT_NEAR(sums.squares, one.residuals.squaredNorm(), 1e-9 * sums.squares);
    for (const int threads : {2, 4}) {
        MisfitSums added;
        const Linearisation several = linearise(problem, problem.startValues(), true, {}, {}, {}, &added, threads);
        ASSERT_TRUE(several.ok) << several.failure;
        EXPECT_EQ(several.residuals, one.residuals);
        EXPECT_EQ(several.jacobian, one.jacobian);
        EXPECT_EQ(added.hessian, sums.hessian);
        EXPECT_EQ(added.gradient, sums.gradient);
        EXPECT_EQ(added.squares, sums.squares);
        ASSERT_EQ(several.trajectories.size(), 5u);
        EXPECT_EQ(several.trajectories[4].outputs, one.trajectories[4].outputs);
    }
}

TEST(Linearise, SimulatesRecordingsSideBySide) {
    FitProblem problem = recordings(2);
    std::atomic<int> begun{0};
    std::atomic<bool> wereTogether{false};
    problem.beforeSimulation = [&](SimulationTask&, SimulationOptions&) {
        const int place = ++begun;
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        while (begun < 2 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
        if (place == 1 && begun >= 2) wereTogether = true;  // the second begins before the first has ended
    };
    EXPECT_TRUE(linearise(problem, problem.startValues(), false, {}, {}, {}, nullptr, 2).ok);
    EXPECT_TRUE(wereTogether);
}

TEST(Linearise, TellsTheFirstRecordingThatFailsWhateverTheThreads) {
    FitProblem problem = recordings(6);
    problem.beforeSimulation = [](SimulationTask& task, SimulationOptions&) {
        if (task.inputs->time.size() == 300 || task.inputs->time.size() == 400) throw std::runtime_error("no valve");
    };
    for (const int threads : {1, 2, 4}) {
        MisfitSums sums;
        const Linearisation line = linearise(problem, problem.startValues(), true, {}, {}, {}, &sums, threads);
        EXPECT_FALSE(line.ok);
        EXPECT_FALSE(sums.ok);
        EXPECT_EQ(line.trajectories.size(), 3u) << "it ends with the one that failed";
        EXPECT_NE(line.failure.english().find("recording 3"), std::string::npos) << line.failure;
        EXPECT_NE(line.failure.english().find("no valve"), std::string::npos) << line.failure;
    }
}

}  // namespace
}  // namespace analogon
