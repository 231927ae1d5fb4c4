#pragma once

#include <QColor>
#include <functional>

class QAbstractItemView;
class QListWidgetItem;
class QPalette;
class QTreeWidgetItem;
class QWidget;

namespace analogon::ui::style {

/// A colour by its meaning: `style::fault`, `style::mutedText`.
using Ink = QColor (*)(const QPalette&);

/// The words of a label in this ink, also in the theme that is chosen next; null: in the palette's own.
void tint(QWidget& label, Ink ink);

/// The same for the words of an item in a list that follows the theme.
void tint(QTreeWidgetItem& item, int column, Ink ink, const QPalette& palette);
void tint(QListWidgetItem& item, Ink ink, const QPalette& palette);
void followTheme(QAbstractItemView& view);

/// Once after a theme was chosen: for colours that were written down where none of these keeps them, as in rich text.
void onThemeChange(QWidget& widget, std::function<void()> redraw);

}  // namespace analogon::ui::style
