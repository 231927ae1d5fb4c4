#include "ui/canvas/diagram_view.hpp"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QScrollBar>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/canvas/block_item.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/gesture.hpp"
#include "ui/canvas/icon_painter.hpp"
#include "ui/canvas/note_item.hpp"
#include "ui/canvas/wire_item.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

constexpr double smallestZoom = 0.5, largestZoom = 24;  // [pixels per diagram unit]
constexpr double gridStep = 10;                         // [diagram units]

}  // namespace

DiagramView::DiagramView(DiagramScene& scene, QWidget* parent) : QGraphicsView(&scene, parent), scene_(scene) {
    setFrameShape(NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setTransformationAnchor(NoAnchor);
    setViewportUpdateMode(FullViewportUpdate);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Diagram"));
}

DiagramView::~DiagramView() = default;

void DiagramView::fitView() {
    isFitted_ = true;
    const QRectF contents = scene_.contents().adjusted(-12, -12, 12, 12);
    if (viewport()->width() < 20) return;
    const double zoom =
        std::min({viewport()->width() / contents.width(), viewport()->height() / contents.height(), 5.0});
    setTransform(QTransform::fromScale(zoom, zoom));
    scene_.setReading(zoom, font());
    centerOn(contents.center());
}

void DiagramView::zoomBy(double factor, QPoint about) {
    const double wanted = std::clamp(zoom() * factor, smallestZoom, largestZoom);
    const QPointF fixed = mapToScene(about);
    scale(wanted / zoom(), wanted / zoom());
    scene_.setReading(zoom(), font());
    const QPoint moved = mapFromScene(fixed) - about;
    horizontalScrollBar()->setValue(horizontalScrollBar()->value() + moved.x());
    verticalScrollBar()->setValue(verticalScrollBar()->value() + moved.y());
    isFitted_ = false;
}

void DiagramView::wheelEvent(QWheelEvent* event) {
    zoomBy(std::pow(1.0015, event->angleDelta().y()), event->position().toPoint());
    event->accept();
}

bool DiagramView::event(QEvent* event) {
    // Tab steps through the blocks as long as there is a next one; then it leaves the diagram as usual.
    if (event->type() == QEvent::KeyPress) {
        auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_Tab || key->key() == Qt::Key_Backtab) {
            if (!scene_.isEmpty() && !(key->modifiers() & Qt::ControlModifier)) {
                selectNext(key->key() == Qt::Key_Tab);
                return true;
            }
        }
    }
    return QGraphicsView::event(event);
}

void DiagramView::selectNext(bool isForward) {
    std::vector<std::string> names;
    for (const Block& block : scene_.diagram().blocks) names.push_back(block.name);
    if (names.empty()) return;
    const std::string now = scene_.selectedBlock().toStdString();
    const auto at = std::find(names.begin(), names.end(), now);
    std::size_t next = isForward ? 0 : names.size() - 1;
    if (at != names.end()) {
        const auto i = static_cast<std::size_t>(at - names.begin());
        next = isForward ? (i + 1) % names.size() : (i + names.size() - 1) % names.size();
    }
    scene_.select(names[next]);
    if (BlockItem* item = scene_.block(names[next])) ensureVisible(item->body(), 20, 20);
}

void DiagramView::keyPressEvent(QKeyEvent* event) {
    const bool isPlain = !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    const double step = event->modifiers() & Qt::ShiftModifier ? 50 : 10;
    const auto arrow = [&](double dx, double dy) {
        if (scene_.selectedNote())
            Q_EMIT noteMoved(dx, dy);
        else if (scene_.selection().blocks.empty())
            panBy(QPoint(static_cast<int>(-dx * 4), static_cast<int>(dy * 4)));
        else
            Q_EMIT moveWanted(dx, dy);
    };
    switch (event->key()) {
        case Qt::Key_Space:
            return fitView();
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            return zoomIn();
        case Qt::Key_Minus:
            return zoomOut();
        case Qt::Key_Left:
            return arrow(-step, 0);
        case Qt::Key_Right:
            return arrow(step, 0);
        case Qt::Key_Up:
            return arrow(0, step);
        case Qt::Key_Down:
            return arrow(0, -step);
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (scene_.selectedNote()) return Q_EMIT noteActivated();
            if (!scene_.selectedBlock().isEmpty()) Q_EMIT blockActivated(scene_.selectedBlock());
            return;
        case Qt::Key_Menu:
            return Q_EMIT menuWanted(viewport()->mapToGlobal(viewport()->rect().center()));
        case Qt::Key_Escape:
            if (gesture_) {
                gesture_->cancel();
                gesture_.reset();
                return;
            }
            return scene_.clearSelection();
        default:
            break;
    }
    if (isPlain && event->text().size() == 1 && event->text().front().isLetter()) return Q_EMIT typed(event->text());
    QGraphicsView::keyPressEvent(event);
}

