#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/effect/model/place.hpp"
#include "core/effect/model/wire_in.hpp"

namespace analogon {

/// The value of a fitted parameter; experiment >= 0: a start value of that experiment alone (index among the
/// experiments that are fitted).
struct ParameterValue {
    std::string name;
    int experiment{-1};
    double value{};
};

/// An effect in a model.
struct PlacedEffect {
    EffectClass effect;
    EffectPlace place;
    std::string instance;
    std::string newInput;                  // top-level input that carries place.spare
    std::vector<FitParameter> freed;       // its fitted parameters (full names), the strength first
    std::map<std::string, double> values;  // of its own parameters, at the time it was wired in
    std::vector<EffectPlace> twins{};      // where it stands as well, with the same parameters
    std::vector<std::string> twinInstances{};
};

/// A model with effects wired in and the values at which it stands.
struct Variant {
    EstimationTask task;
    std::vector<PlacedEffect> effects;
    std::vector<ParameterValue> values;
    /// Steps that served the model or one near it, one a fitted recording; empty: none are known.
    std::vector<GridPlan> plans{};
};

/// Draws what the effect rounds off for the sake of the integration sharper by one step; false: it rounds nothing off.
bool drawSharper(PlacedEffect& placed);

/// keyOf() of each, wherever it stands.
std::set<std::string> keysOf(const std::vector<PlacedEffect>& effects);

/// Whether an effect of that kind, of whatever class, stands at that place.
bool stands(const Variant& variant, std::string_view kind, std::string_view at);

/// Indices of the recordings with a role, in order.
std::vector<int> recordingsOf(const EstimationTask& task, Role role);

/// The recording of a fitted experiment, by its number among them.
const Recording& fittedRecording(const EstimationTask& task, int experiment);

/// The variant with one more effect; its parameters are not yet among the fitted ones.
Outcome<Variant> withEffect(const Variant& variant, const EffectClass& effect, const EffectPlace& place,
                            const std::map<std::string, double>& values);

/// The variant with one effect more at each of these places, all switched off, to be simulated and never shown: in
/// components and at their connectors, driven by no recorded channel. `effects` and `places`: of one class, one for
/// each place.
Outcome<Variant> withEffectsBeside(const Variant& variant, const std::vector<EffectClass>& effects,
                                   const std::vector<EffectPlace>& places);

/// The model as given (`base`) with these effects wired in anew, one after the other; their freed parameters are
/// fitted, and everything stands at `values` where they name it.
Outcome<Variant> withEffects(const Variant& base, const std::vector<PlacedEffect>& effects,
                             const std::vector<ParameterValue>& values);

/// The fit of a variant: a problem with the variant's values as its start.
Outcome<PreparedTask> prepareAt(const Variant& variant, const std::vector<Eigen::VectorXd>& noise,
                                Role role = Role::Fit);

/// The same with all fitted parameters held at the variant's values and `free` alone as parameters.
Outcome<PreparedTask> prepareHeld(const Variant& variant, const std::vector<FitParameter>& free,
                                  const std::vector<Eigen::VectorXd>& noise,
                                  const std::vector<std::string>& alsoKeep = {});

/// Whether an effect of the same class at the same place is among these.
bool hasEffect(const std::vector<PlacedEffect>& effects, const PlacedEffect& effect);

/// Values of a fit result.
std::vector<ParameterValue> valuesOf(const FitResult& result);

/// The steps of its plans alone, without what belongs to the system that was fitted: that may be gone.
std::vector<GridPlan> stepsOf(const FitResult& result);
std::vector<GridPlan> stepsOf(const Linearisation& taken);

/// The model text with all values written in as modifications.
Outcome<std::string> textWithValues(const Variant& variant);

}  // namespace analogon
