#pragma once

#include <string>
#include <vector>

#include "core/diagram/diagram.hpp"

namespace analogon {

/// A block of the later diagram that is an effect, or was changed by one, and what the legend calls it.
struct DiagramMark {
    std::string block;
    std::string words;

    friend bool operator==(const DiagramMark&, const DiagramMark&) = default;
};

/// The diagram of a model without the effects that were added, and with them.
struct DiagramPair {
    Diagram before, after;
    std::vector<DiagramMark> marks;
};

/// Both as inline SVG from their annotations, with the marked blocks outlined and named in a legend. Icons stand once
/// in the page, whatever the number of blocks that have them. `style`: what the page must know to show them.
std::string diagramsHtml(const DiagramPair& pair);
const char* diagramStyle();

/// A file of its own, without CSS of a page, as large as it is drawn on A4.
struct DiagramDrawing {
    std::string svg;
    double width{}, height{};  // [px] of 96 in an inch
};
struct DiagramDrawings {
    DiagramDrawing before, after;
    bool areBeside{};  // there is room for the one beside the other
};
DiagramDrawings diagramDrawings(const DiagramPair& pair);

}  // namespace analogon
