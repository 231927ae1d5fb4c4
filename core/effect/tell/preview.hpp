#pragma once

#include "core/base/progress.hpp"
#include "core/effect/catalogue/finding.hpp"
#include "core/fit/fit.hpp"

namespace analogon {

/// The model with this one effect, both refitted for a first look: a few iterations from its best start, and nothing is
/// asked of evidence. Fails where the effect has no such place, or changes nothing there.
Outcome<ModelState> stateWith(const EstimationTask& task, const EffectChoice& choice, const FitOptions& options,
                              const Progress& progress = {});

}  // namespace analogon
