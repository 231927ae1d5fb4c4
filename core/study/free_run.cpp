#include "core/study/free_run.hpp"

#include <chrono>
#include <limits>

#include "core/base/stopwatch.hpp"
#include "core/base/unless_stopped.hpp"
#include "core/study/class_run.hpp"
#include "core/study/present_values.hpp"
#include "core/study/study_with.hpp"

namespace analogon {

namespace {

constexpr std::size_t mostOutputs = 12;  // of a model that has none: more nobody looks at

/// A model that is ready to run by itself, with its values in its text.
struct FreeModel {
    Study study;
    FlatModel flat;
    EventRunOptions run;
};

Diagnostics undrivenInputs(const FlatModel& model) {
    Diagnostics faults;
    for (std::uint32_t i = 0; i < model.variables.size(); ++i)
        if (model.isInput({i}))
            faults.push_back(error(phrase("nothing drives the input '{}' of the model", model[{i}].name),
                                   model[{i}].declared,
                                   phrase("Connect a source of the library to it (a step, a sine, a table), or import "
                                          "a recording and map a column to it.")));
    return faults;
}

Outcome<FreeModel> freeModel(const Study& study, std::optional<double> stop) {
    Outcome<Study> present = withPresentValues(study);
    if (!present) return present.diagnostics();
    const Outcome<Library> library = studyLibrary(*present);
    if (!library) return library.diagnostics();
    const LibraryClass* const cls = library->find(study.className);
    if (!cls) return error(phrase("there is no class '{}' in the models of the study", study.className));
    Outcome<FlatModel> flat = flatten(*library, study.className);
    if (!flat) return flat.diagnostics();
    if (Diagnostics faults = undrivenInputs(*flat); !faults.empty()) return faults;
    FreeModel model{std::move(*present), std::move(*flat), experimentOf(*library, *cls)};
    if (stop) model.run.stop = *stop;
    return {std::move(model), flat.diagnostics()};
}

/// What is shown of a model: what it gives out, else what it keeps, else what there is.
std::vector<std::string> shownNames(const FlatModel& model, const System& system) {
    std::vector<std::string> names;
    for (const FlatVariable& v : model.variables)
        if (v.causality == FlatCausality::Output) names.push_back(v.name);
    if (!names.empty()) return names;
    for (const SignalInfo& state : system.states()) names.push_back(state.name);
    if (names.empty()) names = tracedNames(model, system);
    if (names.size() > mostOutputs) names.resize(mostOutputs);
    return names;
}

ExperimentState asExperiment(const std::string& name, const FlatModel& model, ClassRun run) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    ExperimentState state;
    state.name = name;
    state.role = Role::Validate;
    state.errorPercent = nothing;
    const auto count = static_cast<Eigen::Index>(run.trajectory.time.size());
    for (std::size_t i = 0; i < run.names.size(); ++i) {
        OutputState output;
        output.name = run.names[i];
        if (const VariableId id = model.find(output.name); id.valid())
            output.unit = model.unitOf(model.variables[id.value]);
        output.figures.errorPercent = output.figures.relativeRmsPercent = output.figures.fitPercent = nothing;
        output.measured = Eigen::VectorXd::Constant(count, nothing);
        output.simulated.resize(count);
        for (Eigen::Index k = 0; k < count; ++k)
            output.simulated[k] = run.trajectory.rows[static_cast<std::size_t>(k)][i];
        state.outputs.push_back(std::move(output));
    }
    state.time = std::move(run.trajectory.time);
    return state;
}

}  // namespace

std::string freeRunName(const Study& study) { return freeExperimentName(study, "Simulation"); }

double freeRunStop(const Library& library, const std::string& className) {
    const LibraryClass* const cls = library.find(className);
    return cls ? experimentOf(library, *cls).stop : EventRunOptions{}.stop;
}

Outcome<RunResult> runFreely(const Study& study, std::optional<double> stop, const RunOptions& options,
                             const Progress& progress) {
    return unlessStopped(progress, [&]() -> Outcome<RunResult> {
        const auto begin = std::chrono::steady_clock::now();
        const Outcome<FreeModel> model = freeModel(withLibraries(study, options.libraryPaths), stop);
        if (!model) return model.diagnostics();
        Outcome<ClassRun> run = runAlone(
            model->flat, [&](const System& system) { return shownNames(model->flat, system); }, model->run, progress);
        if (!run) return run.diagnostics();
        Diagnostics said = model.diagnostics();
        said.insert(said.end(), run->trajectory.remarks.begin(), run->trajectory.remarks.end());
        ModelState state;
        state.modelText = model->study.models.at(study.modelFile);
        state.status = FitStatus::Converged;
        state.simulations = 1;
        state.experiments.push_back(asExperiment(freeRunName(study), model->flat, std::move(*run)));
        RunResult result;
        result.finding.baseline = state;
        result.finding.final = std::move(state);
        result.finding.end.seconds = secondsSince(begin);
        result.completed = study;
        return {std::move(result), std::move(said)};
    });
}

RunResult withFreeRun(RunResult recorded, const RunResult& free) {
    for (ModelState* state : {&recorded.finding.baseline, &recorded.finding.final})
        state->experiments.insert(state->experiments.begin(), free.finding.final.experiments.front());
    return recorded;
}

Outcome<VariableValues> freeVariableValues(const Study& study, std::optional<double> stop,
                                           const std::vector<std::string>& names, const Progress& progress) {
    return unlessStopped(progress, [&]() -> Outcome<VariableValues> {
        const Outcome<FreeModel> model = freeModel(study, stop);
        if (!model) return model.diagnostics();
        for (const std::string& name : names)
            if (!model->flat.find(name).valid())
                return error(phrase("the model has no variable {}", name), {},
                             phrase("take it out of the plot, or choose another one"));
        Outcome<ClassRun> run = runAlone(
            model->flat, [&](const System&) { return names; }, model->run, progress);
        if (!run) return run.diagnostics();
        VariableValues result{std::move(run->trajectory.time), std::vector<std::vector<double>>(names.size())};
        for (const std::vector<double>& row : run->trajectory.rows)
            for (std::size_t i = 0; i < names.size(); ++i) result.values[i].push_back(row[i]);
        return result;
    });
}

}  // namespace analogon
