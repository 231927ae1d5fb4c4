#pragma once

#include <vector>

#include "core/effect/block/law_probe.hpp"

namespace analogon {

/// The quantities of the model that a law at a place may depend on, of which there are series: none that moves as the
/// place's own (`own`), and no angle of a shaft that turns on and on, for nothing depends on how often it has turned.
/// Temperatures as differences to `origin` [K], NaN: to their own first value.
std::vector<LawQuantity> foreignQuantities(const NamedUnits& others, const Series& values, const std::string& own,
                                           double origin);

/// Whether an angle passes enough for a wave along it to show.
bool showsWaves(const LawQuantity& angle);

/// Terms of a law at one of several places.
struct LikelyTerms {
    std::size_t probe{};  // of the place
    TermSet set;
};
/// Those for flows and those for sensors that explain most, best first.
std::vector<LikelyTerms> likeliestTerms(std::vector<LikelyTerms> ofFlows, std::vector<LikelyTerms> ofSensors);

/// Short laws that explain much of the residual to first order, for a flow that a node of the model lacks or for what a
/// sensor adds to its reading: single terms and the best pair of each place from powers, thresholds, waves and products
/// of the place's own quantities and of the inputs, states and outputs of the model. The coefficients carry the unit
/// that makes a term what is missing. What they are worth shows when they are fitted. Best first; the classes are
/// numbered on from `before`, the laws written already.
std::vector<Law> likelyLaws(const NullModel& null, int before, const SimulationOptions& simulation, int threads,
                            const Progress& progress);

}  // namespace analogon
