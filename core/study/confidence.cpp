#include "core/study/confidence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/base/stop.hpp"
#include "core/fit/profile.hpp"
#include "core/residual/noise.hpp"

namespace analogon {
namespace {

constexpr const char* everyOne = "all";

std::vector<std::string> fittedNames(const EstimationTask& task) {
    std::vector<std::string> names;
    for (const FitParameter& p : task.parameters) names.push_back(p.name);
    for (const Recording& r : task.recordings)
        for (const RecordingStart& start : r.starts)
            if (start.isFitted) names.push_back(start.parameter);
    return names;
}

bool isProfiled(const std::string& name, const std::vector<std::string>& profiled) {
    return std::any_of(profiled.begin(), profiled.end(),
                       [&](const std::string& each) { return each == name || each == everyOne; });
}

/// Noise of each output from what the model leaves, in the order of the system's outputs.
std::vector<Eigen::VectorXd> noiseOf(const EstimationTask& task, const System& system, const ModelState& state) {
    std::vector<Eigen::VectorXd> noise(task.recordings.size(), Eigen::VectorXd::Zero(system.outputCount()));
    for (std::size_t r = 0; r < task.recordings.size(); ++r) {
        const auto found = std::find_if(state.experiments.begin(), state.experiments.end(),
                                        [&](const ExperimentState& e) { return e.name == task.recordings[r].name; });
        if (found == state.experiments.end()) continue;
        for (const OutputState& output : found->outputs) {
            const int index = system.outputIndex(output.name);
            if (index >= 0) noise[r][index] = channelNoise(output.simulated - output.measured, output.measured);
        }
    }
    return noise;
}

/// The problem of the last fit, from where it ended.
Outcome<FitProblem> problemAt(const EstimationTask& task, const ModelState& state) {
    Outcome<PreparedTask> prepared = prepare(task);
    if (!prepared) return prepared.diagnostics();
    prepared = prepare(task, noiseOf(task, *prepared->system, state));
    if (!prepared) return prepared.diagnostics();
    for (FitParameter& p : prepared->problem.parameters)
        for (const FitEstimate& e : state.parameters)
            if (e.name == p.name && e.experiment == p.experiment) p.start = std::clamp(e.value, p.min, p.max);
    return std::move(prepared->problem);
}

}  // namespace

Diagnostics checkProfiled(const EstimationTask& task, const std::vector<std::string>& names) {
    const std::vector<std::string> known = fittedNames(task);
    Diagnostics faults;
    for (const std::string& name : names) {
        if (name == everyOne || std::find(known.begin(), known.end(), name) != known.end()) continue;
        const std::string like = suggestion(name, known);
        faults.push_back(
            error(phrase("{} is not fitted: it has no profile", name), {},
                  like.empty() ? phrase("fitted: {}", fmt::join(known, ", ")) : phrase("did you mean {}?", like)));
    }
    return faults;
}

namespace {

void add(const EstimationTask& task, const std::vector<std::string>& profiled, FitOptions options, ModelState& state,
         const Progress& progress) {
    const auto isKnown = [](const FitEstimate& e) { return std::isfinite(e.robustError); };
    if (profiled.empty() && std::any_of(state.parameters.begin(), state.parameters.end(), isKnown)) return;
    const Outcome<FitProblem> problem = problemAt(task, state);
    if (!problem) return;
    options.method = FitMethod::LeastSquares;
    options.starts = 1;
    options.findsRobustErrors = true;
    const FitResult best = fit(*problem, options, progress);
    if (best.status != FitStatus::Converged) return;
    for (std::size_t i = 0; i < best.estimates.size() && !progress.stopRequested(); ++i) {
        const FitEstimate& found = best.estimates[i];
        for (FitEstimate& estimate : state.parameters) {
            if (estimate.name != found.name || estimate.experiment != found.experiment) continue;
            if (!isKnown(estimate)) estimate.robustError = found.robustError;
            if (!isProfiled(found.name, profiled)) continue;
            progress.report(
                {"profile", found.name, static_cast<double>(i) / static_cast<double>(best.estimates.size()), -1.0});
            ConfidenceInterval interval = profile(*problem, best, static_cast<int>(i), options, progress);
            if (!progress.stopRequested()) estimate.interval = std::move(interval);  // half of one would look open
        }
    }
}

}  // namespace

void addConfidence(const EstimationTask& task, const std::vector<std::string>& profiled, const FitOptions& options,
                   ModelState& state, const Progress& progress) {
    try {
        const StopScope scope(progress.stopToken());
        add(task, profiled, options, state, progress);
    } catch (const Stopped&) {  // the estimates have what was found until then
    }
}

}  // namespace analogon
