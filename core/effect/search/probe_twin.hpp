#pragma once

#include "core/effect/block/screen.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using threshold::rounds::twinCorrelation;

/// Whether any probe of a candidate promises the same as this one: one direction each, and that alike.
bool isTwin(const Probe& probe, const Screened& candidate);

}  // namespace analogon
