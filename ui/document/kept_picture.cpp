#include "ui/document/kept_picture.hpp"

#include <QBuffer>
#include <QFile>
#include <QFileInfo>
#include <QImageReader>

namespace analogon::ui {

namespace {

constexpr qint64 largestFile = 64 << 20, largestKept = 256 << 10;  // [bytes]
constexpr int widestKept = 1200;                                   // [px] on either side

QByteArray encoded(const QImage& picture, const char* format) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    return picture.save(&buffer, format) ? bytes : QByteArray();
}

}  // namespace

Outcome<KeptPicture> keptPicture(const QString& path) {
    const QFileInfo info(path);
    const std::string name = info.fileName().toStdString();
    if (!info.isFile()) return error(phrase("'{}' is not a file", name));
    if (info.size() > largestFile) return error(phrase("'{}' is larger than 64 MB: make the picture smaller", name));
    QImageReader reader(path);
    reader.setDecideFormatFromContent(true);
    reader.setAutoTransform(true);
    QImage picture = reader.read();
    if (picture.isNull()) return error(phrase("'{}' cannot be read as a picture: PNG, JPEG and SVG can", name));
    const QByteArray format = reader.format();
    const bool isKeptAsItIs = info.size() <= largestKept && (format == "png" || format == "jpeg") &&
                              reader.transformation() == QImageIOHandler::TransformationNone;
    QByteArray bytes;
    if (isKeptAsItIs) {
        QFile file(path);
        if (file.open(QIODevice::ReadOnly)) bytes = file.readAll();
    } else {
        if (picture.width() > widestKept || picture.height() > widestKept)
            picture = picture.scaled(widestKept, widestKept, Qt::KeepAspectRatio, Qt::SmoothTransformation);
        bytes = encoded(picture, "png");
        if (bytes.size() > largestKept && !picture.hasAlphaChannel()) bytes = encoded(picture, "jpeg");
    }
    if (bytes.isEmpty()) return error(phrase("'{}' cannot be read as a picture: PNG, JPEG and SVG can", name));
    return KeptPicture{bytes, picture.size()};
}

}  // namespace analogon::ui