void DiagramView::panBy(QPoint pixels) {
    isFitted_ = false;
    horizontalScrollBar()->setValue(horizontalScrollBar()->value() - pixels.x());
    verticalScrollBar()->setValue(verticalScrollBar()->value() - pixels.y());
}

BlockItem* DiagramView::blockAt(QPoint at) const {
    for (QGraphicsItem* item : items(at))
        if (item->type() == BlockItem::Type) return static_cast<BlockItem*>(item);
    return nullptr;
}

NoteItem* DiagramView::noteAt(QPoint at) const {
    for (QGraphicsItem* item : items(at))
        if (item->type() == NoteItem::Type) return static_cast<NoteItem*>(item);
    return nullptr;
}

QRect DiagramView::nameRect(const std::string& block) const {
    const BlockItem* item = scene_.block(block);
    return item ? item->nameRect(viewportTransform(), font()).toAlignedRect() : QRect();
}

/// The block whose name is there.
std::string DiagramView::nameAt(QPoint at) const {
    if (zoom() < BlockItem::leastZoomWithNames) return {};
    for (const Block& block : scene_.diagram().blocks)
        if (nameRect(block.name).contains(at)) return block.name;
    return {};
}

Point DiagramView::diagramPoint(QPoint at) const {
    const QPointF scene = mapToScene(at);
    return {scene.x(), -scene.y()};
}

void DiagramView::mousePressEvent(QMouseEvent* event) {
    event->accept();
    if (gesture_) return;
    if (event->button() == Qt::MiddleButton) {
        gesture_ = makePanGesture(*this, event);
        return;
    }
    if (event->button() != Qt::LeftButton) return;
    if (const auto map = overview(); map && map->contains(event->pos())) {
        gesture_ = makeOverviewGesture(*this, event);
        return;
    }
    if (isStale()) return Q_EMIT staleClicked();
    const double reach = std::max(2.5, 6 / zoom());
    const std::string connector = scene_.connectorAt(mapToScene(event->pos()), reach);
    if (!connector.empty()) {
        gesture_ = makeWireGesture(*this, event, connector);
    } else if (blockAt(event->pos())) {
        gesture_ = makeMoveGesture(*this, event);
    } else if (QGraphicsItem* item = itemAt(event->pos()); item && item->type() == WireItem::Type) {
        const bool adds = event->modifiers() & (Qt::ShiftModifier | Qt::ControlModifier);
        const Wire wire = static_cast<const WireItem*>(item)->wire();
        const DiagramSelection clicked{{}, {{wire.from, wire.to}}};
        if (adds)
            scene_.toggle(clicked);
        else
            scene_.setSelection(clicked);
        if (!adds) gesture_ = makeBendGesture(*this, event, wire);
    } else if (NoteItem* note = noteAt(event->pos()); note && !(event->modifiers() & Qt::ShiftModifier)) {
        gesture_ = makeNoteGesture(*this, event, *note);
    } else {
        gesture_ = makeBandGesture(*this, event);
    }
}

void DiagramView::mouseMoveEvent(QMouseEvent* event) {
    if (gesture_) return gesture_->move(event);
    QGraphicsView::mouseMoveEvent(event);  // hovering
}

void DiagramView::mouseReleaseEvent(QMouseEvent* event) {
    if (!gesture_) return;
    // The gesture may ask for a change that rebuilds everything: it is over by then.
    const std::unique_ptr<Gesture> done = std::move(gesture_);
    done->release(event);
}

void DiagramView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (const auto map = overview(); map && map->contains(event->pos())) return lookAtOverview(event->pos());
    if (BlockItem* item = blockAt(event->pos()))
        return Q_EMIT blockActivated(QString::fromStdString(item->block().name));
    if (const std::string name = nameAt(event->pos()); !name.empty())
        return Q_EMIT renameWanted(QString::fromStdString(name));
    if (NoteItem* note = noteAt(event->pos())) {
        scene_.selectNote(*note);
        Q_EMIT noteActivated();
    }
}

