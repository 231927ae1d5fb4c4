#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/eval/system.hpp"
#include "core/fit/estimation_task.hpp"
#include "core/flat/flat_model.hpp"
#include "core/structure/structure.hpp"

namespace analogon {

/// The model of a task in every stage, as each fit and each simulation of the task takes it.
struct CompiledTask {
    std::shared_ptr<const FlatModel> model;  // with start values as parameters, where recordings tell them
    Structure structure;
    SystemPtr system;
};

/// Fitted parameters, start values and `alsoKeep` stay symbolic. Faults: one of them is no parameter that may change;
/// the model cannot be solved. Warnings: what the analysis remarks.
Outcome<CompiledTask> compiled(const EstimationTask& task, const std::vector<std::string>& alsoKeep = {});

}  // namespace analogon
