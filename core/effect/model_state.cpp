#include "core/effect/model_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace analogon {
namespace {

OutputState outputState(const SignalInfo& info, const Eigen::RowVectorXd& simulated,
                        const Eigen::RowVectorXd& measured) {
    return {info.name, info.unit, errorFigures(simulated, measured), measured.transpose(), simulated.transpose()};
}

ExperimentState experimentState(const FitExperiment& experiment, Role role, const Trajectory& trajectory) {
    ExperimentState state;
    state.name = experiment.name;
    state.role = role;
    state.time = experiment.inputs.time;
    state.failure = trajectory.failure;
    for (Eigen::Index o = 0; o < experiment.measured.rows(); ++o) {
        if (experiment.measured.row(o).array().isNaN().all()) continue;
        state.outputs.push_back(outputState(experiment.system->outputs()[static_cast<std::size_t>(o)],
                                            trajectory.outputs.row(o), experiment.measured.row(o)));
    }
    state.errorPercent = meanError(state.outputs, [](const OutputState& o) { return o.figures.errorPercent; });
    return state;
}

/// Residual of one output over the fitted experiments, one after the other.
void summariseResiduals(ModelState& state) {
    std::map<std::string, std::vector<double>> residuals;
    for (const ExperimentState& e : state.experiments)
        if (e.role == Role::Fit)
            for (const OutputState& o : e.outputs)
                for (Eigen::Index k = 0; k < o.measured.size(); ++k)
                    if (!std::isnan(o.measured[k])) residuals[o.name].push_back(o.simulated[k] - o.measured[k]);
    for (const auto& [name, r] : residuals)
        state.residual[name] =
            summarise(Eigen::Map<const Eigen::VectorXd>(r.data(), static_cast<Eigen::Index>(r.size())));
}

/// Fixed steps pass over what switches; the engine that locates events tells where a relation holds the model, or
/// switches without end. Bounded, since the figures do not depend on it.
std::vector<std::string> switchingRemarks(const FitProblem& problem, const Eigen::VectorXd& values,
                                          SimulationOptions options, const Progress& progress) {
    const auto switches = [](const FitExperiment& e) { return e.system->rootCount() > 0; };
    if (std::none_of(problem.experiments.begin(), problem.experiments.end(), switches)) return {};
    options.engine = Engine::Adaptive;
    options.stepLimit = std::min(options.stepLimit, 200'000L);
    options.wallClockLimit = std::min(options.wallClockLimit, 10.0);
    const Linearisation l = linearise(problem, values, false, {}, options, progress);
    std::vector<std::string> remarks;
    for (std::size_t e = 0; e < l.trajectories.size(); ++e) {
        const std::string& name = problem.experiments[e].name;
        for (const std::string& remark : l.trajectories[e].remarks)
            remarks.push_back(fmt::format("experiment '{}': {}", name, remark));
        const SimulationFailure& failure = l.trajectories[e].failure;
        if (failure.failed && (failure.reason.starts_with("events") || failure.reason.ends_with("events")))
            remarks.push_back(
                fmt::format("experiment '{}': a relation of {} switches without end at t = {:.6g} s; "
                            "what follows there is only as good as the steps of the fit",
                            name, failure.variable, failure.time));
    }
    return remarks;
}

}  // namespace

Outcome<ModelState> stateOf(const Variant& variant, const FitResult& fit, const SimulationOptions& simulation,
                            const Progress& progress) {
    ModelState state;
    state.parameters = fit.estimates;
    state.status = fit.status;
    state.message = fit.message;
    state.remarks = fit.remarks;
    state.simulations = fit.simulations;
    Outcome<std::string> text = textWithValues(variant);
    if (!text) return text.diagnostics();
    state.modelText = std::move(*text);

    std::map<int, ExperimentState> byRecording;
    for (const Role role : {Role::Fit, Role::Validate}) {
        Outcome<PreparedTask> prepared = prepareAt(variant, {}, role);
        if (!prepared) return prepared.diagnostics();
        FitProblem& problem = prepared->problem;
        if (problem.experiments.empty()) continue;
        const Eigen::VectorXd values = problem.startValues();
        const Linearisation l = linearise(problem, values, false, {}, simulation, progress);
        for (std::size_t e = 0; e < problem.experiments.size(); ++e)
            if (e < l.trajectories.size())
                byRecording.emplace(prepared->fitRecordings[e],
                                    experimentState(problem.experiments[e], role, l.trajectories[e]));
        for (std::string& remark : switchingRemarks(problem, values, simulation, progress))
            state.remarks.push_back(std::move(remark));
    }
    for (auto& [index, experiment] : byRecording) state.experiments.push_back(std::move(experiment));
    summariseResiduals(state);
    return state;
}

double errorPercentOf(const ModelState& state, Role role) {
    std::vector<const ExperimentState*> experiments;
    for (const ExperimentState& e : state.experiments)
        if (e.role == role) experiments.push_back(&e);
    return meanError(experiments, [](const ExperimentState* e) { return e->errorPercent; });
}

}  // namespace analogon
