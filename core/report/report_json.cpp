#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/report/report.hpp"
#include "core/report/words.hpp"

namespace analogon {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json intervalJson(const ConfidenceInterval& interval) {
    Json values = Json::array(), rises = Json::array();
    for (const double value : interval.values) values.push_back(number(value));
    for (const double rise : interval.rises) rises.push_back(number(rise));
    return {{"level", 0.95},
            {"lower", interval.isOpenBelow ? Json(nullptr) : number(interval.lower)},
            {"upper", interval.isOpenAbove ? Json(nullptr) : number(interval.upper)},
            {"remark", interval.remark},
            {"profile", {{"values", values}, {"rises", rises}}}};
}

Json parametersJson(const ModelState& state) {
    Json parameters = Json::object();
    for (const auto& [each, experiment] : estimatesOf(state)) {
        const FitEstimate& estimate = *each;
        Json json{{"value", number(estimate.value)},
                  {"std", number(estimate.standardError)},
                  {"unit", estimate.unit},
                  {"at_bound", estimate.atBound}};
        if (std::isfinite(estimate.robustError)) json["std_robust"] = estimate.robustError;
        if (std::isfinite(estimate.whiteError)) json["std_if_white"] = estimate.whiteError;
        if (estimate.prior)
            json["prior"] = {{"mean", estimate.prior->mean},
                             {"std", estimate.prior->deviation},
                             {"distance", number(estimate.prior->distance(estimate.value))}};
        if (estimate.interval) json["interval"] = intervalJson(*estimate.interval);
        if (!experiment.empty()) json["experiment"] = experiment;
        // A start value has one estimate for each experiment.
        parameters[experiment.empty() ? estimate.name : fmt::format("{} ({})", estimate.name, experiment)] = json;
    }
    return parameters;
}

Json experimentJson(const ExperimentState& experiment) {
    Json outputs = Json::object();
    for (const OutputState& output : experiment.outputs) {
        const ErrorFigures& figures = output.figures;
        outputs[output.name] = {{"rmse", number(figures.rmse)},
                                {"error_percent", number(figures.errorPercent)},
                                {"relative_rms_percent", number(figures.relativeRmsPercent)},
                                {"fit_percent", number(figures.fitPercent)},
                                {"max_abs", number(figures.maxAbs)},
                                {"unit", output.unit}};
    }
    Json json{{"role", experiment.role == Role::Fit ? "fit" : "validate"},
              {"error_percent", number(experiment.errorPercent)},
              {"outputs", outputs}};
    if (experiment.failure.failed) {
        json["failure"] = {{"time", number(experiment.failure.time)},
                           {"variable", experiment.failure.variable},
                           {"reason", experiment.failure.reason}};
        if (!experiment.failure.cause.empty()) json["failure"]["cause"] = experiment.failure.cause;
    }
    return json;
}

Json stateJson(const ModelState& state) {
    Json json{{"parameters", parametersJson(state)}};
    json["experiments"] = Json::object();
    for (const ExperimentState& experiment : state.experiments)
        json["experiments"][experiment.name] = experimentJson(experiment);
    json["residual"] = Json::object();
    for (const auto& [output, residual] : state.residual)
        json["residual"][output] = {{"noise_std", number(residual.noiseStd)},
                                    {"std", number(residual.standardDeviation)},
                                    {"autocorrelation_time", number(residual.autocorrelationTime)},
                                    {"white", residual.white}};
    if (state.simulations > 0)
        json["convergence"] = {{"status", statusWords(state.status)},
                               {"message", state.message},
                               {"simulations", state.simulations},
                               {"seconds", number(state.seconds)}};
    json["remarks"] = state.remarks;
    return json;
}

Json effectJson(const AddedEffect& effect) {
    Json parameters = Json::object();
    for (const EffectValue& parameter : effect.parameters)
        parameters[parameter.name] = {
            {"value", number(parameter.value)}, {"std", number(parameter.standardError)}, {"unit", parameter.unit}};
    Json alternatives = Json::array();
    for (const Alternative& other : effect.instead.effects)
        alternatives.push_back({{"kind", other.kind},
                                {"at", other.at},
                                {"delta_bic", number(other.deltaBic)},
                                {"equivalent", other.equivalent}});
    const Evidence& evidence = effect.evidence;
    Json json{{"kind", effect.kind},
              {"class", effect.className},
              {"way", name(effect.wired.way)},
              {"at", effect.at},
              {"instance", effect.wired.instance},
              {"description", effect.description},
              {"parameters", parameters},
              {"confidence", name(effect.confidence)},
              {"evidence",
               {{"score", number(evidence.score)},
                {"p_value", number(evidence.pValue)},
                {"delta_bic", number(evidence.deltaBic)},
                {"held_out", number(evidence.heldOut)},
                {"error_percent_before", number(evidence.errorPercentBefore)},
                {"error_percent_after", number(evidence.errorPercentAfter)}}},
              {"alternatives", alternatives},
              {"values_instead", std::vector<std::string>(effect.instead.values.begin(), effect.instead.values.end())}};
    if (!effect.wired.channel.empty()) json["channel"] = effect.wired.channel;
    if (effect.prediction)
        json["prediction"] = {{"error_percent_before", number(effect.prediction->errorPercentBefore)},
                              {"error_percent_after", number(effect.prediction->errorPercentAfter)},
                              {"blocks", effect.prediction->blocks},
                              {"better_in", effect.prediction->betterIn}};
    if (effect.prediction && effect.prediction->besideFlow)
        json["prediction"]["delta_bic_beside_flow"] = number(-*effect.prediction->besideFlow);
    return json;
}

Json candidateJson(const CandidateResult& candidate) {
    Json json{{"kind", candidate.kind},
              {"at", candidate.at},
              {"class", candidate.className},
              {"round", candidate.round},
              {"score", number(candidate.screening.score)},
              {"strength", number(candidate.screening.strength)},
              {"verdict", name(candidate.verdict == Verdict::Failed ? Verdict::NotSignificant : candidate.verdict)}};
    if (candidate.verdict != Verdict::Chosen) json["reason"] = verdictWords(candidate).english();
    if (candidate.verdict == Verdict::Failed) json["failure"] = candidate.failure;
    if (candidate.deltaBic) json["delta_bic"] = number(*candidate.deltaBic);
    if (!candidate.channel.empty()) json["channel"] = candidate.channel;
    if (candidate.verdict == Verdict::Absorbed) json["absorbed_by"] = candidate.screening.absorbedBy;
    return json;
}

Json remainderJson(const Remainder& remainder) {
    Json correlates = Json::array();
    for (const Correlate& correlate : remainder.movesWith)
        correlates.push_back({{"variable", correlate.variable}, {"correlation", number(correlate.correlation)}});
    return {{"output", remainder.output},
            {"node", remainder.node},
            {"equivalent_nodes", remainder.proposal.equalNodes},
            {"experiment", remainder.experiment},
            {"evidence", number(remainder.evidence)},
            {"from", number(remainder.from)},
            {"to", number(remainder.to)},
            {"moves_with", correlates},
            {"proposed_equation", remainder.proposal.equation},
            {"proposed_class", remainder.proposal.className},
            {"proposed_block", remainder.proposal.block},
            {"error_percent_with_proposal",
             {{"fit", number(remainder.proposal.errors.fit < 0 ? std::nan("") : remainder.proposal.errors.fit)},
              {"validate",
               number(remainder.proposal.errors.validate < 0 ? std::nan("") : remainder.proposal.errors.validate)},
              {"validate_without",
               number(remainder.proposal.errorValidateWithout < 0 ? std::nan("")
                                                                  : remainder.proposal.errorValidateWithout)}}}};
}

}  // namespace