void DiagramView::contextMenuEvent(QContextMenuEvent* event) {
    if (BlockItem* item = blockAt(event->pos()); item && !item->isSelected()) scene_.select(item->block().name);
    Q_EMIT menuWanted(event->globalPos());
}

void DiagramView::setGhost(std::optional<GhostBlock> ghost) {
    ghost_ = std::move(ghost);
    viewport()->update();
}

void DiagramView::setStale(const QString& note) {
    if (staleNote_ == note) return;
    staleNote_ = note;
    viewport()->update();
}

void DiagramView::setParted(std::vector<WireEnds> wires) {
    if (parted_ == wires) return;
    parted_ = std::move(wires);
    viewport()->update();
}

void DiagramView::refitIfHidden() {
    if (!isFitted_ || scene_.isEmpty()) return;
    const QRectF seen = mapToScene(viewport()->rect()).boundingRect();
    if (!seen.contains(scene_.contents())) fitView();
}

void DiagramView::resizeEvent(QResizeEvent* event) {
    QGraphicsView::resizeEvent(event);
    refit();
}

void DiagramView::changeEvent(QEvent* event) {
    QGraphicsView::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) viewport()->update();
    if (event->type() == QEvent::FontChange) scene_.setReading(zoom(), font());
}

void DiagramView::drawBackground(QPainter* painter, const QRectF& rect) {
    painter->fillRect(rect, style::canvas(palette()));
    double step = gridStep;
    while (step * zoom() < 14) step *= 2;
    const QColor dot = style::mix(style::canvas(palette()), palette().color(QPalette::Text), 0.16);
    // whole pixels of the screen, at whole pixels: else some dots are larger than others
    const double dense = devicePixelRatioF(), side = std::max(1.0, std::floor(dense)) / dense;
    const QTransform toPixels = painter->worldTransform();
    QVector<QRectF> dots;
    for (double x = std::floor(rect.left() / step) * step; x <= rect.right(); x += step)
        for (double y = std::floor(rect.top() / step) * step; y <= rect.bottom(); y += step) {
            const QPointF at = toPixels.map(QPointF(x, y)) * dense;
            dots << QRectF(std::round(at.x()) / dense, std::round(at.y()) / dense, side, side);
        }
    painter->save();
    painter->resetTransform();
    painter->setRenderHint(QPainter::Antialiasing, false);
    painter->setPen(Qt::NoPen);
    painter->setBrush(dot);
    painter->drawRects(dots);
    painter->restore();
}

void DiagramView::paintNote(QPainter& painter, QPointF at, const QString& text, const QColor& colour) const {
    painter.save();
    const QPointF pixel = painter.worldTransform().map(at);
    painter.resetTransform();
    painter.setFont(font());
    const QFontMetricsF metrics(font());
    QRectF box = metrics.boundingRect(QRectF(0, 0, 320, 400), Qt::TextWordWrap, text).adjusted(-12, -7, 12, 7);
    box.moveTopLeft(pixel + QPointF(16, 16));
    box.moveLeft(std::clamp(box.left(), 4.0, std::max(4.0, viewport()->width() - box.width() - 4)));
    if (box.bottom() > viewport()->height() - 4) box.moveBottom(pixel.y() - 16);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, 1));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(box, Qt::AlignCenter | Qt::TextWordWrap, text);
    painter.restore();
}

std::optional<DiagramView::Overview> DiagramView::overviewShown() const {
    const QRectF seen = mapToScene(viewport()->rect()).boundingRect();
    const QRectF all = scene_.contents();
    if (scene_.isEmpty() || seen.contains(all)) return std::nullopt;
    Overview map;
    map.world = all | seen.intersected(all.adjusted(-200, -200, 200, 200));
    map.scale = std::min(150 / map.world.width(), 100 / map.world.height());
    const QSizeF size = map.world.size() * map.scale;
    map.frame = QRectF(viewport()->width() - size.width() - 18, viewport()->height() - size.height() - 18,
                       size.width() + 10, size.height() + 10);
    return map;
}

std::optional<QRectF> DiagramView::overview() const {
    const auto map = overviewShown();
    return map ? std::optional(map->frame) : std::nullopt;
}

