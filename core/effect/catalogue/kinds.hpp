#pragma once

#include <string>
#include <vector>

#include "core/effect/catalogue/catalogue.hpp"

namespace analogon {

/// Names that are no kind of effect of the catalogue, each as a fault with the kind that is named alike, or all of
/// them.
Diagnostics unknownKinds(const std::vector<std::string>& names, const std::vector<EffectClass>& catalogue);

}  // namespace analogon
