#include "core/study/class_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "core/structure/hybrid.hpp"
#include "core/structure/structure.hpp"

namespace analogon {

namespace {

std::optional<double> numberOf(const syntax::Modification& modification) {
    if (!modification.value) return std::nullopt;
    const syntax::Expression* e = &*modification.value;
    double sign = 1;
    if (e->kind == syntax::Expression::Kind::Unary && e->text == "-") {
        sign = -1;
        e = &e->operands[0];
    }
    return e->kind == syntax::Expression::Kind::Number ? std::optional(sign * e->number) : std::nullopt;
}

void readExperiment(const Library& library, const LibraryClass& cls, EventRunOptions& run, int depth) {
    const auto& annotation = cls.definition->annotation;
    const syntax::Modification* const experiment = annotation ? annotation->find("experiment") : nullptr;
    if (!experiment) {
        if (depth < 20)
            for (const LibraryClass* base : library.bases(cls)) readExperiment(library, *base, run, depth + 1);
        return;
    }
    for (const syntax::Modification& m : experiment->arguments) {
        const std::optional<double> value = numberOf(m);
        if (!value) continue;
        const std::string name = m.name.text();
        if (name == "StartTime") run.start = *value;
        if (name == "StopTime") run.stop = *value;
        if (name == "Interval") run.interval = *value;
        if (name == "Tolerance" && *value > 0) run.tolerance = std::min(*value, 1e-5);
    }
}

}  // namespace

EventRunOptions experimentOf(const Library& library, const LibraryClass& cls) {
    EventRunOptions run;
    readExperiment(library, cls, run, 0);
    return run;
}

std::vector<std::string> tracedNames(const FlatModel& model, const System& system) {
    std::vector<std::string> names;
    std::set<std::string> taken;
    const auto take = [&](const std::string& name) {
        if (taken.insert(name).second) names.push_back(name);
    };
    for (const FlatVariable& v : model.variables)
        if (v.variability == FlatVariability::Continuous && v.type != FlatType::String &&
            v.name.find('$') == std::string::npos && !v.name.ends_with("()"))
            take(v.name);
    for (const SignalInfo& state : system.states()) take(fmt::format("der({})", state.name));
    return names;
}

Outcome<ClassRun> runAlone(const FlatModel& model, const std::function<std::vector<std::string>(const System&)>& wanted,
                           const EventRunOptions& options, const Progress& progress) {
    if (!(options.stop > options.start))
        return error(phrase("the simulation would end at {}, before it begins at {}", options.stop, options.start));
    const Outcome<HybridModel> hybrid = partition(model);
    if (!hybrid) return hybrid.diagnostics();
    StructureOptions keep;
    keep.keep = hybrid->slots;
    const Outcome<Structure> structure = analyse(hybrid->continuous, keep);
    if (!structure) return structure.diagnostics();
    const Outcome<SystemPtr> system = System::build(*structure);
    if (!system) return system.diagnostics();
    ClassRun run;
    run.names = wanted(**system);
    run.states = (*system)->stateCount();
    Outcome<EventTrajectory> trajectory = simulateWithEvents(*hybrid, **system, run.names, options, progress);
    if (!trajectory) return trajectory.diagnostics();
    run.trajectory = std::move(*trajectory);
    return run;
}

}  // namespace analogon
