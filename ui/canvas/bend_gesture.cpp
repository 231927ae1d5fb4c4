#include <QApplication>
#include <cmath>

#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/canvas/gesture.hpp"
#include "ui/canvas/wire_item.hpp"
#include "ui/route/bend.hpp"
#include "ui/route/route.hpp"

namespace analogon::ui {

namespace {

class BendGesture : public Gesture {
public:
    BendGesture(DiagramView& view, QMouseEvent* press, const Wire& wire)
        : Gesture(view), pressed_(press->pos()), wire_(wire), way_(simplified(wire.points)), led_(way_) {
        start_ = view.mapToScene(pressed_);
        if (isOrthogonal(way_)) piece_ = pieceAt(way_, {start_.x(), -start_.y()}, std::max(4.0, 8 / view.zoom()));
        if (piece_) isLevel_ = way_[*piece_].y == way_[*piece_ + 1].y;
    }

    void move(QMouseEvent* event) override {
        if (!piece_) return;
        if (!isMoving_ && (event->pos() - pressed_).manhattanLength() < QApplication::startDragDistance()) return;
        isMoving_ = true;
        view_.viewport()->setCursor(isLevel_ ? Qt::SizeVerCursor : Qt::SizeHorCursor);
        const QPointF at = view_.mapToScene(event->pos());
        const double grid = event->modifiers() & Qt::AltModifier ? 1 : 10;
        // The piece comes to lie on the grid, wherever it was.
        const double was = isLevel_ ? way_[*piece_].y : way_[*piece_].x;
        const double by = isLevel_ ? start_.y() - at.y() : at.x() - start_.x();
        led_ = bent(way_, *piece_, std::round((was + by) / grid) * grid - was);
        show(led_);
    }

    void release(QMouseEvent*) override {
        view_.viewport()->unsetCursor();
        if (led_ == way_) return cancel();
        Q_EMIT view_.wireBent(QString::fromStdString(wire_.from), QString::fromStdString(wire_.to), led_);
    }

    void cancel() override {
        view_.viewport()->unsetCursor();
        show(wire_.points);
    }

private:
    void show(const std::vector<Point>& way) {
        for (WireItem* item : view_.scene()->wires())
            if (item->wire().from == wire_.from && item->wire().to == wire_.to) item->showPoints(way);
    }

    QPoint pressed_;
    QPointF start_;
    Wire wire_;
    std::vector<Point> way_, led_;
    std::optional<std::size_t> piece_;  // none: the wire is drawn aslant
    bool isLevel_{}, isMoving_{};
};

}  // namespace

std::unique_ptr<Gesture> makeBendGesture(DiagramView& view, QMouseEvent* press, const Wire& wire) {
    return std::make_unique<BendGesture>(view, press, wire);
}

}  // namespace analogon::ui
