#include "app/analogon-cli/options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "core/base/visible.hpp"
#include "core/campaign/slurm/slurm_run.hpp"

namespace analogon::cli {

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
        case Command::CampaignTask:
            return "campaign-task";
        case Command::Unpack:
            break;
    }
    return "unpack";
}

const std::map<std::string, FitMethod>& fitMethods() {
    static const std::map<std::string, FitMethod> methods{{"least-squares", FitMethod::LeastSquares},
                                                          {"nelder-mead", FitMethod::NelderMead},
                                                          {"sbplx", FitMethod::Sbplx},
                                                          {"bobyqa", FitMethod::Bobyqa},
                                                          {"crs2", FitMethod::Crs2},
                                                          {"isres", FitMethod::Isres},
                                                          {"esch", FitMethod::Esch}};
    return methods;
}

namespace {

/// CLI11's own ranges name their upper end, which has 309 digits.
CLI::Validator isNumber(bool (*fits)(double number, double least), double least, const char* how) {
    const auto why = [=](const std::string& word) {
        double number = 0;
        if (CLI::detail::lexical_cast(word, number) && fits(number, least)) return std::string();
        return fmt::format("a number {} {} is expected, not \"{}\"", how, least, visibleName(word));
    };
    return CLI::Validator(why, "");
}

CLI::Validator isAbove(double least) {
    return isNumber([](double number, double limit) { return number > limit; }, least, "above");
}

CLI::Validator isAtLeast(double least) {
    return isNumber([](double number, double limit) { return number >= limit; }, least, "of at least");
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
        ->check(isAtLeast(0))
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
        ->check(isAbove(0))
        ->type_name("DT");
    app.add_option("--tolerance", options.tolerance, "With --class: relative tolerance of the integration")
        ->check(isAbove(0))
        ->type_name("TOL");
    addNames(app, "--variables", options.variables,
             "With --class: only variables that fit, for example *.phi,inertia1.w")
        ->type_name("PATTERN,…");
}

void addFit(CLI::App& app, Options& options) {
    app.add_option("--method", options.method,
                   "least-squares, or without slopes: nelder-mead, sbplx, bobyqa; all over the bounds: crs2, isres, "
                   "esch (evolutionary)")
        ->check(CLI::IsMember(fitMethods()).description(""))
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
        ->check(isAbove(0))
        ->type_name("N");
    app.add_flag("--slurm", options.slurm,
                 "Work on the cluster, as the tasks of a Slurm array job; options for sbatch may follow, as one word "
                 "in quotes")
        ->excludes(app.get_option("--jobs"));
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

/// What a task of a Slurm array job calls.
void addCampaignTask(CLI::App& app, Options& options) {
    addCampaignWorker(app, options);
    app.add_option("--task", options.task)->required();
}

void addCheck(CLI::App& app, Options& options) {
    static const std::map<std::string, PrintKind> prints{
        {"flat", PrintKind::Flat}, {"structure", PrintKind::Structure}, {"program", PrintKind::Program}};
    app.add_option("input", options.input, "A model file, or a study")->required()->type_name("MODEL.mo|STUDY");
    app.add_option("--print", options.print, "Print a stage in full: flat, structure or program")
        ->transform(CLI::CheckedTransformer(prints, CLI::ignore_case).description("flat|structure|program"))
        ->option_text("STAGE");
    app.add_option("--class", options.className, "The class to check (default: the last model of the file)")
        ->type_name("NAME");
    addCommon(app, options);
}

void addDiscover(CLI::App& app, Options& options) {
    addRun(app, options);
    addFit(app, options);
    addNames(app, "--kinds", options.kinds, "Only these kinds of effects, separated by commas")->type_name("KIND,…");
    app.add_option("--most-work", options.mostWork,
                   "End with the best so far after so many million steps of its trials: the same on any machine")
        ->check(isAtLeast(0))
        ->type_name("N");
    app.add_option("--patience", options.patience,
                   "Of a long search, how many times as much it may simulate before it says what it has; 0: no limit")
        ->check(isAtLeast(0))
        ->capture_default_str()
        ->type_name("N");
    app.add_option("--trace", options.traceFile, "Receives every decision of the search, one JSON object a line")
        ->type_name("FILE");
}

void addExport(CLI::App& app, Options& options) {
    app.add_option("study", options.input, "The study: a directory, its study.json or an .analogon file")
        ->required()
        ->type_name("STUDY");
    app.add_option("--modelica", options.modelicaFile, "Receives the model with every class it uses")
        ->type_name("FILE");
    app.add_option("--fmu", options.fmuFile,
                   "Receives the model with its fitted values as an FMU (FMI 2.0, Co-Simulation and Model Exchange)")
        ->type_name("FILE");
    app.add_option("--csv", options.csvFile, "Receives measured and simulated traces")->type_name("FILE");
    app.add_option("--mf4", options.mf4File, "Receives measured and simulated traces and residuals as ASAM MDF 4")
        ->type_name("FILE");
    app.add_option("--parameters", options.parameterFile,
                   "Receives the parameters, by the ending of its name: .csv, .json, .ssv (SSP 1.0), .dcm (DCM 2.0) "
                   "or .cdfx (ASAM CDF 2.0)")
        ->type_name("FILE");
    addCommon(app, options);
}

void addChannels(CLI::App& app, Options& options) {
    app.add_option("file", options.input, "ASAM MDF, MATLAB, TDMS, XLSX or a text table")
        ->required()
        ->type_name("FILE");
    app.add_flag("--json", options.asJson, "As JSON");
    app.add_flag("--values", options.withValues, "Read the values: first, last, min, max, mean of each channel");
}

void addGenerate(CLI::App& app, Options& options) {
    addNames(app, "--domains", options.domains, "For example electric-thermal,thermal-fluid")
        ->required()
        ->type_name("DOMAIN,…");
    app.add_option("--data", options.data, "The measurement; of several the last one validates")
        ->required()
        ->type_name("FILE");
    app.add_option("--out", options.out, "The study to write")->required()->type_name("STUDY");
    app.add_option("--class", options.className, "Name of the model (default: Component)")->type_name("NAME");
    addCommon(app, options);
}

/// Takes options for sbatch apart, as a shell would.
void setSbatch(const std::string& line, Options& options) {
    std::optional<std::vector<std::string>> words = splitWords(line);
    if (!words) throw CLI::ValidationError(fmt::format("--slurm: a quote is not closed in {}", visibleName(line)));
    if (const std::string reserved = reservedOption(*words); !reserved.empty())
        throw CLI::ValidationError(
            fmt::format("--slurm: {} is set by the campaign itself; leave it out of the options for sbatch", reserved));
    options.sbatch = std::move(*words);
}

}  // namespace

void describe(CLI::App& app, Options& options) {
    const auto command = [&](Command which, const char* text) {
        CLI::App* sub = app.add_subcommand(name(which), text);
        sub->callback([&options, which] { options.command = which; });
        return sub;
    };
    addCheck(*command(Command::Check, "Parse, flatten, analyse; print unknowns, states, balance"), options);
    CLI::App* simulate = command(Command::Simulate, "The model as it stands against every experiment");
    addRun(*simulate, options);
    addClassRun(*simulate, options);
    CLI::App* fit = command(Command::Fit, "Estimate the parameters");
    addRun(*fit, options);
    addFit(*fit, options);
    addNames(*fit, "--profile", options.profiled,
             "Where the data limit these parameters (or all): 95 % intervals of the likelihood")
        ->type_name("NAME,…");
    addDiscover(*command(Command::Discover, "Fit, find missing effects, add them, refit, report"), options);
    addCampaign(*command(Command::Campaign, "The same fit or discovery for many units"), options);
    addCampaignWorker(*command(Command::CampaignWorker, ""), options);
    addCampaignTask(*command(Command::CampaignTask, ""), options);
    addExport(*command(Command::Export, "The model as an FMU or as stand-alone Modelica, its traces, its parameters"),
              options);
    addChannels(*command(Command::Channels, "What a measurement file holds: groups, channels, units, rasters"),
                options);
    CLI::App* packing = command(Command::Pack, "A study as one .analogon file");
    packing->add_option("study", options.input, "The study: a directory or its study.json")
        ->required()
        ->type_name("STUDY");
    CLI::App* unpacking = command(Command::Unpack, "The files of an .analogon file in a new directory");
    unpacking->add_option("archive", options.input, "The .analogon file")->required()->type_name("FILE");
    for (CLI::App* sub : {packing, unpacking})
        sub->add_option("target,--out", options.out, "What to write (default: named as the study, here)")
            ->type_name("PATH");
    addGenerate(*command(Command::Generate, "Compose a first model from its domains and a measurement"), options);
}

std::vector<std::string> argumentsOf(int argc, char** argv, const CLI::App& app, Options& options) {
    std::vector<std::string> words(argv + 1, argv + argc), kept;
    const std::string mark = "--slurm";
    const bool isCampaign = !words.empty() && words.front() == name(Command::Campaign);
    const CLI::App* const campaign = app.get_subcommand(name(Command::Campaign));
    const auto isOwn = [&](const std::string& word) {
        return campaign->get_option_no_throw(word.substr(0, word.find('='))) != nullptr;
    };
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool hasValue = isCampaign && words[i].starts_with(mark + "=");
        kept.push_back(hasValue ? mark : words[i]);
        if (hasValue) setSbatch(words[i].substr(mark.size() + 1), options);
        if (!isCampaign || words[i] != mark || i + 1 == words.size()) continue;
        if (words[i + 1].starts_with('-') && !isOwn(words[i + 1])) setSbatch(words[++i], options);
    }
    std::reverse(kept.begin(), kept.end());
    return kept;
}

}  // namespace analogon::cli
