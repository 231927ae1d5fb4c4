#include "ui/route/bend.hpp"

#include <algorithm>
#include <cmath>

#include "ui/route/route.hpp"

namespace analogon::ui {

namespace {

double distanceFromPiece(Point at, Point a, Point b) {
    const double x = std::clamp(at.x, std::min(a.x, b.x), std::max(a.x, b.x));
    const double y = std::clamp(at.y, std::min(a.y, b.y), std::max(a.y, b.y));
    return std::hypot(at.x - x, at.y - y);
}

/// How far the first or last piece runs straight before it bends.
double stubOf(Point a, Point b) {
    constexpr double stub = 10;  // [diagram units]
    const double length = std::abs(b.x - a.x) + std::abs(b.y - a.y);
    return length >= 4 * stub ? stub : length / 4;
}

Point towards(Point a, Point b, double by) {
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    return {a.x + by * (b.x - a.x) / length, a.y + by * (b.y - a.y) / length};
}

bool isTurned(Point a, Point b, Point c, Point d) {  // the piece ab has become cd
    return (b.x - a.x) * (d.x - c.x) + (b.y - a.y) * (d.y - c.y) <= 0;
}

/// It may run along an edge, and end on it.
bool crossesBlock(const Diagram& diagram, const std::vector<Point>& way) {
    constexpr double edge = 1;  // [diagram units]
    return std::any_of(diagram.blocks.begin(), diagram.blocks.end(), [&](const Block& block) {
        const auto [low, high] = boxOf(block.placement);
        for (std::size_t i = 1; i < way.size(); ++i)
            if (std::min(way[i - 1].x, way[i].x) < high.x - edge && std::max(way[i - 1].x, way[i].x) > low.x + edge &&
                std::min(way[i - 1].y, way[i].y) < high.y - edge && std::max(way[i - 1].y, way[i].y) > low.y + edge)
                return true;
        return false;
    });
}

}  // namespace

bool isOrthogonal(const std::vector<Point>& way) {
    for (std::size_t i = 1; i < way.size(); ++i)
        if ((way[i].x == way[i - 1].x) == (way[i].y == way[i - 1].y)) return false;
    return way.size() >= 2;
}

std::optional<std::size_t> pieceAt(const std::vector<Point>& way, Point at, double reach) {
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        const double away = distanceFromPiece(at, way[i], way[i + 1]);
        if (away > reach) continue;
        reach = away;
        nearest = i;
    }
    return nearest;
}

std::vector<Point> bent(const std::vector<Point>& way, std::size_t piece, double by) {
    if (!isOrthogonal(way) || piece + 1 >= way.size() || by == 0) return way;
    const Point a = way[piece], b = way[piece + 1];
    const bool isLevel = a.y == b.y;
    const auto moved = [&](Point p) { return isLevel ? Point{p.x, p.y + by} : Point{p.x + by, p.y}; };
    std::vector<Point> result(way.begin(), way.begin() + static_cast<std::ptrdiff_t>(piece));
    Point first = a, last = b;
    if (piece == 0) {
        first = towards(a, b, stubOf(a, b));
        result.insert(result.end(), {a, first});
    }
    if (piece + 2 == way.size()) last = towards(b, a, stubOf(a, b));
    result.insert(result.end(), {moved(first), moved(last)});
    if (piece + 2 == way.size()) result.insert(result.end(), {last, b});
    result.insert(result.end(), way.begin() + static_cast<std::ptrdiff_t>(piece) + 2, way.end());
    return simplified(result);
}

std::vector<Point> stretched(const std::vector<Point>& way, Point from, Point to) {
    if (way.size() < 3 || !isOrthogonal(way)) return {};
    std::vector<Point> result = way;
    const std::size_t n = way.size();
    result.front() = from;
    result.back() = to;
    (way[0].y == way[1].y ? result[1].y : result[1].x) = way[0].y == way[1].y ? from.y : from.x;
    (way[n - 1].y == way[n - 2].y ? result[n - 2].y : result[n - 2].x) = way[n - 1].y == way[n - 2].y ? to.y : to.x;
    if (!isOrthogonal(result) || isTurned(way[0], way[1], result[0], result[1]) ||
        isTurned(way[n - 2], way[n - 1], result[n - 2], result[n - 1]))
        return {};
    return result;
}

bool isLedByHand(const Diagram& diagram, const Wire& wire) {
    const std::vector<Point> way = simplified(wire.points);
    const auto from = diagram.anchor(wire.from), to = diagram.anchor(wire.to);
    if (!from || !to || !isOrthogonal(way)) return false;
    const auto asRead = route(*from, diagram.direction(wire.from), *to, diagram.direction(wire.to));
    return way != simplified(asRead) && way != routeWire(diagram, wire.from, wire.to);
}

std::vector<Point> keptWay(const Wire& wire, const Diagram& before, const Diagram& after) {
    const auto from = after.anchor(wire.from), to = after.anchor(wire.to);
    if (!from || !to) return {};
    const std::vector<Point> was = simplified(wire.points);
    std::vector<Point> way = stretched(was, *from, *to);
    if (way.empty()) return {};
    return crossesBlock(after, way) && !crossesBlock(before, was) ? std::vector<Point>() : way;
}

}  // namespace analogon::ui
