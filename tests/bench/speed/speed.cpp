// Times one pass with all tangents, and whole fits, against hand-written C++ of the same problem in the same run.
//   speed [seconds per figure]
#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <functional>

#include "core/fit/fit.hpp"
#include "tests/bench/speed/hand_written.hpp"
#include "tests/bench/speed/problems.hpp"

namespace analogon::speed {
namespace {

/// Time of this process on a processor [s]: the machine may be busy with other things.
double now() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Least time of some repeats [s].
double timed(double budget, const std::function<void()>& work) {
    double best = 1e300;
    const double end = now() + budget;
    for (int i = 0; i < 3 || now() < end; ++i) {
        const double begin = now();
        work();
        best = std::min(best, now() - begin);
        if (best > budget) break;
    }
    return best;
}

using Pass = std::function<NormalEquations(const Eigen::VectorXd&)>;

struct HandFit {
    Eigen::VectorXd values;
    double cost{};
    int passes{};
};

/// Levenberg and Marquardt in logarithms of the parameters on the normal equations (Nielsen's damping).
HandFit handFit(const SpeedProblem& problem, const Pass& pass) {
    const auto K = static_cast<Eigen::Index>(problem.parameters.size());
    Eigen::VectorXd p(K), lower(K), upper(K), largest = Eigen::VectorXd::Zero(K);
    for (Eigen::Index i = 0; i < K; ++i) {
        const FitParameter& q = problem.parameters[static_cast<std::size_t>(i)];
        p[i] = q.start, lower[i] = q.min, upper[i] = q.max;
    }
    NormalEquations here = pass(p);
    HandFit fit{p, here.cost, 1};
    double damping = 1e-3, growth = 2;
    for (int iteration = 0; iteration < 200; ++iteration) {
        const Eigen::VectorXd gradient = Eigen::Map<const Eigen::VectorXd>(here.gradient.data(), K).cwiseProduct(p);
        const Eigen::MatrixXd hessian =
            p.asDiagonal() * Eigen::Map<const Eigen::MatrixXd>(here.hessian.data(), K, K) * p.asDiagonal();
        largest = largest.cwiseMax(hessian.diagonal());
        Eigen::MatrixXd damped = hessian;
        damped.diagonal() += damping * largest;
        const Eigen::VectorXd step = -damped.ldlt().solve(gradient);
        const Eigen::VectorXd next =
            (p.array() * step.array().max(-1.5).min(1.5).exp()).matrix().cwiseMax(lower).cwiseMin(upper);
        const Eigen::VectorXd taken = (next.array() / p.array()).log();
        const double predicted = -taken.dot(gradient) - 0.5 * taken.dot(hessian * taken);
        NormalEquations there = pass(next);
        ++fit.passes;
        const double fall = here.cost - there.cost;
        if (std::isfinite(there.cost) && fall > 0) {
            const double quality = 2 * fall / predicted - 1;
            damping *= std::max(1.0 / 9, 1 - quality * quality * quality);
            growth = 2;
            p = next;
            here = std::move(there);
            if (fall < 1e-9 * here.cost) break;
        } else {
            if (std::abs(predicted) < 1e-9 * here.cost) break;
            damping *= growth;
            growth *= 2;
        }
    }
    fit.values = p;
    fit.cost = here.cost;
    return fit;
}

void compare(const SpeedProblem& problem, const Pass& pass, double budget) {
    const FitProblem ours = fitProblem(problem);
    const auto K = static_cast<Eigen::Index>(problem.parameters.size());
    const Eigen::VectorXd truth = Eigen::Map<const Eigen::VectorXd>(problem.truth.data(), K);
    const std::size_t samples = problem.inputs.time.size();
    fmt::print("{}: {} samples, {} parameters\n", problem.name, samples, K);

    const double handPass = timed(budget, [&] { pass(truth); });
    const double planning = timed(budget, [&] { planFor(ours, 0, truth); });
    const std::vector<GridPlan> plans{planFor(ours, 0, truth)};
    const double values = timed(budget, [&] { linearise(ours, truth, false, plans); });
    const double tangents = timed(budget, [&] { linearise(ours, truth, true, plans); });
    const auto line = [&](const char* what, double seconds, double reference) {
        fmt::print("  {:<46} {:9.3f} ms {:8.2f}\n", what, 1e3 * seconds, seconds / reference);
    };
    line("pass with tangents, by hand", handPass, handPass);
    line("choice of the method", planning, handPass);
    line("pass with values", values, handPass);
    line("pass with tangents", tangents, handPass);

    HandFit byHand;
    const double handTime = timed(budget, [&] { byHand = handFit(problem, pass); });
    FitResult result;
    const double ourTime = timed(budget, [&] { result = fit(ours); });
    line("fit, by hand", handTime, handTime);
    line("fit", ourTime, handTime);
    const double reference = handFit(problem, pass).cost;
    fmt::print(
        "  by hand {} passes, cost {:.6f}; here {} simulations, J/J* - 1 = {:.1e}, parameters within {:.1e}; {}\n\n",
        byHand.passes, byHand.cost, result.simulations, pass(result.values).cost / reference - 1,
        (result.values.array() / byHand.values.array() - 1).abs().maxCoeff(), result.message);
}

void scaling(double budget) {
    fmt::print("Motor, fits of longer records\n");
    for (const int samples : {10'001, 30'001, 100'001, 300'001, 1'000'001}) {
        const FitProblem problem = fitProblem(motor(samples, false));
        const double seconds = timed(budget, [&] { fit(problem); });
        fmt::print("  {:>8} samples {:9.1f} ms {:8.3f} us a sample\n", samples, 1e3 * seconds, 1e6 * seconds / samples);
    }
}

}  // namespace
}  // namespace analogon::speed

int main(int count, char** arguments) {
    using namespace analogon::speed;
    const double budget = count > 1 ? std::atof(arguments[1]) : 0.5;
    for (const bool isNoisy : {false, true}) {
        const SpeedProblem heater = lambdaHeater(30'001, isNoisy);
        const std::vector<double> table = heaterTable(heater.record());
        compare(
            heater, [&](const Eigen::VectorXd& p) { return heaterPass(heater.record(), table, p.data()); }, budget);
    }
    for (const bool isNoisy : {false, true}) {
        const SpeedProblem shaft = motor(20'001, isNoisy);
        compare(
            shaft, [&](const Eigen::VectorXd& p) { return motorPass(shaft.record(), p.data()); }, budget);
    }
    if (count > 2) scaling(budget);
    return 0;
}
