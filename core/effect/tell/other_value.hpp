#pragma once

#include "core/effect/model/model_state.hpp"
#include "core/effect/model/variant.hpp"

/// A validation recording that a model misses, and the one parameter that would have to be another there.
namespace analogon {

/// For each validation recording that the model misses (missedRecordings(), the first six): where one fitted parameter
/// with another value accounts for most of the miss, that value, and which others do nearly as well. The component, or
/// what is around it and was not recorded (a fan, a load), is another there. The parameter is fitted to that recording
/// alone, all others stand at the values of `state`. `variant`: the model that `state` is of, with all its recordings.
std::vector<Text> otherValues(const Variant& variant, const ModelState& state, const FitOptions& options,
                              const Progress& progress);

}  // namespace analogon
