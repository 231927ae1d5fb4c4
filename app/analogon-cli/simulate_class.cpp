#include "app/analogon-cli/simulate_class.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <ostream>
#include <set>

#include "core/base/file_fault.hpp"
#include "core/base/stop.hpp"
#include "core/eval/system.hpp"
#include "core/flat/flat_model.hpp"
#include "core/library/library.hpp"
#include "core/measure/table.hpp"
#include "core/simulate/event_run.hpp"
#include "core/structure/hybrid.hpp"
#include "core/structure/structure.hpp"
#include "core/study/results.hpp"

namespace analogon::cli {

namespace {

int fails(const Diagnostics& faults, std::ostream& err) {
    err << format(faults) << '\n';
    const bool isNumerical =
        std::any_of(faults.begin(), faults.end(), [](const Diagnostic& d) { return d.isNumerical; });
    return isNumerical ? numericsFailed : inputAtFault;
}

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

/// StartTime, StopTime, Interval and Tolerance of the annotation; those of the nearest base where the class has none.
void readExperiment(const Library& library, const LibraryClass& cls, EventRunOptions& run, int depth = 0) {
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

/// `*` stands for anything, `?` for one character. What stands behind the last `*` is tried ever later: an earlier one
/// needs no second try.
bool matches(std::string_view name, std::string_view pattern) {
    std::size_t n = 0, p = 0, star = std::string_view::npos, from = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            from = n;
        } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
            ++p;
            ++n;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            n = ++from;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

std::vector<std::string> namesOf(const FlatModel& model, const System& system,
                                 const std::vector<std::string>& patterns) {
    std::vector<std::string> names;
    std::set<std::string> taken;
    const auto take = [&](const std::string& name) {
        const bool isWanted = patterns.empty() || std::any_of(patterns.begin(), patterns.end(),
                                                              [&](const std::string& p) { return matches(name, p); });
        if (isWanted && taken.insert(name).second) names.push_back(name);
    };
    for (const FlatVariable& v : model.variables)
        if (v.variability == FlatVariability::Continuous && v.type != FlatType::String &&
            v.name.find('$') == std::string::npos && !v.name.ends_with("()"))
            take(v.name);
    for (const SignalInfo& state : system.states()) take(fmt::format("der({})", state.name));
    return names;
}

std::string csvOf(const EventTrajectory& run, const std::vector<std::string>& names) {
    std::string text = "time";
    for (const std::string& name : names) text += ',' + csvCell(name);
    for (std::size_t k = 0; k < run.time.size(); ++k) {
        if (k % 4096 == 0) stopPoint();
        fmt::format_to(std::back_inserter(text), "\n{}", run.time[k]);
        for (const double value : run.rows[k]) fmt::format_to(std::back_inserter(text), ",{}", value);
    }
    return text + '\n';
}

}  // namespace

int simulateClass(const Options& options, std::ostream& out, std::ostream& err) {
    Outcome<Library> library = builtInLibrary();
    for (const std::filesystem::path& path : options.libraries)
        if (library) library = library->withPath(path);
    if (!library) return fails(library.diagnostics(), err);
    Outcome<FlatModel> flat = flatten(*library, options.className);
    if (!flat) return fails(flat.diagnostics(), err);
    if (!flat.diagnostics().empty()) err << format(flat.diagnostics()) << '\n';
    const LibraryClass& cls = *library->find(options.className);
    EventRunOptions run;
    readExperiment(*library, cls, run);
    if (options.stop) run.stop = *options.stop;
    if (options.interval) run.interval = *options.interval;
    if (options.tolerance) run.tolerance = *options.tolerance;
    Outcome<ResultsPlace> place = ResultsPlace::take(options.out);
    if (!place) return fails(place.diagnostics(), err);
    if (!(run.stop > run.start))
        return fails({fileError(phrase("the simulation would end at {}, before it begins at {}", run.stop, run.start),
                                options.className)},
                     err);
    const Outcome<HybridModel> hybrid = partition(*flat);
    if (!hybrid) return fails(hybrid.diagnostics(), err);
    StructureOptions keep;
    keep.keep = hybrid->slots;
    const Outcome<Structure> structure = analyse(hybrid->continuous, keep);
    if (!structure) return fails(structure.diagnostics(), err);
    const Outcome<SystemPtr> system = System::build(*structure);
    if (!system) return fails(system.diagnostics(), err);
    const std::vector<std::string> names = namesOf(*flat, **system, options.variables);
    const Outcome<EventTrajectory> trajectory =
        simulateWithEvents(*hybrid, **system, names, run, Progress(stopInForce(), {}));
    stopPoint();
    if (!trajectory) return fails(trajectory.diagnostics(), err);
    if (!trajectory->remarks.empty()) err << format(trajectory->remarks) << '\n';
    const Outcome<Done> written = place->writeTraces(csvOf(*trajectory, names));
    if (!written) return fails(written.diagnostics(), err);
    out << fmt::format("{}: {} to {} s, {} states, {} steps, {} events\n", options.className, run.start, run.stop,
                       (*system)->stateCount(), trajectory->steps, trajectory->events);
    return done;
}

}  // namespace analogon::cli
