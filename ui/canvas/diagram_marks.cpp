#include <algorithm>

#include "ui/canvas/block_item.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/icon_painter.hpp"
#include "ui/canvas/wire_item.hpp"

/// Where the small marks of the blocks stand.
namespace analogon::ui {

namespace {

/// What a mark at a block must not cover: connectors, wires, other blocks, and what is written at any of them.
std::vector<QRectF> takenAround(const BlockItem& block, const std::map<std::string, BlockItem*>& blocks,
                                const std::vector<WireItem*>& wires) {
    std::vector<QRectF> taken = block.ports();
    constexpr double reach = 20;  // [diagram units]
    const QRectF near = block.body().adjusted(-reach, -reach, reach, reach);
    for (const auto& [name, other] : blocks) {
        if (!other->boundingRect().intersects(near)) continue;
        taken.push_back(other->labelRect());
        if (other != &block) taken.push_back(other->body());
    }
    constexpr double half = 0.7;  // [diagram units] of the width of a wire
    for (const WireItem* wire : wires)
        for (std::size_t i = 1; i < wire->wire().points.size(); ++i) {
            const QRectF piece = QRectF(toScene(wire->wire().points[i - 1]), toScene(wire->wire().points[i]))
                                     .normalized()
                                     .adjusted(-half, -half, half, half);
            if (piece.intersects(near)) taken.push_back(piece);
        }
    return taken;
}

}  // namespace

/// At the corner that is freest of what must be seen; with two of them, the upper ones are preferred.
void DiagramScene::placeMarks(const std::vector<BlockMark>& marks) {
    for (const auto& [name, item] : blocks_) {
        item->setRemarks({});
        for (QGraphicsItem* child : item->childItems())
            if (child->type() == MarkItem::Type) delete child;
    }
    constexpr double reading = 1.0;  // [px per diagram unit] for which a place is sought
    for (const auto& [name, item] : blocks_) {
        std::vector<QRectF> taken;
        QStringList remarks;
        for (const BlockMark& mark : marks) {
            if (mark.block != name) continue;
            remarks << mark.tip;
            if (item->isMarked() && mark.kind == MarkKind::Effect) continue;  // its label says so already
            if (taken.empty()) taken = takenAround(*item, blocks_, wires_);
            QPointF best;
            double bestCost = 1e300;
            const QRectF body = item->body();
            for (const QPointF at : {body.topRight(), body.topLeft(), body.bottomRight(), body.bottomLeft()}) {
                const QRectF rect = MarkItem::rectAt(reading).translated(at);
                double cost = 0;
                for (const QRectF& other : taken) {
                    const QRectF shared = other & rect;
                    if (!shared.isEmpty()) cost += 1 + shared.width() * shared.height();
                }
                if (cost >= bestCost) continue;
                bestCost = cost;
                best = at;
            }
            auto* shown = new MarkItem(mark.kind, mark.tip, item);
            shown->setPos(best);
            taken.push_back(MarkItem::rectAt(reading).translated(best));
        }
        item->setRemarks(remarks);
    }
}

}  // namespace analogon::ui
