#pragma once

#include <string>
#include <vector>

#include "core/effect/catalogue/finding.hpp"

/// What the report says in words, for the page and the terminal alike. Plain text.
namespace analogon {

/// Whether something was added: before and after are two models.
bool hasChanged(const Finding& finding);

/// Root mean square of error_percent over the experiments with a role; NaN when there is none.
double errorPercent(const ModelState& state, Role role);

/// One or two sentences: what was found, and what it did to the error.
std::string summaryWords(const Finding& finding, const std::string& command);

/// "friction.coulomb at rotor.flange_a (dry friction)"
std::string effectWords(const AddedEffect& effect);

/// Where an effect is, and the recorded channel that drives it: "element by channel gas_flow".
std::string placeWords(const std::string& at, const std::string& channel);

/// How sure an effect is, and what that rests on.
Text confidenceWords(const AddedEffect& effect);

/// Why a candidate was taken or not: its reason, or, where a run kept none, what its verdict means.
Text verdictWords(const CandidateResult& candidate);

std::string remainderWords(const Remainder& remainder);

/// What flow the rest looks like that nobody measured.
Text disturbanceWords(const UnmeasuredFlow& flow);

/// Where the model with all that is proposed is found; empty: nothing is, or it cannot be added.
std::string proposedStudyWords(const Finding& finding);

/// An estimate, and the name of the experiment if it is a start value of that one alone; empty for all experiments.
struct ReportedEstimate {
    const FitEstimate* estimate{};
    std::string experiment;
};
/// All estimates of a state: of the fit, and what single recordings had to tell of their own start.
std::vector<ReportedEstimate> estimatesOf(const ModelState& state);

/// Whether some standard error reckons with residuals that are correlated in time.
bool hasRobustErrors(const ModelState& state);

std::string statusWords(FitStatus status);

/// Whether it is known how far an output, or any of a model, is uncertain since the parameters are.
bool hasBand(const OutputState& output);
bool hasBands(const ModelState& state);

/// Standard deviation of what a model leaves of an output over the fitted experiments; NaN: not known.
double scatterOf(const ModelState& state, const std::string& output);

/// Whether a value lies more than three standard deviations from what was known of it.
bool contradictsPrior(const FitEstimate& estimate);

}  // namespace analogon
