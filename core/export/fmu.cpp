#include "core/export/fmu.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <cctype>
#include <cmath>
#include <fstream>
#include <thread>

#include "core/archive/archive.hpp"
#include "core/base/file_fault.hpp"
#include "core/base/file_handle.hpp"
#include "core/base/unit.hpp"
#include "core/export/fmi2_text.hpp"
#include "core/export/fmu_model.hpp"
#include "core/export/fmu_text.hpp"
#include "core/flat/free_ordinates.hpp"
#include "core/flat/parameter_change.hpp"
#include "core/study/present_values.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;
using Kind = FmuVariable::Kind;

std::string identifierOf(const std::string& name) {
    std::string result;
    for (const char c : name) result += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return result.empty() || std::isdigit(static_cast<unsigned char>(result.front())) ? "m" + result : result;
}

/// The parameters that keep their names: those of the study and its experiment, and every other one with a value of its
/// own that is not 0 (a 0 is folded, as in a simulation) and has not shaped the equations.
std::vector<std::string> tunable(const FlatModel& model, const Study& study, const std::vector<std::string>& started) {
    std::vector<std::string> names;
    for (std::uint32_t i = 0; i < model.variables.size(); ++i) {
        const FlatVariable& v = model.variables[i];
        if (v.variability != FlatVariability::Parameter || v.type != FlatType::Real) continue;
        const auto given = study.parameters.find(v.name);
        const bool isFitted = (given != study.parameters.end() && given->second.fit) ||
                              std::find(started.begin(), started.end(), v.name) != started.end();
        const bool hasOwn =
            v.binding.valid() && model.pool->isConstant(v.binding) && !v.isFinal && !v.isStructural && !v.isProtected;
        if (isFitted || (hasOwn && model.parameterValue({i}).value_or(0) != 0)) names.push_back(v.name);
    }
    return names;
}

/// Lists the variables with their value references, and which are which.
class Variables {
public:
    Variables(FmuModel& out, const FlatModel& flat, const Recording* experiment)
        : out_(out), flat_(flat), experiment_(experiment) {}

    void list() {
        const System& system = *out_.system;
        parameters();
        for (const SignalInfo& info : system.inputs()) {
            out_.inputs.push_back(add(Kind::Input, info));
            out_.variables.back().start = 0;
        }
        for (const SignalInfo& info : system.outputs()) out_.outputs.push_back(add(Kind::Output, info));
        for (const SignalInfo& info : system.states()) state(info);
        for (std::size_t i = 0; i < system.states().size(); ++i) derivative(system.states()[i], out_.states[i]);
    }

private:
    std::size_t add(Kind kind, const SignalInfo& info) {
        FmuVariable v;
        v.kind = kind;
        v.name = info.name;
        v.unit = info.unit;
        v.valueReference = next_++;
        if (const VariableId id = flat_.find(info.name); id.valid()) {
            v.unit = flat_.unitOf(flat_[id]);
            v.description = flat_[id].description;
        }
        out_.variables.push_back(std::move(v));
        return out_.variables.size() - 1;
    }

    /// Those that act on something; fixed are those that act on the start alone, and times of delays: what was
    /// before is known only as far back as it was asked for.
    void parameters() {
        const std::size_t count = out_.system->parameters().size();
        std::vector<char> acts(count, 0), actsLater(count, 0), isDelay(count, 0);
        const auto mark = [](const std::vector<DependsOn>& results, std::vector<char>& who) {
            for (const DependsOn& result : results)
                for (const int p : result.parameters) who[static_cast<std::size_t>(p)] = 1;
        };
        mark(out_.code.derivatives, actsLater);
        mark(out_.code.outputs, actsLater);
        mark(out_.code.initialStates, acts);
        mark(out_.code.delayTimes, isDelay);
        for (std::size_t i = 0; i < count; ++i) {
            const SignalInfo& info = out_.system->parameters()[i];
            if (!acts[i] && !actsLater[i] && !isDelay[i]) {
                ++next_;
                continue;
            }
            FmuVariable& v = out_.variables[add(Kind::Parameter, info)];
            v.start = valueOf(info);
            v.isFixed = !actsLater[i] || isDelay[i];
            if (info.min && *info.min <= *v.start) v.min = info.min;
            if (info.max && *info.max >= *v.start) v.max = info.max;
        }
    }

