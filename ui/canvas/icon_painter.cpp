#include "ui/canvas/icon_painter.hpp"

#include <QBuffer>
#include <QDateTime>
#include <QFileInfo>
#include <QImageReader>
#include <QPainter>
#include <QPixmapCache>
#include <QRegularExpression>
#include <cmath>

#include "core/diagram/annotation.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

QColor toColour(const Colour& c) { return QColor(c.r & 255, c.g & 255, c.b & 255); }

QTransform toScene(const Placement& placement, const Extent& coordinates) {
    const QPolygonF from{QVector<QPointF>{{coordinates.p1.x, coordinates.p1.y},
                                          {coordinates.p2.x, coordinates.p1.y},
                                          {coordinates.p2.x, coordinates.p2.y},
                                          {coordinates.p1.x, coordinates.p2.y}}};
    QPolygonF to;
    for (const QPointF& corner : from) to << toScene(map(placement, coordinates, {corner.x(), corner.y()}));
    QTransform transform;
    if (!QTransform::quadToQuad(from, to, transform)) return {};
    return transform;
}

namespace {

QTransform withOwn(const Primitive& p, const QTransform& transform) {
    QTransform own;
    own.translate(p.origin.x, p.origin.y);
    own.rotate(p.rotation);
    return own * transform;
}

QRectF rectOf(const Extent& e) { return QRectF(QPointF(e.p1.x, e.p1.y), QPointF(e.p2.x, e.p2.y)).normalized(); }

QPainterPath curve(const std::vector<Point>& points, bool smooth) {
    QPainterPath path;
    if (points.empty()) return path;
    const auto at = [&](std::size_t i) { return QPointF(points[i].x, points[i].y); };
    path.moveTo(at(0));
    if (!smooth || points.size() < 3) {
        for (std::size_t i = 1; i < points.size(); ++i) path.lineTo(at(i));
        return path;
    }
    // Modelica's smooth line: quadratic arcs between the middles of its segments.
    path.lineTo((at(0) + at(1)) / 2);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) path.quadTo(at(i), (at(i) + at(i + 1)) / 2);
    path.lineTo(at(points.size() - 1));
    return path;
}

QPainterPath shapeOf(const Primitive& p) {
    QPainterPath path;
    const QRectF rect = rectOf(p.extent);
    switch (p.kind) {
        case Primitive::Kind::Line:
            return curve(p.points, p.smooth);
        case Primitive::Kind::Polygon:
            path = curve(p.points, p.smooth);
            path.closeSubpath();
            return path;
        case Primitive::Kind::Rectangle:
            path.addRoundedRect(rect, p.radius, p.radius);
            return path;
        case Primitive::Kind::Ellipse: {
            const double sweep = p.endAngle - p.startAngle;
            if (std::abs(sweep) >= 360) {
                path.addEllipse(rect);
            } else {
                // The icon's y runs upward, so Qt's angles turn the other way.
                path.arcMoveTo(rect, -p.startAngle);
                path.arcTo(rect, -p.startAngle, -sweep);
            }
            return path;
        }
        case Primitive::Kind::Text:
        case Primitive::Kind::Bitmap:
            break;
    }
    path.addRect(rect);
    return path;
}

QBrush fillOf(const Primitive& p, const QRectF& bounds, const QPalette& palette) {
    if (!p.filled) return Qt::NoBrush;
    const QColor fill = style::onCanvas(toColour(p.fill), palette);
    if (p.gradient == Gradient::None) return fill;
    const QColor edge = style::mix(style::onCanvas(toColour(p.line), palette), fill, 0.35);
    if (p.gradient == Gradient::Sphere) {
        QRadialGradient sphere(bounds.center(), std::max(bounds.width(), bounds.height()) / 2);
        sphere.setColorAt(0, fill);
        sphere.setColorAt(1, edge);
        return sphere;
    }
    const bool across = p.gradient == Gradient::HorizontalCylinder;
    QLinearGradient cylinder(bounds.topLeft(), across ? bounds.bottomLeft() : bounds.topRight());
    cylinder.setColorAt(0, edge);
    cylinder.setColorAt(0.45, fill);
    cylinder.setColorAt(1, edge);
    return cylinder;
}

