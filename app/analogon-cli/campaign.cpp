#include "app/analogon-cli/campaign.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "app/analogon-cli/options.hpp"
#include "app/analogon-cli/progress_view.hpp"
#include "core/base/number_text.hpp"
#include "core/base/stopwatch.hpp"
#include "core/base/visible.hpp"
#include "core/campaign/campaign_run.hpp"
#include "core/campaign/campaign_summary.hpp"
#include "core/campaign/results_table.hpp"
#include "core/campaign/slurm/slurm_run.hpp"
#include "core/campaign/slurm/slurm_task.hpp"

namespace analogon::cli {

namespace {

namespace fs = std::filesystem;

int faulty(const Diagnostics& faults) {
    std::cerr << format(faults) << std::endl;
    return inputAtFault;
}

std::string timeText(double seconds) {
    if (seconds < 0) return "";
    if (seconds < 90) return fmt::format(", {:.0f} s left", seconds);
    if (seconds < 5400) return fmt::format(", {:.0f} min left", seconds / 60);
    return fmt::format(", {:.1f} h left", seconds / 3600);
}

/// Done, running, failed and the time left: a bar, or one JSON object a line.
class CampaignView {
public:
    CampaignView(ProgressKind kind, std::ostream& stream, bool isTerminal)
        : kind_(kind), stream_(stream), bar_(kind, stream, isTerminal), sink_(bar_.sink()) {}

    void show(const CampaignProgress& progress) {
        const CampaignCounts& c = progress.counts;
        const std::size_t ended = c.done + c.failed;
        if (kind_ == ProgressKind::Json) return showJson(progress, ended);
        if (!sink_) return;
        const std::string text = fmt::format("{} done, {} running, {} failed{}", c.done, c.running, c.failed,
                                             timeText(progress.secondsLeft));
        sink_({"units", text, c.units == 0 ? 1 : static_cast<double>(ended) / static_cast<double>(c.units)});
    }
    void clear() { bar_.clear(); }
    /// What is told beside: a line, or a JSON object like the rest.
    void note(const Text& text) {
        if (kind_ == ProgressKind::Json) return bar_.note(text);
        clear();
        stream_ << visible(text.english()) << std::endl;
    }

private:
    void showJson(const CampaignProgress& progress, std::size_t ended) {
        const CampaignCounts& c = progress.counts;
        const bool isLast = ended == c.units;
        if (!isLast && hasShown_ && secondsSince(lastShown_) < 0.1) return;
        hasShown_ = true;
        lastShown_ = std::chrono::steady_clock::now();
        nlohmann::ordered_json json{
            {"stage", "units"},
            {"fraction", c.units ? static_cast<double>(ended) / static_cast<double>(c.units) : 1},
            {"units", c.units},
            {"done", c.done},
            {"running", c.running},
            {"failed", c.failed}};
        if (progress.secondsLeft >= 0) json["seconds_left"] = std::round(progress.secondsLeft);
        stream_ << json.dump() << std::endl;
    }

