#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/diagram/diagram.hpp"

namespace analogon::ui {

/// The same placement elsewhere.
Placement shifted(Placement p, double dx, double dy);

/// Blocks of a diagram on their way elsewhere, with the wires led after them: what is seen while they are dragged is
/// what is there when they are dropped.
class MovedBlocks {
public:
    MovedBlocks(Diagram before, std::set<std::string> names)
        : before_(std::move(before)), names_(std::move(names)), isLed_(before_.wires.size()) {}

    const std::set<std::string>& names() const { return names_; }
    /// By so much from where they were.
    Diagram at(double dx, double dy);

private:
    std::vector<Point> wayOf(std::size_t wire, const Diagram& after);

    Diagram before_;
    std::set<std::string> names_;
    std::vector<std::optional<bool>> isLed_;  // of each wire, by hand; none: not asked yet
};

/// Without what is only painted, so that it is cheap to copy while something is dragged.
Diagram withoutPictures(const Diagram& diagram);

}  // namespace analogon::ui
