#include <algorithm>

#include "ui/canvas/block_item.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/icon_painter.hpp"
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

/// Names are as large where the blocks are near each other on the screen: one that would touch its neighbour's stands
/// further from its block, where it covers no other one, and two names are not read as one.
void DiagramScene::keepNamesApart() {
    constexpr double gap = 6;     // [px]
    constexpr int mostLines = 2;  // further away it would be taken for the name of something else
    if (zoom_ < BlockItem::leastZoomWithNames || blocks_.size() > mostWithNames) return;
    const QTransform toView = QTransform::fromScale(zoom_, zoom_);
    std::vector<QRectF> taken;
    for (const auto& [name, item] : blocks_)
        if (item->isMarked()) taken.push_back(item->effectRect(toView));
    for (const Block& block : diagram_.blocks) {
        BlockItem* item = this->block(block.name);
        if (!item || item->isMarked()) continue;  // its label stands for the name
        const auto isFree = [&](int lines) {
            item->setLinesAway(lines);
            const QRectF name = item->nameRect(toView, font_), wide = name.adjusted(-gap, 0, gap, 0);
            if (std::any_of(taken.begin(), taken.end(), [&](const QRectF& t) { return wide.intersects(t); }))
                return false;
            return lines == 0 || std::none_of(blocks_.begin(), blocks_.end(), [&](const auto& other) {
                       return toView.mapRect(other.second->body()).intersects(name);
                   });
        };
        int lines = 0;
        while (lines <= mostLines && !isFree(lines)) ++lines;
        item->setLinesAway(lines <= mostLines ? lines : 0);  // else nothing is gained
        taken.push_back(item->nameRect(toView, font_));
    }
    update();
}

}  // namespace analogon::ui
