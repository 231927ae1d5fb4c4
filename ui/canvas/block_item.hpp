#pragma once

#include <QFont>
#include <QGraphicsItem>
#include <QPixmap>
#include <QTransform>

#include "core/diagram/diagram.hpp"

namespace analogon::ui {

/// A block of the diagram, or a top-level connector: its icon, its ports, its name.
class BlockItem : public QGraphicsItem {
public:
    enum { Type = UserType + 1 };
    static constexpr double leastZoomWithNames = 0.7;  // [px per diagram unit] else too many in too little room
    explicit BlockItem(const Block& block);

    const Block& block() const { return block_; }
    /// Marks a block that was found to be missing: outline and label in the accent colour.
    void setEffect(const QString& label, bool isBelow = true);
    bool isMarked() const { return label_ != nullptr; }
    QString effectLabel() const;
    /// Where that label stands on the screen; empty: it has none. [px]
    QRectF effectRect(const QTransform& toView) const;
    /// The body without texts and outline.
    QRectF body() const { return body_; }
    /// Its connectors as they are drawn.
    std::vector<QRectF> ports() const;
    /// What a tooltip of the block says besides what it is, as HTML.
    void setRemarks(const QStringList& remarks) { remarks_ = remarks; }
    /// Where the name and the values stand: above or below the body, in its middle or to one side of it.
    struct LabelPlace {
        bool isAbove{};
        int side{};   // -1: ends at the middle, 0: centred, 1: begins at the middle
        int lines{};  // by which the name stands further from the block than it would alone
        bool operator==(const LabelPlace&) const = default;
    };
    void setLabelPlace(LabelPlace place);
    LabelPlace labelPlace() const { return labelPlace_; }
    LabelPlace preferredLabelPlace() const { return {isNameAbove_, 0}; }
    /// The name as it stands on the screen, with the font of the view. [px]
    QRectF nameRect(const QTransform& toView, QFont font) const;
    /// What the texts would cover there, at the zoom of a diagram that fits the window.
    QRectF labelRect(LabelPlace place) const;
    /// The same where they stand.
    QRectF labelRect() const { return labelRect(labelPlace_); }

    int type() const override { return Type; }
    QRectF boundingRect() const override { return bounds_; }
    QPainterPath shape() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

protected:
    void hoverEnterEvent(QGraphicsSceneHoverEvent* event) override;
    void hoverMoveEvent(QGraphicsSceneHoverEvent* event) override;
    void hoverLeaveEvent(QGraphicsSceneHoverEvent* event) override;

private:
    class EffectLabel;
    struct PortShape {
        const Port* port;
        QTransform transform;
        QRectF rect;
    };
    /// What a picture of the icon depends on.
    struct PictureKey {
        QTransform toDevice;  // without whole pixels
        qreal ratio{};
        qint64 palette{};
        QFont font;
        bool operator==(const PictureKey&) const = default;
    };
    void paintIcon(QPainter& painter, const QPalette& palette);
    void paintShapes(QPainter& painter, const QPalette& palette) const;
    void paintUnresolved(QPainter& painter, const QPalette& palette) const;
    QRectF nameLine(const QTransform& toView, const QFont& font) const;
    int labelAlignment() const;
    void paintName(QPainter& painter, const QPalette& palette) const;
    void paintParameters(QPainter& painter, const QPalette& palette, QRectF nameBox, double zoom) const;
    void paintLine(QPainter& painter, const QRectF& box, const QString& text, const QColor& ink,
                   const QPalette& palette) const;
    QString tooltip(const PortShape* port) const;
    QString macro(const QString& name) const;
    const PortShape* portAt(QPointF at) const;

    Block block_;
    QTransform transform_;
    QRectF body_, bounds_, shapes_;
    QPointF nameAt_;  // where the icon wants the component's name: its edge next to the body
    bool isNameAbove_{};
    bool staysInside_{true};  // no text of its icon is larger than its place
    LabelPlace labelPlace_;
    QStringList values_;  // "R = 2.452"
    QStringList remarks_;
    std::vector<PortShape> ports_;
    const PortShape* hovered_{};
    EffectLabel* label_{};
    bool isHovered_{};
    QPixmap picture_;  // of the icon with its ports
    PictureKey pictureKey_;
};

}  // namespace analogon::ui
