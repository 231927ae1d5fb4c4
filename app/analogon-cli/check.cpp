#include "app/analogon-cli/check.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <ostream>
#include <set>

#include "core/archive/archive.hpp"
#include "core/base/outcome.hpp"
#include "core/eval/system.hpp"
#include "core/flat/flat_model.hpp"
#include "core/library/library.hpp"
#include "core/structure/structure.hpp"
#include "core/study/study.hpp"
#include "core/syntax/parser.hpp"

namespace analogon::cli {

namespace {

namespace fs = std::filesystem;

/// A class to check, in the library that knows all it needs.
struct Subject {
    Library library;
    std::string className;
    std::vector<std::string> keep;  // parameters that a study fits
    std::string description;        // for the first line
};

Outcome<Library> libraryOf(const Options& options) {
    Outcome<Library> library = builtInLibrary();
    for (const fs::path& path : options.libraries)
        if (library) library = library->withPath(path);
    return library;
}

/// Name of the model a file is about: the one asked for, or its last class that can be simulated.
Outcome<std::string> classOf(const syntax::StoredDefinition& file, const Options& options, const std::string& name) {
    const std::string prefix = file.within && !file.within->parts.empty() ? file.within->text() + "." : "";
    if (!options.className.empty()) return options.className;
    for (auto it = file.classes.rbegin(); it != file.classes.rend(); ++it) {
        using Restriction = syntax::ClassDefinition::Restriction;
        const auto restriction = (*it)->restriction;
        const bool isModel =
            restriction == Restriction::Model || restriction == Restriction::Block || restriction == Restriction::Class;
        if (isModel && !(*it)->isPartial) return prefix + (*it)->name;
    }
    return fileError("the file holds no model or block that can be checked", name, 0, 0,
                     "name one with --class PACKAGE.MODEL");
}

Outcome<Subject> modelSubject(const Options& options) {
    const std::string name = options.input.string();
    std::ifstream stream(options.input, std::ios::binary);
    if (!stream) return fileError("cannot read the file", name);
    std::string text((std::istreambuf_iterator<char>(stream)), {});
    const auto source = std::make_shared<const Source>(name, std::move(text));
    const syntax::ParseResult parsed = syntax::parse(source);
    if (hasError(parsed.diagnostics)) return parsed.diagnostics;
    Outcome<Library> library = libraryOf(options);
    if (library) library = library->withSource(source);
    if (!library) return library.diagnostics();
    Outcome<std::string> className = classOf(parsed.definition, options, name);
    if (!className) return className.diagnostics();
    return Subject{std::move(*library), *className, {}, "model " + *className};
}

Outcome<Subject> studySubject(const Options& options) {
    Outcome<OpenedStudy> opened = openStudy(options.input);
    if (!opened) return opened.diagnostics();
    Study* const study = &opened->study;
    for (const fs::path& p : options.libraries) study->libraryPaths.push_back(fs::absolute(p).string());
    Outcome<Library> library = studyLibrary(*study);
    if (!library) return namedAs(library.diagnostics(), *opened);
    const Outcome<EstimationTask> task = estimationTask(*study);
    if (!task) return namedAs(task.diagnostics(), *opened);
    Subject subject{std::move(*library), study->className, {}, {}};
    for (const FitParameter& p : task->parameters) subject.keep.push_back(p.name);
    for (const Recording& r : task->recordings)
        for (const RecordingStart& s : r.starts) subject.keep.push_back(s.parameter);
    subject.description = fmt::format("study {}: model {}, {} experiments, {} fitted parameters", study->name,
                                      study->className, task->recordings.size(), task->parameters.size());
    return subject;
}

std::string signalText(const std::vector<SignalInfo>& signals) {
    std::string text;
    for (const SignalInfo& s : signals) {
        text += (text.empty() ? "" : ", ") + s.name;
        if (!s.unit.empty()) text += " [" + s.unit + "]";
    }
    return text.empty() ? "none" : text;
}

void printSummary(const Subject& subject, const FlatModel& flat, const Structure& structure, const System& system,
                  std::ostream& out) {
    int unknowns = 0;
    for (const FlatVariable& v : flat.variables)
        if (v.variability == FlatVariability::Continuous && v.causality != FlatCausality::Input) ++unknowns;
    std::size_t implicit = 0;
    for (const SolutionBlock& block : structure.blocks) implicit += block.isExplicit ? 0 : 1;
    out << subject.description << '\n'
        << fmt::format("  equations   {}\n", flat.equations.size()) << fmt::format("  unknowns    {}\n", unknowns)
        << fmt::format("  balance     {}\n",
                       static_cast<long>(flat.equations.size()) == unknowns
                           ? std::string("as many equations as unknowns")
                           : fmt::format("{} equations for {} unknowns", flat.equations.size(), unknowns))
        << fmt::format("  solved      {} blocks, {} of them simultaneous\n", structure.blocks.size(), implicit)
        << fmt::format("  index       {}\n",
                       structure.indexReduction > 0
                           ? fmt::format("reduced: {} equations differentiated", structure.indexReduction)
                           : std::string("nothing to reduce"))
        << fmt::format("  states      {}  {}\n", system.stateCount(), signalText(system.states()))
        << fmt::format("  inputs      {}  {}\n", system.inputCount(), signalText(system.inputs()))
        << fmt::format("  outputs     {}  {}\n", system.outputCount(), signalText(system.outputs()));
    if (system.rootCount() > 0) out << fmt::format("  events      {}\n", system.rootCount());
}

}  // namespace

int check(const Options& options, std::ostream& out, std::ostream& err) {
    const auto fails = [&err](const Diagnostics& faults) {
        err << format(faults) << '\n';
        return static_cast<int>(inputAtFault);
    };
    const Outcome<Subject> subject = options.input.extension() == ".mo" ? modelSubject(options) : studySubject(options);
    if (!subject) return fails(subject.diagnostics());
    Outcome<FlatModel> flat = flatten(subject->library, subject->className);
    if (!flat) return fails(flat.diagnostics());
    if (!flat.diagnostics().empty()) err << format(flat.diagnostics()) << '\n';
    if (options.print == PrintKind::Flat) {
        out << print(*flat);
        return done;
    }
    const auto model = std::make_shared<const FlatModel>(std::move(*flat));
    const Outcome<Structure> structure = analyse(model, {subject->keep});
    if (!structure) return fails(structure.diagnostics());
    if (options.print == PrintKind::Structure) {
        out << print(*structure);
        return done;
    }
    const auto system = System::build(*structure);
    if (!system) return fails(system.diagnostics());
    if (options.print == PrintKind::Program) {
        out << (*system)->print();
        return done;
    }
    if (!structure->warnings.empty()) err << format(structure->warnings) << '\n';
    printSummary(*subject, *model, *structure, **system, out);
    return done;
}

}  // namespace analogon::cli
