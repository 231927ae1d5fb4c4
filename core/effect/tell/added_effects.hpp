#pragma once

#include <map>
#include <vector>

#include "core/effect/course/held_parameter.hpp"
#include "core/effect/judge/node.hpp"

namespace analogon {

using HeldValues = std::map<int, std::vector<HeldInstead>>;  // by the choice of the effect they imitate

/// Adds the effects of a node to what is found of it, with the parameters that `valued` (the model's equations with
/// their values; null: not at hand) knows beside those that were fitted. `errorAfter`: of the fitted data with them
/// [%]; negative: that of the final model. Returns what else their values may be.
std::vector<Text> addEffects(Finding& finding, const Node& node, const HeldValues& held, const FlatModel* valued,
                             double errorAfter);

}  // namespace analogon
