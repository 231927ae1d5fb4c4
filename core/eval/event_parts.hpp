#pragma once

#include "core/eval/system.hpp"
#include "core/structure/hybrid.hpp"

namespace analogon {

/// What runs a model with events: what decides at events, and the system between them, whose parameters are those of
/// the model and the slots, whose outputs are the readings and the outputs that are no slots.
struct EventParts {
    HybridModel model;  // with its signals kept
    SystemPtr between;
};

/// The system between events, whose parameters are the slots and `symbolic`.
Outcome<SystemPtr> systemBetween(const HybridModel& model, const std::vector<std::string>& symbolic = {});

/// A system of a model with events of its own (FlatModel::events has refusals); `symbolic`: parameters that may change.
/// `structure`: receives that of the model as seen from without.
Outcome<SystemPtr> buildWithEvents(const FlatModel& model, const std::vector<std::string>& symbolic,
                                   Structure& structure);

/// The structure of a model as seen from without, whether it has events of its own or not.
Outcome<Structure> structureSeen(FlatModel model, const std::vector<std::string>& symbolic);

}  // namespace analogon
