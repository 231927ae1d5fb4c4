#include "core/eval/event_parts.hpp"

namespace analogon {

namespace {

/// What stays a parameter: what is asked for, and what events set.
StructureOptions withSlots(const std::vector<std::string>& symbolic, const std::vector<std::string>& slots) {
    StructureOptions options{symbolic};
    options.keep.insert(options.keep.end(), slots.begin(), slots.end());
    return options;
}

}  // namespace

Outcome<SystemPtr> systemBetween(const HybridModel& model, const std::vector<std::string>& symbolic) {
    const Outcome<Structure> structure = analyse(model.continuous, withSlots(symbolic, model.slots));
    if (!structure) return structure.diagnostics();
    return System::build(*structure);
}

Outcome<SystemPtr> buildWithEvents(const FlatModel& model, const std::vector<std::string>& symbolic,
                                   Structure& structure) {
    Outcome<HybridModel> hybrid = partition(model, Signals::Kept, symbolic);
    if (!hybrid) return hybrid.diagnostics();
    const Outcome<SystemPtr> between = systemBetween(*hybrid, symbolic);
    if (!between) return between.diagnostics();
    Outcome<Structure> outer = analyse(hybrid->outside, withSlots(symbolic, hybrid->outsideSlots));
    if (!outer) return outer.diagnostics();
    structure = std::move(*outer);
    auto parts = std::make_shared<EventParts>(EventParts{std::move(*hybrid), *between});
    return System::build(structure, std::move(parts));
}

Outcome<Structure> structureSeen(FlatModel model, const std::vector<std::string>& symbolic) {
    if (model.events.refusals.empty())
        return analyse(std::make_shared<FlatModel>(std::move(model)), StructureOptions{symbolic});
    const Outcome<HybridModel> hybrid = partition(model, Signals::Kept, symbolic);
    if (!hybrid) return hybrid.diagnostics();
    return analyse(hybrid->outside, withSlots(symbolic, hybrid->outsideSlots));
}

}  // namespace analogon
