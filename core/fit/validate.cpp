#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/fit/clock.hpp"
#include "core/fit/fit.hpp"

namespace analogon {

namespace {

bool isIncreasing(const std::vector<double>& time) {
    for (std::size_t k = 1; k < time.size(); ++k) {
        if (!(time[k] > time[k - 1])) return false;
    }
    return true;
}

void checkExperiment(const FitExperiment& experiment, Diagnostics& faults) {
    const auto fault = [&](const Text& text, const Text& hint = {}) {
        faults.push_back(error(phrase("experiment '{}': {}", experiment.name, text), {}, hint));
    };
    if (!experiment.system) return fault(phrase("there is no model"));
    const System& system = *experiment.system;
    const auto samples = static_cast<Eigen::Index>(experiment.inputs.time.size());
    if (samples == 0) return fault(phrase("the recording is empty"));
    if (!isIncreasing(experiment.inputs.time)) return fault(phrase("the time stamps do not increase"));
    if (experiment.inputs.values.rows() != system.inputCount() ||
        (system.inputCount() > 0 && experiment.inputs.values.cols() != samples)) {
        return fault(phrase("the model has {} inputs over {} samples, but {} x {} values are given",
                            system.inputCount(), samples, experiment.inputs.values.rows(),
                            experiment.inputs.values.cols()));
    }
    if (!experiment.inputs.values.allFinite()) fault(phrase("an input has values that are no numbers"));
    if (experiment.measured.rows() != system.outputCount() || experiment.measured.cols() != samples) {
        return fault(phrase("the model has {} outputs over {} samples, but {} x {} measured values are given",
                            system.outputCount(), samples, experiment.measured.rows(), experiment.measured.cols()));
    }
    if (experiment.measured.array().isInf().any()) fault(phrase("a measured value is infinite"));
    if (experiment.weights.size() != system.outputCount()) {
        fault(phrase("{} weights are given for {} outputs", experiment.weights.size(), system.outputCount()));
    } else if (!experiment.weights.allFinite() || (experiment.weights.array() < 0.0).any()) {
        fault(phrase("a weight is negative or not a number"));
    }
    if (static_cast<int>(experiment.parameters.size()) != system.parameterCount()) {
        fault(phrase("{} parameter values are given for {} parameters", experiment.parameters.size(),
                     system.parameterCount()));
    }
}

void checkParameter(const FitProblem& problem, const FitParameter& p, Diagnostics& faults) {
    const auto fault = [&](const Text& text, const Text& hint = {}) { faults.push_back(error(text, {}, hint)); };
    if (!std::isfinite(p.start)) fault(phrase("{}: the start value is not a number", p.name));
    if (std::isnan(p.min) || std::isnan(p.max) || !(p.min < p.max)) {
        fault(phrase("{}: the lower bound {:.6g} is not below the upper bound {:.6g}", p.name, p.min, p.max),
              phrase("a parameter that is known need not be fitted"));
    } else if (p.start < p.min || p.start > p.max) {
        fault(
            phrase("{}: the start value {:.6g} is outside its bounds {:.6g} to {:.6g}", p.name, p.start, p.min, p.max));
    }
    if (p.scale == ParameterScale::Logarithmic && p.start <= 0.0) {
        fault(phrase("{}: a logarithmic scale needs a start value above 0, not {:.6g}", p.name, p.start));
    }
    if (p.prior && !(std::isfinite(p.prior->mean) && p.prior->deviation > 0.0 && std::isfinite(p.prior->deviation)))
        fault(phrase("{}: the prior {:.6g} ± {:.6g} is none", p.name, p.prior->mean, p.prior->deviation),
              phrase("a prior has a mean and a standard deviation above 0"));
    if (p.experiment >= static_cast<int>(problem.experiments.size())) {
        fault(phrase("{}: there is no experiment number {}", p.name, p.experiment));
        return;
    }
    bool isKnown = false;
    std::vector<std::string> names;
    for (std::size_t e = 0; e < problem.experiments.size(); ++e) {
        if (p.experiment >= 0 && p.experiment != static_cast<int>(e)) continue;
        const SystemPtr& system = problem.experiments[e].system;
        if (!system) continue;
        isKnown = isKnown || system->parameterIndex(p.name) >= 0;
        for (const ChannelClock& clock : problem.experiments[e].clocks)
            isKnown = isKnown || clockOf(system->outputs()[static_cast<std::size_t>(clock.output)].name) == p.name;
        for (const SignalInfo& info : system->parameters()) names.push_back(info.name);
    }
    if (isKnown) return;
    const std::string like = suggestion(p.name, names);
    fault(phrase("{} is no free parameter of the model", p.name),
          like.empty() ? Text() : phrase("did you mean {}?", like));
}

}  // namespace

Diagnostics validate(const FitProblem& problem) {
    Diagnostics faults;
    if (problem.experiments.empty())
        faults.push_back(error(phrase("there is no experiment to fit"), {}, phrase("give one the role fit")));
    for (const FitExperiment& experiment : problem.experiments) checkExperiment(experiment, faults);
    std::set<std::pair<std::string, int>> seen;
    for (const FitParameter& p : problem.parameters) {
        if (!seen.emplace(p.name, p.experiment).second) {
            faults.push_back(error(phrase("{} is to be fitted twice", p.name)));
        }
        checkParameter(problem, p, faults);
    }
    if (hasError(faults)) return faults;
    const int count = problem.residualCount();
    const auto known = static_cast<int>(
        std::count_if(problem.parameters.begin(), problem.parameters.end(), [](const auto& p) { return p.prior; }));
    if (count == 0) {
        faults.push_back(error(phrase("nothing is measured: no output has values and a weight above 0")));
    } else if (count + known < static_cast<int>(problem.parameters.size())) {
        faults.push_back(
            error(phrase("{} measured values cannot determine {} parameters", count, problem.parameters.size()), {},
                  phrase("fix some parameters or add measurements")));
    }
    return faults;
}

}  // namespace analogon
