#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/canvas/gesture.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

class BandGesture : public Gesture {
public:
    BandGesture(DiagramView& view, QMouseEvent* press) : Gesture(view), start_(view.mapToScene(press->pos())) {
        if (press->modifiers() & (Qt::ShiftModifier | Qt::ControlModifier)) before_ = view.scene()->selection();
        end_ = start_;
        view.scene()->setSelection(before_);
    }

    void move(QMouseEvent* event) override {
        end_ = view_.mapToScene(event->pos());
        view_.scene()->selectIn(band(), before_);
        view_.viewport()->update();
    }

    void release(QMouseEvent*) override { view_.viewport()->update(); }

    void cancel() override {
        view_.scene()->setSelection(before_);
        view_.viewport()->update();
    }

    void paint(QPainter& painter) const override {
        const QColor accent = style::accent(view_.palette());
        QColor tint = accent;
        tint.setAlphaF(0.1f);
        painter.setPen(QPen(accent, 1 / view_.zoom()));
        painter.setBrush(tint);
        painter.drawRect(band());
    }

private:
    QRectF band() const { return QRectF(start_, end_).normalized(); }

    QPointF start_, end_;
    DiagramSelection before_;
};

class PanGesture : public Gesture {
public:
    PanGesture(DiagramView& view, QMouseEvent* press) : Gesture(view), last_(press->pos()) {
        view.viewport()->setCursor(Qt::ClosedHandCursor);
    }
    void move(QMouseEvent* event) override {
        view_.panBy(event->pos() - last_);
        last_ = event->pos();
    }
    void release(QMouseEvent*) override { view_.viewport()->unsetCursor(); }
    void cancel() override { view_.viewport()->unsetCursor(); }

private:
    QPoint last_;
};

class OverviewGesture : public Gesture {
public:
    OverviewGesture(DiagramView& view, QMouseEvent* press) : Gesture(view) { view.lookAtOverview(press->pos()); }
    void move(QMouseEvent* event) override { view_.lookAtOverview(event->pos()); }
    void release(QMouseEvent*) override {}
};

}  // namespace

std::unique_ptr<Gesture> makeOverviewGesture(DiagramView& view, QMouseEvent* press) {
    return std::make_unique<OverviewGesture>(view, press);
}

std::unique_ptr<Gesture> makeBandGesture(DiagramView& view, QMouseEvent* press) {
    return std::make_unique<BandGesture>(view, press);
}

std::unique_ptr<Gesture> makePanGesture(DiagramView& view, QMouseEvent* press) {
    return std::make_unique<PanGesture>(view, press);
}

}  // namespace analogon::ui
