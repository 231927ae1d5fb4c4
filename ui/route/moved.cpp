#include "ui/route/moved.hpp"

#include "ui/route/bend.hpp"
#include "ui/route/route.hpp"

namespace analogon::ui {

Placement shifted(Placement p, double dx, double dy) {
    if (p.origin == Point{}) {
        p.extent = {{p.extent.p1.x + dx, p.extent.p1.y + dy}, {p.extent.p2.x + dx, p.extent.p2.y + dy}};
    } else {
        p.origin = {p.origin.x + dx, p.origin.y + dy};
    }
    return p;
}

Diagram MovedBlocks::at(double dx, double dy) {
    Diagram after = before_;
    for (Block& block : after.blocks)
        if (names_.contains(block.name)) block.placement = shifted(block.placement, dx, dy);
    for (std::size_t i = 0; i < after.wires.size(); ++i) {
        Wire& wire = after.wires[i];
        const bool first = names_.contains(instanceOf(wire.from)), last = names_.contains(instanceOf(wire.to));
        if (first && last) {
            for (Point& p : wire.points) p = {p.x + dx, p.y + dy};
        } else if (first || last) {
            if (std::vector<Point> way = wayOf(i, after); way.size() >= 2) wire.points = std::move(way);
        }
    }
    return after;
}

std::vector<Point> MovedBlocks::wayOf(std::size_t wire, const Diagram& after) {
    const Wire& was = before_.wires[wire];
    if (!isLed_[wire]) isLed_[wire] = isLedByHand(before_, was);
    std::vector<Point> way;
    if (*isLed_[wire]) way = keptWay(was, before_, after);
    return way.empty() ? routeWire(after, was.from, was.to) : way;
}

Diagram withoutPictures(const Diagram& diagram) {
    Diagram light;
    light.className = diagram.className;
    light.wires = diagram.wires;
    for (const Block& block : diagram.blocks) {
        Block& bare = light.blocks.emplace_back();
        bare.name = block.name;
        bare.placement = block.placement;
        bare.icon.coordinates = block.icon.coordinates;
        bare.isConnector = block.isConnector;
        bare.domain = block.domain;
        for (const Port& port : block.ports) {
            Port& connector = bare.ports.emplace_back(port);
            connector.icon.primitives.clear();
        }
    }
    return light;
}

}  // namespace analogon::ui
