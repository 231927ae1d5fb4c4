#pragma once

#include <QString>

class QAbstractAxis;
class QFont;
class QPalette;

namespace analogon::ui {

/// Labels and lines of an axis in the colours of the palette, a little smaller than `font`.
void styleAxis(QAbstractAxis& axis, const QFont& font, const QPalette& palette);

/// An axis with a title and so styled: logarithmic (a LogAxis, whose series hold logarithms), or linear with labels of
/// this format.
QAbstractAxis* makeAxis(const QString& title, bool isLogarithmic, const QString& linearFormat, const QFont& font,
                        const QPalette& palette);

}  // namespace analogon::ui
