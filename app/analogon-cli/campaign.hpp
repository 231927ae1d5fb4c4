#pragma once

#include "app/analogon-cli/command_line.hpp"
#include "app/analogon-cli/interrupt.hpp"

namespace analogon::cli {

/// The same fit or discovery for many units, in processes of this machine or as an array job of a Slurm cluster.
int campaign(const Options& options, Interrupt& interrupt);

/// What those processes do: takes units from standard input (core/campaign/campaign_run.hpp).
int campaignWorker(const Options& options);

/// What a task of the array job does (core/campaign/slurm/slurm_task.hpp).
int campaignTask(const Options& options, Interrupt& interrupt);

}  // namespace analogon::cli
