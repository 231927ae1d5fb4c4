// Times the way from files to traces, then one pass with all tangents, and whole fits, against hand-written C++ of the
// same problem in the same run; then how both grow with samples, parameters and experiments.
//   speed [seconds per figure]
#include <fmt/format.h>
#include <malloc.h>

#include <Eigen/Core>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>

#include "core/base/memory.hpp"
#include "core/fit/fit.hpp"
#include "core/study/run.hpp"
#include "tests/bench/speed/hand_fit.hpp"
#include "tests/bench/speed/measuring.hpp"

namespace analogon::speed {
namespace {

double processor(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Time on the wall [s], where threads are to show.
double wall() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

Pass motorPassOf(const SpeedProblem& problem) {
    return [&problem](const Eigen::VectorXd& p) { return motorPass(problem.record(), p.data()); };
}

Pass heaterPassOf(const SpeedProblem& problem) {
    return [&problem, table = heaterTable(problem.record())](const Eigen::VectorXd& p) {
        return heaterPass(problem.record(), table, p.data());
    };
}

double deviation(const FitResult& result, const HandFit& byHand) {
    return (result.values.array() / byHand.values.array() - 1).abs().maxCoeff();
}

void compare(const SpeedProblem& problem, const Pass& pass, double budget) {
    const FitProblem ours = fitProblem(problem);
    FitProblem interpreted = ours;
    interpreted.experiments.front().isInterpreted = true;
    const auto K = static_cast<Eigen::Index>(problem.parameters.size());
    const Eigen::VectorXd truth = Eigen::Map<const Eigen::VectorXd>(problem.truth.data(), K);
    fmt::print("{}: {} samples, {} parameters\n", problem.name, problem.inputs.time.size(), K);
    const auto line = [&](const char* what, double seconds, double reference) {
        fmt::print("  {:<46} {:9.3f} ms {:8.2f}\n", what, 1e3 * seconds, seconds / reference);
    };
    const std::vector<GridPlan> plans{planFor(ours, 0, truth)}, itsPlans{planFor(interpreted, 0, truth)};
    const double handPass = timed(budget, [&] { pass(truth); });
    line("pass with tangents, by hand", handPass, handPass);
    line("choice of the method", timed(budget, [&] { planFor(ours, 0, truth); }), handPass);
    line("pass with values", timed(budget, [&] { sumUp(ours, truth, false, plans); }), handPass);
    line("pass with tangents", timed(budget, [&] { sumUp(ours, truth, true, plans); }), handPass);
    line("  by the interpreter", timed(budget, [&] { sumUp(interpreted, truth, true, itsPlans); }), handPass);

    HandFit byHand;
    FitResult result;
    const double handTime = timed(budget, [&] { byHand = handFit(problem, pass); });
    line("fit, by hand", handTime, handTime);
    line("fit", timed(budget, [&] { result = fit(ours); }), handTime);
    FitOptions whole;
    whole.beginsWithPart = false;
    line("  on all samples from the start", timed(budget, [&] { fit(ours, whole); }), handTime);
    FitOptions lean;
    lean.keepsOptimum = false;
    line("  without residuals and Jacobian", timed(budget, [&] { fit(ours, lean); }), handTime);
    line("  by the interpreter", timed(budget, [&] { fit(interpreted); }), handTime);
    FitOptions ceres;
    ceres.method = FitMethod::LeastSquaresByCeres;
    line("  with Ceres in the loop", timed(budget, [&] { fit(ours, ceres); }), handTime);
    fmt::print(
        "  by hand {} passes, cost {:.6f}; here {} simulations after {} of parts, J/J* - 1 = {:.1e}, parameters within "
        "{:.1e}; {}\n\n",
        byHand.passes, byHand.cost, result.simulations, result.partSimulations,
        pass(result.values).cost / byHand.cost - 1, deviation(result, byHand), result.message);
}

/// From the files of an example to the first traces of its model; the program reads the library once.
void startUp(const char* example) {
    const auto directory = std::filesystem::path(ANALOGON_ROOT) / "examples" / example;
    const auto simulate = [&] {
        const auto study = readStudy(directory);
        const auto task = taskOf(study.value(), {});
        const auto prepared = prepare(task.value());
        linearise(prepared->problem, prepared->problem.startValues(), false, {});
    };
    const double begin = now();
    simulate();
    const double first = now() - begin;
    fmt::print("{}: first traces after {:.1f} ms, and again after {:.1f} ms\n", example, 1e3 * first,
               1e3 * timed(0.2, simulate));
}

void growSamples(const char* title, SpeedProblem (*make)(int samples), Pass (*passOf)(const SpeedProblem&),
                 double budget) {
    fmt::print("{}, fits of longer records; memory above that of the data\n", title);
    double twentyThousand = 0;
    for (const int samples : {10'001, 20'001, 30'001, 100'001, 300'001, 1'000'001}) {
        const SpeedProblem problem = make(samples);
        const Pass pass = passOf(problem);
        const FitProblem ours = fitProblem(problem);
        FitResult result;
        HandFit byHand;
        const double hand = timed(budget, [&] { byHand = handFit(problem, pass); });
        const double seconds = timed(budget, [&] { result = fit(ours); });
        if (samples == 20'001) twentyThousand = seconds;
        FitOptions lean;
        lean.keepsOptimum = false;
        const double peak = peakMemory([&] { fit(ours); }), leanPeak = peakMemory([&] { fit(ours, lean); });
        fmt::print(
            "  {:>8} samples {:9.1f} ms by hand {:9.1f} ms {:6.2f}  {:6.3f} us a sample {:7.1f} MB, {:.1f} MB without "
            "Jacobian; {} and {} passes, within {:.0e}\n",
            samples, 1e3 * hand, 1e3 * seconds, seconds / hand, 1e6 * seconds / samples, peak, leanPeak, byHand.passes,
            result.simulations, deviation(result, byHand));
        if (samples == 1'000'001) fmt::print("  {:.0f} times the fit of 20 001 samples\n", seconds / twentyThousand);
    }
    fmt::print("\n");
}

/// No exact steps here: the drag grows with the speed, so that the steps of each interval have to be chosen. The
/// measurements are those of a linear drag; what counts is what the fit takes, not where it ends. Large blocks go back
/// to the system at once from here on, as in a fresh process: the peak is what is in use, not what fits before it left.
void takeStepsInALongRecord() {
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
    constexpr int samples = 1'000'001;
    SpeedProblem problem = motor(samples, false);
    const std::string linear = "tau - b*w2";
    problem.text.replace(problem.text.find(linear), linear.size(), "tau - b*w2*sqrt(1 + (w2/10)^2)");
    const FitProblem ours = fitProblem(problem);
    FitResult result;
    double seconds = 0;
    const double peak = peakMemory([&] {
        const double begin = now();
        result = fit(ours);
        seconds = now() - begin;
    });
    fmt::print(
        "\nMotor with a drag that is not linear\n  {:>8} samples {:9.1f} ms, {} passes, {:.1f} MB above the data\n",
        samples, 1e3 * seconds, result.simulations, peak);
}

void chainLine(const SpeedProblem& problem, int masses, double budget) {
    const FitProblem ours = fitProblem(problem);
    const auto K = static_cast<Eigen::Index>(problem.parameters.size());
    const Eigen::VectorXd truth = Eigen::Map<const Eigen::VectorXd>(problem.truth.data(), K);
    const std::vector<GridPlan> plans{planFor(ours, 0, truth)};
    NormalEquations byHand;
    MisfitSums sums;
    const double hand =
        timed(budget, [&] { byHand = chainPass(problem.record(), problem.truth.data(), masses, static_cast<int>(K)); });
    const double seconds = timed(budget, [&] { sums = sumUp(ours, truth, true, plans); });
    const double states = 2.0 * masses + 1;
    fmt::print(
        "  {:>3} masses {:>3} parameters {:9.2f} ms by hand {:9.2f} ms {:6.2f}  {:7.3f} us a parameter, {:.4f} a "
        "state and parameter; costs within {:.0e}\n",
        masses, K, 1e3 * hand, 1e3 * seconds, seconds / hand, 1e6 * seconds / static_cast<double>(K),
        1e6 * seconds / (static_cast<double>(K) * states), std::abs(0.5 * sums.squares / byHand.cost - 1));
}

void growParameters(double budget) {
    constexpr int samples = 5001;
    fmt::print("Motor on a chain of masses, {} samples, one pass with tangents in all parameters\n", samples);
    for (const int masses : {1, 2, 4, 10, 20}) chainLine(chain(samples, masses), masses, budget);
    fmt::print("The chain of 20 masses, with tangents in some of its parameters\n");
    for (const int fitted : {4, 8, 16, 32, 62}) chainLine(chain(samples, 20, fitted), 20, budget);
    fmt::print("\n");
}

void growExperiments(double budget) {
    constexpr int samples = 2001;
    fmt::print("Motor, fits of several recordings of {} samples\n", samples);
    for (const int count : {1, 2, 5, 10, 20, 50}) {
        std::vector<SpeedProblem> recordings;
        for (int e = 0; e < count; ++e)
            recordings.push_back(motor(samples, false, 20260102u + static_cast<unsigned>(e)));
        const FitProblem ours = fitProblem(recordings);
        const Pass pass = [&](const Eigen::VectorXd& p) {
            NormalEquations sums = motorPass(recordings.front().record(), p.data());
            for (std::size_t e = 1; e < recordings.size(); ++e) {
                const NormalEquations one = motorPass(recordings[e].record(), p.data());
                sums.cost += one.cost;
                std::transform(one.gradient.begin(), one.gradient.end(), sums.gradient.begin(), sums.gradient.begin(),
                               std::plus<>());
                std::transform(one.hessian.begin(), one.hessian.end(), sums.hessian.begin(), sums.hessian.begin(),
                               std::plus<>());
            }
            return sums;
        };
        FitResult result;
        HandFit byHand;
        const double hand = timed(budget, [&] { byHand = handFit(recordings.front(), pass); });
        const double seconds = timed(budget, [&] { result = fit(ours); });
        fmt::print(
            "  {:>3} experiments {:9.2f} ms by hand {:9.2f} ms {:6.2f}  {:7.3f} ms an experiment, {} and {} passes; "
            "within {:.0e}\n",
            count, 1e3 * hand, 1e3 * seconds, seconds / hand, 1e3 * seconds / count, byHand.passes, result.simulations,
            deviation(result, byHand));
    }
    fmt::print("\n");
}

/// What one thread would gain from another is seen on the wall of an idle machine, and in the processor time of the
/// busier one of a busy machine.
void growThreads() {
    const FitProblem ours = fitProblem(motor(20'001, true));
    fmt::print("Motor with a noisy input, 16 starts on two threads against one\n");
    double one = 1e300, oneOnTheWall = 1e300, two = 1e300, twoOnTheWall = 1e300;
    for (int repeat = 0; repeat < 5; ++repeat)
        for (const int threads : {1, 2}) {
            FitOptions options;
            options.starts = 16;
            options.threads = threads;
            const double begin = wall(), all = processor(CLOCK_PROCESS_CPUTIME_ID),
                         own = processor(CLOCK_THREAD_CPUTIME_ID);
            fit(ours, options);
            const double spent = processor(CLOCK_THREAD_CPUTIME_ID) - own;
            const double other = processor(CLOCK_PROCESS_CPUTIME_ID) - all - spent;
            double& best = threads == 1 ? one : two;
            double& bestOnTheWall = threads == 1 ? oneOnTheWall : twoOnTheWall;
            best = std::min(best, std::max(spent, other));
            bestOnTheWall = std::min(bestOnTheWall, wall() - begin);
        }
    fmt::print("  {:.2f} times as fast on the wall, {:.2f} times by processor time of the busier thread\n",
               oneOnTheWall / twoOnTheWall, one / two);
}

}  // namespace
}  // namespace analogon::speed

int main(int count, char** arguments) {
    using namespace analogon::speed;
    analogon::growHeap();  // as the programs do
    const double budget = count > 1 ? std::atof(arguments[1]) : 0.5;
    for (const char* const example : {"lambda-sensor-heating", "water-pump"}) startUp(example);
    fmt::print("\n");
    for (const bool isNoisy : {false, true}) {
        const SpeedProblem heater = lambdaHeater(30'001, isNoisy);
        compare(heater, heaterPassOf(heater), budget);
    }
    for (const bool isNoisy : {false, true}) {
        const SpeedProblem shaft = motor(20'001, isNoisy);
        compare(shaft, motorPassOf(shaft), budget);
    }
    growSamples(
        "Motor", [](int samples) { return motor(samples, false); }, motorPassOf, budget);
    growSamples(
        "Heater", [](int samples) { return lambdaHeater(samples, true); }, heaterPassOf, budget);
    growParameters(budget);
    growExperiments(budget);
    growThreads();
    takeStepsInALongRecord();
    return 0;
}
