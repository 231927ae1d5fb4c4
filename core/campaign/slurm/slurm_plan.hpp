#pragma once

#include "core/campaign/campaign.hpp"
#include "core/campaign/slurm/slurm.hpp"

namespace analogon {

/// A unit that a task of an array works on.
struct PlannedUnit {
    std::size_t unit{};  // in the order of the table
    std::string name;
    int lost{};  // how many times a task ended while it worked on it
};

/// Which task of an array job works on which units, one after the other. It lies in `DIR/slurm`, whatever the number of
/// units in four files: units.txt (a line "TASK LOST UNIT NAME" for each), array.sh, job.json (the number of the job),
/// and output.txt, to which tasks write what hinders them.
struct SlurmPlan {
    std::vector<std::vector<PlannedUnit>> tasks;
    SlurmJob job;  // not known: it was about to be submitted
};

/// Units in their order in at most so many tasks, of which none has two units more than another.
std::vector<std::vector<PlannedUnit>> blocksOf(const std::vector<PlannedUnit>& units, std::size_t mostTasks);

std::filesystem::path slurmFolder(const std::filesystem::path& out);

/// The array script. `task`: the program that works on a task, with its arguments but for the task's number.
std::string arrayScript(std::size_t tasks, const std::vector<std::string>& task, const std::filesystem::path& out);

/// The plan with its script, before it is submitted, then the number of its job.
Outcome<Done> writePlan(const SlurmPlan& plan, const std::vector<std::string>& task, const std::filesystem::path& out);
Outcome<Done> writeJob(const SlurmJob& job, const std::filesystem::path& out);
/// The plan of a job that was, or was about to be, submitted and did not end yet; empty: there is none.
std::optional<SlurmPlan> readPlan(const std::filesystem::path& out);
/// The job has ended.
void forgetJob(const std::filesystem::path& out);

/// Every unit of the plan is still that of the campaign.
bool isOf(const SlurmPlan& plan, const Campaign& campaign);

}  // namespace analogon
