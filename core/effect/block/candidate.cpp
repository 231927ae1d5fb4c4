#include "core/effect/block/candidate.hpp"

#include "core/base/unit.hpp"
#include "core/eval/event_parts.hpp"
#include "core/fit/clock.hpp"
#include "core/flat/parameter_change.hpp"

namespace analogon {
namespace {

/// The effect with the units of its parameters that depend on the signal it is at.
EffectClass inUnitsOf(const std::string& signal, EffectClass effect) {
    if (signal.empty()) return effect;
    for (const std::string& name : effect.parameters.inSignalUnit) effect.parameters.units[name] = signal;
    const std::string rate = signal.find('/') == std::string::npos ? signal + "/s" : "(" + signal + ")/s";
    for (const std::string& name : effect.parameters.inSignalRate) effect.parameters.units[name] = rate;
    return effect;
}

/// Whether an effect or another class of its kind stands at a place: one kind has several classes where something of it
/// may be known or not.
bool isThere(const Variant& variant, const EffectClass& e, const EffectPlace& p) {
    return std::any_of(variant.effects.begin(), variant.effects.end(), [&](const PlacedEffect& x) {
        const bool isSame = x.effect.className == e.className || (x.effect.kind == e.kind && e.proposal.empty());
        return isSame && (x.place == p || std::find(x.twins.begin(), x.twins.end(), p) != x.twins.end());
    });
}

/// Whether a place belongs to an effect that was added. An input that an effect brought in is a recorded channel, no
/// actuator; a proposal is taken out again at the end, and nothing may hang on its connectors.
bool isOfEffect(const Variant& variant, const EffectPlace& p) {
    return std::any_of(variant.effects.begin(), variant.effects.end(), [&](const PlacedEffect& x) {
        return (!x.newInput.empty() && p.connector == x.newInput) ||
               (!x.effect.proposal.empty() && p.connector.starts_with(x.instance + "."));
    });
}

/// The recorded channels that an effect may take up.
std::vector<std::string> sparesFor(const EffectClass& effect, const Variant& variant, const ModelNodes& nodes) {
    std::vector<std::string> names;
    if (effect.placement.channel.empty()) return names;
    const auto first = std::find_if(variant.task.recordings.begin(), variant.task.recordings.end(),
                                    [](const Recording& r) { return r.role == Role::Fit && !r.spares.empty(); });
    if (first != variant.task.recordings.end())
        for (const SpareChannel& s : first->spares)
            if (effect.placement.quantity.empty() || areConvertible(s.unit, effect.placement.quantity))
                names.push_back(s.name);
    if (effect.placement.orInput)
        for (std::string& input : nodes.inputsIn(effect.placement.quantity)) names.push_back(std::move(input));
    return names;
}

}  // namespace

Outcome<ModelNodes> nodesOf(const Variant& variant, Diagram& diagram) {
    Outcome<FlatModel> flat = flatten(variant.task.library, variant.task.className);
    if (!flat) return flat.diagnostics();
    StructureOptions options;
    for (const ParameterValue& v : variant.values)
        if (!isClock(v.name)) options.keep.push_back(v.name);
    flat = withStarts(std::move(*flat), options.keep);
    if (!flat) return flat.diagnostics();
    Outcome<Structure> structure = structureSeen(std::move(*flat), options.keep);
    if (!structure) return structure.diagnostics();
    Outcome<Diagram> read = readDiagram(variant.task.library, variant.task.className);
    if (!read) return read.diagnostics();
    diagram = std::move(*read);
    return ModelNodes(variant.task.library, diagram, *structure);
}

Outcome<std::vector<Candidate>> candidatesFor(const Variant& variant, const std::vector<EffectClass>& catalogue) {
    Diagram diagram;
    Outcome<ModelNodes> nodes = nodesOf(variant, diagram);
    if (!nodes) return nodes.diagnostics();
    std::vector<Candidate> candidates;
    for (const EffectClass& e : catalogue)
        for (const EffectPlace& p : nodes->placesFor(e, sparesFor(e, variant, *nodes)))
            if (!isThere(variant, e, p) && !isOfEffect(variant, p))
                candidates.push_back({inUnitsOf(nodes->unitAt(p), e), p});
    return candidates;
}

}  // namespace analogon
