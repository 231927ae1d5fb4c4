#include "ui/route/route.hpp"

#include <algorithm>
#include <cmath>

namespace analogon::ui {

namespace {

constexpr double stub = 10;  // [diagram units] a wire runs straight before its first bend

struct Box {
    Point low, high;
};

bool crosses(Point a, Point b, const Box& box) {
    return std::min(a.x, b.x) < box.high.x && std::max(a.x, b.x) > box.low.x && std::min(a.y, b.y) < box.high.y &&
           std::max(a.y, b.y) > box.low.y;
}

/// Blocks a little smaller than they are: a wire may run along an edge and end on it.
std::vector<Box> obstacles(const Diagram& diagram) {
    std::vector<Box> boxes;
    boxes.reserve(diagram.blocks.size());
    for (const Block& block : diagram.blocks) {
        const auto [low, high] = boxOf(block.placement);
        boxes.push_back({{low.x + 1, low.y + 1}, {high.x - 1, high.y - 1}});
    }
    return boxes;
}

/// A way that turns back on itself runs over its own first piece.
bool turnsBack(const std::vector<Point>& way) {
    for (std::size_t i = 2; i < way.size(); ++i) {
        const Point a{way[i - 1].x - way[i - 2].x, way[i - 1].y - way[i - 2].y};
        const Point b{way[i].x - way[i - 1].x, way[i].y - way[i - 1].y};
        if (a.x * b.x + a.y * b.y < 0) return true;
    }
    return false;
}

/// Length that two pieces of wire share.
double overlap(Point a, Point b, Point c, Point d) {
    const auto shared = [](double p, double q, double r, double s) {
        return std::max(0.0, std::min(std::max(p, q), std::max(r, s)) - std::max(std::min(p, q), std::min(r, s)));
    };
    if (a.x == b.x && c.x == d.x && a.x == c.x) return shared(a.y, b.y, c.y, d.y);
    if (a.y == b.y && c.y == d.y && a.y == c.y) return shared(a.x, b.x, c.x, d.x);
    return 0;
}

/// Whether a point lies within the rectangle of two others.
bool isBetween(Point p, Point a, Point b) {
    return p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
           p.y <= std::max(a.y, b.y);
}

/// Whether two pieces at right angles meet where one of them ends: where both turn there, one would not see which goes
/// where. That they cross is no harm.
bool meet(Point a, Point b, Point c, Point d) {
    if ((a.x == b.x) == (c.x == d.x)) return false;
    return isBetween(a, c, d) || isBetween(b, c, d) || isBetween(c, a, b) || isBetween(d, a, b);
}

/// Pieces of wires that belong to other nodes: a wire on top of them could not be told apart.
using Pieces = std::vector<std::pair<Point, Point>>;

Pieces otherWires(const Diagram& diagram, const std::string& from, const std::string& to) {
    Pieces pieces;
    constexpr std::size_t most = 200;  // beyond that the search would be felt
    if (diagram.wires.size() > most) return pieces;
    for (const Wire& wire : diagram.wires) {
        const bool isOfNode = wire.from == from || wire.from == to || wire.to == from || wire.to == to;
        if (isOfNode) continue;
        for (std::size_t i = 1; i < wire.points.size(); ++i) pieces.emplace_back(wire.points[i - 1], wire.points[i]);
    }
    return pieces;
}

double costOf(const std::vector<Point>& way, const std::vector<Box>& boxes, const Pieces& pieces) {
    double cost = 12.0 * static_cast<double>(way.size());
    for (std::size_t i = 1; i < way.size(); ++i) {
        cost += std::abs(way[i].x - way[i - 1].x) + std::abs(way[i].y - way[i - 1].y);
        for (const Box& box : boxes)
            if (crosses(way[i - 1], way[i], box)) cost += 150;
        for (const auto& [a, b] : pieces) {
            cost += 4 * overlap(way[i - 1], way[i], a, b);
            if (meet(way[i - 1], way[i], a, b)) cost += 8;  // twice at a corner
        }
    }
    return turnsBack(way) ? cost + 400 : cost;
}

/// What none of the ways can touch is left out of their costs: the same way is the best.
void keepWithin(const Box& region, std::vector<Box>& boxes, Pieces& pieces) {
    const auto isApart = [&](Point a, Point b) {
        return std::max(a.x, b.x) < region.low.x || std::min(a.x, b.x) > region.high.x ||
               std::max(a.y, b.y) < region.low.y || std::min(a.y, b.y) > region.high.y;
    };
    std::erase_if(boxes, [&](const Box& box) { return isApart(box.low, box.high); });
    std::erase_if(pieces, [&](const auto& piece) { return isApart(piece.first, piece.second); });
}

Box regionOf(const std::vector<std::vector<Point>>& ways) {
    Box region{{1e300, 1e300}, {-1e300, -1e300}};
    for (const std::vector<Point>& way : ways)
        for (const Point p : way) {
            region.low = {std::min(region.low.x, p.x), std::min(region.low.y, p.y)};
            region.high = {std::max(region.high.x, p.x), std::max(region.high.y, p.y)};
        }
    return region;
}

double snapped(double value) { return std::round(value / 5) * 5; }

std::vector<Point> bestWay(Point a, Point da, Point b, Point db, std::vector<Box> boxes, Pieces pieces) {
    const Point p{a.x + stub * da.x, a.y + stub * da.y}, q{b.x + stub * db.x, b.y + stub * db.y};
    std::vector<std::vector<Point>> ways{{a, p, {q.x, p.y}, q, b}, {a, p, {p.x, q.y}, q, b}};
    std::vector<double> across{snapped((a.x + b.x) / 2)}, along{snapped((a.y + b.y) / 2)};
    for (const double off : {-20.0, -10.0, 10.0, 20.0}) {
        for (const Point end : {p, q}) {
            across.push_back(end.x + off);
            along.push_back(end.y + off);
        }
        across.push_back(off < 0 ? std::min(p.x, q.x) - 30 : std::max(p.x, q.x) + 30);
        along.push_back(off < 0 ? std::min(p.y, q.y) - 30 : std::max(p.y, q.y) + 30);
    }
    for (const double x : across) ways.push_back({a, p, {x, p.y}, {x, q.y}, q, b});
    for (const double y : along) ways.push_back({a, p, {p.x, y}, {q.x, y}, q, b});
    keepWithin(regionOf(ways), boxes, pieces);
    std::vector<Point> best;
    double bestCost = 1e300;
    for (const std::vector<Point>& way : ways) {
        std::vector<Point> plain = simplified(way);
        const double cost = costOf(plain, boxes, pieces);
        if (cost < bestCost) {
            bestCost = cost;
            best = std::move(plain);
        }
    }
    return best;
}

}  // namespace

std::pair<Point, Point> boxOf(const Placement& placement) {
    const Extent unit{{-1, -1}, {1, 1}};
    Point low{1e300, 1e300}, high{-1e300, -1e300};
    for (const Point corner : {Point{-1, -1}, Point{1, -1}, Point{1, 1}, Point{-1, 1}}) {
        const Point p = map(placement, unit, corner);
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return {low, high};
}

std::string instanceOf(const std::string& connector) { return connector.substr(0, connector.find_first_of(".[")); }

std::vector<Point> simplified(const std::vector<Point>& points) {
    std::vector<Point> result;
    for (const Point p : points) {
        if (!result.empty() && result.back() == p) continue;
        const std::size_t n = result.size();
        if (n >= 2) {
            const Point a = result[n - 2], b = result[n - 1];
            const bool isStraight = (a.x == b.x && b.x == p.x && (b.y - a.y) * (p.y - b.y) >= 0) ||
                                    (a.y == b.y && b.y == p.y && (b.x - a.x) * (p.x - b.x) >= 0);
            if (isStraight) result.pop_back();
        }
        result.push_back(p);
    }
    if (result.size() == 1) result.push_back(result.front());
    return result;
}

std::vector<Point> routeWire(const Diagram& diagram, const std::string& from, const std::string& to) {
    const auto a = diagram.anchor(from), b = diagram.anchor(to);
    if (!a || !b) return {};
    return bestWay(*a, diagram.direction(from), *b, diagram.direction(to), obstacles(diagram),
                   otherWires(diagram, from, to));
}

std::vector<Point> routeTo(const Diagram& diagram, const std::string& from, Point to) {
    const auto a = diagram.anchor(from);
    if (!a) return {};
    return bestWay(*a, diagram.direction(from), to, {}, obstacles(diagram), otherWires(diagram, from, from));
}

}  // namespace analogon::ui
