#include "app/analogon-cli/command_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <mutex>
#include <string_view>
#include <utility>

#include "app/analogon-cli/campaign.hpp"
#include "app/analogon-cli/channels.hpp"
#include "app/analogon-cli/check.hpp"
#include "app/analogon-cli/convert.hpp"
#include "app/analogon-cli/generate.hpp"
#include "app/analogon-cli/interrupt.hpp"
#include "app/analogon-cli/progress_view.hpp"
#include "app/analogon-cli/simulate_class.hpp"
#include "app/analogon-cli/visible_stream.hpp"
#include "core/archive/archive.hpp"
#include "core/base/distinct.hpp"
#include "core/base/file_fault.hpp"
#include "core/base/guard.hpp"
#include "core/base/stop.hpp"
#include "core/base/visible.hpp"
#include "core/report/decision_lines.hpp"
#include "core/report/report.hpp"
#include "core/study/results.hpp"
#include "core/study/run.hpp"

namespace analogon::cli {

namespace {

namespace fs = std::filesystem;

int fails(const Diagnostics& faults) {
    std::cerr << format(faults) << std::endl;
    const bool isNumerical =
        std::any_of(faults.begin(), faults.end(), [](const Diagnostic& d) { return d.isNumerical; });
    return isNumerical ? numericsFailed : inputAtFault;
}

const char* name(Command command) {
    switch (command) {
        case Command::Check:
            return "check";
        case Command::Simulate:
            return "simulate";
        case Command::Fit:
            return "fit";
        case Command::Discover:
            return "discover";
        case Command::Export:
            return "export";
        case Command::Generate:
            return "generate";
        case Command::Channels:
            return "channels";
        case Command::Pack:
            return "pack";
        case Command::Campaign:
            return "campaign";
        case Command::CampaignWorker:
            return "campaign-worker";
        case Command::Unpack:
            break;
    }
    return "unpack";
}

const std::map<std::string, FitMethod> methods{{"least-squares", FitMethod::LeastSquares},
                                               {"nelder-mead", FitMethod::NelderMead},
                                               {"sbplx", FitMethod::Sbplx},
                                               {"bobyqa", FitMethod::Bobyqa},
                                               {"crs2", FitMethod::Crs2},
                                               {"isres", FitMethod::Isres},
                                               {"esch", FitMethod::Esch}};

RunOptions runOptions(const Options& options) {
    RunOptions run;
    run.libraryPaths = options.libraries;
    run.discover.threads = options.threads;
    run.discover.kinds = options.kinds;
    run.profiled = options.profiled;
    run.discover.fit.threads = options.threads;
    run.discover.fit.method = methods.at(options.method);
    run.discover.mostWork = 1e6 * options.mostWork;
    run.discover.patience = options.patience;
    if (!options.traceFile.empty()) run.discover.trace = std::make_shared<DecisionTrace>();
    return run;
}

/// Whether a file holds the decisions of a search, told by how its first line begins; an empty one may become one.
bool holdsDecisions(const fs::path& file) {
    constexpr std::string_view begin = "{\"number\":0,";
    std::string first(begin.size(), '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(first.data(), static_cast<std::streamsize>(first.size()));
    return stream.gcount() == 0 || first == begin;
}

/// Makes room, before a long search, for the file that is to receive its decisions. It takes the place of earlier ones
/// alone.
Outcome<Done> prepareTarget(const fs::path& file) {
    std::error_code code;
    if (file.empty()) return Done{};
    if (fs::is_directory(file, code)) return fileError(phrase("this is a directory; name a file"), file.string());
    if (fs::exists(file, code) && (!fs::is_regular_file(file, code) || !holdsDecisions(file)))
        return fileError("this exists and is no trace of an earlier search", file.string(), 0, 0,
                         "name a new file with --trace");
    fs::create_directories(fs::absolute(file).parent_path(), code);
    if (code) return cannotWrite(file, code);
    return Done{};
}

/// The decisions so far, whatever came of the search.
Outcome<Done> writeTrace(const RunOptions& run, const fs::path& file) {
    return run.discover.trace ? writeDecisions(run.discover.trace->decisions(), file) : Done{};
}

/// What a run has found until now, from its thread to the one that tells of it where the run does not come back.
class FoundSoFar {
public:
    void keep(RunResult result) {
        const std::lock_guard lock(mutex_);
        result_ = std::move(result);
    }
    std::optional<RunResult> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(result_, std::nullopt);
    }

private:
    std::mutex mutex_;
    std::optional<RunResult> result_;
};

int endsWithoutResult() {
    std::cerr << "interrupted before there was a result" << std::endl;
    return interrupted;
}

/// The results as files. Once that is interrupted, it begins anew, without what takes long. Returns whether it was.
bool write(const RunResult& result, const Options& options, ResultsPlace& place, std::stop_token stop,
           Outcome<Done>& written) {
    if (!stop.stop_requested()) try {
            const StopScope scope(std::move(stop));
            written = place.write(result, name(options.command));
            return false;
        } catch (const Stopped&) {
        }
    written = place.write(result, name(options.command), Traces::Short);
    return true;
}

/// The table, whatever becomes of the files; and they.
int tell(const RunResult& result, const Options& options, ResultsPlace& place, const std::stop_token& stop) {
    std::cout << visible(summaryText(result.finding)) << std::endl;
    Outcome<Done> written = Done{};
    const bool isInterrupted = write(result, options, place, stop, written);
    if (!written) return fails(written.diagnostics());
    if (!written.diagnostics().empty()) std::cerr << format(written.diagnostics()) << std::endl;
    std::cout << "report: " << visible((options.out / "report.html").string()) << std::endl;
    if (isInterrupted) {
        std::cerr << (result.finding.interrupted ? "interrupted; the best result so far was written"
                      : leavesTracesOut(result.finding, Traces::Short)
                          ? "interrupted when the work was done; the results were written but for the traces"
                          : "interrupted when the work was done; the results were written")
                  << std::endl;
        return interrupted;
    }
    if (result.finding.interrupted)
        std::cerr << "the search ended at its limit of work; the best result so far was written" << std::endl;
    if (options.command != Command::Fit || result.finding.final.status != FitStatus::Failed) return done;
    return fails({numericalError(result.finding.final.message, phrase("give other start values, or narrower bounds"))});
}

/// simulate, fit and discover: the same but for the call in the middle.
int runStudy(const Options& options, Interrupt& interrupt) {
    if (const Outcome<Done> can = prepareTarget(options.traceFile); !can) return fails(can.diagnostics());
    Outcome<OpenedStudy> opened = [&] {
        const StopScope scope(interrupt.token());
        return openStudy(options.input);
    }();
    if (!opened) return fails(opened.diagnostics());
    if (!opened.diagnostics().empty()) std::cerr << format(opened.diagnostics()) << std::endl;
    const Study* const study = &opened->study;
    Outcome<ResultsPlace> place = ResultsPlace::take(options.out, options.input);
    if (!place) return fails(place.diagnostics());

    FoundSoFar found;
    ProgressView view(options.progress, std::cerr, isatty(STDERR_FILENO) != 0);
    const Interrupt::LastWords lastWords(interrupt, [&] {
        view.clear();
        if (const std::optional<RunResult> result = found.take())
            tell(*result, options, *place, interrupt.token());
        else
            endsWithoutResult();
        const ResultsPlace left(std::move(*place));  // goes where nothing was written, when this ends
        opened->files.reset();                       // where an archive was unpacked
    });
    const Progress progress(interrupt.token(), view.sink());
    RunOptions run = runOptions(options);
    run.keep = [&](RunResult result) { found.keep(std::move(result)); };
    const Outcome<RunResult> result = options.command == Command::Simulate ? runSimulate(*study, run, progress)
                                      : options.command == Command::Fit    ? runFit(*study, run, progress)
                                                                           : runDiscover(*study, run, progress);
    interrupt.tell();
    view.clear();
    const Outcome<Done> traced = writeTrace(run, options.traceFile);
    if (!traced) std::cerr << format(traced.diagnostics()) << std::endl;
    if (!result)
        return interrupt.wasRaised() ? endsWithoutResult()
                                     : fails(notYetTold(namedAs(result.diagnostics(), *opened), opened.diagnostics()));
    if (const Diagnostics more = notYetTold(namedAs(result.diagnostics(), *opened), opened.diagnostics());
        !more.empty())
        std::cerr << format(more) << std::endl;
    for (const Text& remark : result->finding.final.remarks) view.note(remark);
    const int status = tell(*result, options, *place, interrupt.token());
    return traced || status != done ? status : static_cast<int>(inputAtFault);
}

int execute(const Options& options, Interrupt& interrupt) {
    const auto isRun = [&](Command c) { return options.command == c; };
    if (isRun(Command::Simulate) && !options.className.empty()) {
        const StopScope scope(interrupt.token());
        VisibleStream out(std::cout);
        return simulateClass(options, out, std::cerr);
    }
    if (isRun(Command::Simulate) || isRun(Command::Fit) || isRun(Command::Discover))
        return runStudy(options, interrupt);
    if (isRun(Command::Campaign)) return campaign(options, interrupt);
    if (isRun(Command::CampaignWorker)) return campaignWorker(options);
    const StopScope scope(interrupt.token());
    VisibleStream out(std::cout);
    switch (options.command) {
        case Command::Check:
            return check(options, out, std::cerr);
        case Command::Generate:
            return generate(options, out, std::cerr);
        case Command::Channels:
            return channels(options, out, std::cerr);
        case Command::Export:
            return exportStudy(options, out, std::cerr);
        case Command::Pack:
            return pack(options, out, std::cerr);
        default:
            return unpack(options, out, std::cerr);
    }
}

/// The names of a list, separated by commas, each as it stands.
std::vector<std::string> namesIn(const std::string& list, const std::string& option) {
    std::vector<std::string> names;
    for (std::size_t at = 0, end = 0; end != std::string::npos; at = end + 1) {
        end = list.find(',', at);
        names.push_back(list.substr(at, end == std::string::npos ? end : end - at));
    }
    for (const std::string& name : names)
        if (name.find_first_not_of(" \t") == std::string::npos)
            throw CLI::ValidationError(fmt::format(
                "{}: a name is missing in \"{}\"; give names separated by single commas", option, visibleName(list)));
    if (list.starts_with("--"))
        throw CLI::ValidationError(
            fmt::format("{}: names are expected, and \"{}\" is another option", option, visibleName(list)));
    return names;
}

/// Names after one option, separated by commas: what follows them is no further one, and the option may be repeated.
CLI::Option* addNames(CLI::App& app, const char* option, std::vector<std::string>& names, const char* text) {
    const auto add = [&names, option](const std::vector<std::string>& lists) {
        for (const std::string& list : lists)
            for (std::string& name : namesIn(list, option)) names.push_back(std::move(name));
    };
    return app.add_option_function<std::vector<std::string>>(option, add, text)->allow_extra_args(false);
}

void addCommon(CLI::App& app, Options& options) {
    app.add_option("--library", options.libraries, "A further library: a package directory or a .mo file")
        ->allow_extra_args(false)
        ->type_name("PATH");
}

void addRun(CLI::App& app, Options& options) {
    static const std::map<std::string, ProgressKind> kinds{
        {"bar", ProgressKind::Bar}, {"json", ProgressKind::Json}, {"none", ProgressKind::None}};
    app.add_option("study", options.input, "The study: a directory, its study.json or an .analogon file")
        ->required()
        ->type_name("STUDY");
    app.add_option("--out", options.out, "Receives report.json, report.html, traces.csv and study/")
        ->required()
        ->type_name("DIR");
    app.add_option("--progress", options.progress,
                   "On standard error: bar, json or none (default: a bar on a terminal)")
        ->transform(CLI::CheckedTransformer(kinds, CLI::ignore_case).description("bar|json|none"))
        ->option_text("KIND");
    app.add_option("--threads", options.threads, "How many threads to use (default: all)")
        ->check(CLI::NonNegativeNumber.description(""))
        ->type_name("N");
    addCommon(app, options);
}

/// A class of a library instead of a study.
void addClassRun(CLI::App& app, Options& options) {
    CLI::Option* const study = app.get_option("study");
    CLI::Option* const cls = app.add_option("--class", options.className,
                                            "Instead of a study: any class, by its annotation \"experiment\"; leaves "
                                            "traces.csv")
                                 ->type_name("NAME");
    study->required(false);
    app.callback([&options, study, cls] {
        options.command = Command::Simulate;
        if (study->empty() && cls->empty()) throw CLI::RequiredError("study");
        if (!study->empty() && !cls->empty()) throw CLI::ValidationError("--class: give a study or a class, not both");
    });
    app.add_option("--stop", options.stop, "With --class: the end of the simulation, in seconds")->type_name("T");
    app.add_option("--interval", options.interval, "With --class: between the rows of traces.csv, in seconds")
        ->check(CLI::PositiveNumber.description(""))
        ->type_name("DT");
    app.add_option("--tolerance", options.tolerance, "With --class: relative tolerance of the integration")
        ->check(CLI::PositiveNumber.description(""))
        ->type_name("TOL");
    addNames(app, "--variables", options.variables,
             "With --class: only variables that fit, for example *.phi,inertia1.w")
        ->type_name("PATTERN,…");
}

void addFit(CLI::App& app, Options& options) {
    app.add_option("--method", options.method,
                   "least-squares, or without slopes: nelder-mead, sbplx, bobyqa; all over the bounds: crs2, isres, "
                   "esch (evolutionary)")
        ->check(CLI::IsMember(methods).description(""))
        ->capture_default_str()
        ->option_text("NAME");
}

void addCampaign(CLI::App& app, Options& options) {
    static const std::map<std::string, ProgressKind> kinds{
        {"bar", ProgressKind::Bar}, {"json", ProgressKind::Json}, {"none", ProgressKind::None}};
    app.add_option("campaign", options.input, "What is done for which units: campaign.json")
        ->required()
        ->type_name("CAMPAIGN.json");
    app.add_option("--out", options.out, "Receives results.csv, campaign.html, campaign.json and units/")
        ->required()
        ->type_name("DIR");
    app.add_option("--jobs", options.jobs, "How many units at once (default: as many as the machine has processors)")
        ->check(CLI::PositiveNumber.description(""))
        ->type_name("N");
    app.add_flag("--retry", options.retry, "Work once more on units that failed before");
    app.add_option("--progress", options.progress,
                   "On standard error: bar, json or none (default: a bar on a terminal)")
        ->transform(CLI::CheckedTransformer(kinds, CLI::ignore_case).description("bar|json|none"))
        ->option_text("KIND");
}

/// What the program calls itself with.
void addCampaignWorker(CLI::App& app, Options& options) {
    app.group("");
    app.add_option("campaign", options.input)->required();
    app.add_option("--out", options.out)->required();
}

/// Every command with its options; the callback of the one that was given sets options.command.
void describe(CLI::App& app, Options& options) {
    const auto command = [&](Command which, const char* text) {
        CLI::App* sub = app.add_subcommand(name(which), text);
        sub->callback([&options, which] { options.command = which; });
        return sub;
    };
    static const std::map<std::string, PrintKind> prints{
        {"flat", PrintKind::Flat}, {"structure", PrintKind::Structure}, {"program", PrintKind::Program}};

    CLI::App* check = command(Command::Check, "Parse, flatten, analyse; print unknowns, states, balance");
    check->add_option("input", options.input, "A model file, or a study")->required()->type_name("MODEL.mo|STUDY");
    check->add_option("--print", options.print, "Print a stage in full: flat, structure or program")
        ->transform(CLI::CheckedTransformer(prints, CLI::ignore_case).description("flat|structure|program"))
        ->option_text("STAGE");
    check->add_option("--class", options.className, "The class to check (default: the last model of the file)")
        ->type_name("NAME");
    addCommon(*check, options);

    CLI::App* simulate = command(Command::Simulate, "The model as it stands against every experiment");
    addRun(*simulate, options);
    addClassRun(*simulate, options);
    CLI::App* fit = command(Command::Fit, "Estimate the parameters");
    addRun(*fit, options);
    addFit(*fit, options);
    addNames(*fit, "--profile", options.profiled,
             "Where the data limit these parameters (or all): 95 % intervals of the likelihood")
        ->type_name("NAME,…");
    CLI::App* discover = command(Command::Discover, "Fit, find missing effects, add them, refit, report");
    addRun(*discover, options);
    addFit(*discover, options);
    addNames(*discover, "--kinds", options.kinds, "Only these kinds of effects, separated by commas")
        ->type_name("KIND,…");
    discover
        ->add_option("--most-work", options.mostWork,
                     "End with the best so far after so many million steps of its trials: the same on any machine")
        ->check(CLI::NonNegativeNumber.description(""))
        ->type_name("N");
    discover
        ->add_option("--patience", options.patience,
                     "Of a long search, how many times as much it may simulate before it says what it has; 0: no limit")
        ->check(CLI::NonNegativeNumber.description(""))
        ->capture_default_str()
        ->type_name("N");
    discover->add_option("--trace", options.traceFile, "Receives every decision of the search, one JSON object a line")
        ->type_name("FILE");

    addCampaign(*command(Command::Campaign, "The same fit or discovery for many units"), options);
    addCampaignWorker(*command(Command::CampaignWorker, ""), options);

    CLI::App* exporting =
        command(Command::Export, "The model as an FMU or as stand-alone Modelica, its traces, its parameters");
    exporting->add_option("study", options.input, "The study: a directory, its study.json or an .analogon file")
        ->required()
        ->type_name("STUDY");
    exporting->add_option("--modelica", options.modelicaFile, "Receives the model with every class it uses")
        ->type_name("FILE");
    exporting
        ->add_option("--fmu", options.fmuFile,
                     "Receives the model with its fitted values as an FMU (FMI 2.0, Co-Simulation and Model Exchange)")
        ->type_name("FILE");
    exporting->add_option("--csv", options.csvFile, "Receives measured and simulated traces")->type_name("FILE");
    exporting
        ->add_option("--mf4", options.mf4File, "Receives measured and simulated traces and residuals as ASAM MDF 4")
        ->type_name("FILE");
    exporting
        ->add_option("--parameters", options.parameterFile,
                     "Receives the parameters, by the ending of its name: .csv, .json, .ssv (SSP 1.0), .dcm (DCM 2.0) "
                     "or .cdfx (ASAM CDF 2.0)")
        ->type_name("FILE");
    addCommon(*exporting, options);

    CLI::App* channels = command(Command::Channels, "What a measurement file holds: groups, channels, units, rasters");
    channels->add_option("file", options.input, "ASAM MDF, MATLAB, TDMS, XLSX or a text table")
        ->required()
        ->type_name("FILE");
    channels->add_flag("--json", options.asJson, "As JSON");
    channels->add_flag("--values", options.withValues, "Read the values: first, last, min, max, mean of each channel");

    CLI::App* packing = command(Command::Pack, "A study as one .analogon file");
    packing->add_option("study", options.input, "The study: a directory or its study.json")
        ->required()
        ->type_name("STUDY");
    CLI::App* unpacking = command(Command::Unpack, "The files of an .analogon file in a new directory");
    unpacking->add_option("archive", options.input, "The .analogon file")->required()->type_name("FILE");
    for (CLI::App* sub : {packing, unpacking})
        sub->add_option("target,--out", options.out, "What to write (default: named as the study, here)")
            ->type_name("PATH");

    CLI::App* generate = command(Command::Generate, "Compose a first model from its domains and a measurement");
    addNames(*generate, "--domains", options.domains, "For example electric-thermal,thermal-fluid")
        ->required()
        ->type_name("DOMAIN,…");
    generate->add_option("--data", options.data, "The measurement; of several the last one validates")
        ->required()
        ->type_name("FILE");
    generate->add_option("--out", options.out, "The study to write")->required()->type_name("STUDY");
    generate->add_option("--class", options.className, "Name of the model (default: Component)")->type_name("NAME");
    addCommon(*generate, options);
}

}  // namespace

int run(int argc, char** argv) {
    Options options;
    CLI::App app("Physical models of automotive components from test-bench measurements", "analogon-cli");
    app.set_version_flag("--version", "analogon-cli " ANALOGON_VERSION);
    app.require_subcommand(1);
    describe(app, options);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& fault) {
        const bool isFault = fault.get_exit_code() != static_cast<int>(CLI::ExitCodes::Success);
        app.exit(fault, std::cout, std::cerr);
        return isFault ? inputAtFault : done;
    }
    Interrupt interrupt;
    int status = done;
    try {
        const std::optional<Diagnostic> thrown = guarded([&] { status = execute(options, interrupt); });
        return thrown ? fails({*thrown}) : status;
    } catch (const Stopped&) {
        return endsWithoutResult();
    }
}

}  // namespace analogon::cli
