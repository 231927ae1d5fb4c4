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
#include "app/analogon-cli/options.hpp"
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

RunOptions runOptions(const Options& options) {
    RunOptions run;
    run.libraryPaths = options.libraries;
    run.discover.threads = options.threads;
    run.discover.kinds = options.kinds;
    run.profiled = options.profiled;
    run.discover.fit.threads = options.threads;
    run.discover.fit.method = fitMethods().at(options.method);
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
        std::cerr << (result.finding.end.interrupted ? "interrupted; the best result so far was written"
                      : leavesTracesOut(result.finding, Traces::Short)
                          ? "interrupted when the work was done; the results were written but for the traces"
                          : "interrupted when the work was done; the results were written")
                  << std::endl;
        return interrupted;
    }
    if (result.finding.end.interrupted)
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
    if (isRun(Command::CampaignTask)) return campaignTask(options, interrupt);
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

}  // namespace

int run(int argc, char** argv) {
    Options options;
    CLI::App app("Physical models of automotive components from test-bench measurements", "analogon-cli");
    app.set_version_flag("--version", "analogon-cli " ANALOGON_VERSION);
    app.require_subcommand(1);
    describe(app, options);
    try {
        app.parse(argumentsOf(argc, argv, app, options));
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
