#pragma once

#include <vector>

#include "core/effect/catalogue/catalogue.hpp"
#include "core/effect/model/variant.hpp"

namespace analogon {

/// Where an effect of one signal may stand as well: at the other outputs of its unit that a sensor of the same class
/// feeds, the other inputs that feed a block of the same class. Empty for effects that belong to no signal.
std::vector<EffectPlace> likePlaces(const Variant& variant, const PlacedEffect& placed,
                                    const std::vector<EffectClass>& catalogue);

}  // namespace analogon
