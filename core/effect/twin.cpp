#include "core/effect/twin.hpp"

#include "core/effect/screen.hpp"

namespace analogon {
namespace {

/// Class of the block that a top-level output shows; effects in between are passed. Empty: none.
std::string sourceOf(const Diagram& diagram, const std::string& output) {
    std::string connector = output, cameFrom;
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
        // through the effect to what it takes its signal from
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
    if (placed.effect.signalSide != "output") return like;
    Outcome<Diagram> diagram = readDiagram(variant.task.library, variant.task.className);
    Outcome<std::vector<Candidate>> candidates = candidatesFor(variant, catalogue);
    if (!diagram || !candidates) return like;
    const std::string source = sourceOf(*diagram, placed.place.connector);
    if (source.empty()) return like;
    for (const Candidate& c : *candidates)
        if (c.effect.className == placed.effect.className && sourceOf(*diagram, c.place.connector) == source)
            like.push_back(c.place);
    return like;
}

}  // namespace analogon
