#include "core/eval/event_parts.hpp"

namespace analogon {

Outcome<SystemPtr> buildWithEvents(const FlatModel& model, const std::vector<std::string>& symbolic,
                                   Structure& structure) {
    Outcome<HybridModel> hybrid = partition(model, Signals::Kept, symbolic);
    if (!hybrid) return hybrid.diagnostics();
    const auto withSlots = [&](const std::vector<std::string>& slots) {
        StructureOptions options{symbolic};
        options.keep.insert(options.keep.end(), slots.begin(), slots.end());
        return options;
    };
    const Outcome<Structure> inner = analyse(hybrid->continuous, withSlots(hybrid->slots));
    if (!inner) return inner.diagnostics();
    const Outcome<SystemPtr> between = System::build(*inner);
    if (!between) return between.diagnostics();
    Outcome<Structure> outer = analyse(hybrid->outside, withSlots(hybrid->outsideSlots));
    if (!outer) return outer.diagnostics();
    structure = std::move(*outer);
    auto parts = std::make_shared<EventParts>(EventParts{std::move(*hybrid), *between});
    return System::build(structure, std::move(parts));
}

Outcome<Structure> structureSeen(FlatModel model, const std::vector<std::string>& symbolic) {
    StructureOptions options{symbolic};
    if (model.events.refusals.empty()) return analyse(std::make_shared<FlatModel>(std::move(model)), options);
    const Outcome<HybridModel> hybrid = partition(model, Signals::Kept, symbolic);
    if (!hybrid) return hybrid.diagnostics();
    options.keep.insert(options.keep.end(), hybrid->outsideSlots.begin(), hybrid->outsideSlots.end());
    return analyse(hybrid->outside, options);
}

}  // namespace analogon