    ProgressKind kind_;
    std::ostream& stream_;
    ProgressView bar_;
    Progress::Sink sink_;
    std::chrono::steady_clock::time_point lastShown_{};
    bool hasShown_{};
};

/// The campaign with its study.
struct OpenedCampaign {
    Campaign campaign;
    CampaignTemplate study;
};

Outcome<OpenedCampaign> opened(const Options& options) {
    Outcome<Campaign> campaign = readCampaign(options.input);
    if (!campaign) return campaign.diagnostics();
    Outcome<CampaignTemplate> study = CampaignTemplate::open(*campaign);
    if (!study) return study.diagnostics();
    return OpenedCampaign{std::move(*campaign), std::move(*study)};
}

/// This program as another process of the campaign.
std::vector<std::string> processOf(Command command, const Campaign& campaign, const fs::path& out) {
    return {fs::read_symlink("/proc/self/exe").string(), name(command), campaign.file.string(), "--out", out.string()};
}

RunOptions unitOptions() {
    RunOptions run;
    run.discover.threads = run.discover.fit.threads = 1;  // the units themselves run side by side
    return run;
}

void tellFailures(const Campaign& campaign, const CampaignState& state, CampaignView& view) {
    constexpr std::size_t most = 10;
    std::size_t told = 0;
    for (std::size_t i = 0; i < campaign.units.size(); ++i) {
        if (state.of(i) != UnitState::Failed) continue;
        if (++told > most) continue;
        view.note(phrase("failed: {}: {}", visibleName(campaign.units[i].name), state.record(i).fault));
    }
    if (told > most) view.note(phrase("and {} more units; results.csv names them", told - most));
}

/// What is there when the run has ended, for whatever reason.
int collect(const Campaign& campaign, const CampaignState& state, bool isInterrupted, CampaignView& view) {
    if (Outcome<Done> table = writeResultsTable(campaign, state); !table) return faulty(table.diagnostics());
    const CampaignSummary summary = summaryOf(campaign, state);
    if (Outcome<Done> page = writeCampaignPage(campaign, state, summary); !page) return faulty(page.diagnostics());
    const CampaignCounts counts = state.counts();
    tellFailures(campaign, state, view);
    for (const ParameterSummary& p : summary.parameters)
        for (const OddUnit& odd : p.odd)
            std::cout << fmt::format("odd: {}: {} = {} ({:+.1f} robust standard deviations)\n",
                                     visibleName(campaign.units[odd.unit].name), p.parameter.name,
                                     numberText(p.values[odd.unit]), odd.deviation);
    std::cout << fmt::format("{} units: {} done, {} failed, {} waiting\nresults: {}", counts.units, counts.done,
                             counts.failed, counts.waiting, visible((state.out() / "campaign.html").string()))
              << std::endl;
    if (isInterrupted) {
        view.note(phrase("interrupted; the same command goes on where it was"));
        return interrupted;
    }
    return counts.done == 0 && counts.failed > 0 ? numericsFailed : done;
}

void tellKept(const CampaignState& state, CampaignView& view) {
    if (state.kept() == 1) view.note(phrase("1 unit is done already"));
    if (state.kept() > 1) view.note(phrase("{} units are done already", state.kept()));
    if (state.changed() == 1)
        view.note(
            phrase("1 unit has changed since it was worked on (study, row or recordings) and is worked on again"));
    else if (state.changed() > 1)
        view.note(
            phrase("{} units have changed since they were worked on (study, row or recordings) and are worked on again",
                   state.changed()));
}

int onThisMachine(const OpenedCampaign& read, CampaignState& state, const Options& options, CampaignView& view,
                  Interrupt& interrupt) {
    CampaignRunOptions run;
    run.worker = processOf(Command::CampaignWorker, read.campaign, state.out());
    run.jobs = options.jobs > 0 ? options.jobs : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    run.stop = interrupt.token();
    run.report = [&](const CampaignProgress& progress) { view.show(progress); };
    const Outcome<Done> worked = runCampaign(read.campaign, read.study, state, run);
    interrupt.tell();
    view.clear();
    if (!worked) return faulty(worked.diagnostics());
    return collect(read.campaign, state, interrupt.wasRaised(), view);
}

int onTheCluster(const OpenedCampaign& read, CampaignState& state, const Slurm& slurm, const Options& options,
                 CampaignView& view, Interrupt& interrupt) {
    SlurmRunOptions run;
    run.task = processOf(Command::CampaignTask, read.campaign, state.out());
    run.options = options.sbatch;
    run.stop = interrupt.token();
    run.report = [&](const CampaignProgress& progress) { view.show(progress); };
    run.note = [&](const Text& text) { view.note(text); };
    const Outcome<SlurmEnd> end = runOnSlurm(read.campaign, read.study, state, slurm, run);
    interrupt.tell();
    view.clear();
    if (!end) return faulty(end.diagnostics());
    const int status = collect(read.campaign, state, interrupt.wasRaised() || end->isCancelled, view);
    if (end->isStillQueued)
        view.note(phrase("Slurm job {} works on; \"scancel {}\" ends it", end->job.id, end->job.id));
    if (end->isCancelled) view.note(phrase("Slurm job {} was cancelled", end->job.id));
    return status;
}

}  // namespace

int campaign(const Options& options, Interrupt& interrupt) {
    Outcome<OpenedCampaign> read = opened(options);
    if (!read) return faulty(read.diagnostics());
    std::optional<Slurm> slurm;
    if (options.slurm) {
        Outcome<Slurm> found = Slurm::find(interrupt.token());
        if (!found) return faulty(found.diagnostics());
        slurm = std::move(*found);
    } else if (const std::optional<Diagnostic> job = jobAtWork(options.out)) {
        return faulty({*job});
    }
    Outcome<CampaignState> state = CampaignState::take(read->campaign, read->study, options.out, options.retry);
    if (!state) return faulty(state.diagnostics());
    CampaignView view(options.progress, std::cerr, isatty(STDERR_FILENO) != 0);
    tellKept(*state, view);
    return slurm ? onTheCluster(*read, *state, *slurm, options, view, interrupt)
                 : onThisMachine(*read, *state, options, view, interrupt);
}

int campaignWorker(const Options& options) {
    Outcome<OpenedCampaign> read = opened(options);
    if (!read) return faulty(read.diagnostics());
    const Outcome<Done> served =
        serveUnits(read->campaign, read->study, options.out, unitOptions(), std::cin, std::cout);
    return served ? static_cast<int>(done) : faulty(served.diagnostics());
}

int campaignTask(const Options& options, Interrupt& interrupt) {
    Outcome<OpenedCampaign> read = opened(options);
    if (!read) return faulty(read.diagnostics());
    const Outcome<Done> worked =
        runSlurmTask(read->campaign, read->study, options.out, options.task,
                     processOf(Command::CampaignWorker, read->campaign, options.out), interrupt.token());
    interrupt.tell();
    if (!worked) return faulty(worked.diagnostics());
    return interrupt.wasRaised() ? interrupted : done;
}

}  // namespace analogon::cli
