#pragma once

#include "core/fit/compiled_task.hpp"
#include "core/study/study.hpp"

namespace analogon {

/// What a study is read for. What hinders one purpose is a remark to another.
enum class Purpose { Check, Simulate, Fit, Discover };

/// A study that may be worked on: its task, and the model of it in every stage.
struct ValidStudy {
    EstimationTask task;
    CompiledTask model;
};

/// The one examination of a study, the same for every command and for the window: the model and its ranges, what
/// study.json says, the measurements, and whether the model can be solved with what is told of it. Each fault and each
/// remark is said once, with its place, faults first; the remarks come along with a study that is valid.
/// What the reading of the files remarked (readStudy) is said there.
Outcome<ValidStudy> validated(const Study& study, Purpose purpose);

}  // namespace analogon
