#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/effect/model/variant.hpp"

namespace analogon {

/// An effect at a place.
struct Candidate {
    EffectClass effect;
    EffectPlace place;
};

/// The nodes of a variant. `diagram` receives its drawing, which they refer to.
Outcome<ModelNodes> nodesOf(const Variant& variant, Diagram& diagram);

/// Sorts items by how many parts of the model meet at their connectors, the most first; else they keep their order.
template <class Item, class ConnectorOf>
void mostPartsFirst(const Variant& variant, std::vector<Item>& items, const ConnectorOf& connectorOf) {
    if (items.size() < 2) return;
    Diagram diagram;
    if (const Outcome<ModelNodes> nodes = nodesOf(variant, diagram))
        std::stable_sort(items.begin(), items.end(), [&](const Item& a, const Item& b) {
            return nodes->blocksAt(connectorOf(a)) > nodes->blocksAt(connectorOf(b));
        });
}

/// Every effect of the catalogue at every place where it fits.
Outcome<std::vector<Candidate>> candidatesFor(const Variant& variant, const std::vector<EffectClass>& catalogue);

}  // namespace analogon