    /// An output that is a state is listed once.
    void state(const SignalInfo& info) {
        const auto isSame = [&](std::size_t output) { return out_.variables[output].name == info.name; };
        const auto same = std::find_if(out_.outputs.begin(), out_.outputs.end(), isSame);
        if (same != out_.outputs.end()) {
            out_.states.push_back(*same);
            ++next_;
        } else {
            out_.states.push_back(add(Kind::State, info));
        }
        out_.variables[out_.states.back()].nominal = info.nominal;
    }

    void derivative(const SignalInfo& info, std::size_t stateAt) {
        const FmuVariable& of = out_.variables[stateAt];
        FmuVariable v;
        v.kind = Kind::Derivative;
        v.name = fmt::format("der({})", info.name);
        // Per second; not where the unit's zero is not 0, whose differences have another unit.
        const std::string unit = of.unit.empty() ? "" : of.unit + "/s";
        if (const auto perSecond = dimensionOf(unit); perSecond && !of.unit.starts_with("deg")) v.unit = unit;
        v.valueReference = next_++;
        v.stateOf = stateAt;
        out_.derivatives.push_back(out_.variables.size());
        out_.variables.push_back(std::move(v));
    }

    /// A start value that the experiment has for itself goes before the model's own.
    double valueOf(const SignalInfo& parameter) const {
        if (experiment_)
            for (const RecordingStart& start : experiment_->starts)
                if (start.parameter == parameter.name && std::isfinite(start.value)) return start.value;
        return parameter.value;
    }

    FmuModel& out_;
    const FlatModel& flat_;
    const Recording* experiment_{};
    unsigned next_{};
};

/// The experiment that an importing tool offers, and the inputs as they are at its start.
void addExperiment(const Recording& first, FmuModel& model) {
    const auto samples = first.time.size();
    model.experiment = {first.time.front(), first.time.back(),
                        samples > 1 ? (first.time.back() - first.time.front()) / static_cast<double>(samples - 1) : 1};
    for (std::size_t i = 0; i < first.inputNames.size(); ++i)
        for (const std::size_t input : model.inputs)
            if (model.variables[input].name == first.inputNames[i])
                model.variables[input].start = first.inputs(static_cast<Eigen::Index>(i), 0);
}

/// The first experiment of a study; nothing: it has none.
Outcome<std::optional<Recording>> firstExperiment(const Study& study) {
    if (study.experiments.empty()) return std::optional<Recording>();
    Outcome<EstimationTask> task = estimationTask(study);
    if (!task) return task.diagnostics();
    return std::optional(std::move(task->recordings.front()));
}

Outcome<FmuModel> fmuModel(const Study& given) {
    const Outcome<Study> study = withPresentValues(given);
    if (!study) return study.diagnostics();
    const Outcome<std::optional<Recording>> first = firstExperiment(*study);
    if (!first) return first.diagnostics();
    const Recording* const experiment = *first ? &**first : nullptr;
    const Outcome<Library> library = studyLibrary(*study);
    if (!library) return library.diagnostics();
    std::vector<std::string> started;  // by the experiment, at values of its own
    if (experiment)
        for (const RecordingStart& start : experiment->starts) started.push_back(start.parameter);
    std::vector<std::string> free = started;
    for (const auto& [name, parameter] : study->parameters)
        if (parameter.fit) free.push_back(name);
    Outcome<FlatModel> flattened = flatten(*library, study->className, free);
    if (flattened) flattened = withStarts(std::move(*flattened), started, StartTold::Always);
    if (!flattened) return flattened.diagnostics();
    const auto flat = std::make_shared<const FlatModel>(std::move(*flattened));
    const Outcome<Structure> structure = analyse(flat, {.keep = tunable(*flat, *study, started)});
    if (!structure) return structure.diagnostics();
    const Outcome<SystemPtr> system = System::build(*structure);
    if (!system) return system.diagnostics();

    FmuModel model;
    model.name = study->className;
    model.identifier = identifierOf(study->className);
    model.study = study->name;
    model.system = *system;
    model.code = (*system)->cCode();
    model.hasModelExchange = (*system)->delays().empty() && !(*system)->needsInputDerivative();
    Variables(model, *flat, experiment).list();
    if (experiment) addExperiment(*experiment, model);
    return model;
}

std::string array(const char* type, const char* name, const std::vector<std::string>& values) {
    return fmt::format("static const {} {}[] = {{{}}};\n", type, name,
                       values.empty() ? "0" : fmt::format("{}", fmt::join(values, ", ")));
}

