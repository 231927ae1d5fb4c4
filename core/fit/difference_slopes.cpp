#include "core/fit/difference_slopes.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/memory.hpp"

namespace analogon {
namespace {

constexpr double visible = 1e-2;  // of the signal: what a change should move
constexpr int mostTries = 4;      // to find such a change

}  // namespace

bool maySwitch(const FitProblem& problem) {
    return std::any_of(problem.experiments.begin(), problem.experiments.end(),
                       [](const FitExperiment& e) { return !e.system->isSmooth(); });
}

double signalOf(const FitProblem& problem) {
    double squares = 0;
    for (const FitExperiment& e : problem.experiments)
        for (Eigen::Index o = 0; o < e.measured.rows(); ++o) {
            if (!e.isFitted(o)) continue;
            double sum = 0, count = 0;
            for (const double y : e.measured.row(o))
                if (!std::isnan(y)) sum += y, ++count;
            for (const double y : e.measured.row(o))
                if (!std::isnan(y)) squares += std::pow(e.weights[o] * (y - sum / count), 2);
        }
    return std::sqrt(squares);
}

Eigen::VectorXd visibleSteps(const FitProblem& problem, const Eigen::VectorXd& values) {
    Eigen::VectorXd steps(values.size());
    for (Eigen::Index k = 0; k < values.size(); ++k) {
        const FitParameter& p = problem.parameters[static_cast<std::size_t>(k)];
        const double up = p.max - values[k], down = values[k] - p.min, range = p.max - p.min;
        const double wanted = values[k] != 0 ? 1e-2 * std::abs(values[k]) : range < 1e100 ? 1e-4 * range : 1e-6;
        steps[k] = wanted <= up || up >= down ? std::min(wanted, up) : -std::min(wanted, down);
    }
    return steps;
}

Linearisation lineariseByDifferences(const FitProblem& problem, const Eigen::VectorXd& values,
                                     const std::vector<GridPlan>& plans, const SimulationOptions& options,
                                     const Progress& progress, int& simulations) {
    const auto residualsAt = [&](const Eigen::VectorXd& at) {
        return linearise(problem, at, false, plans, options, progress);
    };
    Linearisation here = residualsAt(values);
    if (!here.ok) return here;
    const auto fail = [&](const Linearisation& there) {
        here.ok = false;
        here.failure = there.failure;
        return here;
    };
    const double signal = signalOf(problem);
    Eigen::VectorXd steps = visibleSteps(problem, values);
    resizeLarge(here.jacobian, here.residuals.size(), values.size());
    for (Eigen::Index k = 0; k < values.size(); ++k) {
        const FitParameter& p = problem.parameters[static_cast<std::size_t>(k)];
        if (steps[k] == 0) {  // its bounds leave it no room
            here.jacobian.col(k).setZero();
            continue;
        }
        Eigen::VectorXd there = values, change;
        for (int tries = 0;; ++tries) {
            there[k] = values[k] + steps[k];
            const Linearisation l = residualsAt(there);
            ++simulations;
            if (!l.ok) return fail(l);
            change = l.residuals - here.residuals;
            const double moved = change.norm() / std::max(signal, 1e-300);
            if (tries >= mostTries || (moved > 0.2 * visible && moved < 5 * visible)) break;
            steps[k] *= std::clamp(visible / std::max(moved, 1e-300), 0.05, 20.0);
            const double most = steps[k] > 0 ? p.max - values[k] : values[k] - p.min;
            if (std::abs(steps[k]) > most) {
                steps[k] = std::copysign(most, steps[k]);
                tries = mostTries;
            }
        }
        there[k] = values[k] - steps[k];
        if (there[k] < p.min || there[k] > p.max) {
            here.jacobian.col(k) = change / steps[k];
            continue;
        }
        const Linearisation back = residualsAt(there);
        ++simulations;
        if (!back.ok) return fail(back);
        here.jacobian.col(k) = (change - (back.residuals - here.residuals)) / (2 * steps[k]);
    }
    return here;
}

}  // namespace analogon
