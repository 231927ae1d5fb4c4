#include "ui/canvas/diagram_scene.hpp"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/canvas/block_item.hpp"
#include "ui/canvas/icon_painter.hpp"
#include "ui/canvas/wire_item.hpp"

namespace analogon::ui {

namespace {

/// The graphics of the Diagram annotation itself, behind the blocks.
class GraphicsItem : public QGraphicsItem {
public:
    explicit GraphicsItem(std::vector<Primitive> primitives) : primitives_(std::move(primitives)) {
        flip_.scale(1, -1);
        setZValue(-1);
        setAcceptedMouseButtons(Qt::NoButton);
    }
    QRectF boundingRect() const override { return boundsOf(primitives_, flip_).adjusted(-2, -2, 2, 2); }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget* widget) override {
        painter->setRenderHint(QPainter::Antialiasing);
        paintPrimitives(
            *painter, primitives_, flip_, [](const QString& name) { return name; },
            widget ? widget->palette() : QPalette());
    }

private:
    std::vector<Primitive> primitives_;
    QTransform flip_;
};

bool isOnSegment(Point p, Point a, Point b) {
    const double cross = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length == 0 || std::abs(cross) > 0.1 * length) return false;
    const double along = ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / length;
    return along > 0.5 && along < length - 0.5;
}

/// Corners of a wire that lie on another wire of the same node.
std::vector<QPointF> junctions(const Wire& wire, const std::vector<Wire>& wires) {
    std::vector<QPointF> result;
    for (const Wire& other : wires) {
        if (&other == &wire) continue;
        const bool isSameNode =
            other.from == wire.from || other.from == wire.to || other.to == wire.from || other.to == wire.to;
        if (!isSameNode) continue;
        for (const Point p : wire.points)
            for (std::size_t i = 1; i < other.points.size(); ++i)
                if (isOnSegment(p, other.points[i - 1], other.points[i])) result.push_back(toScene(p));
    }
    return result;
}

/// A wire whose drawn ends miss the ports (an icon was changed since) is led on to them.
void reachAnchors(Wire& wire, const Diagram& diagram) {
    if (wire.points.size() < 2) return;
    const auto reach = [](std::vector<Point>& points, std::optional<Point> anchor) {
        constexpr double tolerance = 0.5;
        if (!anchor) return;
        Point& first = points[0];
        const Point second = points[1];
        if (std::hypot(first.x - anchor->x, first.y - anchor->y) < tolerance) return;
        const bool isHorizontal = std::abs(first.y - second.y) < tolerance;
        const bool isVertical = std::abs(first.x - second.x) < tolerance;
        const bool slides = (isHorizontal && std::abs(anchor->y - second.y) < tolerance) ||
                            (isVertical && std::abs(anchor->x - second.x) < tolerance);
        if (slides) {
            first = *anchor;
        } else if (points.size() > 2) {  // the first segment moves along, the second grows
            points[1] = isHorizontal ? Point{second.x, anchor->y} : Point{anchor->x, second.y};
            first = *anchor;
        } else {
            const Point corner =
                isHorizontal ? Point{(first.x + second.x) / 2, anchor->y} : Point{anchor->x, (first.y + second.y) / 2};
            const Point onward = isHorizontal ? Point{corner.x, second.y} : Point{second.x, corner.y};
            points = {*anchor, corner, onward, second};
        }
    };
    reach(wire.points, diagram.anchor(wire.from));
    std::vector<Point> backward(wire.points.rbegin(), wire.points.rend());
    reach(backward, diagram.anchor(wire.to));
    wire.points.assign(backward.rbegin(), backward.rend());
}

}  // namespace

/// Whether a label under the block would cover neither a block nor a wire.
bool DiagramScene::hasRoomBelow(const BlockItem& item) const {
    const QRectF body = item.body();
    const QRectF label(body.center().x() - 20, body.bottom() + 3, 40, 12);
    const bool coversBlock = std::any_of(blocks_.begin(), blocks_.end(), [&](const auto& other) {
        return other.second != &item && other.second->body().intersects(label);
    });
    const bool coversWire = std::any_of(wires_.begin(), wires_.end(), [&](const WireItem* wire) {
        const auto& points = wire->wire().points;
        for (std::size_t i = 1; i < points.size(); ++i)
            if (QRectF(toScene(points[i - 1]), toScene(points[i]))
                    .normalized()
                    .adjusted(-1, -1, 1, 1)
                    .intersects(label))
                return true;
        return false;
    });
    return !coversBlock && !coversWire;
}

namespace {

std::string instanceOf(const std::string& connector) { return connector.substr(0, connector.find_first_of(".[")); }

}  // namespace

DiagramScene::DiagramScene(QObject* parent) : QGraphicsScene(parent) {
    setItemIndexMethod(NoIndex);  // a few hundred items that are rebuilt as a whole
    connect(this, &QGraphicsScene::selectionChanged, this, [this] {
        if (!isRebuilding_) Q_EMIT blockSelected(selectedBlock());
    });
}

void DiagramScene::show(const Diagram& diagram) {
    const std::string selected = selectedBlock().toStdString();
    isRebuilding_ = true;
    clear();
    blocks_.clear();
    wires_.clear();
    if (!diagram.graphics.empty()) addItem(new GraphicsItem(diagram.graphics));
    std::vector<Wire> wires = diagram.wires;
    for (Wire& wire : wires) reachAnchors(wire, diagram);
    for (const Wire& wire : wires) {
        if (wire.points.size() < 2) continue;
        auto* item = new WireItem(wire);
        item->setJunctions(junctions(wire, wires));
        addItem(item);
        wires_.push_back(item);
    }
    for (const Block& block : diagram.blocks) {
        auto* item = new BlockItem(block);
        addItem(item);
        blocks_[block.name] = item;
    }
    setSceneRect(contents().adjusted(-400, -400, 400, 400));
    if (BlockItem* item = block(selected)) item->setSelected(true);
    isRebuilding_ = false;
    if (!selected.empty() && !block(selected)) Q_EMIT blockSelected({});
}

void DiagramScene::mark(const std::vector<EffectMark>& effects) {
    std::map<std::string, QString> labels;
    for (const EffectMark& effect : effects) labels[effect.instance] = effect.label;
    for (const auto& [name, item] : blocks_)
        item->setEffect(labels.contains(name) ? labels[name] : QString(), hasRoomBelow(*item));
    for (WireItem* item : wires_)
        item->setMarked(labels.contains(instanceOf(item->wire().from)) || labels.contains(instanceOf(item->wire().to)));
}

BlockItem* DiagramScene::block(const std::string& name) const {
    const auto found = blocks_.find(name);
    return found == blocks_.end() ? nullptr : found->second;
}

QString DiagramScene::selectedBlock() const {
    for (QGraphicsItem* item : selectedItems())
        if (item->type() == BlockItem::Type) return QString::fromStdString(static_cast<BlockItem*>(item)->block().name);
    return {};
}

void DiagramScene::select(const std::string& name) {
    clearSelection();
    if (BlockItem* item = block(name)) item->setSelected(true);
}

QRectF DiagramScene::contents() const {
    QRectF rect;
    constexpr double labelHeight = 14;
    for (const auto& [name, item] : blocks_)
        rect |=
            item->isMarked() ? item->boundingRect().adjusted(0, -labelHeight, 0, labelHeight) : item->boundingRect();
    for (const WireItem* item : wires_) rect |= item->boundingRect();
    return rect;
}

}  // namespace analogon::ui
