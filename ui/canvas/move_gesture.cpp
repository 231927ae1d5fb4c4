#include <QApplication>
#include <cmath>

#include "ui/canvas/block_item.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/canvas/gesture.hpp"

namespace analogon::ui {

namespace {

class MoveGesture : public Gesture {
public:
    MoveGesture(DiagramView& view, QMouseEvent* press) : Gesture(view), pressed_(press->pos()) {
        start_ = view.mapToScene(pressed_);
        BlockItem* item = view.blockAt(pressed_);
        const bool adds = press->modifiers() & (Qt::ShiftModifier | Qt::ControlModifier);
        if (!item) return;
        name_ = item->block().name;
        wasSelected_ = item->isSelected();
        if (adds)
            view.scene()->toggle({{name_}, {}});
        else if (!wasSelected_)
            view.scene()->select(name_);
        adds_ = adds;
    }

    void move(QMouseEvent* event) override {
        if (!isMoving_ && (event->pos() - pressed_).manhattanLength() < QApplication::startDragDistance()) return;
        isMoving_ = true;
        const QPointF by = view_.mapToScene(event->pos()) - start_;
        const double grid = event->modifiers() & Qt::AltModifier ? 1 : 10;
        const double dx = std::round(by.x() / grid) * grid, dy = -std::round(by.y() / grid) * grid;
        if (dx == dx_ && dy == dy_) return;
        dx_ = dx;
        dy_ = dy;
        view_.scene()->showMoved(dx_, dy_);
        view_.setParted(dx_ == 0 && dy_ == 0 ? std::vector<WireEnds>() : view_.partedByMove(dx_, dy_));
    }

    void release(QMouseEvent*) override {
        view_.setParted({});
        if (dx_ != 0 || dy_ != 0) {
            const double dx = dx_, dy = dy_;
            view_.scene()->showMoved(0, 0);
            Q_EMIT view_.dropWanted(dx, dy);
        } else if (!isMoving_ && wasSelected_ && !adds_) {
            view_.scene()->select(name_);  // a click into a selection of several picks one
        }
    }

    void cancel() override {
        view_.setParted({});
        view_.scene()->showMoved(0, 0);
    }

private:
    QPoint pressed_;
    QPointF start_;
    std::string name_;
    bool wasSelected_{}, adds_{}, isMoving_{};
    double dx_{}, dy_{};  // [diagram units]
};

}  // namespace

std::unique_ptr<Gesture> makeMoveGesture(DiagramView& view, QMouseEvent* press) {
    return std::make_unique<MoveGesture>(view, press);
}

}  // namespace analogon::ui
