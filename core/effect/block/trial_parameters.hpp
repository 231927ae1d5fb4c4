#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/effect/block/trial.hpp"

/// The parameters that a candidate's effect frees, and where a fit of them may begin.
namespace analogon {

/// Factor by which a shape may leave the values with which it is tried.
double reachOf(const EffectClass& effect, const std::string& shape);

/// Those of the newest effect of a variant (`wired`), as a probe of it offers them.
std::vector<FitParameter> freedParameters(const Screened& screened, const Probe& probe, const Variant& wired);

/// The starts that a screened candidate offers: every probe's estimate of the strength (0), and for traces taken at a
/// strength that strength itself, since what sets in at a threshold has no slope below it.
std::vector<std::pair<const Probe*, double>> startsOf(const Screened& screened);

/// What the probe that explains most once the noise is made white offers for the parameters of a trial's effect; empty:
/// none explains anything.
std::vector<ParameterValue> offeredByWhitened(const Trial& trial);

}  // namespace analogon
