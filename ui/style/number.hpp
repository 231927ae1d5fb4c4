#pragma once

#include <QLocale>
#include <QString>
#include <optional>
#include <string_view>

/// Numbers as people read and type them. What the window shows has the decimal sign of its language, a comma in German;
/// files, models and studies have the point and do not come from here.
namespace analogon::ui::style {

/// That of the texts of the window, whatever the desktop's is.
QLocale windowLocale();

/// What was written with a point ("(2.10 ± 0.03)e-11", the digits of a `Text::number`), with the sign of the window.
QString withDecimalSign(std::string_view numbers);

/// A number as an engineer writes it: so many significant digits, no trailing zeros, an exponent as short as the
/// reports write it ("5e-5"); a dash for what is no number.
QString numberText(double value, int digits = 5);
/// "12.50": so many decimals, of which none is left out.
QString fixedText(double value, int decimals);
/// "8.61 %", "12.3 %"; a dash for what is no number.
QString percentText(double value);
/// "3 Ohm"; the number alone where there is no unit.
QString numberWithUnit(const QString& number, const QString& unit);
/// "R [Ohm]", likewise.
QString nameWithUnit(const QString& name, const QString& unit);
/// Groups of three with a narrow space, which every language reads the same: "12 345".
QString countText(qulonglong count);

/// What was typed, with a point or a comma in any language. There is no sign between thousands: "1.234,5" is none, and
/// "1,234" is less than two.
std::optional<double> readNumber(const QString& typed);

}  // namespace analogon::ui::style
