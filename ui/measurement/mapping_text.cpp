#include "ui/measurement/mapping_text.hpp"

#include <QCoreApplication>
#include <QRegularExpression>

#include "core/base/unit.hpp"
#include "core/measure/all_channels.hpp"
#include "core/measure/channel_place.hpp"
#include "core/measure/common_raster.hpp"
#include "core/study/recorded.hpp"
#include "ui/style/number.hpp"

namespace analogon::ui {

const Column* columnOf(const Table* file, const ChannelName& name) {
    if (!file) return nullptr;
    const std::vector<ChannelPlace> places = placesOf(*file, name);
    return places.size() == 1 ? places.front().column : nullptr;
}

QString labelText(const Table* file, const ChannelName& name) {
    const Column* column = columnOf(file, name);
    return QString::fromStdString(column ? labelOf(*file, *column) : name.column);
}

std::vector<const Column*> channelsOf(const Table& file) {
    std::vector<const Column*> channels;
    const std::vector<const Table*> groups = tablesOf(file);
    for (const Table* const group : groups)
        for (std::size_t i = 0; i < group->columns.size(); ++i)
            if (groups.size() == 1 || group->time != i) channels.push_back(&group->columns[i]);
    return channels;
}

QString withUnit(const std::string& label, const std::string& unit) {
    const QString text = QString::fromStdString(label);
    return unit.empty() ? text : text + QStringLiteral("  [%1]").arg(QString::fromStdString(unit));
}

QString columnText(const Table* table, const ChannelMapping& mapping) {
    const Column* column = columnOf(table, mapping.channel());
    const std::string unit = mapping.unit.empty() && column ? column->unit : mapping.unit;
    QString text = withUnit(column ? labelOf(*table, *column) : mapping.column, unit);
    if (mapping.interpolation == Interpolation::Hold)
        text += QStringLiteral(" · ") + QCoreApplication::translate("MeasurementPanel", "held");
    return text;
}

QString clockTip(bool isOutput) {
    const QString tip = QCoreApplication::translate(
        "MeasurementPanel", "How far the clock of this channel's logger is ahead of the others");
    return isOutput ? tip + QCoreApplication::translate(
                                "MeasurementPanel", ": seconds, or fit to find it. The result is among the parameters.")
                    : tip + QCoreApplication::translate("MeasurementPanel", ", in seconds");
}

QString mappingTip(const ChannelMapping& mapping, const QString& file) {
    QString tip = QCoreApplication::translate("MeasurementPanel", "Column %1 of %2")
                      .arg(QString::fromStdString(mapping.column), file);
    if (mapping.scale != 1)
        tip +=
            QCoreApplication::translate("MeasurementPanel", "\nscaled by %1").arg(style::numberText(mapping.scale, 6));
    if (mapping.offset != 0)
        tip += QCoreApplication::translate("MeasurementPanel", "\nshifted by %1")
                   .arg(style::numberText(mapping.offset, 6));
    if (mapping.interpolation == Interpolation::Hold)
        tip += QCoreApplication::translate("MeasurementPanel", "\nheld: each value lasts until the next sample");
    if (mapping.weight != 1)
        tip += QCoreApplication::translate("MeasurementPanel", "\nweight %1").arg(style::numberText(mapping.weight, 6));
    return tip;
}

bool hasOwnClock(const ChannelMapping& mapping) { return mapping.fitsClock || mapping.clock != 0; }

QString clockText(const ChannelMapping& mapping) {
    return mapping.fitsClock ? QCoreApplication::translate("MeasurementPanel", "fit")
                             : style::numberText(mapping.clock, 6) + QStringLiteral(" s");
}

std::optional<double> readSeconds(const QString& typed) {
    static const QRegularExpression form(QStringLiteral(R"(^([-+]?[\d.,]+(?:[eE][-+]?\d+)?)\s*([a-z]*)$)"));
    const QString text = typed.trimmed();
    if (text.isEmpty()) return 0.0;
    const QRegularExpressionMatch match = form.match(text);
    const std::optional<double> number = style::readNumber(match.captured(1));
    const QString unit = match.captured(2).isEmpty() ? QStringLiteral("s") : match.captured(2);
    const Outcome<UnitConversion> toSeconds = convertUnit(unit.toStdString(), "s");
    return number && toSeconds ? std::optional((*toSeconds)(*number)) : std::nullopt;
}

std::optional<std::pair<double, double>> readRange(const QString& typed) {
    static const QString number = QStringLiteral(R"(([-+]?[\d.,]*\d(?:[eE][-+]?\d+)?)\s*s?)"),
                         between = QStringLiteral(R"((?:\s*(?:…|\.{2,3}|;|–|-\s)\s*|(?<=[\ds])-|\s+))");
    static const QRegularExpression form('^' + number + between + number + '$');
    const QRegularExpressionMatch match = form.match(typed.trimmed());
    const std::optional<double> from = style::readNumber(match.captured(1)), to = style::readNumber(match.captured(2));
    return from && to && *from < *to ? std::optional(std::pair(*from, *to)) : std::nullopt;
}

}  // namespace analogon::ui