std::string reportJson(const Finding& finding, const ReportContext& context) {
    Json json{{"format", "analogon-report-1"}};
    // A simulation or a plain fit asks no question that a finding would answer.
    json["finding"] = context.command == "discover" ? Json(name(finding.kind)) : Json(nullptr);
    json["title"] = context.title;
    json["program"] = {{"name", "Analogon"}, {"version", context.version}, {"command", context.command}};
    json["summary"] = summaryWords(finding, context.command);
    json["interrupted"] = finding.end.interrupted;
    json["seconds"] = number(finding.end.seconds);
    json["baseline"] = stateJson(finding.baseline);
    json["effects"] = Json::array();
    for (const AddedEffect& effect : finding.effects) json["effects"].push_back(effectJson(effect));
    json["candidates"] = Json::array();
    for (const CandidateResult& candidate : finding.candidates) json["candidates"].push_back(candidateJson(candidate));
    if (!finding.unexplained.remainders.empty()) {
        json["remainder"] = remainderJson(finding.unexplained.remainders.front());
        if (finding.unexplained.remainders.size() > 1) {
            json["remainders"] = Json::array();
            for (const Remainder& remainder : finding.unexplained.remainders)
                json["remainders"].push_back(remainderJson(remainder));
        }
    }
    if (finding.unexplained.disturbance)
        json["disturbance"] = {{"node", finding.unexplained.disturbance->node},
                               {"size", number(finding.unexplained.disturbance->size)},
                               {"unit", finding.unexplained.disturbance->unit},
                               {"time_constant", number(finding.unexplained.disturbance->timeConstant)}};
    if (finding.unexplained.proposed) json["with_proposals"] = stateJson(finding.unexplained.proposed->state);
    if (!finding.nextExperiment.empty()) json["next_experiment"] = finding.nextExperiment;
    json["warnings"] = finding.warnings;
    json["final"] = stateJson(finding.final.experiments.empty() ? finding.baseline : finding.final);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace analogon
