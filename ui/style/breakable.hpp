#pragma once

#include <QString>

namespace analogon::ui {

/// A name as HTML that may break behind each sign in it, and within a long word without one: in a narrow legend it
/// takes another line, and no letter of it is cut off. One of no more than `whole` letters stays in one piece: for
/// where there is room for so many.
QString breakable(const QString& name, int whole = 0);

/// A plain text whose names may break behind their dots and underscores; its words stay whole.
QString breakableAtSigns(const QString& text);

}  // namespace analogon::ui