/// What sources/fmu.c needs to know of the model beside its equations.
std::string description(const FmuModel& model, const std::string& guid) {
    const System& system = *model.system;
    std::vector<std::string> parameters, inputs, nominals, delayedInputs, delayedTaps;
    for (const SignalInfo& p : system.parameters()) parameters.push_back(fmt::format("{}", p.value));
    std::vector<std::string> fixed(parameters.size(), "0");
    for (const FmuVariable& v : model.variables) {
        if (v.kind != Kind::Parameter) continue;
        if (v.start) parameters[v.valueReference] = fmt::format("{}", *v.start);
        if (v.isFixed) fixed[v.valueReference] = "1";
    }
    for (const std::size_t input : model.inputs)
        inputs.push_back(fmt::format("{}", model.variables[input].start.value_or(0)));
    for (const SignalInfo& x : system.states()) nominals.push_back(fmt::format("{}", x.nominal));
    for (const DelayInfo& delay : system.delays()) {
        delayedInputs.push_back(std::to_string(delay.input));
        delayedTaps.push_back(std::to_string(delay.tap));
    }
    return fmt::format(
               "/* {0}: names and values; the equations are in equations.h. */\n\n"
               "#define FMI2_FUNCTION_PREFIX {1}_\n#define HAS_MODEL_EXCHANGE {2}\n\n"
               "static const char modelGuid[] = \"{3}\";\nstatic const double defaultTolerance = {4};\n",
               model.identifier, model.identifier, model.hasModelExchange ? 1 : 0, guid, model.tolerance) +
           array("double", "parameterStart", parameters) + array("unsigned char", "isFixed", fixed) +
           array("double", "inputStart", inputs) + array("double", "stateNominal", nominals) +
           array("int", "delayedInput", delayedInputs) + array("int", "delayedTap", delayedTaps);
}

/// Of the content, so that the same model has the same one (UUID version 5, RFC 4122).
std::string guidOf(const FmuModel& model) {
    const std::string content = modelDescription(model, "") + model.code.text + description(model, "");
    return fmt::format("{{{}}}", to_string(boost::uuids::name_generator_sha1(boost::uuids::ns::oid())(content)));
}

Outcome<Done> writeFiles(const Fmu& fmu, const fs::path& directory) {
    for (const auto& [name, content] : fmu.files) {
        std::error_code code;
        fs::create_directories((directory / name).parent_path(), code);
        std::ofstream stream(directory / name, std::ios::binary);
        stream << content;
        stream.close();
        if (!stream) return cannotWrite(directory / name, phrase("the disk may be full"));
    }
    return Done{};
}

