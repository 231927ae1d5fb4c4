#pragma once

#include <string>
#include <vector>

namespace analogon::ui {

/// A wire by its ends.
struct WireEnds {
    std::string from, to;
    friend bool operator==(const WireEnds&, const WireEnds&) = default;
};

/// What is selected in the diagram.
struct DiagramSelection {
    std::vector<std::string> blocks;  // in the order in which they were selected
    std::vector<WireEnds> wires;
    bool isEmpty() const { return blocks.empty() && wires.empty(); }
    friend bool operator==(const DiagramSelection&, const DiagramSelection&) = default;
};

}  // namespace analogon::ui
