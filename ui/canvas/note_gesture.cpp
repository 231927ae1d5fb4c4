#include <QApplication>
#include <cmath>

#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/canvas/gesture.hpp"
#include "ui/canvas/note_item.hpp"

namespace analogon::ui {

namespace {

class NoteGesture : public Gesture {
public:
    NoteGesture(DiagramView& view, QMouseEvent* press, NoteItem& note) : Gesture(view), pressed_(press->pos()) {
        start_ = view.mapToScene(pressed_);
        view.scene()->selectNote(note);
    }

    void move(QMouseEvent* event) override {
        if (!isMoving_ && (event->pos() - pressed_).manhattanLength() < QApplication::startDragDistance()) return;
        isMoving_ = true;
        const QPointF by = view_.mapToScene(event->pos()) - start_;
        const double grid = event->modifiers() & Qt::AltModifier ? 1 : 10;
        dx_ = std::round(by.x() / grid) * grid;
        dy_ = -std::round(by.y() / grid) * grid;
        show(dx_, dy_);
    }

    void release(QMouseEvent*) override {
        if (dx_ != 0 || dy_ != 0) Q_EMIT view_.noteMoved(dx_, dy_);
    }

    void cancel() override { show(0, 0); }

private:
    /// Whichever is selected: the diagram may have been drawn anew while the button was held.
    void show(double dx, double dy) {
        if (NoteItem* note = view_.scene()->selectedNote()) note->setPos(dx, -dy);
    }

    QPoint pressed_;
    QPointF start_;
    bool isMoving_{};
    double dx_{}, dy_{};  // [diagram units]
};

}  // namespace

std::unique_ptr<Gesture> makeNoteGesture(DiagramView& view, QMouseEvent* press, NoteItem& note) {
    return std::make_unique<NoteGesture>(view, press, note);
}

}  // namespace analogon::ui
