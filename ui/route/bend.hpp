#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/diagram/diagram.hpp"

namespace analogon::ui {

/// The piece of an orthogonal way (0: the first) that passes within `reach` of a point, the nearest of several;
/// nothing: none does.
std::optional<std::size_t> pieceAt(const std::vector<Point>& way, Point at, double reach);

/// Pieces that run along an axis alone, and at least one.
bool isOrthogonal(const std::vector<Point>& way);

/// The way with one piece moved by `by` at right angles to itself. Its ends stay: the first and the last piece leave
/// straight ahead before they bend.
std::vector<Point> bent(const std::vector<Point>& way, std::size_t piece, double by);

/// The same way between other ends, its first and last pieces made longer or shorter; empty: it cannot be kept, as it
/// would turn back on itself or has no corner.
std::vector<Point> stretched(const std::vector<Point>& way, Point from, Point to);

/// Whether a wire runs otherwise than the program would lead it: by hand.
bool isLedByHand(const Diagram& diagram, const Wire& wire);

/// The way of a wire that was led by hand, whose ends stand elsewhere `after`; empty: it is to be led anew, as it would
/// turn back on itself or come to cross a block.
std::vector<Point> keptWay(const Wire& wire, const Diagram& before, const Diagram& after);

}  // namespace analogon::ui
