#include <QApplication>
#include <cmath>

#include "ui/canvas/block_item.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/canvas/gesture.hpp"
#include "ui/canvas/icon_painter.hpp"
#include "ui/route/route.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

class WireGesture : public Gesture {
public:
    WireGesture(DiagramView& view, QMouseEvent* press, std::string from)
        : Gesture(view), pressed_(press->pos()), from_(std::move(from)) {
        for (const auto& [name, at] : view.scene()->connectors())
            if (name != from_) ends_.push_back({name, at, view.refusal(from_, name)});
    }

    void move(QMouseEvent* event) override {
        if (!isDrawing_ && (event->pos() - pressed_).manhattanLength() < QApplication::startDragDistance()) return;
        isDrawing_ = true;
        at_ = view_.mapToScene(event->pos());
        target_ = targetAt(event->pos());
        way_ = target_ ? routeWire(view_.scene()->diagram(), from_, target_->name)
                       : routeTo(view_.scene()->diagram(), from_, {at_.x(), -at_.y()});
        view_.viewport()->setCursor(target_ && !target_->refusal.isEmpty() ? Qt::ForbiddenCursor : Qt::CrossCursor);
        view_.viewport()->update();
    }

    void release(QMouseEvent* event) override {
        view_.viewport()->unsetCursor();
        view_.viewport()->update();
        if (!isDrawing_) {
            if (BlockItem* item = view_.blockAt(event->pos())) view_.scene()->select(item->block().name);
            return;
        }
        if (!target_) return;
        if (!target_->refusal.isEmpty()) return Q_EMIT view_.refused(target_->refusal);
        Q_EMIT view_.wireWanted(QString::fromStdString(from_), QString::fromStdString(target_->name));
    }

    void cancel() override {
        view_.viewport()->unsetCursor();
        view_.viewport()->update();
    }

    void paint(QPainter& painter) const override {
        if (!isDrawing_) return;
        const QPalette palette = view_.palette();
        const double pixel = 1 / view_.zoom();
        const QColor accent = style::accent(palette), good = style::good(palette), fault = style::fault(palette);
        for (const End& end : ends_) {
            if (!end.refusal.isEmpty()) continue;
            QColor glow = good;
            glow.setAlphaF(0.3f);
            painter.setPen(QPen(good, 1.5 * pixel));
            painter.setBrush(glow);
            painter.drawEllipse(end.at, 8 * pixel, 8 * pixel);
        }
        const bool isRefused = target_ && !target_->refusal.isEmpty();
        // a refused wire is grey: red is the colour of heat
        painter.setPen(QPen(isRefused ? style::mutedText(palette) : accent, 2 * pixel,
                            isRefused ? Qt::DashLine : Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
        QPolygonF line;
        for (const Point p : way_) line << toScene(p);
        painter.drawPolyline(line);
        if (!target_) return;
        const double radius = 11 * pixel;
        if (isRefused) {
            painter.setPen(QPen(fault, 2.5 * pixel));
            const QPointF slant = QPointF(radius, radius) * std::sqrt(0.5);
            painter.drawLine(target_->at - slant, target_->at + slant);
        }
        painter.drawEllipse(target_->at, radius, radius);
        if (isRefused) view_.paintNote(painter, target_->at, target_->refusal, fault);
    }

private:
    struct End {
        std::string name;
        QPointF at;
        QString refusal;  // why it does not fit; empty: it does
    };

    /// The nearest connector in reach; over a block, its only connector that fits.
    const End* targetAt(QPoint pointer) const {
        const QPointF at = view_.mapToScene(pointer);
        const double reach = std::max(4.0, 12 / view_.zoom());
        const End* nearest = nullptr;
        double distance = reach;
        for (const End& end : ends_) {
            const double d = std::hypot(end.at.x() - at.x(), end.at.y() - at.y());
            if (d > distance) continue;
            distance = d;
            nearest = &end;
        }
        if (nearest) return nearest;
        const BlockItem* item = view_.blockAt(pointer);
        if (!item) return nullptr;
        const End* only = nullptr;
        for (const End& end : ends_) {
            if (instanceOf(end.name) != item->block().name || (!end.refusal.isEmpty() && !item->block().isConnector))
                continue;
            if (only) return nullptr;
            only = &end;
        }
        return only;
    }

    QPoint pressed_;
    std::string from_;
    std::vector<End> ends_;
    bool isDrawing_{};
    QPointF at_;
    const End* target_{};
    std::vector<Point> way_;
};

}  // namespace

std::unique_ptr<Gesture> makeWireGesture(DiagramView& view, QMouseEvent* press, const std::string& from) {
    return std::make_unique<WireGesture>(view, press, from);
}

}  // namespace analogon::ui
