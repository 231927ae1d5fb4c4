#include "core/effect/model/model_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/parallel.hpp"
#include "core/base/range.hpp"
#include "core/base/stop.hpp"
#include "core/base/unit.hpp"
#include "core/effect/thresholds.hpp"
#include "core/fit/clock.hpp"
#include "core/fit/own_parameters.hpp"
#include "core/fit/uncertainty.hpp"

namespace analogon {

using namespace threshold::noise;

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
    state.errorPercent = errorPercentOf(state.outputs);
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

/// Which of a problem's parameters belong to one experiment alone.
std::vector<Eigen::Index> ownParameters(const FitProblem& problem, int experiment) {
    std::vector<Eigen::Index> own;
    for (std::size_t i = 0; i < problem.parameters.size(); ++i)
        if (problem.parameters[i].experiment == experiment) own.push_back(static_cast<Eigen::Index>(i));
    return own;
}

/// A standard error takes neighbouring samples for independent. Where what the model leaves is correlated in time they
/// say the same again, and the error that reckons with that is reported where it is the larger one.
void reckonWithColour(FitEstimate& estimate) {
    if (!(estimate.robustError > estimate.standardError)) return;
    estimate.whiteError = estimate.standardError;
    estimate.standardError = estimate.robustError;
}

bool isColoured(const ExperimentState& state) {
    return std::any_of(state.outputs.begin(), state.outputs.end(),
                       [](const OutputState& o) { return isColoured(summarise(o.simulated - o.measured)); });
}

/// Start values that a recording leaves open and no fit has found: of one that only validates, or of a model that is
/// only simulated. Each is estimated from its own recording, the model held as it stands.
class OpenStarts {
public:
    OpenStarts(const FitProblem& problem, Role role, const FitResult& fit, const SimulationOptions& simulation,
               const Progress& progress) {
        FitOptions options;
        options.simulation = simulation;
        options.simulation.reached = nullptr;
        options.findsRobustErrors = true;
        values_ = problem.startValues();
        for (int e = 0; e < static_cast<int>(problem.experiments.size()); ++e) {
            const auto isFound = [&](const FitEstimate& known) { return known.experiment == e; };
            if (role == Role::Fit && std::any_of(fit.estimates.begin(), fit.estimates.end(), isFound)) continue;
            if (!hasOwnParameters(problem, e)) continue;
            FitResult own = fitOwnParameters(problem, e, values_, options, progress);
            if (!own.optimum.ok) continue;  // the simulation from the value given tells why
            values_(ownParameters(problem, e)) = own.values;
            found_.emplace(e, std::move(own));
        }
    }

    const Eigen::VectorXd& values() const { return values_; }

    void addTo(int experiment, ExperimentState& state) const {
        const auto found = found_.find(experiment);
        if (found == found_.end()) return;
        state.starts = found->second.estimates;
        if (isColoured(state)) std::for_each(state.starts.begin(), state.starts.end(), reckonWithColour);
    }

