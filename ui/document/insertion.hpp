#pragma once

#include <optional>

#include "core/diagram/diagram.hpp"
#include "ui/route/selection.hpp"

namespace analogon::ui {

/// What becomes of the wires when a block is led into a connection.
struct Insertion {
    std::vector<WireEnds> parted;  // these go
    std::vector<WireEnds> laid;    // these come
    WireEnds between;              // the two members that are parted; of several on one side, the first
};

/// How a block is led into the connection on whose wire its middle lies: two of its connectors are of the wire's kind,
/// nothing is connected to it, and it need not be part of the diagram yet. The wire says which two members are parted;
/// whatever else is connected with either of them stays with it. Where several wires of one node run over each other,
/// the picture shows one line: the end they share is parted from all their other ends. Connectors are chosen so that
/// the new wires are short; signals keep their direction. Nothing: it does not fit, or the two members stay connected
/// by other wires, which would bypass it.
std::optional<Insertion> insertionAt(const Diagram& diagram, const Block& block);

}  // namespace analogon::ui
