#include "app/analogon-cli/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <ostream>
#include <set>

#include "core/archive/archive.hpp"
#include "core/base/distinct.hpp"
#include "core/base/outcome.hpp"
#include "core/base/regular_file.hpp"
#include "core/eval/system.hpp"
#include "core/flat/flat_model.hpp"
#include "core/flat/range.hpp"
#include "core/library/library.hpp"
#include "core/structure/hybrid.hpp"
#include "core/structure/structure.hpp"
#include "core/study/study_with.hpp"
#include "core/study/validate.hpp"
#include "core/syntax/parser.hpp"

namespace analogon::cli {

namespace {

namespace fs = std::filesystem;

/// A class to check, in the library that knows all it needs.
struct Subject {
    Library library;
    std::string className;
    std::string description;  // for the first line
};

Outcome<Library> libraryOf(const Options& options) {
    Outcome<Library> library = builtInLibrary();
    for (const fs::path& path : options.libraries)
        if (library) library = library->withPath(path);
    return library;
}

/// Models within packages, by their full names.
void collectModels(const syntax::ClassDefinition& definition, const std::string& name,
                   std::vector<std::string>& found) {
    using Restriction = syntax::ClassDefinition::Restriction;
    if (definition.restriction == Restriction::Package)
        for (const syntax::ClassPtr& c : definition.classes) collectModels(*c, name + "." + c->name, found);
    else if (!definition.isPartial &&
             (definition.restriction == Restriction::Model || definition.restriction == Restriction::Block))
        found.push_back(name);
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
    std::vector<std::string> inside;
    for (const syntax::ClassPtr& c : file.classes) collectModels(*c, prefix + c->name, inside);
    return fileError("the file holds no model or block that can be checked by itself", name, 0, 0,
                     inside.empty() ? "a partial class is checked through one that extends it"
                                    : "name one with --class, for example --class " + inside.front());
}

/// The outermost directory of the package that a file or directory is part of; empty: none.
fs::path packageOf(const fs::path& path) {
    std::error_code problem;
    fs::path root;
    const fs::path whole = fs::absolute(path, problem).lexically_normal();
    for (fs::path at = fs::is_directory(whole, problem) ? whole : whole.parent_path();
         fs::exists(at / "package.mo", problem) && at != at.parent_path(); at = at.parent_path())
        root = at;
    return root;
}

/// Where the classes lie that a file of no package may name.
fs::path neighbourhood(const fs::path& file) {
    std::error_code problem;
    return fs::absolute(file, problem).lexically_normal().parent_path();
}

Outcome<Subject> modelSubject(const Options& options) {
    const std::string name = options.input.string();
    Outcome<std::string> text = readRegularFile(options.input);
    if (!text) return text.diagnostics();
    const auto source = std::make_shared<const Source>(name, std::move(*text));
    const syntax::ParseResult parsed = syntax::parse(source);
    if (hasError(parsed.diagnostics)) return parsed.diagnostics;
    Outcome<Library> library = libraryOf(options);
    // A file of a package sees its neighbours.
    const fs::path package = packageOf(options.input);
    const bool isPackageFile = !package.empty() && options.input.filename() == "package.mo";
    const bool isBuiltIn = library && library->find(package.filename().string()) != nullptr;
    if (library && !package.empty() && !isBuiltIn) library = library->withPath(package);
    if (library && package.empty()) library = library->withDirectories({neighbourhood(options.input)});
    if (library && !isPackageFile) library = library->withSource(source);
    if (!library) return library.diagnostics();
    Outcome<std::string> className = classOf(parsed.definition, options, name);
    if (!className) return className.diagnostics();
    if (!library->find(*className)) {
        std::string held;
        for (const syntax::ClassPtr& c : parsed.definition.classes) held += (held.empty() ? "" : ", ") + c->name;
        const std::string like = suggestion(*className, library->names());
        return fileError(fmt::format("there is no class \"{}\"", *className), name, 0, 0,
                         like.empty() ? "the file holds " + held : fmt::format("did you mean \"{}\"?", like));
    }
    return Subject{std::move(*library), *className, "model " + *className};
}

std::string signalText(const std::vector<SignalInfo>& signals) {
    std::string text;
    for (const SignalInfo& s : signals) {
        text += (text.empty() ? "" : ", ") + s.name;
        if (!s.unit.empty()) text += " [" + s.unit + "]";
    }
    return text.empty() ? "none" : text;
}

/// The algebraic loops: what is solved for, and how many unknowns hang on it.
std::string loopText(const Structure& structure) {
    constexpr std::size_t most = 5;  // lines, and names in a line
    const auto name = [&](ExpressionId node) {
        return structure.pool->print(node, [&](VariableId id) { return (*structure.model)[id].name; });
    };
    std::string text;
    std::size_t count = 0;
    for (const SolutionBlock& block : structure.blocks) {
        if (block.isExplicit || ++count > most) continue;
        std::string unknowns;
        for (std::size_t i = 0; i < block.unknowns.size() && i < most; ++i)
            unknowns += (i == 0 ? "" : ", ") + name(block.unknowns[i]);
        if (block.unknowns.size() > most) unknowns += fmt::format(" and {} more", block.unknowns.size() - most);
        text += fmt::format("  loop        {}, {} unknowns, solved for {}\n", block.isLinear ? "linear" : "nonlinear",
                            block.torn.size(), unknowns);
    }
    if (count > most) text += fmt::format("  loop        and {} more\n", count - most);
    return text;
}

void printSummary(const std::string& description, const FlatModel& flat, const Structure& structure,
                  const System& system, std::ostream& out, const HybridModel* hybrid = nullptr) {
    int unknowns = 0;
    for (const FlatVariable& v : flat.variables)
        if (v.variability == FlatVariability::Continuous && v.causality != FlatCausality::Input) ++unknowns;
    const auto declared = [&](FlatCausality causality) {
        std::vector<SignalInfo> signals;
        for (std::uint32_t i = 0; i < flat.variables.size(); ++i) {
            const FlatVariable& v = flat.variables[i];
            const bool isOwn = causality != FlatCausality::Input || flat.isInput({i});  // not what events bring along
            if (v.causality == causality && isOwn && !(v.isDiscrete && v.isProtected)) {
                signals.emplace_back();
                signals.back().name = v.name;
                signals.back().unit = v.unit;
            }
        }
        return signals;
    };
    const std::vector<SignalInfo> inputs = hybrid ? declared(FlatCausality::Input) : system.inputs();
    const std::vector<SignalInfo> outputs = hybrid ? declared(FlatCausality::Output) : system.outputs();
    std::size_t implicit = 0;
    for (const SolutionBlock& block : structure.blocks) implicit += block.isExplicit ? 0 : 1;
    out << description << '\n'
        << fmt::format("  equations   {}\n", flat.equations.size()) << fmt::format("  unknowns    {}\n", unknowns)
        << fmt::format("  balance     {}\n",
                       static_cast<long>(flat.equations.size()) == unknowns
                           ? std::string("as many equations as unknowns")
                           : fmt::format("{} equations for {} unknowns", flat.equations.size(), unknowns))
        << fmt::format("  solved      {} blocks, {} of them simultaneous\n", structure.blocks.size(), implicit)
        << loopText(structure)
        << fmt::format("  index       {}\n",
                       structure.indexReduction > 0
                           ? fmt::format("reduced: {} equations differentiated", structure.indexReduction)
                           : std::string("nothing to reduce"))
        << fmt::format("  states      {}  {}\n", system.stateCount(), signalText(system.states()))
        << fmt::format("  inputs      {}  {}\n", inputs.size(), signalText(inputs))
        << fmt::format("  outputs     {}  {}\n", outputs.size(), signalText(outputs));
    const auto watched = [](const auto& all) {
        return static_cast<std::size_t>(
            std::count_if(all.begin(), all.end(), [](const auto& one) { return one.isWatched; }));
    };
    if (hybrid)
        out << fmt::format("  events      {}  {} relations, {} sampled, {} assignments\n",
                           watched(hybrid->relations) + hybrid->samples.size() + watched(hybrid->wholes),
                           watched(hybrid->relations), hybrid->samples.size(), hybrid->assignments.size());
    else if (system.rootCount() > 0)
        out << fmt::format("  events      {}\n", system.rootCount());
}

int fails(const Diagnostics& faults, std::ostream& err) {
    err << format(faults) << '\n';
    return inputAtFault;
}

int checkSubject(const Outcome<Subject>& subject, const Options& options, std::ostream& out, std::ostream& err) {
    if (!subject) return fails(subject.diagnostics(), err);
    Outcome<FlatModel> flat = flatten(subject->library, subject->className);
    if (!flat) return fails(flat.diagnostics(), err);
    if (!flat.diagnostics().empty()) err << format(flat.diagnostics()) << '\n';
    if (const Diagnostics faults = outsideRange(*flat); !faults.empty()) return fails(faults, err);
    if (options.print == PrintKind::Flat) {
        out << print(*flat);
        return done;
    }
    const auto model = std::make_shared<const FlatModel>(std::move(*flat));
    std::optional<HybridModel> hybrid;
    if (!model->events.refusals.empty()) {  // it has events of its own: when, pre, sample
        Outcome<HybridModel> parted = partition(*model);
        if (!parted) return fails(parted.diagnostics(), err);
        hybrid = std::move(*parted);
    }
    StructureOptions keep;
    if (hybrid) keep.keep = hybrid->slots;
    const Outcome<Structure> structure = analyse(hybrid ? hybrid->continuous : model, keep);
    if (!structure) return fails(structure.diagnostics(), err);
    if (options.print == PrintKind::Structure) {
        out << print(*structure);
        return done;
    }
    const auto system = System::build(*structure);
    if (!system) return fails(system.diagnostics(), err);
    if (options.print == PrintKind::Program) {
        out << (*system)->print();
        return done;
    }
    if (!structure->warnings.empty()) err << format(structure->warnings) << '\n';
    printSummary(subject->description, *model, *structure, **system, out, hybrid ? &*hybrid : nullptr);
    return done;
}

/// What fit, discover and simulate would say of a study before they begin, and the model as they take it.
int checkStudy(const Options& options, std::ostream& out, std::ostream& err) {
    if (!options.className.empty())
        return fails({fileError("the class of a study stands in its study.json: --class is for model files",
                                options.input.string())},
                     err);
    const Outcome<OpenedStudy> opened = openStudy(options.input);
    if (!opened) return fails(opened.diagnostics(), err);
    const Study study = withLibraries(opened->study, options.libraries);
    const Outcome<ValidStudy> valid = validated(study, Purpose::Check);
    Diagnostics said = opened.diagnostics();
    for (const Diagnostic& d : namedAs(valid.diagnostics(), *opened)) said.push_back(d);
    if (said = distinct(std::move(said)); !said.empty()) err << format(said) << '\n';
    if (!valid) return inputAtFault;
    const CompiledTask& model = valid->model;
    if (options.print == PrintKind::Flat)
        out << print(*model.model);
    else if (options.print == PrintKind::Structure)
        out << print(model.structure);
    else if (options.print == PrintKind::Program)
        out << model.system->print();
    else
        printSummary(fmt::format("study {}: model {}, {} experiments, {} fitted parameters", study.name,
                                 study.className, valid->task.recordings.size(), valid->task.parameters.size()),
                     *model.model, model.structure, *model.system, out);
    return done;
}

/// Every model and block of a package, one after the other.
int checkPackage(const Options& options, const fs::path& root, std::ostream& out, std::ostream& err) {
    Outcome<Library> library = libraryOf(options);
    if (library) library = library->withPath(root);
    if (!library) return checkSubject(library.diagnostics(), options, out, err);
    std::vector<std::string> names;
    const std::string prefix = root.filename().string() + ".";
    for (const LibraryClass* cls : library->classes()) {
        const LibraryClass* around = library->find(cls->scope);
        if (around && around->definition->restriction == syntax::ClassDefinition::Restriction::Package &&
            cls->qualifiedName.starts_with(prefix) &&
            cls->definition->restriction != syntax::ClassDefinition::Restriction::Package)
            collectModels(*cls->definition, cls->qualifiedName, names);
    }
    if (!options.className.empty()) names = {options.className};
    int status = done;
    for (const std::string& name : names)
        if (checkSubject(Subject{*library, name, "model " + name}, options, out, err) != done) status = inputAtFault;
    return status;
}

}  // namespace

int check(const Options& options, std::ostream& out, std::ostream& err) {
    std::error_code problem;
    if (options.input.extension() == ".mo") return checkSubject(modelSubject(options), options, out, err);
    if (fs::exists(options.input / "package.mo", problem) && !fs::exists(options.input / "study.json", problem))
        return checkPackage(options, packageOf(options.input), out, err);
    return checkStudy(options, out, err);
}

}  // namespace analogon::cli
