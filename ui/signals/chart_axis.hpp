#pragma once

#include <QString>

class QAbstractAxis;
class QFont;
class QPalette;

namespace analogon::ui {

/// Labels and lines of an axis in the colours of the palette, a little smaller than `font`.
void styleAxis(QAbstractAxis& axis, const QFont& font, const QPalette& palette);

/// An axis with a title and so styled: logarithmic to the base 10, or linear with labels of this format.
QAbstractAxis* makeAxis(const QString& title, bool isLogarithmic, const QString& linearFormat, const QFont& font,
                        const QPalette& palette);

}  // namespace analogon::ui
