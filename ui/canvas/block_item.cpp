#include "ui/canvas/block_item.hpp"

#include <QCoreApplication>
#include <QGraphicsScene>
#include <QGraphicsSceneHoverEvent>
#include <QPaintEngine>
#include <QPainter>
#include <QStyleOptionGraphicsItem>
#include <algorithm>
#include <cmath>

#include "ui/canvas/icon_painter.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

constexpr double outlineGap = 3;  // [diagram units] between a block and the outline around it

QRectF coordinatesRect(const Extent& e) {
    return QRectF(QPointF(e.p1.x, e.p1.y), QPointF(e.p2.x, e.p2.y)).normalized();
}

/// Names are a little smaller than the view's font, and smaller still in a diagram that is seen from afar.
QFont nameFont(QFont font, double zoom) {
    font.setPointSizeF(font.pointSizeF() * 0.9 * std::clamp(zoom / 0.9, 0.8, 1.0));
    return font;
}

double zoomOf(const QTransform& toView) { return std::sqrt(std::abs(toView.determinant())); }

constexpr double sideGap = 3;  // [diagram units] between the middle of a block and a text beside it

/// A value that is a number, for reading; an expression as it stands in the model.
QString valueText(const std::string& text, int digits = 5) {
    const QString value = QString::fromStdString(text);
    bool isNumber = false;
    const double number = value.toDouble(&isNumber);
    return isNumber ? style::numberText(number, digits) : value;
}

/// The values a block was given, rounded for reading; the first few.
QStringList valueLines(const Block& block) {
    constexpr int most = 3;
    QStringList lines;
    if (block.isConnector) return lines;
    for (const auto& [name, text] : block.parameters) {
        if (text.find('(') != std::string::npos) continue;
        if (lines.size() == most) {
            lines.back() += QStringLiteral(" …");
            break;
        }
        QString value = valueText(text);
        constexpr qsizetype longest = 16;
        if (value.size() > longest) value = value.left(longest - 1) + QStringLiteral("…");
        lines << QString::fromStdString(name) + " = " + value;
    }
    return lines;
}

}  // namespace

/// The label of a found effect: readable at every zoom.
class BlockItem::EffectLabel : public QGraphicsItem {
public:
    EffectLabel(QGraphicsItem* parent, QString text, bool isBelow)
        : QGraphicsItem(parent), text_(std::move(text)), isBelow_(isBelow) {
        setFlag(ItemIgnoresTransformations);
        setZValue(10);
        setAcceptedMouseButtons(Qt::NoButton);
    }
    const QString& text() const { return text_; }
    QRectF boundingRect() const override {
        const QFontMetricsF metrics(font());
        const double width = metrics.horizontalAdvance(text_) + 20, height = metrics.height() + 8;
        return {-width / 2, isBelow_ ? 4 : -height - 4, width, height};
    }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget* widget) override {
        const QPalette palette = widget ? widget->palette() : QPalette();
        const QRectF box = boundingRect();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(Qt::NoPen);
        painter->setBrush(palette.color(QPalette::Active, QPalette::Highlight));
        painter->drawRoundedRect(box, box.height() / 2, box.height() / 2);
        painter->setFont(font());
        painter->setPen(palette.color(QPalette::Active, QPalette::HighlightedText));
        painter->drawText(box, Qt::AlignCenter, text_);
    }

private:
    QFont font() const {
        QFont f = scene() ? scene()->font() : QFont();
        f.setPointSizeF(f.pointSizeF() * 0.95);
        f.setWeight(QFont::DemiBold);
        return f;
    }
    QString text_;
    bool isBelow_;
};

