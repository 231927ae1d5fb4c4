#pragma once

#include <functional>
#include <stop_token>

#include "core/campaign/campaign_run.hpp"
#include "core/campaign/slurm/slurm.hpp"

namespace analogon {

struct SlurmRunOptions {
    std::vector<std::string> task;     // the program that works on a task of the array (slurm_task.hpp), with its
                                       // arguments but for "--task NUMBER"
    std::vector<std::string> options;  // for sbatch
    std::stop_token stop{};
    std::function<void(const CampaignProgress&)> report{};
    std::function<void(const Text&)> note{};  // what the user is told meanwhile
};

/// How following a job ended.
struct SlurmEnd {
    SlurmJob job;          // that is still in the queue, or was the last one
    bool isCancelled{};    // by somebody: units wait, and no further job was submitted
    bool isStillQueued{};  // what follows it was stopped
};

inline constexpr int mostLosses = 3;  // tasks that end while they work on one unit, before it counts as failed

/// Works on the units that wait as tasks of a Slurm array job: writes its script into `DIR/slurm`, submits it, follows
/// it, and submits what was lost once more, until no unit waits. A job that an earlier run submitted is followed on. A
/// unit whose tasks end three times while it is worked on, without a record, has failed. It may be stopped: the job
/// goes on. Slurm is asked every half second at first, then ever more rarely, at most every minute. Faults: sbatch
/// refuses the job; tasks cannot begin (with what they say); files cannot be written.
Outcome<SlurmEnd> runOnSlurm(const Campaign& campaign, const CampaignTemplate& study, CampaignState& state,
                             const Slurm& slurm, const SlurmRunOptions& options);

/// Why units cannot be worked on here: a Slurm job works on them, or may. Empty: none does.
std::optional<Diagnostic> jobAtWork(const std::filesystem::path& out);

/// An option that a campaign needs for itself, among those for sbatch; empty: there is none.
std::string reservedOption(const std::vector<std::string>& options);

}  // namespace analogon
