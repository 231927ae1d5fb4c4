#include <QFont>
#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "ui/document/composer.hpp"
#include "ui/document/document.hpp"
#include "ui/route/route.hpp"

/// The texts and pictures of a diagram.
namespace analogon::ui {

namespace {

constexpr double noteHeight = 10;                         // [diagram units]
constexpr double pictureWidth = 120, pictureHeight = 60;  // of a picture when it comes

/// As wide as its words are in a line of this height.
double noteWidth(const QString& text) {
    QFont font;
    font.setPixelSize(100);
    const double width = QFontMetricsF(font).horizontalAdvance(text) / 100 * 0.72 * noteHeight;
    return std::max(10.0, std::ceil(width / 5) * 5);
}

/// The left end of the first free line above blocks, wires, texts and pictures.
Point firstFreeLine(const Diagram& diagram) {
    double left = 1e300, top = -1e300;
    const auto take = [&](double x, double y) {
        left = std::min(left, x);
        top = std::max(top, y);
    };
    for (const Block& block : diagram.blocks) {
        const auto [low, high] = boxOf(block.placement);
        take(low.x, high.y + 15);  // its name may stand above it
    }
    for (const Wire& wire : diagram.wires)
        for (const Point p : wire.points) take(p.x, p.y);
    for (const Primitive& p : diagram.graphics)
        for (const Point corner : {p.extent.p1, p.extent.p2}) take(p.origin.x + corner.x, p.origin.y + corner.y);
    if (left > 1e299) return {-50, 0};
    return {std::floor(left / 10) * 10, std::ceil(top / 10) * 10 + 10};
}

}  // namespace

bool Composer::addText(const QString& text) {
    if (!isReady() || text.trimmed().isEmpty()) return false;
    const Point at = firstFreeLine(document_.diagram());
    const Extent extent{at, {at.x + noteWidth(text), at.y + noteHeight}};
    return apply(addGraphic(*document_.definition(), textRecord(extent, text.toStdString()),
                            QObject::tr("Add a text").toStdString()));
}

bool Composer::addPicture(const QByteArray& bytes, QSizeF size) {
    if (!isReady() || bytes.isEmpty() || size.isEmpty()) return false;
    const Point at = firstFreeLine(document_.diagram());
    size.scale(pictureWidth, pictureHeight, Qt::KeepAspectRatio);
    const Extent extent{at, {at.x + std::round(size.width()), at.y + std::round(size.height())}};
    return apply(addGraphic(*document_.definition(), pictureRecord(extent, bytes.toBase64().toStdString()),
                            QObject::tr("Add a picture").toStdString()));
}

bool Composer::moveNote(const OwnGraphic& note, double dx, double dy) {
    if (!isReady()) return false;
    const bool isText = note.primitive.kind == Primitive::Kind::Text;
    return apply(
        changeGraphic(*document_.definition(), note.begin, analogon::moved(note.primitive, dx, dy),
                      isText ? QObject::tr("Move a text").toStdString() : QObject::tr("Move a picture").toStdString()));
}

bool Composer::setText(const OwnGraphic& note, const QString& text) {
    if (!isReady() || text.toStdString() == note.primitive.text) return false;
    GraphicChange change;
    change.text = text.toStdString();
    // a line that fills its height grows with its words
    const auto [p1, p2] = note.primitive.extent;
    const double was = std::max(1e-9, noteWidth(QString::fromStdString(note.primitive.text)));
    change.extent = Extent{p1, {p1.x + (p2.x - p1.x) * noteWidth(text) / was, p2.y}};
    return apply(
        changeGraphic(*document_.definition(), note.begin, change, QObject::tr("Change a text").toStdString()));
}

bool Composer::removeNote(const OwnGraphic& note) {
    if (!isReady()) return false;
    const bool isText = note.primitive.kind == Primitive::Kind::Text;
    return apply(removeGraphic(
        *document_.definition(), note.begin,
        isText ? QObject::tr("Remove a text").toStdString() : QObject::tr("Remove a picture").toStdString()));
}

}  // namespace analogon::ui
