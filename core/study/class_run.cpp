#include "core/study/class_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/diagram/annotation.hpp"
#include "core/eval/event_parts.hpp"

namespace analogon {

namespace {

void readExperiment(const Library& library, const LibraryClass& cls, EventRunOptions& run, int depth) {
    const auto& annotation = cls.definition->annotation;
    const syntax::Modification* const experiment = annotation ? annotation->find("experiment") : nullptr;
    if (!experiment) {
        if (depth < 20)
            for (const LibraryClass* base : library.bases(cls)) readExperiment(library, *base, run, depth + 1);
        return;
    }
    const annotation::Record record(*experiment);
    if (const auto start = record.number("StartTime")) run.start = *start;
    if (const auto stop = record.number("StopTime")) run.stop = *stop;
    if (const auto interval = record.number("Interval")) run.interval = *interval;
    if (const auto tolerance = record.number("Tolerance"); tolerance && *tolerance > 0)
        run.tolerance = std::min(*tolerance, 1e-5);
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

namespace {

double intervalFor(const EventRunOptions& options, std::size_t names, std::size_t mostValues) {
    constexpr double fewestRows = 2500;  // what they show between events would be lost with less
    const double span = options.stop - options.start;
    const double asked = options.interval > 0 ? options.interval : span / fewestRows;
    const double most = static_cast<double>(mostValues) / static_cast<double>(std::max<std::size_t>(names, 1));
    return std::max(asked, span / std::max(most, fewestRows));
}

}  // namespace

Outcome<ClassRun> runAlone(const FlatModel& model, const std::function<std::vector<std::string>(const System&)>& wanted,
                           const EventRunOptions& options, const Progress& progress, std::size_t mostValues) {
    if (!(options.stop >= options.start))
        return error(phrase("the simulation would end at {}, before it begins at {}", options.stop, options.start));
    const Outcome<HybridModel> hybrid = partition(model);
    if (!hybrid) return hybrid.diagnostics();
    const Outcome<SystemPtr> system = systemBetween(*hybrid);
    if (!system) return system.diagnostics();
    ClassRun run;
    run.names = wanted(**system);
    run.states = (*system)->stateCount();
    EventRunOptions within = options;
    within.interval = run.interval = intervalFor(options, run.names.size(), mostValues);
    Outcome<EventTrajectory> trajectory = simulateWithEvents(*hybrid, **system, run.names, within, progress);
    if (!trajectory) return trajectory.diagnostics();
    run.trajectory = std::move(*trajectory);
    return run;
}

}  // namespace analogon