BlockItem::BlockItem(const Block& block) : block_(block) {
    transform_ = toScene(block_.placement, block_.icon.coordinates);
    body_ = transform_.mapRect(coordinatesRect(block_.icon.coordinates));
    for (const Port& port : block_.ports) {
        // The port's own icon stands in the block's icon, which stands in the diagram.
        const Extent& e = port.icon.coordinates;
        const QPolygonF from{QVector<QPointF>{{e.p1.x, e.p1.y}, {e.p2.x, e.p1.y}, {e.p2.x, e.p2.y}, {e.p1.x, e.p2.y}}};
        QPolygonF to;
        for (const QPointF& corner : from) {
            const Point inIcon = map(port.placement, e, {corner.x(), corner.y()});
            to << transform_.map(QPointF(inIcon.x, inIcon.y));
        }
        PortShape shape{&port, {}, to.boundingRect()};
        QTransform::quadToQuad(from, to, shape.transform);
        ports_.push_back(shape);
    }
    // Names are set by us: readable at every zoom, which a text that scales with the icon is not.
    nameAt_ = {body_.center().x(), body_.bottom() + outlineGap};
    auto& primitives = block_.icon.primitives;
    for (const Primitive& p : primitives) {
        if (p.kind == Primitive::Kind::Text && p.fontSize > 0) staysInside_ = false;
        if (p.kind != Primitive::Kind::Text || p.text != "%name") continue;
        const QPointF at = boundsOf({p}, transform_).center();
        isNameAbove_ = at.y() < body_.center().y();
        nameAt_ = {at.x(), isNameAbove_ ? body_.top() - outlineGap : body_.bottom() + outlineGap};
    }
    std::erase_if(primitives, [](const Primitive& p) { return p.kind == Primitive::Kind::Text && p.text == "%name"; });
    values_ = valueLines(block_);
    setLabelPlace(preferredLabelPlace());
    setFlag(ItemIsSelectable);
    setAcceptHoverEvents(true);
    setZValue(1);
}

void BlockItem::setLabelPlace(LabelPlace place) {
    prepareGeometryChange();
    labelPlace_ = place;
    shapes_ = body_ | boundsOf(block_.icon.primitives, transform_);
    for (const PortShape& port : ports_) shapes_ |= port.rect;
    shapes_.adjust(-2, -2, 2, 2);  // the width of their lines
    bounds_ = shapes_.adjusted(-outlineGap, -outlineGap, outlineGap, outlineGap);
    bounds_ |= labelRect(place);
}

QRectF BlockItem::labelRect(LabelPlace place) const {
    constexpr double nameHeight = 8, lineHeight = 6, nameWidth = 3.5, lineWidth = 2.8;  // [diagram units] a character
    double width = nameWidth * static_cast<double>(block_.name.size());
    for (const QString& line : values_) width = std::max(width, lineWidth * static_cast<double>(line.size()));
    const double height = nameHeight + lineHeight * static_cast<double>(values_.size());
    const double x = nameAt_.x() + (place.side - 1) * width / 2 + place.side * sideGap;
    return {x, place.isAbove ? body_.top() - outlineGap - height : body_.bottom() + outlineGap, width, height};
}

void BlockItem::setEffect(const QString& label, bool isBelow) {
    delete label_;
    label_ = nullptr;
    if (!label.isEmpty()) {
        label_ = new EffectLabel(this, label, isBelow);
        label_->setPos(body_.center().x(), isBelow ? body_.bottom() + outlineGap : body_.top() - outlineGap);
    }
    setZValue(label_ ? 2 : 1);
    update();
}

QString BlockItem::effectLabel() const { return label_ ? label_->text() : QString(); }

QRectF BlockItem::effectRect(const QTransform& toView) const {
    return label_ ? label_->boundingRect().translated(toView.map(label_->pos())) : QRectF();
}

std::vector<QRectF> BlockItem::ports() const {
    std::vector<QRectF> rects;
    for (const PortShape& port : ports_) rects.push_back(port.rect);
    return rects;
}

QPainterPath BlockItem::shape() const {
    QPainterPath path;
    path.addRect(body_);
    for (const PortShape& port : ports_) path.addRect(port.rect);
    return path;
}

QString BlockItem::macro(const QString& name) const {
    if (name == "name") return QString::fromStdString(block_.name);
    if (name == "class") return QString::fromStdString(block_.className).section('.', -1);
    for (const auto& [parameter, text] : block_.parameters)
        if (name == QString::fromStdString(parameter)) return valueText(text);
    return name;
}

