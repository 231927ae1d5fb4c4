#pragma once

#include <QByteArray>
#include <QSizeF>
#include <QString>

#include "core/base/outcome.hpp"

namespace analogon::ui {

/// A picture as a model keeps it in its text.
struct KeptPicture {
    QByteArray bytes;  // of a PNG or JPEG file
    QSizeF size;       // [px]
};

/// Reads a picture file. What would make the text of the model long is made smaller: a diagram shows no more of it.
Outcome<KeptPicture> keptPicture(const QString& file);

}  // namespace analogon::ui
