#include <algorithm>

#include "ui/canvas/block_item.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/icon_painter.hpp"
#include "ui/canvas/mark_item.hpp"
#include "ui/canvas/wire_item.hpp"

/// Where the names of the blocks stand.
namespace analogon::ui {

namespace {

constexpr std::size_t mostWithNames = 120;  // beyond that nobody reads them at once, and the search would be felt

}  // namespace

/// Names stand where they cover least: on the side the icon asks for, else on the other, else beside the middle.
void DiagramScene::placeLabels() {
    std::vector<QRectF> taken;
    for (const auto& [name, item] : blocks_) taken.push_back(item->body());
    if (blocks_.size() <= mostWithNames)
        for (const WireItem* wire : wires_)
            for (std::size_t i = 1; i < wire->wire().points.size(); ++i)
                taken.push_back(QRectF(toScene(wire->wire().points[i - 1]), toScene(wire->wire().points[i]))
                                    .normalized()
                                    .adjusted(-0.7, -0.7, 0.7, 0.7));
    if (blocks_.size() > mostWithNames) return;
    for (const auto& [name, item] : blocks_) {
        const BlockItem::LabelPlace preferred = item->preferredLabelPlace();
        BlockItem::LabelPlace best = preferred;
        double bestCost = 1e300;
        for (const int side : {0, 1, -1})
            for (const bool isAbove : {preferred.isAbove, !preferred.isAbove}) {
                const QRectF rect = item->labelRect({isAbove, side});
                double cost = (side != 0 ? 12 : 0) + (isAbove != preferred.isAbove ? 6 : 0);
                for (const QRectF& other : taken) {
                    const QRectF shared = other & rect;
                    if (!shared.isEmpty()) cost += 15 + shared.width() * shared.height();
                }
                if (cost >= bestCost) continue;
                bestCost = cost;
                best = {isAbove, side};
            }
        item->setLabelPlace(best);
        places_[name] = best;
        taken.push_back(item->labelRect(best));
    }
    keepNamesApart();
}

void DiagramScene::setReading(double zoom, const QFont& font) {
    if (zoom == zoom_ && font == font_) return;
    zoom_ = zoom;
    font_ = font;
    keepNamesApart();
}

/// What a name had better not cover at this zoom. [px]
std::vector<QRectF> DiagramScene::drawnAround(const QTransform& toView) const {
    std::vector<QRectF> drawn;
    for (const auto& [name, item] : blocks_) {
        drawn.push_back(toView.mapRect(item->body()));
        for (const QGraphicsItem* child : item->childItems())
            if (child->type() == MarkItem::Type)
                drawn.push_back(toView.mapRect(MarkItem::rectAt(toView.m11()).translated(child->pos())));
    }
    for (const WireItem* wire : wires_)
        for (std::size_t i = 1; i < wire->wire().points.size(); ++i)
            drawn.push_back(
                toView
                    .mapRect(QRectF(toScene(wire->wire().points[i - 1]), toScene(wire->wire().points[i])).normalized())
                    .adjusted(-1, -1, 1, 1));
    return drawn;
}

/// Names are as large where the blocks are near each other on the screen: one that would touch its neighbour's stands
/// to a side of its block, on the other edge of it or a line further away, so that two names are not read as one.
void DiagramScene::keepNamesApart() {
    constexpr double gap = 6;  // [px]
    if (zoom_ < BlockItem::leastZoomWithNames || blocks_.size() > mostWithNames) return;
    const QTransform toView = QTransform::fromScale(zoom_, zoom_);
    const std::vector<QRectF> drawn = drawnAround(toView);
    const auto touchesAny = [](const QRectF& rect, const std::vector<QRectF>& others) {
        return std::any_of(others.begin(), others.end(), [&](const QRectF& o) { return rect.intersects(o); });
    };
    std::vector<QRectF> taken;
    for (const auto& [name, item] : blocks_)
        if (item->isMarked()) taken.push_back(item->effectRect(toView));
    for (const Block& block : diagram_.blocks) {
        BlockItem* item = this->block(block.name);
        if (!item || item->isMarked()) continue;  // its label stands for the name
        const BlockItem::LabelPlace usual = places_[block.name];
        const bool above = usual.isAbove;
        std::optional<BlockItem::LabelPlace> best, second;
        for (const BlockItem::LabelPlace& place : {usual,
                                                   {above, -1, 0},
                                                   {above, 1, 0},
                                                   {above, 0, 0},
                                                   {!above, 0, 0},
                                                   {!above, -1, 0},
                                                   {!above, 1, 0},
                                                   {above, usual.side, 1},
                                                   {!above, 0, 1}}) {
            item->setLabelPlace(place);
            const QRectF rect = item->nameRect(toView, font_);
            if (touchesAny(rect.adjusted(-gap, 0, gap, 0), taken)) continue;
            if (!second) second = place;
            if (place != usual && touchesAny(rect, drawn)) continue;
            best = place;
            break;
        }
        item->setLabelPlace(best ? *best : second.value_or(usual));
        taken.push_back(item->nameRect(toView, font_));
    }
    update();
}

}  // namespace analogon::ui
