#pragma once

#include "core/diagram/edit.hpp"
#include "core/study/run.hpp"
#include "ui/document/document.hpp"

namespace analogon::ui {

/// A made-up finding for a study that is open and simulated: an effect is attached to a connector, and the traces
/// after it lie closer to the measured ones. For tests of the panels, which must not depend on what a search finds.
inline RunResult sampleFinding(const Document& document, const std::string& kind, const std::string& className,
                               const std::string& description, const std::string& connector, const std::string& port,
                               const std::string& strength) {
    RunResult result;
    Finding& finding = result.finding;
    finding.kind = FindingKind::Effect;
    finding.baseline = *document.before();
    finding.final = finding.baseline;
    for (ExperimentState& e : finding.final.experiments) {
        e.errorPercent *= 0.12;
        for (OutputState& o : e.outputs) {
            o.simulated = 0.12 * o.simulated + 0.88 * o.measured;
            o.figures.errorPercent *= 0.12;
        }
    }
    for (const auto& [name, setting] : document.study().parameters) {
        FitEstimate estimate;
        estimate.name = name;
        estimate.value = document.parameterValue(name).value_or(1) * 1.07;
        estimate.standardError = 0.01 * estimate.value;
        finding.final.parameters.push_back(estimate);
    }
    if (!finding.final.parameters.empty()) {
        FitEstimate& last = finding.final.parameters.back();
        last.atBound = true;
        last.value = document.study().parameters.at(last.name).max.value_or(last.value);
    }

    const std::string instance = freeName(*document.definition(), kind.substr(kind.find('.') + 1));
    const Point at = document.diagram().anchor(connector).value_or(Point{});
    ModelEdit edit(*document.definition(), &document.diagram(), &document.library());
    edit.addComponent({className,
                       instance,
                       {{strength, "0.0021"}},
                       "",
                       freePlacement(document.diagram(), {at.x, at.y - 30}, 20, 20)});
    edit.addConnection(connector, instance + "." + port, {}, domainColour(document.diagram().domain(connector)));
    const auto change = edit.finish("add");
    result.completed = document.study();
    std::string& text = result.completed.models[result.completed.modelFile];
    if (change) text = syntax::apply(text, *change).text;
    finding.final.modelText = text;

    AddedEffect effect;
    effect.kind = kind;
    effect.className = className;
    effect.at = connector;
    effect.wired.instance = instance;
    effect.description = description;
    effect.parameters = {{strength, 0.0021, 3.1e-5, "N.m"}};
    effect.evidence = {812.0,
                       0,
                       -1540,
                       0.93,
                       finding.baseline.experiments.front().errorPercent,
                       finding.final.experiments.front().errorPercent};
    effect.instead.effects = {{"actuator.deadzone", "input v_cmd", -610, false},
                              {"voltage.drop", "motor", -1538, true}};
    finding.effects = {effect};

    const auto candidate = [&](const char* what, const char* where, double score, std::optional<double> bic,
                               Verdict verdict) {
        CandidateResult c;
        c.kind = what;
        c.at = where;
        c.screening.score = score;
        c.deltaBic = bic;
        c.verdict = verdict;
        if (verdict == Verdict::Absorbed) c.screening.absorbedBy = {"motor.k"};
        finding.candidates.push_back(c);
    };
    candidate(kind.c_str(), connector.c_str(), 812, -1540.2, Verdict::Chosen);
    candidate("voltage.drop", "motor", 801, -1538.7, Verdict::Equivalent);
    candidate("actuator.deadzone", "input v_cmd", 640, -610.4, Verdict::Weaker);
    candidate("torque.constant", connector.c_str(), 210, -120, Verdict::FailsHeldOut);
    candidate("sensor.lag", "output w_pump", 3.2, std::nullopt, Verdict::NotSignificant);
    candidate("inertia.added", connector.c_str(), 0, std::nullopt, Verdict::Absorbed);
    return result;
}

}  // namespace analogon::ui
