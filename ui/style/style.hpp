#pragma once

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <QString>

class QAbstractItemView;
class QApplication;
class QProgressBar;
class QTreeView;
class QWidget;

/// Colours, spacing and icons, all taken from the palette, so that the dark theme is free.
namespace analogon::ui::style {

enum class Theme { System, Light, Dark };

/// Fusion with our palette. System: light or dark as the desktop's own palette is.
void apply(QApplication& application, Theme theme);
Theme current();

bool isDark(const QPalette& palette);
/// a*(1-t) + b*t
QColor mix(const QColor& a, const QColor& b, double t);

QColor accent(const QPalette& palette);
QColor accentText(const QPalette& palette);  // words in it
QColor mutedText(const QPalette& palette);
QColor hairline(const QPalette& palette);
QColor canvas(const QPalette& palette);
QColor good(const QPalette& palette);
QColor caution(const QPalette& palette);
QColor fault(const QPalette& palette);

/// Traces: told apart without red against green.
QColor measuredTrace(const QPalette& palette);
QColor beforeTrace(const QPalette& palette);
QColor afterTrace(const QPalette& palette);
/// Of a signal that is none of these three: colours told apart without red against green, in turn from 0 on.
QColor signalTrace(int index, const QPalette& palette);

/// A colour meant for white paper, as it must be drawn on this palette's canvas (same hue, turned lightness).
QColor onCanvas(const QColor& paper, const QPalette& palette);

/// Drawn from :/icons/NAME.svg in the palette's text colour; follows theme changes.
QIcon icon(const QString& name);

inline constexpr int unit = 4;  // [px] spacing comes in multiples of it
inline constexpr int margin = 3 * unit;

/// What to do next, in the middle of a list while nothing is in it.
void showWhenEmpty(QAbstractItemView* list, const QString& advice);

/// Whether a user has typed into this editor of a cell: results that arrive meanwhile do not take that back.
bool isTypedInto(const QWidget* editor);

/// Texts of this column break into lines where the column is too narrow, and its rows are as high as they need.
void wrapColumn(QTreeView* view, int column);

/// Secondary text: smaller and muted.
void makeCaption(QWidget* label);
/// A low bar without a figure, which keeps its room while it is hidden.
void makeQuiet(QProgressBar* bar);
/// A heading of a panel or a card.
void makeHeading(QWidget* label, double scale = 1.15);

}  // namespace analogon::ui::style
