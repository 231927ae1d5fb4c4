#include "core/effect/model/variant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

#include "core/base/unit.hpp"
#include "core/diagram/edit.hpp"
#include "core/fit/clock.hpp"
#include "core/fit/held_value.hpp"
#include "core/flat/flat_model.hpp"
#include "core/syntax/printer.hpp"

namespace analogon {
namespace {

const LibraryClass* modelOf(const EstimationTask& task) { return task.library.find(task.className); }

/// The task with another text of its model.
Outcome<EstimationTask> withText(const EstimationTask& task, std::string text) {
    EstimationTask changed = task;
    changed.model = std::make_shared<Source>(task.model->name(), std::move(text));
    Outcome<Library> library = task.library.withSource(changed.model);
    if (!library) return library.diagnostics();
    changed.library = std::move(*library);
    return changed;
}

/// Lets a recorded but unused channel drive a new top-level input of that unit (empty: of the channel's own).
void connectSpare(EstimationTask& task, const std::string& spare, const std::string& input, const std::string& unit) {
    for (Recording& r : task.recordings.edit()) {
        const auto channel =
            std::find_if(r.spares.begin(), r.spares.end(), [&](const SpareChannel& s) { return s.name == spare; });
        if (channel == r.spares.end()) continue;
        Eigen::VectorXd values =
            Eigen::Map<const Eigen::VectorXd>(channel->values.data(), static_cast<Eigen::Index>(r.time.size()));
        const Outcome<UnitConversion> conversion = convertUnit(channel->unit, unit);
        if (!unit.empty() && conversion) values = values.unaryExpr(*conversion);
        r.addInput(input, values);
    }
}

/// Wires the newest effect in at one more place, with the parameters it has at its first.
Outcome<Done> addTwin(Variant& variant, const EffectPlace& place) {
    PlacedEffect& placed = variant.effects.back();
    std::map<std::string, std::string> same = placed.effect.bound;
    for (const FitParameter& p : placed.freed) same[p.name.substr(placed.instance.size() + 1)] = p.name;
    for (const auto& [name, value] : placed.values) same[name] = placed.instance + "." + name;
    Outcome<WiredEffect> wired =
        wireIn(variant.task.library, *modelOf(variant.task)->definition, placed.effect, place, {}, same);
    if (!wired) return wired.diagnostics();
    Outcome<EstimationTask> task = withText(variant.task, syntax::apply(variant.task.model->text(), wired->edit).text);
    if (!task) return task.diagnostics();
    variant.task = std::move(*task);
    placed.twins.push_back(place);
    placed.twinInstances.push_back(wired->instance);
    return Done{};
}

}  // namespace

bool drawSharper(PlacedEffect& placed) {
    bool changes = false;
    for (const auto& [name, factor] : placed.effect.trial.sharper)
        if (const auto value = placed.values.find(name); value != placed.values.end()) {
            value->second *= factor;
            changes = true;
        }
    return changes;
}

std::set<std::string> keysOf(const std::vector<PlacedEffect>& effects) {
    std::set<std::string> keys;
    for (const PlacedEffect& e : effects) {
        keys.insert(keyOf(e.effect, e.place));
        for (const EffectPlace& twin : e.twins) keys.insert(keyOf(e.effect, twin));
    }
    return keys;
}

bool stands(const Variant& variant, std::string_view kind, std::string_view at) {
    return std::any_of(variant.effects.begin(), variant.effects.end(),
                       [&](const PlacedEffect& e) { return e.effect.kind == kind && e.place.at == at; });
}

std::vector<int> recordingsOf(const EstimationTask& task, Role role) {
    std::vector<int> indices;
    for (std::size_t i = 0; i < task.recordings.size(); ++i)
        if (task.recordings[i].role == role) indices.push_back(static_cast<int>(i));
    return indices;
}

const Recording& fittedRecording(const EstimationTask& task, int experiment) {
    return task
        .recordings[static_cast<std::size_t>(recordingsOf(task, Role::Fit)[static_cast<std::size_t>(experiment)])];
}

Outcome<Variant> withEffect(const Variant& variant, const EffectClass& effect, const EffectPlace& place,
                            const std::map<std::string, double>& values) {
    const LibraryClass* model = modelOf(variant.task);
    if (model == nullptr) return error(phrase("unknown class '{}'", variant.task.className));
    Outcome<WiredEffect> wired = wireIn(variant.task.library, *model->definition, effect, place, values, effect.bound);
    if (!wired) return wired.diagnostics();
    Outcome<EstimationTask> task = withText(variant.task, syntax::apply(variant.task.model->text(), wired->edit).text);
    if (!task) return task.diagnostics();
    Variant changed{std::move(*task), variant.effects, variant.values, variant.plans};
    if (!wired->newInput.empty()) connectSpare(changed.task, place.spare, wired->newInput, effect.placement.quantity);
    changed.effects.push_back({effect, place, wired->instance, wired->newInput, {}, values});
    return changed;
}

Outcome<Variant> withEffectsBeside(const Variant& variant, const std::vector<EffectClass>& effects,
                                   const std::vector<EffectPlace>& places) {
    const LibraryClass* model = modelOf(variant.task);
    if (model == nullptr) return error(phrase("unknown class '{}'", variant.task.className));
    Outcome<WiredBeside> wired = wireInBeside(variant.task.library, *model->definition, effects.front(), places);
    if (!wired) return wired.diagnostics();
    Outcome<EstimationTask> task = withText(variant.task, syntax::apply(variant.task.model->text(), wired->edit).text);
    if (!task) return task.diagnostics();
    Variant changed{std::move(*task), variant.effects, variant.values, variant.plans};
    for (std::size_t i = 0; i < places.size(); ++i)
        changed.effects.push_back({effects[i], places[i], wired->instances[i], {}, {}, {}});
    return changed;
}

Outcome<Variant> withEffects(const Variant& base, const std::vector<PlacedEffect>& effects,
                             const std::vector<ParameterValue>& values) {
    Variant variant = base;
    // values of effects that are not in this variant belong to nothing
    variant.values = values;
    std::erase_if(variant.values, [&](const ParameterValue& v) {
        return v.experiment < 0 && std::none_of(base.task.parameters.begin(), base.task.parameters.end(),
                                                [&](const FitParameter& p) { return p.name == v.name; });
    });
    std::set<std::string> taken;  // an effect that stood aside may be called as another one is now
    for (const PlacedEffect& e : effects) {
        Outcome<Variant> wider = withEffect(variant, e.effect, e.place, e.values);
        if (!wider) return wider;
        variant = std::move(*wider);
        PlacedEffect& placed = variant.effects.back();
        // an instance may be named otherwise than before: its parameters and their values follow it
        for (FitParameter p : e.freed) {
            const std::string before = p.name;
            p.name = placed.instance + before.substr(e.instance.size());
            if (taken.insert(before).second)
                for (const ParameterValue& v : values)
                    if (v.name == before) variant.values.push_back({p.name, v.experiment, v.value});
            placed.freed.push_back(p);
            variant.task.parameters.push_back(std::move(p));
        }
        for (const EffectPlace& twin : e.twins)
            if (Outcome<Done> added = addTwin(variant, twin); !added) return added.diagnostics();
    }
    return variant;
}

Outcome<PreparedTask> prepareAt(const Variant& variant, const std::vector<Eigen::VectorXd>& noise, Role role) {
    std::vector<std::string> kept;
    for (const ParameterValue& v : variant.values)
        if (!isClock(v.name)) kept.push_back(v.name);
    Outcome<PreparedTask> prepared = prepare(variant.task, noise, role, kept);
    if (!prepared) return prepared;
    if (role == Role::Fit) prepared->problem.knownPlans = variant.plans;
    for (const ParameterValue& v : variant.values)
        for (FitParameter& p : prepared->problem.parameters)
            if (p.name == v.name && (p.experiment < 0 || (role == Role::Fit && p.experiment == v.experiment)))
                p.start = v.value;
    return prepared;
}

namespace {

/// Clocks that are fitted stay where the variant has them. What lies beyond their bounds is left out all the same, so
/// that residuals compare row by row.
void holdClocks(EstimationTask& task, const Variant& variant) {
    for (const FitParameter& p : variant.task.parameters) {
        if (!isClock(p.name)) continue;
        for (Recording& r : task.recordings.edit())
            for (RecordingClock& clock : r.clocks) {
                if (clockOf(clock.output) != p.name) continue;
                blankBeyond(r, clock.output, p.min, p.max);
                for (const ParameterValue& v : variant.values)
                    if (v.name == p.name) clock.offset = v.value;
            }
    }
}

}  // namespace

Outcome<PreparedTask> prepareHeld(const Variant& variant, const std::vector<FitParameter>& free,
                                  const std::vector<Eigen::VectorXd>& noise, const std::vector<std::string>& alsoKeep) {
    EstimationTask task = variant.task;
    task.parameters = free;
    const auto isFree = [&](const std::string& name) {
        return std::any_of(free.begin(), free.end(), [&](const FitParameter& p) { return p.name == name; });
    };
    std::vector<std::string> kept = alsoKeep;
    for (const ParameterValue& v : variant.values)
        if (v.experiment < 0 && !isFree(v.name) && !isClock(v.name)) kept.push_back(v.name);
    holdClocks(task, variant);
    const std::vector<int> fitted = recordingsOf(task, Role::Fit);
    for (std::size_t e = 0; e < fitted.size(); ++e) {
        if (task.recordings[static_cast<std::size_t>(fitted[e])].starts.empty()) continue;
        for (RecordingStart& s : task.recordings.edit()[static_cast<std::size_t>(fitted[e])].starts) {
            s.isFitted = false;
            for (const ParameterValue& v : variant.values)
                if (v.experiment == static_cast<int>(e) && v.name == s.parameter) s.value = v.value;
        }
    }
    Outcome<PreparedTask> prepared = prepare(task, noise, Role::Fit, kept);
    if (!prepared) return prepared;
    prepared->problem.knownPlans = variant.plans;
    for (const ParameterValue& v : variant.values) {
        if (v.experiment < 0) setParameter(prepared->problem, v.name, v.value);
    }
    return prepared;
}

std::vector<ParameterValue> valuesOf(const FitResult& result) {
    std::vector<ParameterValue> values;
    for (const FitEstimate& e : result.estimates) values.push_back({e.name, e.experiment, e.value});
    return values;
}

namespace {

/// What is looked up belongs to one system; the steps serve others like it.
std::vector<GridPlan> withoutTerms(std::vector<GridPlan> plans) {
    for (GridPlan& plan : plans) plan.terms.reset();
    return plans;
}

}  // namespace

std::vector<GridPlan> stepsOf(const FitResult& result) { return withoutTerms(result.plans); }

std::vector<GridPlan> stepsOf(const Linearisation& taken) {
    std::vector<GridPlan> plans;
    for (const Trajectory& t : taken.trajectories) plans.push_back(t.plan);
    return withoutTerms(std::move(plans));
}

Outcome<std::string> textWithValues(const Variant& variant) {
    const LibraryClass* model = modelOf(variant.task);
    if (model == nullptr) return error(phrase("unknown class '{}'", variant.task.className));
    ModelEdit edit(*model->definition, nullptr, &variant.task.library);
    const bool setsElements = std::any_of(variant.values.begin(), variant.values.end(), [](const ParameterValue& v) {
        return v.experiment < 0 && v.name.find('[') != std::string::npos;
    });
    if (setsElements) {
        Outcome<FlatModel> flat = flatten(variant.task.library, variant.task.className);
        if (!flat) return flat.diagnostics();
        edit.valuesOf([flat = std::make_shared<const FlatModel>(std::move(*flat))](const std::string& name) {
            const VariableId id = flat->find(name);
            const std::optional<double> value = id.valid() ? flat->parameterValue(id) : std::nullopt;
            return value ? std::optional(syntax::printNumber(*value)) : std::nullopt;
        });
    }
    for (const ParameterValue& v : variant.values)
        if (v.experiment < 0 && !isClock(v.name)) edit.setParameter(v.name, syntax::printNumber(v.value));
    Outcome<syntax::TextEdit> text = edit.finish("Write fitted values");
    if (!text) return text.diagnostics();
    return syntax::apply(variant.task.model->text(), std::move(*text)).text;
}

bool hasEffect(const std::vector<PlacedEffect>& effects, const PlacedEffect& effect) {
    const std::string key = keyOf(effect.effect, effect.place);
    return std::any_of(effects.begin(), effects.end(),
                       [&](const PlacedEffect& e) { return keyOf(e.effect, e.place) == key; });
}

}  // namespace analogon