    void addTo(const FitProblem& problem, Eigen::MatrixXd& covariance) const {
        for (const auto& [experiment, own] : found_) {
            const std::vector<Eigen::Index> indices = ownParameters(problem, experiment);
            if (own.covariance.allFinite()) covariance(indices, indices) = own.covariance;
        }
    }

private:
    Eigen::VectorXd values_;
    std::map<int, FitResult> found_;
};

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

/// What an error in percent is a part of where a channel has no range.
std::vector<Text> standstillRemarks(const ModelState& state) {
    std::vector<Text> remarks;
    for (const ExperimentState& e : state.experiments)
        for (const OutputState& o : e.outputs) {
            const Range range = rangeOf(o.measured);
            if (range.isEmpty() || range.width() > 0 || !std::isfinite(o.figures.rmse)) continue;
            const std::string unit = behindNumber(o.unit);
            remarks.push_back(
                o.figures.hasScale()
                    ? phrase("experiment '{}': {} stands still at {:.5g}{}: its error is told in percent of that",
                             e.name, o.name, range.high, unit)
                    : phrase("experiment '{}': {} is 0 throughout: it has no error in percent, the root mean square "
                             "deviation is {:.3g}{}",
                             e.name, o.name, o.figures.rmse, unit));
        }
    return remarks;
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

bool switches(const FitExperiment& experiment) { return experiment.system->rootCount() > 0; }

bool anySwitches(const FitProblem& problem) {
    return std::any_of(problem.experiments.begin(), problem.experiments.end(), switches);
}

/// By the engine that locates events and controls its error.
Linearisation integrateClosely(const FitProblem& problem, const Eigen::VectorXd& values, SimulationOptions options,
                               const Progress& progress) {
    options.engine = Engine::Adaptive;
    return linearise(problem, values, false, {}, options, progress);
}

/// What no fit has to agree with is integrated closely where fixed steps may not do: relations that switch, stiff
/// models. Nothing: they do.
std::optional<Linearisation> integrateCloselyWhereNeeded(const FitProblem& problem, const Eigen::VectorXd& values,
                                                         const SimulationOptions& options, const Progress& progress,
                                                         Linearisation& fixed) {
    if (options.engine != Engine::Auto || progress.stopRequested()) return std::nullopt;
    const auto mayNotDo = [&](std::size_t e) {
        const Trajectory& t = fixed.trajectories[e];
        return t.failure.failed || t.plan.method == GridMethod::Esdirk || switches(problem.experiments[e]);
    };
    bool isNeeded = false;
    for (std::size_t e = 0; e < fixed.trajectories.size(); ++e) isNeeded = isNeeded || mayNotDo(e);
    if (!isNeeded) return std::nullopt;
    Linearisation close = integrateClosely(problem, values, options, progress);
    for (std::size_t e = 0; e < close.trajectories.size(); ++e) {
        if (close.trajectories[e].failure.failed) continue;
        if (e >= fixed.trajectories.size())
            fixed.trajectories.push_back(close.trajectories[e]);
        else if (mayNotDo(e))
            fixed.trajectories[e] = close.trajectories[e];
    }
    return close;
}

/// The same beside a fit, whose figures do not depend on it: bounded in work.
Linearisation integrateCloselyBeside(const FitProblem& problem, const Eigen::VectorXd& values,
                                     SimulationOptions options, const Progress& progress) {
    options.stepLimit = std::min(options.stepLimit, 200'000L);
    options.wallClockLimit = std::numeric_limits<double>::infinity();
    return integrateClosely(problem, values, options, progress);
}

/// Fixed steps pass over what switches; the engine that locates events tells where a relation holds the model, or
/// switches without end.
std::vector<Text> switchingRemarks(const FitProblem& problem, const Linearisation& close) {
    std::vector<Text> remarks;
    for (std::size_t e = 0; e < close.trajectories.size(); ++e) {
        const std::string& name = problem.experiments[e].name;
        for (const Text& remark : close.trajectories[e].remarks)
            remarks.push_back(phrase("experiment '{}': {}", name, remark));
        const SimulationFailure& failure = close.trajectories[e].failure;
        if (failure.failed && (failure.reason.starts_with("events") || failure.reason.ends_with("events")))
            remarks.push_back(
                phrase("experiment '{}': a relation of {} switches without end at t = {:.6g} s; "
                       "what follows there is only as good as the steps of the fit",
                       name, failure.variable, failure.time));
    }
    return remarks;
}

}  // namespace

bool isColoured(const ResidualSummary& residual) { return residual.whiteProbability < colourSignificance; }

namespace {

/// Of all recordings, those of a role are one stretch of what is to be simulated.
SimulationOptions ofRole(SimulationOptions options, const std::vector<Recording>& recordings, Role role) {
    if (!options.reached) return options;
    const auto isFit = [](const Recording& r) { return r.role == Role::Fit; };
    const double share = static_cast<double>(std::count_if(recordings.begin(), recordings.end(), isFit)) /
                         static_cast<double>(std::max<std::size_t>(1, recordings.size()));
    options.reached = [all = options.reached, share, role](double part) {
        all(role == Role::Fit ? share * part : share + (1 - share) * part);
    };
    return options;
}

}  // namespace

Outcome<ModelState> valuesAlone(const Variant& variant, const FitResult& fit) {
    ModelState state;
    state.parameters = fit.estimates;
    state.status = fit.status;
    state.message = fit.message;
    state.remarks = fit.remarks;
    state.simulations = fit.simulations;
    state.seconds = fit.seconds;
    Outcome<std::string> text = textWithValues(variant);
    if (!text) return text.diagnostics();
    state.modelText = std::move(*text);
    return state;
}

Outcome<ModelState> stateOf(const Variant& variant, const FitResult& fit, const SimulationOptions& simulation,
                            const Progress& progress, Detail detail, int threads) {
    Outcome<ModelState> begun = valuesAlone(variant, fit);
    if (!begun) return begun;
    ModelState& state = *begun;
    const Variant told = withClocksTold(variant);
    std::map<int, ExperimentState> byRecording;
    for (const Role role : {Role::Fit, Role::Validate}) {
        const auto hasRole = [role](const Recording& r) { return r.role == role; };
        if (std::none_of(told.task.recordings.begin(), told.task.recordings.end(), hasRole)) continue;
        Outcome<PreparedTask> prepared = prepareAt(told, {}, role);
        if (!prepared) return prepared.diagnostics();
        FitProblem& problem = prepared->problem;
        if (problem.experiments.empty()) continue;
        const OpenStarts open(problem, role, fit, simulation, progress);
        const Eigen::VectorXd& values = open.values();
        const SimulationOptions watched = ofRole(simulation, variant.task.recordings, role);
        Linearisation l = linearise(problem, values, false, {}, watched, progress, nullptr, threads);
        std::optional<Linearisation> close;
        if (fit.simulations == 0) close = integrateCloselyWhereNeeded(problem, values, watched, progress, l);
        const bool hasBands = detail == Detail::Report && fit.covariance.size() > 0;
        Eigen::MatrixXd covariance = hasBands ? covarianceIn(problem, role, fit) : Eigen::MatrixXd();
        if (hasBands) open.addTo(problem, covariance);
        std::vector<ExperimentState> found(std::min(problem.experiments.size(), l.trajectories.size()));
        parallelFor(static_cast<int>(found.size()), std::max(1, threads), [&](int index) {
            const auto e = static_cast<std::size_t>(index);
            ExperimentState& experiment = found[e];
            experiment = experimentState(problem.experiments[e], role, l.trajectories[e]);
            experiment.failure.cause = causeOf(problem, index, values, experiment.failure, simulation, progress);
            open.addTo(index, experiment);
            if (hasBands) addDeviations(problem, index, values, covariance, simulation, progress, experiment);
        });
        for (std::size_t e = 0; e < found.size(); ++e)
            byRecording.emplace(prepared->fitRecordings[e], std::move(found[e]));
        if (detail != Detail::Report || !anySwitches(problem) || isStopped()) continue;
        if (!close) close = integrateCloselyBeside(problem, values, simulation, progress);
        for (Text& remark : switchingRemarks(problem, *close)) state.remarks.push_back(std::move(remark));
    }
    for (auto& [index, experiment] : byRecording) state.experiments.push_back(std::move(experiment));
    summariseResiduals(state);
    for (Text& remark : standstillRemarks(state)) state.remarks.push_back(std::move(remark));
    if (std::any_of(state.residual.begin(), state.residual.end(), [](const auto& r) { return isColoured(r.second); }))
        std::for_each(state.parameters.begin(), state.parameters.end(), reckonWithColour);
    return begun;
}

Outcome<FlatModel> flattened(const EstimationTask& task, const std::string& textWithValues) {
    Outcome<Library> library = task.library.withSource(std::make_shared<Source>(task.model->name(), textWithValues));
    if (!library) return library.diagnostics();
    return flatten(*library, task.className);
}

void addOtherParameters(const FlatModel& model, const PlacedEffect& placed, std::vector<EffectValue>& values) {
    const std::string prefix = placed.instance + ".";
    for (std::size_t v = 0; v < model.variables.size(); ++v) {
        const FlatVariable& variable = model.variables[v];
        if (variable.isProtected || variable.variability != FlatVariability::Parameter ||
            variable.type != FlatType::Real || variable.name.rfind(prefix, 0) != 0)
            continue;
        const std::string name = variable.name.substr(prefix.size());
        if (!placed.effect.parameters.units.contains(name) ||
            std::any_of(values.begin(), values.end(), [&](const EffectValue& known) { return known.name == name; }))
            continue;
        // the parts of an effect are off at 0 (a heat capacity that is small, what follows from it)
        if (const std::optional<double> value = model.parameterValue({static_cast<std::uint32_t>(v)});
            value && *value != 0)
            values.push_back({name, *value, std::nan(""),
                              variable.unit.empty() ? placed.effect.parameters.units.at(name) : variable.unit});
    }
}

double errorPercentOf(const std::vector<OutputState>& outputs) {
    return meanError(
        outputs, [](const OutputState& o) { return o.figures.errorPercent; },
        [](const OutputState& o) { return o.figures.hasScale(); });
}

double errorPercentOf(const ModelState& state, Role role) {
    std::vector<const ExperimentState*> experiments;
    for (const ExperimentState& e : state.experiments)
        if (e.role == role) experiments.push_back(&e);
    const auto hasScale = [](const ExperimentState* e) {
        return std::any_of(e->outputs.begin(), e->outputs.end(),
                           [](const OutputState& o) { return o.figures.hasScale(); });
    };
    return meanError(
        experiments, [](const ExperimentState* e) { return e->errorPercent; }, hasScale);
}

ErrorsWith errorsOf(const ModelState& state) { return {errorPercentOf(state, Role::Fit), validationErrorOf(state)}; }

double validationErrorOf(const ModelState& state) {
    const bool isAny = std::any_of(state.experiments.begin(), state.experiments.end(),
                                   [](const ExperimentState& e) { return e.role == Role::Validate; });
    return isAny ? errorPercentOf(state, Role::Validate) : -1;
}

}  // namespace analogon