void DiagramView::lookAtOverview(QPoint at) {
    const auto map = overviewShown();
    if (!map) return;
    isFitted_ = false;
    centerOn(map->world.topLeft() + (at - map->frame.topLeft() - QPointF(5, 5)) / map->scale);
}

/// Where one is in a diagram that does not fit into the window.
void DiagramView::paintOverview(QPainter& painter) const {
    const auto map = overviewShown();
    if (!map) return;
    const auto& [frame, world, scale] = *map;
    painter.save();
    painter.resetTransform();
    QColor ground = palette().color(QPalette::Base);
    ground.setAlphaF(0.9f);
    painter.setPen(style::hairline(palette()));
    painter.setBrush(ground);
    painter.drawRect(frame);
    const auto small = [&frame = frame, &world = world, &scale = scale](const QRectF& r) {
        return QRectF(frame.left() + 5 + (r.left() - world.left()) * scale,
                      frame.top() + 5 + (r.top() - world.top()) * scale, r.width() * scale, r.height() * scale);
    };
    painter.setPen(Qt::NoPen);
    painter.setBrush(style::mutedText(palette()));
    for (const Block& block : scene_.diagram().blocks)
        if (const BlockItem* item = scene_.block(block.name)) painter.drawRect(small(item->body()));
    painter.setPen(QPen(style::accent(palette()), 1));
    painter.setBrush(Qt::NoBrush);
    const QRectF seen = mapToScene(viewport()->rect()).boundingRect();
    painter.drawRect(small(seen).intersected(frame.adjusted(1, 1, -1, -1)));
    painter.restore();
}

void DiagramView::drawForeground(QPainter* painter, const QRectF&) {
    painter->setRenderHint(QPainter::Antialiasing);
    const double pixel = 1 / zoom();
    if (const std::string& place = scene_.pointedOut(); !place.empty()) {
        const QColor accent = style::accent(palette());
        painter->setPen(QPen(accent, 2.5 * pixel));
        QColor tint = accent;
        tint.setAlphaF(0.15f);
        painter->setBrush(tint);
        if (const BlockItem* item = scene_.block(place))
            painter->drawRoundedRect(item->body().adjusted(-4, -4, 4, 4), 2, 2);
        else if (const auto at = scene_.diagram().anchor(place))
            painter->drawEllipse(toScene(*at), 13 * pixel, 13 * pixel);
    }
    if (isStale()) {
        painter->save();
        painter->resetTransform();
        QColor veil = style::canvas(palette());
        veil.setAlphaF(0.65f);
        painter->fillRect(viewport()->rect(), veil);
        painter->restore();
        paintNote(*painter, mapToScene(QPoint(0, 0)), staleNote_, style::fault(palette()));
    }
    if (scene_.isEmpty() && !ghost_ && !isStale()) {
        painter->save();
        painter->resetTransform();
        painter->setPen(style::mutedText(palette()));
        painter->setFont(font());
        painter->drawText(viewport()->rect(), Qt::AlignCenter | Qt::TextWordWrap,
                          tr("Drag blocks here from the library,\nor press A and type the name of a block."));
        painter->restore();
    }
    for (const WireItem* item : scene_.wires()) {
        const WireEnds ends{item->wire().from, item->wire().to};
        if (std::find(parted_.begin(), parted_.end(), ends) == parted_.end()) continue;
        QPolygonF line;
        for (const Point p : item->wire().points) line << toScene(p);
        painter->setPen(QPen(style::accent(palette()), 3 * pixel, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter->setBrush(Qt::NoBrush);
        painter->drawPolyline(line);
    }
    if (ghost_) {
        const double x = std::round(ghost_->at.x() / 10) * 10, y = std::round(ghost_->at.y() / 10) * 10;
        Placement placement;
        placement.extent = {{x - 10, -y - 10}, {x + 10, -y + 10}};
        painter->setOpacity(0.75);
        paintPrimitives(
            *painter, ghost_->icon.primitives, toScene(placement, ghost_->icon.coordinates),
            [this](const QString&) { return ghost_->name; }, palette());
        painter->setOpacity(1);
        painter->setPen(QPen(style::accent(palette()), 1.5 * pixel));
        painter->setBrush(Qt::NoBrush);
        painter->drawRoundedRect(QRectF(x - 13, y - 13, 26, 26), 2, 2);
    }
    if (gesture_) gesture_->paint(*painter);
    paintOverview(*painter);
}

}  // namespace analogon::ui