QPen penOf(const Primitive& p, double deviceScale, const QPalette& palette) {
    if (!p.outlined) return Qt::NoPen;
    const double width = std::max(p.thickness * 0.9, 1.0 / deviceScale);  // never under a pixel
    QPen pen(style::onCanvas(toColour(p.line), palette), width, p.dashed ? Qt::DashLine : Qt::SolidLine, Qt::RoundCap,
             Qt::RoundJoin);
    return pen;
}

QString expanded(const QString& text, const TextMacros& macros) {
    static const QRegularExpression macro(R"(%(%|\{[^}]*\}|[A-Za-z_][A-Za-z0-9_.]*))");
    QString result;
    qsizetype end = 0;
    for (auto it = macro.globalMatch(text); it.hasNext();) {
        const QRegularExpressionMatch match = it.next();
        QString name = match.captured(1);
        if (name.startsWith('{')) name = name.mid(1, name.size() - 2);
        result += text.mid(end, match.capturedStart() - end);
        result += name == "%" ? QStringLiteral("%") : macros(name);
        end = match.capturedEnd();
    }
    return result + text.mid(end);
}

void paintText(QPainter& painter, const Primitive& p, const QRectF& scene, const TextMacros& macros,
               const QPalette& palette) {
    const QString text = expanded(QString::fromStdString(p.text), macros);
    if (text.isEmpty()) return;
    painter.save();
    const QTransform world = painter.worldTransform();
    QRectF rect = world.mapRect(scene);
    painter.resetTransform();
    const double deviceScale = std::sqrt(std::abs(world.determinant()));
    QFont font = painter.font();
    double pixels = p.fontSize > 0 ? p.fontSize * 0.3 * deviceScale : rect.height() * 0.72;
    font.setBold(p.bold);
    font.setPixelSize(100);
    const double width = QFontMetricsF(font).horizontalAdvance(text) / 100;
    if (p.fontSize <= 0 && width * pixels > rect.width() && rect.width() > 0) pixels = rect.width() / width;
    if (pixels >= 6.5) {  // smaller is not readable
        font.setPixelSize(static_cast<int>(std::round(pixels)));
        painter.setFont(font);
        painter.setPen(style::onCanvas(toColour(p.line), palette));
        const int horizontal = p.alignment < 0 ? Qt::AlignLeft : p.alignment > 0 ? Qt::AlignRight : Qt::AlignHCenter;
        painter.drawText(rect, horizontal | Qt::AlignVCenter | Qt::TextDontClip, text);
    }
    painter.restore();
}

/// What a picture is known by: a file that was written anew is another one.
QString keyOf(const Primitive& p, const QFileInfo& file) {
    const QByteArrayView text(p.text.data(), static_cast<qsizetype>(p.text.size()));
    QString key = QStringLiteral("bitmap-%1-%2").arg(text.size()).arg(qHash(text));
    if (file.isFile()) key += QStringLiteral("-%1-%2").arg(file.size()).arg(file.lastModified().toMSecsSinceEpoch());
    return key;
}

