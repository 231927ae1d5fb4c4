#pragma once

#include <stop_token>

#include "core/campaign/unit_study.hpp"

namespace analogon {

/// Works on the units of one task of an array (slurm_plan.hpp), one after the other, in the process that a local
/// campaign works in: one that crashes costs its unit. What is done already is not done again, and a unit that another
/// task works on (Slurm starts a task anew where a node does not answer, and that node may still work) is waited for.
/// `worker`: the program that serves as worker (campaign_run.hpp), with its arguments.
/// Faults: no plan, the table of units was changed meanwhile, no worker can begin.
Outcome<Done> runSlurmTask(const Campaign& campaign, const CampaignTemplate& study, const std::filesystem::path& out,
                           std::size_t task, const std::vector<std::string>& worker, const std::stop_token& stop);

}  // namespace analogon
