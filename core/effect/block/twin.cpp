#include "core/effect/block/twin.hpp"

#include "core/effect/block/screen.hpp"

namespace analogon {
namespace {

/// Class of the block that a top-level output shows or an input feeds; effects in between are passed. Empty: none.
std::string blockBehind(const Diagram& diagram, const std::string& signal) {
    std::string connector = signal, cameFrom;
    for (std::size_t steps = 0; steps < diagram.blocks.size(); ++steps) {
        const Block* next = nullptr;
        for (const Wire& w : diagram.wires) {
            if (w.from != connector && w.to != connector) continue;
            const std::string& other = w.from == connector ? w.to : w.from;
            const Block* block = diagram.find(other.substr(0, other.find('.')));
            if (block != nullptr && block->name != cameFrom) next = block;
        }
        if (next == nullptr) return {};
        if (!next->isEffect) return next->className;
        // through the effect to its other side
        std::string onward;
        for (const Wire& w : diagram.wires)
            for (const std::string& end : {w.from, w.to})
                if (end != connector && end.substr(0, end.find('.')) == next->name &&
                    (w.from == end ? w.to : w.from) != connector)
                    onward = end;
        if (onward.empty()) return {};
        connector = onward;
        cameFrom = next->name;
    }
    return {};
}

}  // namespace

std::vector<EffectPlace> likePlaces(const Variant& variant, const PlacedEffect& placed,
                                    const std::vector<EffectClass>& catalogue) {
    std::vector<EffectPlace> like;
    if (placed.effect.placement.signalSide.empty()) return like;
    Diagram diagram;
    const Outcome<ModelNodes> nodes = nodesOf(variant, diagram);
    const Outcome<std::vector<Candidate>> candidates = candidatesFor(variant, catalogue);
    if (!nodes || !candidates) return like;
    const std::string behind = blockBehind(diagram, placed.place.connector);
    if (behind.empty()) return like;
    for (const Candidate& c : *candidates)
        if (c.effect.className == placed.effect.className && blockBehind(diagram, c.place.connector) == behind &&
            nodes->unitAt(c.place) == nodes->unitAt(placed.place))
            like.push_back(c.place);
    return like;
}

}  // namespace analogon