/// Decoded once, not with every stroke of the wheel; null: it cannot be read, which is found out once, too.
QPixmap decodedPicture(const Primitive& p) {
    constexpr qint64 largest = 64 << 20;  // [bytes] of a file
    const std::string_view bytes = annotation::pictureBytes(p);
    const QFileInfo file(bytes.empty() ? QString::fromStdString(annotation::pictureFile(p)) : QString());
    const QString key = keyOf(p, file), failed = key + "-failed";
    QPixmap picture;
    if (QPixmapCache::find(key, &picture)) return picture;
    if (QPixmapCache::find(failed, nullptr)) return {};
    QBuffer buffer;
    QImageReader reader;
    if (!bytes.empty()) {
        buffer.setData(QByteArray::fromBase64(QByteArray(bytes.data(), static_cast<qsizetype>(bytes.size()))));
        buffer.open(QIODevice::ReadOnly);
        reader.setDevice(&buffer);
    } else if (file.isFile() && file.size() <= largest) {
        reader.setFileName(file.filePath());
    }
    reader.setAutoTransform(true);
    if (reader.device() || !reader.fileName().isEmpty()) picture = QPixmap::fromImage(reader.read());
    if (picture.isNull())
        QPixmapCache::insert(failed, QPixmap(1, 1));  // a null one is not kept
    else
        QPixmapCache::insert(key, picture);
    return picture;
}

/// As large as it goes into its extent with the proportions that it has; one that cannot be read is an empty frame.
void paintPicture(QPainter& painter, const Primitive& p, const QTransform& own, const QPalette& palette) {
    const QPixmap picture = decodedPicture(p);
    const QRectF extent = rectOf(p.extent);
    painter.save();
    painter.setTransform(own, true);
    if (picture.isNull()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(style::mutedText(palette), 0, Qt::DashLine));
        painter.drawRect(extent);
    } else {
        QSizeF size = picture.size();
        size.scale(extent.size(), Qt::KeepAspectRatio);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.translate(extent.center());
        painter.scale(1, -1);  // the diagram's y runs upward
        painter.drawPixmap(QRectF(QPointF(-size.width() / 2, -size.height() / 2), size), picture, picture.rect());
    }
    painter.restore();
}

void paintArrow(QPainter& painter, QPointF tip, QPointF from, double size) {
    const QLineF line(tip, from);
    if (line.length() <= 0) return;
    const QPointF back = (from - tip) / line.length() * size;
    const QPointF across(-back.y() * 0.4, back.x() * 0.4);
    painter.drawPolygon(QPolygonF{QVector<QPointF>{tip, tip + back + across, tip + back - across}});
}

}  // namespace

void paintPrimitives(QPainter& painter, const std::vector<Primitive>& primitives, const QTransform& transform,
                     const TextMacros& macros, const QPalette& palette) {
    const double deviceScale = std::sqrt(std::abs(painter.worldTransform().determinant()));
    for (const Primitive& p : primitives) {
        const QTransform own = withOwn(p, transform);
        const QPainterPath path = own.map(shapeOf(p));
        if (p.kind == Primitive::Kind::Text) {
            paintText(painter, p, path.boundingRect(), macros, palette);
            continue;
        }
        if (p.kind == Primitive::Kind::Bitmap) {
            paintPicture(painter, p, own, palette);
            continue;
        }
        const QPen pen = penOf(p, deviceScale, palette);
        painter.setPen(pen);
        const bool isLine = p.kind == Primitive::Kind::Line;
        painter.setBrush(isLine ? QBrush(Qt::NoBrush) : fillOf(p, path.boundingRect(), palette));
        painter.drawPath(path);
        if (isLine && p.points.size() >= 2 && (p.arrowAtStart || p.arrowAtEnd)) {
            const auto at = [&](std::size_t i) { return own.map(QPointF(p.points[i].x, p.points[i].y)); };
            const std::size_t n = p.points.size();
            const double size = 1.4;  // diagram units
            painter.setPen(Qt::NoPen);
            painter.setBrush(pen.color());
            if (p.arrowAtStart) paintArrow(painter, at(0), at(1), size);
            if (p.arrowAtEnd) paintArrow(painter, at(n - 1), at(n - 2), size);
        }
    }
}

QRectF boundsOf(const std::vector<Primitive>& primitives, const QTransform& transform) {
    QRectF bounds;
    for (const Primitive& p : primitives) bounds |= withOwn(p, transform).map(shapeOf(p)).boundingRect();
    return bounds;
}

}  // namespace analogon::ui
