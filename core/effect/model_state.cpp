#include "core/effect/model_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/fit/clock.hpp"
#include "core/fit/uncertainty.hpp"

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

/// Covariance of a problem's parameters as a fit found it; 0 for those that were not fitted.
Eigen::MatrixXd covarianceIn(const FitProblem& problem, Role role, const FitResult& fit) {
    const auto count = static_cast<Eigen::Index>(problem.parameters.size());
    std::vector<Eigen::Index> found;
    for (const FitParameter& p : problem.parameters) {
        Eigen::Index index = -1;
        for (std::size_t i = 0; i < fit.estimates.size(); ++i)
            if (fit.estimates[i].name == p.name && fit.estimates[i].experiment == p.experiment &&
                (role == Role::Fit || p.experiment < 0))
                index = static_cast<Eigen::Index>(i);
        found.push_back(index);
    }
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
        for (Eigen::Index j = 0; j < count; ++j) {
            const Eigen::Index a = found[static_cast<std::size_t>(i)], b = found[static_cast<std::size_t>(j)];
            if (a >= 0 && b >= 0) covariance(i, j) = fit.covariance(a, b);
        }
    return covariance;
}

/// The variant with its clocks told: of a recording, only what they stamp outside it has to be left out then.
Variant withClocksTold(Variant variant) {
    for (FitParameter& p : variant.task.parameters) {
        if (!isClock(p.name)) continue;
        for (const ParameterValue& v : variant.values)
            if (v.name == p.name) p.start = v.value;
        p.min = p.max = p.start;
    }
    return variant;
}

/// How far the simulated outputs are uncertain since the parameters are.
void addDeviations(const FitProblem& problem, int experiment, const Eigen::VectorXd& values,
                   const Eigen::MatrixXd& covariance, const SimulationOptions& simulation, const Progress& progress,
                   ExperimentState& state) {
    constexpr std::size_t mostSamples = 200'000;  // the slopes of longer ones take too much memory
    if (state.failure.failed || state.time.size() > mostSamples || !covariance.allFinite()) return;
    const FitExperiment& fitted = problem.experiments[static_cast<std::size_t>(experiment)];
    const Eigen::MatrixXd band = predictionBand(problem, experiment, values, covariance, nullptr, simulation, progress);
    for (OutputState& output : state.outputs) {
        const int row = fitted.system->outputIndex(output.name);
        if (row >= 0 && band.row(row).allFinite()) output.deviation = band.row(row).transpose();
    }
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
                            const Progress& progress, Detail detail) {
    ModelState state;
    state.parameters = fit.estimates;
    state.status = fit.status;
    state.message = fit.message;
    state.remarks = fit.remarks;
    state.simulations = fit.simulations;
    Outcome<std::string> text = textWithValues(variant);
    if (!text) return text.diagnostics();
    state.modelText = std::move(*text);

    const Variant told = withClocksTold(variant);
    std::map<int, ExperimentState> byRecording;
    for (const Role role : {Role::Fit, Role::Validate}) {
        Outcome<PreparedTask> prepared = prepareAt(told, {}, role);
        if (!prepared) return prepared.diagnostics();
        FitProblem& problem = prepared->problem;
        if (problem.experiments.empty()) continue;
        const Eigen::VectorXd values = problem.startValues();
        const Linearisation l = linearise(problem, values, false, {}, simulation, progress);
        const bool hasBands = detail == Detail::Report && fit.covariance.size() > 0;
        const Eigen::MatrixXd covariance = hasBands ? covarianceIn(problem, role, fit) : Eigen::MatrixXd();
        for (std::size_t e = 0; e < std::min(problem.experiments.size(), l.trajectories.size()); ++e) {
            ExperimentState experiment = experimentState(problem.experiments[e], role, l.trajectories[e]);
            if (hasBands)
                addDeviations(problem, static_cast<int>(e), values, covariance, simulation, progress, experiment);
            byRecording.emplace(prepared->fitRecordings[e], std::move(experiment));
        }
        if (detail != Detail::Report) continue;
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
