#include "ui/canvas/diagram_scene.hpp"

#include <QPainter>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <set>

#include "ui/canvas/block_item.hpp"
#include "ui/canvas/icon_painter.hpp"
#include "ui/canvas/note_item.hpp"
#include "ui/canvas/wire_item.hpp"
#include "ui/route/route.hpp"

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

/// Wires by the connectors they end at.
using WiresAt = std::map<std::string, std::vector<std::size_t>>;

/// Corners of a wire that lie on another wire of the same node.
std::vector<QPointF> junctions(std::size_t index, const std::vector<Wire>& wires, const WiresAt& at) {
    std::vector<QPointF> result;
    const Wire& wire = wires[index];
    for (const std::string& end : {wire.from, wire.to})
        for (const std::size_t o : at.at(end)) {
            if (o == index) continue;
            const Wire& other = wires[o];
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

DiagramScene::DiagramScene(QObject* parent) : QGraphicsScene(parent) {
    setItemIndexMethod(NoIndex);  // a few hundred items that are rebuilt as a whole
    connect(this, &QGraphicsScene::selectionChanged, this, [this] {
        if (isRebuilding_) return;
        noteOrder();
        Q_EMIT blockSelected(selectedBlock());
        Q_EMIT selectionEdited();
    });
}

DiagramScene::~DiagramScene() {
    isRebuilding_ = true;  // items that leave one by one are no change of the selection
    clear();
}

void DiagramScene::show(const Diagram& diagram, const std::vector<OwnGraphic>& own) {
    const DiagramSelection selected = selection();
    const QString shownBlock = selectedBlock();
    const NoteItem* chosen = selectedNote();
    // a change of a text or picture leaves it where its record begins
    const std::optional<std::uint32_t> note = chosen ? std::optional(chosen->graphic().begin) : std::nullopt;
    isRebuilding_ = true;
    diagram_ = diagram;
    moved_.reset();
    pointedOut_.clear();
    clear();
    blocks_.clear();
    places_.clear();
    wires_.clear();
    notes_.clear();
    showGraphics(own, note);
    std::vector<Wire> wires = diagram.wires;
    for (Wire& wire : wires) reachAnchors(wire, diagram);
    WiresAt at;
    for (std::size_t i = 0; i < wires.size(); ++i)
        for (const std::string& end : {wires[i].from, wires[i].to}) at[end].push_back(i);
    for (std::size_t i = 0; i < wires.size(); ++i) {
        if (wires[i].points.size() < 2) continue;
        auto* item = new WireItem(wires[i]);
        item->setJunctions(junctions(i, wires, at));
        addItem(item);
        wires_.push_back(item);
    }
    for (const Block& block : diagram.blocks) {
        auto* item = new BlockItem(block);
        addItem(item);
        blocks_[block.name] = item;
    }
    placeLabels();
    setSceneRect(contents().adjusted(-400, -400, 400, 400));
    if (!selectedNote()) setSelection(selected);
    isRebuilding_ = false;
    noteOrder();
    if (selectedBlock() != shownBlock) Q_EMIT blockSelected(selectedBlock());
    if (!(selection() == selected)) Q_EMIT selectionEdited();
}

void DiagramScene::showGraphics(const std::vector<OwnGraphic>& own, std::optional<std::uint32_t> chosen) {
    std::vector<Primitive> plain(
        diagram_.graphics.begin(),
        diagram_.graphics.end() - static_cast<std::ptrdiff_t>(std::min(own.size(), diagram_.graphics.size())));
    for (const OwnGraphic& graphic : own) {
        if (!NoteItem::isNote(graphic.primitive)) {
            plain.push_back(graphic.primitive);
            continue;
        }
        auto* item = new NoteItem(graphic);
        addItem(item);
        notes_.push_back(item);
        item->setSelected(chosen == graphic.begin);
    }
    if (!plain.empty()) addItem(new GraphicsItem(std::move(plain)));
}

NoteItem* DiagramScene::selectedNote() const {
    const auto found = std::find_if(notes_.begin(), notes_.end(), [](const NoteItem* n) { return n->isSelected(); });
    return found == notes_.end() ? nullptr : *found;
}

void DiagramScene::selectNote(NoteItem& note) {
    setSelection({});
    clearSelection();
    note.setSelected(true);
}

void DiagramScene::mark(const std::vector<EffectMark>& effects, const std::vector<BlockMark>& marks) {
    std::map<std::string, QString> labels;
    for (const EffectMark& effect : effects) labels[effect.instance] = effect.label;
    for (const auto& [name, item] : blocks_) {
        const auto label = labels.find(name);
        if (label == labels.end())
            item->setEffect({});
        else
            item->setEffect(label->second, hasRoomBelow(*item));
    }
    for (WireItem* item : wires_)
        item->setMarked(labels.contains(instanceOf(item->wire().from)) || labels.contains(instanceOf(item->wire().to)));
    placeMarks(marks);
    keepNamesApart();
}

BlockItem* DiagramScene::block(const std::string& name) const {
    const auto found = blocks_.find(name);
    return found == blocks_.end() ? nullptr : found->second;
}

QString DiagramScene::selectedBlock() const {
    const DiagramSelection selected = selection();
    return selected.blocks.size() == 1 ? QString::fromStdString(selected.blocks.front()) : QString();
}

DiagramSelection DiagramScene::selection() const {
    DiagramSelection result;
    for (const std::string& name : order_)
        if (const BlockItem* item = block(name); item && item->isSelected()) result.blocks.push_back(name);
    for (const auto& [name, item] : blocks_)
        if (item->isSelected() && std::find(order_.begin(), order_.end(), name) == order_.end())
            result.blocks.push_back(name);
    for (const WireItem* item : wires_)
        if (item->isSelected()) result.wires.push_back({item->wire().from, item->wire().to});
    return result;
}

void DiagramScene::noteOrder() { order_ = selection().blocks; }

void DiagramScene::select(const std::string& name) {
    setSelection(block(name) ? DiagramSelection{{name}, {}} : DiagramSelection{});
}

void DiagramScene::toggle(const DiagramSelection& part) {
    const auto toggled = [](auto now, const auto& these) {
        for (const auto& one : these)
            if (const auto found = std::find(now.begin(), now.end(), one); found != now.end())
                now.erase(found);
            else
                now.push_back(one);
        return now;
    };
    const DiagramSelection now = selection();
    setSelection({toggled(now.blocks, part.blocks), toggled(now.wires, part.wires)});
}

void DiagramScene::setSelection(const DiagramSelection& wanted) {
    const bool wasRebuilding = isRebuilding_;
    const DiagramSelection before = selection();
    isRebuilding_ = true;
    clearSelection();
    order_ = wanted.blocks;
    for (const std::string& name : wanted.blocks)
        if (BlockItem* item = block(name)) item->setSelected(true);
    for (WireItem* item : wires_)
        if (std::find(wanted.wires.begin(), wanted.wires.end(), WireEnds{item->wire().from, item->wire().to}) !=
            wanted.wires.end())
            item->setSelected(true);
    isRebuilding_ = wasRebuilding;
    if (isRebuilding_ || before == wanted) return;
    noteOrder();
    Q_EMIT blockSelected(selectedBlock());
    Q_EMIT selectionEdited();
}

void DiagramScene::selectIn(const QRectF& rect, const DiagramSelection& also) {
    DiagramSelection wanted = also;
    for (const auto& [name, item] : blocks_)
        if (rect.contains(item->body()) &&
            std::find(wanted.blocks.begin(), wanted.blocks.end(), name) == wanted.blocks.end())
            wanted.blocks.push_back(name);
    for (const WireItem* item : wires_) {
        const WireEnds ends{item->wire().from, item->wire().to};
        const auto& points = item->wire().points;
        const bool isInside =
            std::all_of(points.begin(), points.end(), [&](Point p) { return rect.contains(toScene(p)); });
        if (isInside && std::find(wanted.wires.begin(), wanted.wires.end(), ends) == wanted.wires.end())
            wanted.wires.push_back(ends);
    }
    setSelection(wanted);
}

void DiagramScene::showMoved(double dx, double dy) {
    const DiagramSelection selected = selection();
    const std::set<std::string> names(selected.blocks.begin(), selected.blocks.end());
    if (!moved_ || moved_->names() != names) moved_.emplace(withoutPictures(diagram_), names);
    const bool isBack = dx == 0 && dy == 0;
    const Diagram after = isBack ? Diagram() : moved_->at(dx, dy);
    for (const std::string& name : names)
        if (BlockItem* item = block(name)) item->setPos(dx, -dy);
    for (WireItem* item : wires_) {
        const Wire& wire = item->wire();
        const bool first = names.contains(instanceOf(wire.from)), last = names.contains(instanceOf(wire.to));
        if (first && last) {
            item->setPos(dx, -dy);
        } else if (first || last) {
            const auto led = std::find_if(after.wires.begin(), after.wires.end(),
                                          [&](const Wire& w) { return w.from == wire.from && w.to == wire.to; });
            item->showPoints(led == after.wires.end() || led->points.size() < 2 ? wire.points : led->points);
        }
    }
    if (isBack) moved_.reset();
}

std::vector<std::pair<std::string, QPointF>> DiagramScene::connectors() const {
    std::vector<std::pair<std::string, QPointF>> result;
    for (const Block& b : diagram_.blocks) {
        if (b.isConnector) {
            if (const auto at = diagram_.anchor(b.name)) result.emplace_back(b.name, toScene(*at));
            continue;
        }
        for (const Port& port : b.ports) {
            const std::string name = b.name + "." + port.name;
            if (const auto at = diagram_.anchor(name)) result.emplace_back(name, toScene(*at));
        }
    }
    return result;
}

std::string DiagramScene::connectorAt(QPointF at, double reach) const {
    std::string nearest;
    double distance = reach;
    for (const auto& [name, place] : connectors()) {
        const double d = std::hypot(place.x() - at.x(), place.y() - at.y());
        if (d <= distance) {
            distance = d;
            nearest = name;
        }
    }
    return nearest;
}

void DiagramScene::pointOut(const std::string& place) {
    if (pointedOut_ == place) return;
    pointedOut_ = place;
    update();
}

QRectF DiagramScene::contents() const {
    QRectF rect;
    constexpr double labelHeight = 14;
    for (const auto& [name, item] : blocks_)
        rect |=
            item->isMarked() ? item->boundingRect().adjusted(0, -labelHeight, 0, labelHeight) : item->boundingRect();
    for (const WireItem* item : wires_) rect |= item->boundingRect();
    for (const NoteItem* item : notes_) rect |= item->boundingRect();
    return blocks_.empty() && notes_.empty() ? QRectF(-100, -70, 200, 140) : rect;
}

}  // namespace analogon::ui
