#include "core/fit/own_parameters.hpp"

#include <algorithm>

#include "core/fit/held_value.hpp"

namespace analogon {

bool hasOwnParameters(const FitProblem& problem, int experiment) {
    return std::any_of(problem.parameters.begin(), problem.parameters.end(),
                       [&](const FitParameter& p) { return p.experiment == experiment; });
}

FitResult fitOwnParameters(const FitProblem& problem, int experiment, const Eigen::VectorXd& values,
                           const FitOptions& options, const Progress& progress) {
    FitProblem alone;
    alone.weightsAreNoise = problem.weightsAreNoise;
    alone.beforeSimulation = problem.beforeSimulation;
    alone.experiments = {problem.experiments[static_cast<std::size_t>(experiment)]};
    for (std::size_t i = 0; i < problem.parameters.size(); ++i) {
        FitParameter parameter = problem.parameters[i];
        const double value = values[static_cast<Eigen::Index>(i)];
        if (parameter.experiment < 0) hold(alone.experiments.front(), parameter.name, value);
        if (parameter.experiment != experiment) continue;
        parameter.experiment = 0;
        parameter.start = value;
        alone.parameters.push_back(std::move(parameter));
    }
    FitResult result = fit(alone, options, progress);
    for (FitEstimate& estimate : result.estimates) estimate.experiment = experiment;
    return result;
}

}  // namespace analogon
