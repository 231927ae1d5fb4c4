#include "ui/document/insertion.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "ui/document/connector.hpp"
#include "ui/route/route.hpp"

namespace analogon::ui {

namespace {

constexpr double reach = 5;  // [diagram units] half a step of the grid: a block lies on a wire that runs between two

struct Hit {
    std::size_t wire{};
    double distance{};
    Point at;  // the point of the wire that is nearest
};

Point nearestOn(Point a, Point b, Point p) {
    const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    const double t = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
    return {a.x + t * dx, a.y + t * dy};
}

double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// Wires that pass a point, nearest first; of equal ones that first which is drawn over the others.
std::vector<Hit> wiresAt(const Diagram& diagram, Point middle) {
    std::vector<Hit> hits;
    for (std::size_t w = diagram.wires.size(); w-- > 0;) {
        const std::vector<Point>& points = diagram.wires[w].points;
        std::optional<Hit> nearest;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const Point at = nearestOn(points[i - 1], points[i], middle);
            if (const double d = distance(at, middle); d <= reach && (!nearest || d < nearest->distance))
                nearest = Hit{w, d, at};
        }
        if (nearest) hits.push_back(*nearest);
    }
    std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.distance < b.distance; });
    return hits;
}

/// All connectors that wires lead to from some of them, these included.
std::set<std::string> connectedWith(const Diagram& diagram, const std::set<std::size_t>& without,
                                    std::vector<std::string> from) {
    std::multimap<std::string, std::string> neighbours;
    for (std::size_t w = 0; w < diagram.wires.size(); ++w) {
        if (without.contains(w)) continue;
        neighbours.emplace(diagram.wires[w].from, diagram.wires[w].to);
        neighbours.emplace(diagram.wires[w].to, diagram.wires[w].from);
    }
    std::set<std::string> found(from.begin(), from.end());
    while (!from.empty()) {
        const auto [first, last] = neighbours.equal_range(from.back());
        from.pop_back();
        for (auto next = first; next != last; ++next)
            if (found.insert(next->second).second) from.push_back(next->second);
    }
    return found;
}

/// A line of the picture: one end, and those on its other side.
struct Line {
    std::set<std::size_t> wires;
    std::string end;
    std::vector<std::string> others;
};

std::string otherEnd(const Wire& wire, const std::string& end) { return wire.from == end ? wire.to : wire.from; }

Line lineOf(const Diagram& diagram, const std::vector<std::size_t>& wires) {
    const Wire& top = diagram.wires[wires.front()];
    for (const std::string& end : {top.from, top.to}) {
        const bool isShared = std::all_of(wires.begin(), wires.end(), [&](std::size_t w) {
            return diagram.wires[w].from == end || diagram.wires[w].to == end;
        });
        if (!isShared) continue;
        Line line{{wires.begin(), wires.end()}, end, {}};
        for (const std::size_t w : line.wires) line.others.push_back(otherEnd(diagram.wires[w], end));
        return line;
    }
    return {{wires.front()}, top.from, {top.to}};  // they share none: the one that is seen
}

/// The connectors of a block that take the sides of a line.
struct Ends {
    std::string first, second;
};

std::optional<Ends> endsFor(const Diagram& diagram, const Block& block, const Line& line,
                            const std::set<std::string>& side, const std::set<std::string>& otherSide) {
    const Domain domain = diagram.domain(line.end);
    const std::string kind = connectorClass(diagram, line.end);
    const auto hasSource = [&](const std::set<std::string>& members) {
        return std::any_of(members.begin(), members.end(), [&](const auto& c) { return isSource(diagram, c); });
    };
    const bool isFed = isSignal(domain) && hasSource(side);
    if (isSignal(domain) && !isFed && !hasSource(otherSide)) return std::nullopt;
    const auto fits = [&](const Port& port, bool isFirst) {
        if (isSignal(domain)) return port.domain == (isFirst == isFed ? Domain::RealInput : Domain::RealOutput);
        return port.domain == domain && (domain != Domain::Other || (!kind.empty() && port.className == kind));
    };
    Diagram alone;
    alone.blocks.push_back(block);
    const auto length = [&](const std::string& port, const std::string& end) {
        const auto a = alone.anchor(port), b = diagram.anchor(end);
        return a && b ? std::abs(a->x - b->x) + std::abs(a->y - b->y) : 0;
    };
    std::optional<Ends> best;
    double shortest = 0;
    for (const Port& first : block.ports)
        for (const Port& second : block.ports) {
            if (first.name == second.name || !fits(first, true) || !fits(second, false)) continue;
            const Ends ends{block.name + "." + first.name, block.name + "." + second.name};
            double sum = length(ends.first, line.end);
            for (const std::string& other : line.others) sum += length(ends.second, other);
            if (best && sum >= shortest) continue;
            best = ends;
            shortest = sum;
        }
    return best;
}

}  // namespace

std::optional<Insertion> insertionAt(const Diagram& diagram, const Block& block) {
    if (block.isConnector) return std::nullopt;
    for (const Wire& wire : diagram.wires)
        if (instanceOf(wire.from) == block.name || instanceOf(wire.to) == block.name) return std::nullopt;
    const auto [low, high] = boxOf(block.placement);
    const std::vector<Hit> hits = wiresAt(diagram, {(low.x + high.x) / 2, (low.y + high.y) / 2});
    std::set<std::size_t> tried;
    for (const Hit& hit : hits) {
        if (tried.contains(hit.wire)) continue;
        const Wire& top = diagram.wires[hit.wire];
        const std::set<std::string> node = connectedWith(diagram, {}, {top.from});
        std::vector<std::size_t> wires;
        for (const Hit& h : hits)
            if (node.contains(diagram.wires[h.wire].from) && distance(h.at, hit.at) < 0.1) wires.push_back(h.wire);
        tried.insert(wires.begin(), wires.end());

        const Line line = lineOf(diagram, wires);
        const std::set<std::string> side = connectedWith(diagram, line.wires, {line.end});
        const std::set<std::string> otherSide = connectedWith(diagram, line.wires, line.others);
        if (std::any_of(line.others.begin(), line.others.end(), [&](const auto& o) { return side.contains(o); }))
            continue;
        const std::optional<Ends> ends = endsFor(diagram, block, line, side, otherSide);
        if (!ends) continue;

        Insertion result;
        for (const std::size_t w : line.wires) result.parted.push_back({diagram.wires[w].from, diagram.wires[w].to});
        // In the text they stand as the parted ones did, from and to.
        if (top.from == line.end) {
            result.laid.push_back({line.end, ends->first});
            for (const std::string& other : line.others) result.laid.push_back({ends->second, other});
            result.between = {line.end, line.others.front()};
        } else {
            for (const std::string& other : line.others) result.laid.push_back({other, ends->second});
            result.laid.push_back({ends->first, line.end});
            result.between = {line.others.front(), line.end};
        }
        return result;
    }
    return std::nullopt;
}

}  // namespace analogon::ui