void BlockItem::paintUnresolved(QPainter& painter, const QPalette& palette) const {
    painter.setPen(QPen(style::fault(palette), 0.6, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(body_, 1, 1);
}

/// The line that the name stands in, wider than any name.
QRectF BlockItem::nameLine(const QTransform& toView, const QFont& font) const {
    const QPointF at =
        toView.map(QPointF(nameAt_.x() + labelPlace_.side * sideGap,
                           labelPlace_.isAbove ? body_.top() - outlineGap : body_.bottom() + outlineGap));
    const double height = QFontMetricsF(font).height(), wide = 400;
    const double left = at.x() + (labelPlace_.side - 1) * wide / 2;
    const double away = height * labelPlace_.lines;
    return {left, labelPlace_.isAbove ? at.y() - height - away : at.y() + away, wide, height};
}

QRectF BlockItem::nameRect(const QTransform& toView, QFont font) const {
    font = nameFont(font, zoomOf(toView));
    return QFontMetricsF(font).boundingRect(nameLine(toView, font), labelAlignment(),
                                            QString::fromStdString(block_.name));
}

int BlockItem::labelAlignment() const {
    return Qt::AlignVCenter | (labelPlace_.side == 0  ? Qt::AlignHCenter
                               : labelPlace_.side > 0 ? Qt::AlignLeft
                                                      : Qt::AlignRight);
}

void BlockItem::paintName(QPainter& painter, const QPalette& palette) const {
    const QTransform world = painter.worldTransform();
    const double zoom = zoomOf(world);
    if (zoom < leastZoomWithNames) return;
    painter.save();
    painter.resetTransform();
    const QFont font = nameFont(painter.font(), zoom);
    painter.setFont(font);
    const QRectF box = nameLine(world, font);
    const QColor ink = block_.isResolved ? style::mix(palette.color(QPalette::Text), style::canvas(palette), 0.2)
                                         : style::fault(palette);
    paintLine(painter, box, QString::fromStdString(block_.name), ink, palette);
    paintParameters(painter, palette, box, zoom);
    painter.restore();
}

/// A wire that runs under a text does not strike it out.
void BlockItem::paintLine(QPainter& painter, const QRectF& box, const QString& text, const QColor& ink,
                          const QPalette& palette) const {
    const int align = labelAlignment();
    QColor ground = style::canvas(palette);
    ground.setAlphaF(0.8f);
    painter.fillRect(QFontMetricsF(painter.font()).boundingRect(box, align, text), ground);
    painter.setPen(ink);
    painter.drawText(box, align, text);
}

/// The values it was given, in quiet lines beyond its name, where there is room for them.
void BlockItem::paintParameters(QPainter& painter, const QPalette& palette, QRectF nameBox, double zoom) const {
    if (zoom < 1.55) return;
    QFont font = painter.font();
    font.setPointSizeF(font.pointSizeF() * 0.85);
    painter.setFont(font);
    const double height = QFontMetricsF(font).height();
    double top = labelPlace_.isAbove ? nameBox.top() - height * static_cast<double>(values_.size()) : nameBox.bottom();
    for (const QString& line : values_) {
        paintLine(painter, QRectF(nameBox.left(), top, nameBox.width(), height), line, style::mutedText(palette),
                  palette);
        top += height;
    }
}

void BlockItem::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) {
    const QPalette palette = widget ? widget->palette() : QPalette();
    painter->setRenderHint(QPainter::Antialiasing);
    const QColor accent = style::accent(palette);
    const QRectF around = body_.adjusted(-outlineGap, -outlineGap, outlineGap, outlineGap);
    const double pixel = 1.0 / std::max(0.01, std::sqrt(std::abs(painter->worldTransform().determinant())));
    const bool isSelected = option->state & QStyle::State_Selected;
    if (label_) {
        QColor tint = accent;
        tint.setAlphaF(0.14f);
        painter->setPen(QPen(accent, 2 * pixel));
        painter->setBrush(tint);
        painter->drawRoundedRect(around, 2, 2);
    } else if (isSelected || isHovered_) {
        QColor tint = accent;
        tint.setAlphaF(isSelected ? 0.12f : 0.06f);
        painter->setPen(isSelected ? QPen(accent, 1.5 * pixel) : QPen(Qt::NoPen));
        painter->setBrush(tint);
        painter->drawRoundedRect(around, 2, 2);
    }
    if (!label_) paintName(*painter, palette);
    if (!block_.isResolved) return paintUnresolved(*painter, palette);
    paintIcon(*painter, palette);
    if (!hovered_) return;
    painter->setPen(QPen(accent, 2 * pixel));
    painter->setBrush(Qt::NoBrush);
    painter->drawEllipse(hovered_->rect.center(), hovered_->rect.width() * 0.9, hovered_->rect.height() * 0.9);
}

/// Of hundreds of blocks few change from one picture of the diagram to the next: each keeps the picture of its icon.
void BlockItem::paintIcon(QPainter& painter, const QPalette& palette) {
    const QTransform toDevice = painter.deviceTransform();
    const QRect pixels = toDevice.mapRect(shapes_).toAlignedRect().adjusted(-1, -1, 1, 1);
    constexpr qint64 most = 128 * 128;  // larger ones are few at a time, and would take much memory
    const bool isOnScreen = painter.paintEngine()->type() == QPaintEngine::Raster;
    if (!isOnScreen || !staysInside_ || qint64{pixels.width()} * pixels.height() > most)
        return paintShapes(painter, palette);
    const auto shifted = [](const QTransform& t, QPoint by) { return t * QTransform::fromTranslate(by.x(), by.y()); };
    const qreal ratio = painter.device()->devicePixelRatio();
    const PictureKey key{shifted(toDevice, -pixels.topLeft()), ratio, palette.cacheKey(), painter.font()};
    if (!(key == pictureKey_)) {
        picture_ = QPixmap(pixels.size());
        picture_.setDevicePixelRatio(ratio);
        picture_.fill(Qt::transparent);
        QPainter drawing(&picture_);
        drawing.setRenderHint(QPainter::Antialiasing);
        drawing.setFont(painter.font());
        drawing.setWorldTransform(key.toDevice * QTransform::fromScale(1 / ratio, 1 / ratio));
        paintShapes(drawing, palette);
        pictureKey_ = key;
    }
    painter.save();
    painter.resetTransform();
    painter.drawPixmap(painter.deviceTransform().inverted().map(QPointF(pixels.topLeft())), picture_);
    painter.restore();
}

void BlockItem::paintShapes(QPainter& painter, const QPalette& palette) const {
    const auto macros = [this](const QString& name) { return macro(name); };
    paintPrimitives(painter, block_.icon.primitives, transform_, macros, palette);
    for (const PortShape& port : ports_) {
        // A port is a place to connect to; its name would only clutter the block.
        std::vector<Primitive> shapes;
        for (const Primitive& p : port.port->icon.primitives)
            if (p.kind != Primitive::Kind::Text) shapes.push_back(p);
        paintPrimitives(painter, shapes, port.transform, macros, palette);
    }
}

const BlockItem::PortShape* BlockItem::portAt(QPointF at) const {
    for (const PortShape& port : ports_)
        if (port.rect.adjusted(-1, -1, 1, 1).contains(at)) return &port;
    return nullptr;
}

QString BlockItem::tooltip(const PortShape* port) const {
    const auto text = [](const std::string& s) { return QString::fromStdString(s).toHtmlEscaped(); };
    if (port) {
        QString tip = QStringLiteral("<b>%1.%2</b><br>%3")
                          .arg(text(block_.name), text(port->port->name), text(port->port->className));
        if (!port->port->description.empty())
            tip += "<br>" + QCoreApplication::translate("Library", port->port->description.c_str()).toHtmlEscaped();
        return tip;
    }
    QString tip = QStringLiteral("<b>%1</b><br>%2").arg(text(block_.name), text(block_.className));
    if (!block_.isResolved) tip += "<br>" + QObject::tr("This class is not known.");
    if (!block_.description.empty())
        tip += "<br>" + QCoreApplication::translate("Library", block_.description.c_str()).toHtmlEscaped();
    constexpr int digits = 12;  // as many as were written
    for (const auto& [name, value] : block_.parameters)
        tip += "<br>" + text(name) + " = " + valueText(value, digits).toHtmlEscaped();
    for (const QString& remark : remarks_) tip += "<br>" + remark;
    return tip;
}

void BlockItem::hoverEnterEvent(QGraphicsSceneHoverEvent* event) {
    isHovered_ = true;
    hoverMoveEvent(event);
    update();
}

void BlockItem::hoverMoveEvent(QGraphicsSceneHoverEvent* event) {
    const PortShape* port = portAt(event->pos());
    if (port != hovered_) update();
    hovered_ = port;
    setToolTip(tooltip(port));
}

void BlockItem::hoverLeaveEvent(QGraphicsSceneHoverEvent*) {
    isHovered_ = false;
    hovered_ = nullptr;
    update();
}

}  // namespace analogon::ui
