#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <stdexcept>
#include <thread>

#include "core/fit/fit.hpp"
#include "tests/core/fit/motor_problem.hpp"

// Simulations that fail, and fits that are stopped.
namespace analogon {
namespace {

using test::motorProblem;
using ::testing::Contains;
using ::testing::HasSubstr;

/// Makes chosen simulations fail, each in another way.
class Faults {
public:
    /// `isAt` is asked with the number of the simulation.
    explicit Faults(std::function<bool(int)> isAt) : isAt_(std::move(isAt)) {}

    void operator()(SimulationTask& task, SimulationOptions& options) {
        if (!isAt_(simulations_++)) return;
        switch (injected_++ % 3) {
            case 0:
                task.parameters.front() = std::nan("");
                break;
            case 1:
                options.evaluationLimit = -1;
                break;
            default:
                throw std::runtime_error("out of memory");
        }
    }
    int injected() const { return injected_; }

private:
    std::function<bool(int)> isAt_;
    int simulations_{}, injected_{};
};

/// Ten in a row soon after the start, then about four of five, until there were a hundred.
bool isFaulty(int simulation) {
    if (simulation < 2) return false;
    if (simulation < 12) return true;
    return (static_cast<unsigned>(simulation) * 2654435761u >> 16) % 5 != 0;
}

class AHundredFailures : public ::testing::TestWithParam<FitMethod> {};

TEST_P(AHundredFailures, CostTimeButNotTheOptimum) {
    FitProblem problem = motorProblem(1500, 0.005);
    FitOptions options;
    options.method = GetParam();
    // Ceres counts its failed steps as iterations.
    if (options.method == FitMethod::LeastSquaresByCeres) options.maxIterations = 500;
    if (options.method == FitMethod::NelderMead) problem.parameters.resize(3);
    const FitResult undisturbed = fit(problem, options);
    ASSERT_EQ(undisturbed.status, FitStatus::Converged) << undisturbed.message;
    EXPECT_EQ(undisturbed.failedSimulations, 0);

    int allowed = 100;
    Faults faults([&](int simulation) { return allowed > 0 && isFaulty(simulation) && allowed-- > 0; });
    problem.beforeSimulation = std::ref(faults);
    const FitResult disturbed = fit(problem, options);
    EXPECT_EQ(disturbed.status, FitStatus::Converged) << disturbed.message;
    EXPECT_EQ(faults.injected(), 100) << disturbed.message;
    for (Eigen::Index i = 0; i < disturbed.values.size(); ++i)
        EXPECT_NEAR(disturbed.values[i], undisturbed.values[i], 1e-4 * std::abs(undisturbed.values[i])) << i;
    EXPECT_EQ(disturbed.failedSimulations, 100);
    EXPECT_THAT(disturbed.remarks, Contains(HasSubstr("100 of")));
    EXPECT_TRUE(disturbed.optimum.ok);
}

INSTANTIATE_TEST_SUITE_P(Fit, AHundredFailures,
                         ::testing::Values(FitMethod::LeastSquares, FitMethod::LeastSquaresByCeres,
                                           FitMethod::NelderMead));

TEST(Fit, TellsWhatWasThrownInASimulation) {
    FitProblem problem = motorProblem(300, 0.005);
    problem.beforeSimulation = [](SimulationTask&, SimulationOptions&) { throw std::runtime_error("out of memory"); };
    const FitResult result = fit(problem);
    EXPECT_EQ(result.status, FitStatus::Failed);
    EXPECT_THAT(result.message, HasSubstr("experiment 'steps' failed at t = 0 s: out of memory"));
}

/// Processor time from the moment the user cancels, so long after a report of the fit, until it is back: the machine
/// may be busy with other things.
struct Cancelled {
    FitResult result;
    double seconds{};
};
Cancelled cancelledFit(const FitProblem& problem, int report, int milliseconds, const FitOptions& options = {}) {
    std::stop_source source;
    std::clock_t asked{};
    int reports = 0;
    const auto cancel = [&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
        asked = std::clock();
        source.request_stop();
    };
    std::jthread user;
    if (report == 0) user = std::jthread(cancel);
    const Progress progress(source.get_token(), [&](const Progress::Report&) {
        if (++reports == report) user = std::jthread(cancel);
    });
    Cancelled cancelled{fit(problem, options, progress), 0};
    cancelled.seconds = static_cast<double>(std::clock() - asked) / CLOCKS_PER_SEC;
    return cancelled;
}

TEST(Fit, StopsAtOnceWhenCancelledInALongRecord) {
    constexpr int attempts = 3;  // other work on the machine only adds to the time: the least counts
    for (const int samples : {100'000, 1'000'000}) {
        // In the middle of the simulations that follow the third report.
        FitOptions options;
        options.beginsWithPart = false;
        const int milliseconds = samples / 50'000;  // well within one of them on any machine
        const FitProblem problem = motorProblem(samples, 0.005);
        double least = 1;
        for (int attempt = 0; attempt < attempts && least >= 0.1; ++attempt) {
            const auto [result, seconds] = cancelledFit(problem, 3, milliseconds, options);
            EXPECT_EQ(result.status, FitStatus::Cancelled) << result.message;
            ASSERT_EQ(result.values.size(), 8);
            EXPECT_LT(result.cost, result.startCost);
            EXPECT_TRUE(std::isfinite(result.estimates.front().standardError));
            least = std::min(least, seconds);
        }
        EXPECT_LT(least, 0.1) << samples << " samples";
    }
}

TEST(Fit, KeepsTheBestOfAPartWhenCancelledThere) {
    for (const int samples : {100'000, 1'000'000}) {
        const FitProblem problem = motorProblem(samples, 0.005);
        std::stop_source source;
        std::vector<Progress::Value> best;
        int reports = 0;
        const Progress progress(source.get_token(), [&](const Progress::Report& report) {
            if (++reports > 3) return;
            best = report.best;
            if (reports == 3) source.request_stop();
        });
        const FitResult result = fit(problem, {}, progress);
        EXPECT_EQ(result.status, FitStatus::Cancelled) << result.message;
        EXPECT_GT(result.partSimulations, 0);
        EXPECT_LE(result.simulations, 2);  // none of them finished
        ASSERT_EQ(best.size(), 8u);
        for (std::size_t i = 0; i < best.size(); ++i) {
            EXPECT_EQ(result.estimates[i].value, best[i].value) << best[i].name;
            EXPECT_NE(best[i].value, problem.parameters[i].start);
        }
    }
}

TEST(Fit, StopsAtOnceWhenCancelledWhileItChoosesItsSteps) {
    FitProblem problem = motorProblem(500'000, 0.005);
    problem.experiments.front().inputs.time.back() += 1e-4;  // not equidistant: no exact steps
    const auto [result, seconds] = cancelledFit(problem, 0, 20);
    EXPECT_EQ(result.status, FitStatus::Cancelled) << result.message;
    EXPECT_LT(seconds, 0.05);  // [s] marking what was not reached would take longer
}

}  // namespace
}  // namespace analogon
