#pragma once

#include <vector>

#include "core/effect/catalogue.hpp"
#include "core/effect/variant.hpp"

namespace analogon {

/// Where an effect of one sensor may stand as well: at the other outputs that are fed by a sensor of the same class.
/// Empty for effects that belong to no sensor.
std::vector<EffectPlace> likePlaces(const Variant& variant, const PlacedEffect& placed,
                                    const std::vector<EffectClass>& catalogue);

}  // namespace analogon
