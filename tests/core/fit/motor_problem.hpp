#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/fit/problem.hpp"
#include "tests/core/simulate/text_models.hpp"

namespace analogon::test {

inline SampledInputs steps(int count, double step, double level, double period) {
    SampledInputs inputs;
    inputs.values.resize(1, count);
    for (int k = 0; k < count; ++k) {
        inputs.time.push_back(k * step);
        inputs.values(0, k) = std::fmod(k * step, period) < 0.5 * period ? level : 0.2 * level;
    }
    return inputs;
}

/// An experiment whose measurement is the system itself at `truth` (by name order of its parameters) and noise.
inline FitExperiment simulated(const std::string& name, const SystemPtr& system, const SampledInputs& inputs,
                               const std::vector<double>& truth, double sigma, unsigned seed) {
    FitExperiment experiment;
    experiment.name = name;
    experiment.system = system;
    experiment.inputs = inputs;
    experiment.parameters = ownParameters(*system);
    SimulationTask task;
    task.system = system.get();
    task.inputs = &inputs;
    task.parameters = truth;
    const Trajectory exact = simulate(task);
    EXPECT_FALSE(exact.failure.failed);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0.0, sigma > 0 ? sigma : 1.0);
    experiment.measured = exact.outputs;
    if (sigma > 0) {
        experiment.measured = experiment.measured.unaryExpr([&](double value) { return value + normal(random); });
    }
    experiment.weights = Eigen::VectorXd::Constant(system->outputCount(), sigma > 0 ? 1.0 / sigma : 1.0);
    return experiment;
}

inline FitParameter parameter(const std::string& name, double start, double min = -1e300, double max = 1e300) {
    FitParameter p;
    p.name = name;
    p.start = start;
    p.min = min;
    p.max = max;
    return p;
}

/// The motor on an elastic shaft with all its eight parameters off.
inline FitProblem motorProblem(int count, double sigma) {
    const SystemPtr system = compileText(motorText, "Motor", {"R", "L", "k", "J1", "J2", "c", "d", "b"});
    FitProblem problem;
    const std::vector<double> truth = ownParameters(*system);
    FitExperiment experiment = simulated("steps", system, steps(count, 1e-3, 6.0, 0.5), truth, 0.0, 5);
    std::mt19937 random(9);
    std::normal_distribution<double> normal;
    for (Eigen::Index o = 0; o < 2; ++o) {
        const double level = sigma * (experiment.measured.row(o).maxCoeff() - experiment.measured.row(o).minCoeff());
        for (double& value : experiment.measured.row(o)) value += level * normal(random);
        experiment.weights[o] = 1.0 / level;
    }
    problem.experiments.push_back(experiment);
    const double factors[] = {1.6, 0.6, 0.7, 1.5, 0.6, 1.8, 0.5, 2.0};
    for (std::size_t i = 0; i < truth.size(); ++i) {
        problem.parameters.push_back(
            parameter(system->parameters()[i].name, truth[i] * factors[i], truth[i] * 1e-2, truth[i] * 1e2));
    }
    return problem;
}

}  // namespace analogon::test
