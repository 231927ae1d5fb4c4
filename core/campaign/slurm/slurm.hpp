#pragma once

#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/campaign/slurm/command_run.hpp"

namespace analogon {

/// A job as Slurm names it.
struct SlurmJob {
    std::string id, cluster;  // the cluster is empty for the one at hand

    bool isKnown() const { return !id.empty(); }
};

/// A task of an array that has not ended.
struct QueuedTask {
    bool isRunning{};
    bool isStuck{};      // Slurm holds it after it could not be started: nothing will become of it
    std::string reason;  // why it waits ("Resources")
};

/// The cluster at hand, by the programs that its users have.
class Slurm {
public:
    /// Faults: no sbatch or squeue on PATH, no answer, a cluster without job arrays.
    static Outcome<Slurm> find(const std::stop_token& stop);

    /// How many tasks an array may have (MaxArraySize, MaxJobCount).
    std::size_t mostTasks() const { return mostTasks_; }

    /// Submits a script. It is not interrupted: the job would be there, and its number not known. Fault: what sbatch
    /// says against it.
    Outcome<SlurmJob> submit(const std::filesystem::path& script, const std::vector<std::string>& options) const;
    /// A job of this user that is in the queue with this script.
    std::optional<SlurmJob> jobOf(const std::filesystem::path& script, const std::stop_token& stop) const;
    /// The tasks of a job that are still in the queue, by their numbers. Fault: Slurm does not answer.
    Outcome<std::map<std::size_t, QueuedTask>> queued(const SlurmJob& job, const std::stop_token& stop) const;
    /// How tasks ended ("COMPLETED", "NODE_FAIL", …): by the accounting, where there is none by what the controller
    /// still knows. Those that nobody knows are left out.
    std::map<std::size_t, std::string> endings(const SlurmJob& job, const std::stop_token& stop) const;
    void cancel(const SlurmJob& job, std::optional<std::size_t> task = {}) const;

private:
    std::filesystem::path sbatch_, squeue_;
    std::optional<std::filesystem::path> scontrol_, sacct_, scancel_;
    std::size_t mostTasks_{};
};

/// The tasks that one line of squeue or sacct stands for: "12_7" is 7, "12_[3-5,9%2]" is 3, 4, 5 and 9; none of another
/// job.
std::vector<std::size_t> tasksNamed(const std::string& text, const std::string& job);

}  // namespace analogon
