#include "ui/canvas/diagram_view.hpp"

#include <QKeyEvent>
#include <QScrollBar>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/canvas/diagram_scene.hpp"
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

void DiagramView::fitView() {
    isFitted_ = true;
    const QRectF contents = scene_.contents().adjusted(-12, -12, 12, 12);
    if (scene_.isEmpty() || viewport()->width() < 20) return;
    const double zoom =
        std::min({viewport()->width() / contents.width(), viewport()->height() / contents.height(), 5.0});
    setTransform(QTransform::fromScale(zoom, zoom));
    centerOn(contents.center());
}

void DiagramView::zoomBy(double factor, QPoint about) {
    const double wanted = std::clamp(zoom() * factor, smallestZoom, largestZoom);
    const QPointF fixed = mapToScene(about);
    scale(wanted / zoom(), wanted / zoom());
    const QPoint moved = mapFromScene(fixed) - about;
    horizontalScrollBar()->setValue(horizontalScrollBar()->value() + moved.x());
    verticalScrollBar()->setValue(verticalScrollBar()->value() + moved.y());
    isFitted_ = false;
}

void DiagramView::wheelEvent(QWheelEvent* event) {
    zoomBy(std::pow(1.0015, event->angleDelta().y()), event->position().toPoint());
    event->accept();
}

void DiagramView::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Space:
            return fitView();
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            return zoomBy(1.25, viewport()->rect().center());
        case Qt::Key_Minus:
            return zoomBy(0.8, viewport()->rect().center());
        case Qt::Key_Escape:
            return scene_.clearSelection();
        default:
            QGraphicsView::keyPressEvent(event);
    }
}

void DiagramView::mousePressEvent(QMouseEvent* event) {
    const bool onGround = itemAt(event->pos()) == nullptr;
    if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && onGround)) {
        isPanning_ = true;
        hasPanned_ = false;
        panFrom_ = event->pos();
        return event->accept();
    }
    QGraphicsView::mousePressEvent(event);
}

void DiagramView::mouseMoveEvent(QMouseEvent* event) {
    if (!isPanning_) return QGraphicsView::mouseMoveEvent(event);
    const QPoint moved = event->pos() - panFrom_;
    if (!hasPanned_ && moved.manhattanLength() < 4) return;
    hasPanned_ = true;
    isFitted_ = false;
    viewport()->setCursor(Qt::ClosedHandCursor);
    panFrom_ = event->pos();
    horizontalScrollBar()->setValue(horizontalScrollBar()->value() - moved.x());
    verticalScrollBar()->setValue(verticalScrollBar()->value() - moved.y());
}

void DiagramView::mouseReleaseEvent(QMouseEvent* event) {
    if (!isPanning_) return QGraphicsView::mouseReleaseEvent(event);
    isPanning_ = false;
    viewport()->unsetCursor();
    if (!hasPanned_ && event->button() == Qt::LeftButton) scene_.clearSelection();
}

void DiagramView::resizeEvent(QResizeEvent* event) {
    QGraphicsView::resizeEvent(event);
    refit();
}

void DiagramView::changeEvent(QEvent* event) {
    QGraphicsView::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) viewport()->update();
}

void DiagramView::drawBackground(QPainter* painter, const QRectF& rect) {
    painter->fillRect(rect, style::canvas(palette()));
    double step = gridStep;
    while (step * zoom() < 14) step *= 2;
    const QColor dot = style::mix(style::canvas(palette()), palette().color(QPalette::Text), 0.16);
    QVector<QPointF> dots;
    for (double x = std::floor(rect.left() / step) * step; x <= rect.right(); x += step)
        for (double y = std::floor(rect.top() / step) * step; y <= rect.bottom(); y += step) dots << QPointF(x, y);
    painter->setRenderHint(QPainter::Antialiasing, false);
    painter->setPen(QPen(dot, 0));
    painter->drawPoints(dots.constData(), static_cast<int>(dots.size()));
}

}  // namespace analogon::ui
