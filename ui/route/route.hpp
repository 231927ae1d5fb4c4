#pragma once

#include "core/diagram/diagram.hpp"

namespace analogon::ui {

/// An orthogonal way between two connectors of a diagram that leaves each block straight away from its side. Of the
/// ways with up to two bends between the stubs it takes the one with the least length, bends, blocks crossed and pieces
/// that lie on other wires. Fewer than two points: a connector is unknown.
std::vector<Point> routeWire(const Diagram& diagram, const std::string& from, const std::string& to);

/// The same to a free point, as while a wire is being drawn.
std::vector<Point> routeTo(const Diagram& diagram, const std::string& from, Point to);

/// Without repeated points and without corners on a straight line.
std::vector<Point> simplified(const std::vector<Point>& points);

/// Corners of a block in the diagram, lower left and upper right.
std::pair<Point, Point> boxOf(const Placement& placement);

/// "motor" of "motor.flange" or "motor[2].flange".
std::string instanceOf(const std::string& connector);

}  // namespace analogon::ui
