#include "core/report/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "core/base/number_text.hpp"
#include "core/effect/model/model_state.hpp"

namespace analogon {

namespace {

std::string lowerFirst(std::string text) {
    // Not for names such as "I2R" or "DC": two capitals in a row are an abbreviation.
    const bool isWord = text.size() > 1 && std::isupper(static_cast<unsigned char>(text[0])) &&
                        !std::isupper(static_cast<unsigned char>(text[1]));
    if (isWord) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    while (!text.empty() && text.back() == '.') text.pop_back();
    return text;
}

constexpr double mostGrowth = 1.05;  // of the validation error, for a change of the model to pass

/// "The error on validation data falls from 8.6 % to 1.1 %."
std::string errorWords(const Finding& finding) {
    for (const Role role : {Role::Validate, Role::Fit}) {
        const double before = errorPercent(finding.baseline, role), after = errorPercent(finding.final, role);
        if (!std::isfinite(before) || !std::isfinite(after)) continue;
        const char* const data = role == Role::Validate ? "validation data" : "the fitted data";
        const char* const verb = after < before ? "falls" : "grows";
        const auto [was, is] = percentTexts(before, after);
        if (was == is) return fmt::format("the error on {} stays at {}", data, is);
        const bool isBorneOut = role != Role::Validate || after < mostGrowth * before;
        return fmt::format("the error on {} {} from {} to {}{}", data, verb, was, is,
                           isBorneOut ? "" : " (it describes the fitted recordings only: do not rely on it)");
    }
    return "the model changes as listed below";
}

std::string plainErrorWords(const ModelState& state) {
    std::string text;
    const double fit = errorPercent(state, Role::Fit), validation = errorPercent(state, Role::Validate);
    if (std::isfinite(fit)) text = fmt::format("Its error is {} on the fitted data", percentText(fit));
    if (std::isfinite(validation))
        text +=
            fmt::format("{}{} on validation data", text.empty() ? "Its error is " : " and ", percentText(validation));
    return text.empty() ? text : text + ".";
}

/// Name of the experiment that a fitted start value belongs to; empty for parameters of all experiments.
std::string experimentOf(const ModelState& state, const FitEstimate& estimate) {
    if (estimate.experiment < 0) return {};
    int index = 0;
    for (const ExperimentState& experiment : state.experiments)
        if (experiment.role == Role::Fit && index++ == estimate.experiment) return experiment.name;
    return fmt::format("experiment {}", estimate.experiment + 1);
}

/// What the level of some of them means.
std::string indicatedWords(const std::vector<AddedEffect>& effects) {
    const auto count = std::count_if(effects.begin(), effects.end(),
                                     [](const AddedEffect& e) { return e.confidence == Confidence::Indicated; });
    if (count == 0) return "";
    return fmt::format(" {} indicated, not established: the model predicts clearly better with {}, though not all.",
                       count == static_cast<std::ptrdiff_t>(effects.size()) ? count == 1 ? "The effect is" : "They are"
                       : count == 1                                         ? "One of them is"
                                                                            : "Some of them are",
                       count == 1 ? "it" : "them");
}

const char* howEnded(const Finding& finding) {
    return finding.end.isAtLimitOfWork ? "ended at its limit of work" : "was interrupted";
}

}  // namespace

bool hasChanged(const Finding& finding) { return !finding.effects.empty() && !finding.final.experiments.empty(); }

double errorPercent(const ModelState& state, Role role) {
    const bool isAny = std::any_of(state.experiments.begin(), state.experiments.end(),
                                   [&](const ExperimentState& experiment) { return experiment.role == role; });
    return isAny ? errorPercentOf(state, role) : std::nan("");
}

std::string effectWords(const AddedEffect& effect) {
    std::string what = lowerFirst(effect.description);
    if (effect.confidence == Confidence::Indicated) what += what.empty() ? "indicated" : ", indicated";
    return fmt::format("{} at {}{}", effect.kind, placeWords(effect.at, effect.wired.channel),
                       what.empty() ? "" : " (" + what + ")");
}

std::string placeWords(const std::string& at, const std::string& channel) {
    return channel.empty() ? at : fmt::format("{} by channel {}", at, channel);
}

Text confidenceWords(const AddedEffect& effect) {
    if (effect.confidence == Confidence::Established)
        return phrase("established: neither noise nor a disturbance accounts for it");
    if (!effect.prediction) return phrase("indicated: the search ended before its last tests");
    const auto [before, after] =
        percentTexts(effect.prediction->errorPercentBefore, effect.prediction->errorPercentAfter);
    if (effect.prediction->besideFlow)
        return phrase(
            "indicated: structure remains, but beside a flow that nobody measured it is far likelier than that flow "
            "alone and than any other name; the error of what was left out of the fit goes from {} to {}",
            before, after);
    return phrase(
        "indicated: structure remains, but with it the error of what was left out of the fit falls from {} "
        "to {}, in {} of {} parts",
        before, after, effect.prediction->betterIn, effect.prediction->blocks);
}

std::string summaryWords(const Finding& finding, const std::string& command) {
    const ModelState& state = finding.final.experiments.empty() ? finding.baseline : finding.final;
    if (command == "simulate") {
        if (finding.end.interrupted) return "The simulation was interrupted: it ends before the recordings do.";
        const bool hasOpenStarts = std::any_of(state.experiments.begin(), state.experiments.end(),
                                               [](const ExperimentState& e) { return !e.starts.empty(); });
        return fmt::format("The model was simulated as it stands{}. {}",
                           hasOpenStarts ? ", from start values that each recording had to tell itself" : "",
                           plainErrorWords(state));
    }
    if (command == "fit" && finding.end.interrupted)
        return "The fit was interrupted: these are the best parameters so far. " + plainErrorWords(state);
    if (command == "fit") return "The parameters of the model were fitted. " + plainErrorWords(state);
    if (finding.end.interrupted && !hasChanged(finding))
        return fmt::format("The search {} before an effect was accepted. {}", howEnded(finding),
                           plainErrorWords(state));

    if (!finding.end.notSearched.empty() && finding.unexplained.remainders.empty())
        return "No effect was looked for: " + finding.end.notSearched.english() + ". " + plainErrorWords(state);

    std::string text;
    std::vector<std::string> effects;
    for (const AddedEffect& effect : finding.effects) effects.push_back(effectWords(effect));
    const char* const begin =
        finding.kind == FindingKind::Partial ? "Part of what the model lacks is explained by" : "The model lacked";
    if (!effects.empty())
        text = fmt::format("{} {}. With {}, {}", begin, listed(effects), effects.size() == 1 ? "it" : "them",
                           errorWords(finding));
    switch (finding.kind) {
        case FindingKind::Adequate:
            return "The model explains the measurement: what is left is noise, and nothing was added. " +
                   plainErrorWords(state);
        case FindingKind::Effect:
            text += ", and what is left is noise.";
            break;
        case FindingKind::Partial:
            text += "; what is left still has a structure that nothing known here explains.";
            text += indicatedWords(finding.effects);
            break;
        case FindingKind::Interrupted:
            break;
        case FindingKind::Unexplained:
            text = (finding.end.notSearched.empty()
                        ? "What the model leaves over is not noise, and no known effect explains it. "
                        : "What the model leaves over is not noise, and no effect was looked for. ") +
                   plainErrorWords(state);
            break;
    }
    std::set<std::string> values;
    for (const AddedEffect& effect : finding.effects)
        values.insert(effect.instead.values.begin(), effect.instead.values.end());
    if (!values.empty())
        text += fmt::format(" Another value of what the study holds would explain as much as {}: {}.",
                            finding.effects.size() == 1 ? "the effect" : "one of the effects", fmt::join(values, "; "));
    if (finding.end.interrupted) text += fmt::format(" The search {}; this is the best so far.", howEnded(finding));
    return text;
}

Text verdictWords(const CandidateResult& candidate) {
    if (!candidate.reason.empty()) return candidate.reason;
    switch (candidate.verdict) {
        case Verdict::Chosen:
            return phrase("explains the residual best and passes every check");
        case Verdict::Equivalent:
            return phrase("explains it as well: this data cannot tell it from the chosen one");
        case Verdict::Weaker:
            return phrase("explains part of it, less than the chosen one");
        case Verdict::NotSignificant:
            return phrase("gains no more than chance would");
        case Verdict::Absorbed:
            return candidate.screening.absorbedBy.empty()
                       ? phrase("the data cannot show it: it only shifts parameters")
                       : phrase("the data cannot show it: it only shifts {}", listed(candidate.screening.absorbedBy));
        case Verdict::WrongSign:
            return phrase("would need a strength of the wrong physical sign");
        case Verdict::FailsHeldOut:
            return phrase("does not predict the parts of the data that were left out");
        case Verdict::Failed:
            return phrase("could not be simulated or fitted");
    }
    return {};
}

Text disturbanceWords(const UnmeasuredFlow& flow) {
    return phrase(
        "What remains behaves like a flow of {} {} (root mean square) at {} that nobody measured, and that "
        "changes within about {} s.",
        numberText(flow.size, 2), flow.unit, flow.node, numberText(flow.timeConstant, 2));
}

std::string remainderWords(const Remainder& remainder) {
    std::string text = fmt::format("What is left on output {}", remainder.output);
    if (!remainder.experiment.empty()) text += fmt::format(" of '{}'", remainder.experiment);
    if (remainder.to > remainder.from)
        text +=
            fmt::format(" is strongest between {} s and {} s", numberText(remainder.from), numberText(remainder.to));
    else
        text += " is not noise";
    if (!remainder.node.empty()) text += fmt::format("; it acts at {}", remainder.node);
    if (!remainder.proposal.equalNodes.empty())
        text += fmt::format(", or as well at {}", fmt::join(remainder.proposal.equalNodes, ", "));
    std::vector<std::string> variables;
    for (const Correlate& correlate : remainder.movesWith)
        if (correlate.isWorthAWord())
            variables.push_back(fmt::format("{} (correlation {:.2f})", correlate.variable, correlate.correlation));
    if (!variables.empty()) text += "; it moves with " + listed(variables).english();
    text += '.';
    const bool isWorse = remainder.proposal.worsensValidation();
    if (!remainder.proposal.equation.empty())
        text += (isWorse ? " Proposed, but not borne out by validation: " : " Proposed: ") +
                remainder.proposal.equation.english();
    if (!remainder.proposal.className.empty())
        text += fmt::format(" (block {}{})", remainder.proposal.className,
                            remainder.proposal.block.empty() ? "" : ", written to proposed.mo");
    if (remainder.proposal.errors.fit >= 0) {
        text += fmt::format("; with it the error would be {} on the fitted data",
                            percentText(remainder.proposal.errors.fit));
        const auto [without, with] =
            percentTexts(remainder.proposal.errorValidateWithout, remainder.proposal.errors.validate);
        if (remainder.proposal.errors.validate >= 0) text += fmt::format(" and {} on validation data", with);
        if (isWorse)
            text += fmt::format(", worse than the {} without it: it describes the fitted recordings only", without);
    }
    return text;
}

std::string proposedStudyWords(const Finding& finding) {
    if (!finding.unexplained.proposed) return {};
    return "What is proposed is not in the completed study; the study with it, as it was fitted, is in study-proposed.";
}

std::vector<ReportedEstimate> estimatesOf(const ModelState& state) {
    std::vector<ReportedEstimate> estimates;
    for (const FitEstimate& estimate : state.parameters)
        estimates.push_back({&estimate, experimentOf(state, estimate)});
    for (const ExperimentState& experiment : state.experiments)
        for (const FitEstimate& start : experiment.starts) estimates.push_back({&start, experiment.name});
    return estimates;
}

bool hasRobustErrors(const ModelState& state) {
    const std::vector<ReportedEstimate> estimates = estimatesOf(state);
    return std::any_of(estimates.begin(), estimates.end(),
                       [](const ReportedEstimate& e) { return std::isfinite(e.estimate->whiteError); });
}

std::string statusWords(FitStatus status) {
    switch (status) {
        case FitStatus::Converged:
            return "converged";
        case FitStatus::IterationLimit:
            return "iteration limit";
        case FitStatus::Cancelled:
            return "cancelled";
        case FitStatus::Failed:
            return "failed";
    }
    return {};
}

bool hasBand(const OutputState& output) {
    return output.deviation.size() > 0 && output.deviation.size() == output.simulated.size();
}

bool hasBands(const ModelState& state) {
    for (const ExperimentState& experiment : state.experiments)
        if (std::any_of(experiment.outputs.begin(), experiment.outputs.end(), hasBand)) return true;
    return false;
}

double scatterOf(const ModelState& state, const std::string& output) {
    const auto found = state.residual.find(output);
    return found == state.residual.end() ? std::nan("") : found->second.standardDeviation;
}

bool contradictsPrior(const FitEstimate& estimate) {
    return estimate.prior && std::abs(estimate.prior->distance(estimate.value)) > NormalPrior::contradiction;
}

}  // namespace analogon
