#include "ui/style/number.hpp"

#include <QCoreApplication>
#include <QRegularExpression>
#include <cmath>

namespace analogon::ui::style {

/// The translation of the code of a language is the code of the language of the translation.
QLocale windowLocale() { return QLocale(QCoreApplication::translate("Language", "en")); }

QString withDecimalSign(std::string_view numbers) {
    return QString::fromUtf8(numbers.data(), static_cast<qsizetype>(numbers.size()))
        .replace(QLatin1Char('.'), windowLocale().decimalPoint());
}

QString numberText(double value, int digits) {
    if (!std::isfinite(value)) return QStringLiteral("–");
    QLocale plain = QLocale::c();
    plain.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::OmitLeadingZeroInExponent);
    return withDecimalSign(plain.toString(value, 'g', digits).remove('+').toStdString());
}

QString fixedText(double value, int decimals) {
    if (!std::isfinite(value)) return QStringLiteral("–");
    return withDecimalSign(QString::number(value, 'f', decimals).toStdString());
}

QString percentText(double value) {
    if (!std::isfinite(value)) return QStringLiteral("–");
    return fixedText(value, std::abs(value) < 9.995 ? 2 : 1) + QStringLiteral(" %");
}

QString numberWithUnit(const QString& number, const QString& unit) {
    return unit.isEmpty() || unit == "1" ? number : number + " " + unit;
}

QString nameWithUnit(const QString& name, const QString& unit) {
    return unit.isEmpty() || unit == "1" ? name : name + " [" + unit + "]";
}

QString countText(qulonglong count) {
    QString text = QString::number(count);
    for (qsizetype at = text.size() - 3; at > 0 && text.size() > 4; at -= 3) text.insert(at, QChar(0x202F));
    return text;
}

std::optional<double> readNumber(const QString& typed) {
    static const QRegularExpression form(QStringLiteral(R"(^[-+]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][-+]?\d+)?$)"));
    QString digits = typed.trimmed();
    digits.replace(QChar(0x2212), '-');  // the minus sign of typography, as it is copied from a text
    if (!form.match(digits).hasMatch()) return std::nullopt;
    const double value = digits.replace(',', '.').toDouble();
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace analogon::ui::style
