#include "core/effect/tell/added_effects.hpp"

#include <algorithm>
#include <cmath>

#include "core/effect/judge/judgement.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/tell/proposed_value.hpp"

namespace analogon {
namespace {

AddedEffect describe(const NullModel& last, const ModelState& state, const PlacedEffect& placed, const Step& step) {
    AddedEffect effect;
    effect.kind = placed.effect.kind;
    effect.className = placed.effect.className;
    effect.description = placed.effect.description;
    effect.at = placed.place.at;
    effect.wired.way = placed.effect.placement.way;
    effect.wired.instance = placed.instance;
    effect.wired.newInput = placed.newInput;
    effect.wired.channel = placed.place.spare;
    // an interrupted search may have a state of before the last refit
    const std::string& strength = placed.freed.front().name;
    const bool isInState = std::any_of(state.parameters.begin(), state.parameters.end(),
                                       [&](const FitEstimate& e) { return e.name == strength; });
    for (const FitParameter& p : placed.freed)
        for (const FitEstimate& e : isInState ? state.parameters : last.fit.estimates)
            if (e.name == p.name)
                effect.parameters.push_back(
                    {p.name.substr(placed.instance.size() + 1), e.value, e.standardError, e.unit});
    for (const auto& [name, value] : placed.values) {
        const auto unit = placed.effect.parameters.units.find(name);
        effect.parameters.push_back(
            {name, value, std::nan(""), unit == placed.effect.parameters.units.end() ? "" : unit->second});
    }
    effect.evidence.score = step.acceptance.explained;
    effect.evidence.pValue = pValue(step.acceptance.explained, static_cast<int>(placed.freed.size()), step.tried);
    effect.evidence.deltaBic = -step.acceptance.evidence;
    effect.evidence.heldOut = step.acceptance.heldOut;
    effect.confidence = step.prediction ? Confidence::Indicated : Confidence::Established;
    effect.prediction = step.prediction;
    // what stands in the model as well is no other explanation, nor is another class of it; and each is named once
    for (const Alternative& a : step.alternatives)
        if (!stands(last.variant, a.kind, a.at) &&
            std::none_of(effect.instead.effects.begin(), effect.instead.effects.end(),
                         [&](const Alternative& b) { return b.kind == a.kind && b.at == a.at; }))
            effect.instead.effects.push_back({a.kind, a.at, effect.evidence.deltaBic + a.deltaBic, a.equivalent});
    return effect;
}

/// Where an effect stands as well, with the same parameters.
void addTwins(Finding& finding, const PlacedEffect& placed, AddedEffect effect) {
    for (std::size_t t = 0; t < placed.twins.size(); ++t) {
        effect.at = placed.twins[t].at;
        effect.wired.instance = placed.twinInstances[t];
        effect.instead.effects.clear();
        finding.effects.push_back(effect);
        finding.warnings.push_back(
            placed.effect.placement.signalSide == "output"
                ? phrase("{} stands at {} and {} with one set of parameters: equal sensors, and the data do not "
                         "tell them apart",
                         effect.kind, placed.place.at, effect.at)
                : phrase("{} stands at {} and {} with one set of parameters: they feed equal blocks, and the data "
                         "do not tell them apart",
                         effect.kind, placed.place.at, effect.at));
    }
}

}  // namespace

std::vector<Text> addEffects(Finding& finding, const Node& node, const HeldValues& held, const FlatModel* valued,
                             double errorAfter) {
    std::vector<Text> heldRemarks;
    for (std::size_t i = 0; i < node.steps.size() && i < node.null.variant.effects.size(); ++i) {
        const PlacedEffect& placed = node.null.variant.effects[i];
        AddedEffect effect = describe(node.null, finding.final, placed, node.steps[i]);
        if (valued) addOtherParameters(*valued, placed, effect.parameters);
        // what the model is without this effect, and with it; the others are there in both
        effect.evidence.errorPercentBefore =
            node.steps[i].errorWithout >= 0 ? node.steps[i].errorWithout : errorPercentOf(finding.baseline, Role::Fit);
        effect.evidence.errorPercentAfter = errorAfter >= 0 ? errorAfter : errorPercentOf(finding.final, Role::Fit);
        if (const auto values = held.find(node.steps[i].order); values != held.end())
            for (const HeldInstead& h : values->second) {
                effect.instead.values.push_back(h.text());
                heldRemarks.push_back(remarkOf(h, effect.kind, effect.at));
            }
        finding.effects.push_back(effect);
        addTwins(finding, placed, std::move(effect));
    }
    return heldRemarks;
}

}  // namespace analogon
