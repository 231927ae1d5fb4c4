#include "ui/measurement/recording_extent.hpp"

#include <QCoreApplication>

#include "core/study/measured.hpp"
#include "ui/style/number.hpp"

namespace analogon::ui {

RecordingExtent extentOf(const Table& table, const StudyExperiment& experiment) {
    const Column* const time = table.find(experiment.timeColumn, experiment.timeGroup);
    if (!time || time->values.empty()) return {table.rows(), {}};
    const auto [first, last] = experiment.range ? usedRows(table, experiment) : std::pair(std::size_t{}, table.rows());
    if (last <= first) return {0, {}};
    const UnitConversion seconds = secondsOf(*time);
    return {last - first, seconds(time->values[last - 1]) - seconds(time->values[first])};
}

QString extentText(const RecordingExtent& extent) {
    const QString text =
        QCoreApplication::translate("MeasurementPanel", "%1 samples").arg(style::countText(extent.samples));
    return extent.seconds ? text + QStringLiteral(" · %1 s").arg(style::numberText(*extent.seconds, 6)) : text;
}

}  // namespace analogon::ui
