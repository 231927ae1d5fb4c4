#include "core/study/sensitivity.hpp"

#include <algorithm>
#include <cmath>

#include "core/fit/optimum_uncertainty.hpp"
#include "core/fit/priors.hpp"
#include "core/fit/reduced_misfit.hpp"

namespace analogon {

namespace {

/// The slopes of each output, out of the rows that follow one another by recording, output and sample.
std::vector<OutputSensitivity> perOutput(const FitProblem& problem, const Eigen::MatrixXd& jacobian) {
    std::vector<OutputSensitivity> outputs;
    Eigen::Index row = 0;
    for (const FitExperiment& experiment : problem.experiments)
        for (Eigen::Index o = 0; o < experiment.measured.rows(); ++o) {
            if (!experiment.isFitted(o)) continue;
            const SignalInfo& info = experiment.system->outputs()[static_cast<std::size_t>(o)];
            OutputSensitivity output{experiment.name, info.name, info.unit, {}, {}};
            for (Eigen::Index i = 0; i < experiment.measured.cols(); ++i)
                if (!std::isnan(experiment.measured(o, i)))
                    output.time.push_back(experiment.inputs.time[static_cast<std::size_t>(i)]);
            const auto count = static_cast<Eigen::Index>(output.time.size());
            output.slopes = jacobian.middleRows(row, count) / experiment.weights[o];
            row += count;
            if (count > 0) outputs.push_back(std::move(output));
        }
    return outputs;
}

/// Of a weighted residual, against which the priors weigh.
double scatterOf(const FitProblem& problem, const Linearisation& line) {
    if (problem.scatter > 0) return problem.scatter;
    const auto freedom = static_cast<double>(line.residuals.size()) - static_cast<double>(problem.parameters.size());
    const double scatter = freedom > 0 ? line.residuals.norm() / std::sqrt(freedom) : 1.0;
    return problem.weightsAreNoise ? std::max(scatter, 1.0) : scatter;
}

}  // namespace

Outcome<Sensitivity> sensitivityOf(const Study& study, const Progress& progress) {
    const Outcome<EstimationTask> task = estimationTask(study, UnusedColumns::Leave);
    if (!task) return task.diagnostics();
    const Outcome<PreparedTask> prepared = prepare(*task);
    if (!prepared) return prepared.diagnostics();
    const FitProblem& problem = prepared->problem;
    if (problem.parameters.empty())
        return error(phrase("no parameter is fitted"), {}, phrase("check the parameters that are to be looked at"));
    Sensitivity result;
    result.values = problem.startValues();
    for (const FitParameter& p : problem.parameters) {
        const std::string of =
            p.experiment < 0 ? "" : " (" + problem.experiments[static_cast<std::size_t>(p.experiment)].name + ")";
        result.parameters.push_back(p.name + of);
        result.units.push_back(p.unit);
    }
    const Linearisation line = linearise(problem, result.values, true, {}, {}, progress);
    if (!line.ok) return error(line.failure);
    const ReducedMisfit reduced = withPriors(reduce(line.jacobian, line.residuals),
                                             priorResiduals(problem, result.values, scatterOf(problem, line)));
    const Uncertainty uncertainty =
        uncertaintyAt(problem, result.parameters, result.values, line, reduced.jacobian, line.residuals.squaredNorm())
            .uncertainty;
    result.standardErrors = uncertainty.standardErrors;
    result.correlation = uncertainty.correlation;
    result.outputs = perOutput(problem, line.jacobian);
    return result;
}

}  // namespace analogon
