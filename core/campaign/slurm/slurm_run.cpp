#include "core/campaign/slurm/slurm_run.hpp"

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <set>
#include <thread>
#include <utility>

#include "core/base/regular_file.hpp"
#include "core/base/stopwatch.hpp"
#include "core/campaign/slurm/slurm_plan.hpp"
#include "core/campaign/unit_run.hpp"

namespace analogon {

namespace {

using std::chrono::steady_clock;

constexpr std::size_t lastOutput = 500;  // [byte] of what tasks say that are shown

/// [s] until Slurm is asked again: a twentieth of what has passed, so that hardly anything is waited for in vain and
/// the number of questions grows with the logarithm of the time.
double pauseAfter(double passed) { return std::clamp(passed / 20, 0.5, 60.0); }

/// The last that tasks said.
std::string outputOf(const std::filesystem::path& out) {
    constexpr std::uint64_t most = 64u << 20;  // [byte]
    Outcome<std::string> text = readRegularFile(slurmFolder(out) / "output.txt", most);
    if (!text) return {};
    std::string said = std::move(*text);
    while (said.ends_with('\n')) said.pop_back();
    if (said.size() > lastOutput) said.erase(0, said.size() - lastOutput);
    return said;
}

/// Has a network file system look anew what lies in the folder of the units.
void lookAnew(const std::filesystem::path& out) {
    const FileHandle folder(open((out / "units").c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    std::error_code code;
    for (std::filesystem::directory_iterator entry(out / "units", code), end; !code && entry != end;
         entry.increment(code)) {
    }
}

class SlurmRun {
public:
    SlurmRun(const Campaign& campaign, const CampaignTemplate& study, CampaignState& state, const Slurm& slurm,
             const SlurmRunOptions& options)
        : campaign_(campaign),
          study_(study),
          state_(state),
          slurm_(slurm),
          options_(options),
          lost_(campaign.units.size(), 0) {}

    Outcome<SlurmEnd> run() {
        adopt();
        for (;;) {
            if (!plan_.job.isKnown()) {
                if (state_.waiting().empty() || options_.stop.stop_requested()) return ending(false);
                if (Outcome<Done> submitted = submit(); !submitted) return submitted.diagnostics();
            }
            follow();
            if (options_.stop.stop_requested()) return ending(true);
            const Outcome<bool> goesOn = judge();
            if (!goesOn) return goesOn.diagnostics();
            forgetJob(state_.out());
            if (!*goesOn) return ending(false, true);
            plan_ = {};
        }
    }

private:
    /// A job of an earlier run that is still there, or ended meanwhile.
    void adopt() {
        std::optional<SlurmPlan> earlier = readPlan(state_.out());
        if (!earlier) return;
        const bool isWhole = isOf(*earlier, campaign_);
        if (!earlier->job.isKnown())
            if (const auto found = slurm_.jobOf(slurmFolder(state_.out()) / "array.sh", options_.stop))
                earlier->job = *found;
        if (isWhole)
            for (const auto& task : earlier->tasks)
                for (const PlannedUnit& one : task) lost_[one.unit] = one.lost;
        if (!earlier->job.isKnown() || !isWhole) {
            if (earlier->job.isKnown()) slurm_.cancel(earlier->job);
            forgetJob(state_.out());
            return;
        }
        plan_ = std::move(*earlier);
        note(phrase("Slurm job {} of an earlier run is followed", plan_.job.id));
    }

    Outcome<Done> submit() {
        std::vector<PlannedUnit> units;
        for (const std::size_t unit : state_.waiting()) {
            units.push_back({unit, campaign_.units[unit].name, lost_[unit]});
            // one that failed before would count as worked on
            std::error_code code;
            if (readUnitRecord(state_.out(), campaign_.units[unit].name))
                std::filesystem::remove(folderOf(state_.out(), campaign_.units[unit].name) / "unit.json", code);
        }
        plan_.tasks = blocksOf(units, slurm_.mostTasks());
        if (Outcome<Done> written = writePlan(plan_, options_.task, state_.out()); !written) return written;
        Outcome<SlurmJob> job = slurm_.submit(slurmFolder(state_.out()) / "array.sh", options_.options);
        if (!job) {
            forgetJob(state_.out());
            return job.diagnostics();
        }
        plan_.job = *job;
        note(phrase("Slurm job {}: {} units in {} tasks", plan_.job.id, units.size(), plan_.tasks.size()));
        return writeJob(plan_.job, state_.out());
    }

    /// Until no task of the job is in the queue.
    void follow() {
        const auto begin = steady_clock::now();
        isCollected_.assign(plan_.tasks.size(), false);
        stuck_.clear();
        wasSeen_ = false;
        for (bool isSilent = false; !options_.stop.stop_requested();) {
            const auto queued = slurm_.queued(plan_.job, options_.stop);
            if (options_.stop.stop_requested()) break;
            if (queued) {
                isSilent = false;
                take(*queued);
                tellWhyItWaits(*queued);
                tell();
                if (queued->empty()) return;
            } else if (!isSilent) {
                isSilent = true;
                note(queued.diagnostics().front().message);
            }
            const auto asked = steady_clock::now();
            const double pause = pauseAfter(secondsSince(begin));
            while (secondsSince(asked) < pause && !options_.stop.stop_requested())
                std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
    }

    /// Why nothing goes on, where that is more than that others come first; once for each reason.
    void tellWhyItWaits(const std::map<std::size_t, QueuedTask>& queued) {
        if (queued.empty()) return;
        for (const auto& [task, one] : queued)
            if (one.isRunning) return;
        const std::string& reason = queued.begin()->second.reason;
        for (const char* usual : {"", "None", "Priority", "Resources", "BeginTime"})
            if (reason == usual) return;
        if (std::exchange(reason_, reason) != reason) note(phrase("Slurm job {} waits: {}", plan_.job.id, reason));
    }

    /// What the queue says of the tasks: those that left it are looked at, once.
    void take(const std::map<std::size_t, QueuedTask>& queued) {
        wasSeen_ = wasSeen_ || !queued.empty();
        for (std::size_t i = 0; i < plan_.tasks.size(); ++i) {
            const auto there = queued.find(i);
            if (there == queued.end()) {
                if (!isCollected_[i]) collect(i);
                isCollected_[i] = true;
                continue;
            }
            isCollected_[i] = false;
            const auto next = atWork(i);
            if (next && there->second.isRunning) state_.begin(*next);
            if (next && !there->second.isRunning) state_.lose(*next);
            if (there->second.isStuck && stuck_.insert(i).second) slurm_.cancel(plan_.job, i);
        }
    }

    bool isEnded(std::size_t unit) const {
        return state_.of(unit) == UnitState::Done || state_.of(unit) == UnitState::Failed;
    }

    void collect(std::size_t task) {
        for (const PlannedUnit& one : plan_.tasks[task]) {
            if (isEnded(one.unit)) continue;
            std::optional<UnitRecord> record = recordThatHolds(campaign_, study_, one.unit, state_.out());
            if (record) {
                ++ended_;
                state_.end(one.unit, std::move(*record));
            } else {
                state_.lose(one.unit);
            }
        }
    }

    /// The unit that a task works on next, or worked on when it ended.
    std::optional<std::size_t> atWork(std::size_t task) const {
        for (const PlannedUnit& one : plan_.tasks[task])
            if (!isEnded(one.unit)) return one.unit;
        return std::nullopt;
    }

    /// The job has left the queue: which units were lost, how often, and whether it is worth to go on. False: somebody
    /// cancelled it.
    Outcome<bool> judge() {
        const auto isLost = [&](std::size_t i) { return atWork(i).has_value(); };
        std::vector<std::size_t> lost;
        lookAnew(state_.out());
        for (std::size_t i = 0; i < plan_.tasks.size(); ++i) {
            if (isLost(i)) collect(i);
            if (isLost(i)) lost.push_back(i);
        }
        tell();
        if (lost.empty()) return true;
        const std::map<std::size_t, std::string> endings = slurm_.endings(plan_.job, options_.stop);
        bool isCancelled = false, areTheirFault = true, areKnown = true;
        for (const std::size_t i : lost) {
            const auto found = endings.find(i);
            const std::string how = found == endings.end() ? std::string() : found->second;
            const bool hasCancelled = how == "CANCELLED" && !stuck_.contains(i);
            isCancelled = isCancelled || (hasCancelled && wasSeen_);
            areTheirFault = areTheirFault && (how.empty() || how == "FAILED");
            areKnown = areKnown && !how.empty();
            if (!hasCancelled) lose(*atWork(i), how);
        }
        if (isCancelled) return false;
        if (ended_ == 0 && lost.size() == plan_.tasks.size() && areTheirFault)
            if (const std::string said = outputOf(state_.out()); areKnown || !said.empty()) return cannotBegin(said);
        if (!state_.waiting().empty())
            note(phrase("{} tasks of Slurm job {} ended before their units were done; these are submitted again",
                        lost.size(), plan_.job.id));
        return true;
    }

    Diagnostic cannotBegin(const std::string& said) const {
        forgetJob(state_.out());
        return error(
            said.empty() ? phrase("the tasks of Slurm job {} could not begin", plan_.job.id)
                         : phrase("the tasks of Slurm job {} could not begin: {}", plan_.job.id, said),
            Span(),
            phrase("This program, the campaign, its recordings and \"{}\" must lie where every node sees them.",
                   state_.out().string()));
    }

    void lose(std::size_t unit, const std::string& how) {
        if (++lost_[unit] < mostLosses) return;
        const Outcome<std::string> fingerprint = fingerprintOf(campaign_, study_, campaign_.units[unit]);
        state_.end(unit, recordFailure(campaign_.units[unit], fingerprint ? *fingerprint : std::string(),
                                       fmt::format("its task ended {} times before the unit was done{}", lost_[unit],
                                                   how.empty() ? "" : " (" + how + ")"),
                                       state_.out()));
    }

    void tell() {
        const CampaignCounts counts = state_.counts();
        const double rest = static_cast<double>(counts.waiting + counts.running);
        const double left = ended_ == 0 ? -1 : secondsSince(begin_) / static_cast<double>(ended_) * rest;
        if (options_.report) options_.report({counts, left});
        (void)state_.write(campaign_);  // it is written at the end, and what hinders that is told then
    }

    void note(const Text& text) const {
        if (options_.note) options_.note(text);
    }

    Outcome<SlurmEnd> ending(bool isStopped, bool isCancelled = false) {
        for (std::size_t i = 0; i < campaign_.units.size(); ++i)
            if (state_.of(i) == UnitState::Running) state_.lose(i);
        if (Outcome<Done> written = state_.write(campaign_); !written) return written.diagnostics();
        return SlurmEnd{plan_.job, isCancelled, isStopped && plan_.job.isKnown()};
    }

    const Campaign& campaign_;
    const CampaignTemplate& study_;
    CampaignState& state_;
    const Slurm& slurm_;
    const SlurmRunOptions& options_;
    SlurmPlan plan_;
    std::vector<int> lost_;          // of each unit
    std::vector<bool> isCollected_;  // of each task
    std::string reason_;             // that was told
    std::set<std::size_t> stuck_;    // tasks that were given up
    bool wasSeen_{};                 // in the queue, by this run
    std::size_t ended_{};            // units, in this run
    steady_clock::time_point begin_{steady_clock::now()};
};

}  // namespace

Outcome<SlurmEnd> runOnSlurm(const Campaign& campaign, const CampaignTemplate& study, CampaignState& state,
                             const Slurm& slurm, const SlurmRunOptions& options) {
    return SlurmRun(campaign, study, state, slurm, options).run();
}

std::optional<Diagnostic> jobAtWork(const std::filesystem::path& out) {
    const std::optional<SlurmPlan> plan = readPlan(out);
    if (!plan || !plan->job.isKnown()) return std::nullopt;
    if (const Outcome<Slurm> slurm = Slurm::find({}))
        if (const auto queued = slurm->queued(plan->job, {}); queued && queued->empty()) return std::nullopt;
    return fileError(phrase("Slurm job {} works on this campaign", plan->job.id), out.string(), 0, 0,
                     phrase("Follow it with --slurm, or end it with \"scancel {}\".", plan->job.id));
}

std::string reservedOption(const std::vector<std::string>& options) {
    constexpr std::array reserved{"--array", "--help",    "--parsable", "--test-only",
                                  "--usage", "--version", "--wait",     "--wrap"};
    constexpr std::size_t shortest = 4;  // of an option that is not written out
    for (const std::string& word : options) {
        const std::string name = word.substr(0, word.find('='));
        if (name.size() == 2 || (word.size() > 2 && word[0] == '-' && word[1] != '-'))
            for (const char* letter : {"-a", "-h", "-V", "-W"})
                if (word.starts_with(letter)) return letter;
        for (const char* option : reserved)
            if (name.size() >= shortest && std::string_view(option).starts_with(name)) return option;
    }
    return {};
}

}  // namespace analogon
