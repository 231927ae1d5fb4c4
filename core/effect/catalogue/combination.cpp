#include "core/effect/catalogue/combination.hpp"

#include <algorithm>
#include <set>

namespace analogon {
namespace {

bool isModified(const Block& component, const std::string& parameter) {
    return std::any_of(component.parameters.begin(), component.parameters.end(),
                       [&](const auto& modified) { return modified.first == parameter; });
}

/// The effects that specialise a component of this class.
std::vector<EffectClass> effectsOn(const Library& library, const LibraryClass& of, const Block& component) {
    std::vector<EffectClass> effects;
    if (std::optional<EffectClass> own = effectOf(library, of)) return {std::move(*own)};
    for (const std::string& name : combinedIn(of))
        if (const LibraryClass* c = library.find(name))
            if (std::optional<EffectClass> e = effectOf(library, *c);
                e && isModified(component, e->parameters.strength))
                effects.push_back(std::move(*e));
    return effects;
}

}  // namespace

std::string classWith(const Library& library, const Block& component, const EffectClass& effect) {
    const LibraryClass* of = library.find(component.className);
    if (of == nullptr) return {};
    const std::vector<EffectClass> there = effectsOn(library, *of, component);
    if (there.empty() && combinedIn(*of).empty()) return component.isEffect ? std::string() : effect.className;
    std::set<std::string> wanted{effect.className};
    for (const EffectClass& e : there) {
        // both join a node by one connector, or else the class would have to have two
        if (e.className == effect.className) return {};
        if (!e.placement.node.empty() && !effect.placement.node.empty() && e.placement.node != effect.placement.node)
            return {};
        wanted.insert(e.className);
    }
    for (const LibraryClass* c : library.classes()) {
        const std::vector<std::string> held = combinedIn(*c);
        const std::set<std::string> all(held.begin(), held.end());
        if (std::includes(all.begin(), all.end(), wanted.begin(), wanted.end())) return c->qualifiedName;
    }
    return {};
}

std::string nodePortOf(const Library& library, const Block& component) {
    const LibraryClass* of = library.find(component.className);
    if (of == nullptr) return {};
    for (const EffectClass& e : effectsOn(library, *of, component))
        if (!e.placement.node.empty()) return e.placement.node;
    return {};
}

}  // namespace analogon
