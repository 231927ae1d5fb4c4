#pragma once

#include <string>
#include <vector>

#include "core/effect/catalogue/finding.hpp"
#include "core/effect/model/null_model.hpp"
#include "core/flat/flat_model.hpp"

namespace analogon {

/// Whether a variable is a Real parameter that may have another value without another flattening.
bool isTunable(const FlatVariable& variable);

/// Real parameters of a model that act where a recording begins and nowhere else: they stand in start attributes and
/// initial equations alone.
std::vector<std::string> startParameters(const FlatModel& model);

/// A start value that a recording is told (by the study, a column's first sample or the model), and may be told
/// wrongly.
struct ToldStart {
    int recording{};   // of the task
    int experiment{};  // among those of its role
    std::string parameter;
    double value{};
    bool isOfMidRun{};  // one of all that a record has which begins elsewhere
};

/// Those of the recordings with a role that are not fitted.
Outcome<std::vector<ToldStart>> toldStarts(const EstimationTask& task, Role role = Role::Fit);

enum class Against { Noise, Residual };  // of a channel

/// Those of recordings that begin elsewhere than the model does (a record that was cut out of a longer one), by far
/// more than noise or than what the model leaves elsewhere in them, and of the states there that nothing decides.
std::vector<ToldStart> startsBegunElsewhere(const NullModel& null, Against against);

/// The same of recordings that only validate, where a model begins elsewhere in them (`state`), or in all of them.
std::vector<ToldStart> startsOfChecks(const EstimationTask& task, const ModelState& state, bool allDo);

/// Whether an output begins elsewhere than it was measured, by far more than `deviation`. `residual`: simulated less
/// measured; NaN: not measured.
bool beginsElsewhere(const Eigen::VectorXd& residual, double deviation, double range);
/// The same, by far more than what the model leaves in the fitted recordings.
bool beginsElsewhere(const OutputState& output, const ModelState& state);

/// Makes a start value one that is fitted, from where the recording was told it to be (else from the value given); or
/// takes that back.
void setFitted(EstimationTask& task, const ToldStart& start, bool isFitted);
void setFitted(EstimationTask& task, const std::vector<ToldStart>& starts, bool areFitted);

}  // namespace analogon
