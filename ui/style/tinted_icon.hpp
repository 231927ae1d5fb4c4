#pragma once

#include <QIconEngine>
#include <QString>

namespace analogon::ui::style {

/// Paints an SVG of :/icons whose strokes are `currentColor` in the palette's colour of the moment. Lists show the same
/// few icons in hundreds of rows: each is drawn from its text once for a size and a colour.
class TintedIcon : public QIconEngine {
public:
    explicit TintedIcon(QString name) : name_(std::move(name)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override;
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override;
    QIconEngine* clone() const override { return new TintedIcon(name_); }

private:
    void draw(QPainter& painter, const QRectF& rect, QIcon::Mode mode) const;

    QString name_;
};

}  // namespace analogon::ui::style