/// A compiler without room for its intermediate files fails as it does on a fault of the sources: an FMU that was
/// there would lose its binary. So its room is taken on trial before; 1 MiB holds a small model many times over.
bool hasRoomForCompiler(const Fmu& fmu, const fs::path& directory) {
    std::size_t bytes = 1u << 20;
    for (const auto& [name, content] : fmu.files) bytes += 8 * content.size();
    const fs::path trial = directory / "room";
    const FileHandle file(open(trial.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
    const bool hasRoom = file.isOpen() && posix_fallocate(file.number(), 0, static_cast<off_t>(bytes)) == 0;
    std::error_code code;
    fs::remove(trial, code);
    return hasRoom;
}

Diagnostic sourcesOnly(const Text& why) {
    Diagnostic note;
    note.severity = Severity::Note;
    note.message = phrase("the FMU holds C sources and no binary: {}", why);
    note.hint = phrase("The importing tool must compile it; documentation/index.html says how.");
    return note;
}

constexpr const char* messagesName = "messages";

/// How a program ended that was run.
struct Ended {
    enum class How { Exited, NotRun, TookTooLong, Stopped };
    How how{};
    int status{};
};

/// The environment of this program with another place for temporary files.
std::vector<std::string> environmentWith(const fs::path& temporary) {
    std::vector<std::string> variables{"TMPDIR=" + temporary.string()};
    for (char** each = environ; *each; ++each)
        if (!std::string_view(*each).starts_with("TMPDIR=")) variables.emplace_back(*each);
    return variables;
}

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

/// Runs a program found on PATH within a directory of ours: its messages in a file there, its temporary files, too,
/// since one that is ended leaves them. What has not ended in time, or when it is to stop, is ended with all that it
/// has started.
Ended runProgram(std::vector<std::string> arguments, const fs::path& within, std::chrono::seconds limit,
                 const Progress& progress) {
    using How = Ended::How;
    const fs::path messages = within / messagesName;
    std::vector<std::string> variables = environmentWith(within);
    std::vector<char*> pointers = pointersTo(arguments), environment = pointersTo(variables);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);  // of its own, with what it starts
    pid_t process{};
    const int failed = posix_spawnp(&process, pointers[0], &files, &attributes, pointers.data(), environment.data());
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
    if (failed) return {How::NotRun, 0};
    const auto end = std::chrono::steady_clock::now() + limit;
    for (int status{};;) {
        const pid_t ended = waitpid(process, &status, WNOHANG);
        if (ended == process) return {How::Exited, WIFEXITED(status) ? WEXITSTATUS(status) : 1};
        if (ended < 0 && errno != EINTR) return {How::NotRun, 0};
        const bool isLate = std::chrono::steady_clock::now() > end;
        if (isLate || progress.stopRequested()) {
            kill(-process, SIGKILL);
            while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
            }
            return {isLate ? How::TookTooLong : How::Stopped, 0};
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

/// binaries/linux64; what comes back is why there is none.
std::optional<Diagnostic> addBinary(const Fmu& fmu, const fs::path& directory, const fs::path& within,
                                    std::chrono::seconds limit, const Progress& progress) {
#if defined(__linux__) && defined(__x86_64__)
    const fs::path binaries = directory / "binaries" / "linux64";
    std::error_code code;
    fs::create_directories(binaries, code);
    // Without fused multiply-add, so that results are those of the interpreter.
    const Ended compiler =
        runProgram({"cc", "-std=c99", "-O2", "-shared", "-fPIC", "-fvisibility=hidden", "-ffp-contract=off",
                    "-DFMI2_OVERRIDE_FUNCTION_PREFIX", "-o", (binaries / (fmu.modelIdentifier + ".so")).string(),
                    (directory / "sources" / "fmu.c").string(), "-lm"},
                   within, limit, progress);
    const bool hasExited = compiler.how == Ended::How::Exited;
    if (hasExited && compiler.status == 0) return std::nullopt;
    fs::remove_all(directory / "binaries", code);
    if (compiler.how == Ended::How::NotRun || (hasExited && compiler.status == 127))
        return sourcesOnly(phrase("no C compiler (cc) is on PATH"));
    if (compiler.how == Ended::How::TookTooLong)
        return sourcesOnly(phrase("the C compiler (cc) was still busy after {} s and was ended", limit.count()));
    std::ifstream stream(within / messagesName);
    std::string line;
    std::getline(stream, line);
    return sourcesOnly(line.empty() ? phrase("the C compiler (cc) failed")
                                    : phrase("the C compiler (cc) failed: {}", line));
#else
    (void)fmu;
    (void)directory;
    (void)within;
    (void)limit;
    (void)progress;
    return sourcesOnly(phrase("on this platform none is made"));
#endif
}

}  // namespace

Outcome<Fmu> fmuOf(const Study& study) {
    const Outcome<FmuModel> model = fmuModel(study);
    if (!model) return model.diagnostics();
    const std::string guid = guidOf(*model);
    Fmu fmu;
    fmu.modelIdentifier = model->identifier;
    fmu.hasModelExchange = model->hasModelExchange;
    fmu.files["modelDescription.xml"] = modelDescription(*model, guid);
    fmu.files["documentation/index.html"] = modelDocumentation(*model);
    fmu.files["sources/description.h"] = description(*model, guid);
    fmu.files["sources/equations.h"] = model->code.text;
    fmu.files["sources/fmi2.h"] = fmi2Text;
    fmu.files["sources/fmu.c"] = fmuText;
    return fmu;
}

Outcome<Done> writeFmu(const Fmu& fmu, const fs::path& file, std::chrono::seconds compilerLimit,
                       const Progress& progress) {
    const Outcome<std::shared_ptr<const TemporaryDirectory>> place = TemporaryDirectory::make();
    if (!place) return place.diagnostics();
    const fs::path directory = (*place)->path() / "fmu";
    if (Outcome<Done> written = writeFiles(fmu, directory); !written) return written;
    const fs::path within = (*place)->path() / "compiler";
    std::error_code code;
    if (!fs::create_directory(within, code)) return cannotWrite(within, code);
    if (!hasRoomForCompiler(fmu, within)) return cannotWrite(within, phrase("the disk may be full"));
    const std::optional<Diagnostic> note = addBinary(fmu, directory, within, compilerLimit, progress);
    if (progress.stopRequested()) return fileError(phrase("interrupted"), file.string());
    if (Outcome<Done> zipped = zipDirectory(directory, file, progress); !zipped) return zipped;
    return note ? Outcome<Done>(Done{}, {*note}) : Outcome<Done>(Done{});
}

}  // namespace analogon
