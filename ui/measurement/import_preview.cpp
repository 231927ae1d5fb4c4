// What ImportPanel reads beside the window.
#include <fmt/format.h>

#include <QFile>
#include <QFileInfo>
#include <cmath>
#include <set>

#include "core/measure/all_channels.hpp"
#include "core/measure/open/read_table.hpp"
#include "core/measure/unknown_unit.hpp"
#include "ui/measurement/import_panel.hpp"
#include "ui/measurement/mapping.hpp"

namespace analogon::ui {

namespace {

/// The first lines of a file, and those around what is wrong.
std::vector<FileLine> linesOf(const QString& path, const Diagnostics& problems) {
    constexpr int first = 200, around = 3, longest = 500;  // characters
    std::set<int> faulty;
    for (const Diagnostic& d : problems)
        if (d.place.line > 0) faulty.insert(d.place.line);
    QFile file(path);
    std::vector<FileLine> lines;
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly)) return lines;  // a pipe may never end
    const int last = std::max(first, faulty.empty() ? 0 : *faulty.rbegin() + around);
    for (int number = 1; number <= last && !file.atEnd(); ++number) {
        const QString text = QString::fromUtf8(file.readLine().trimmed().left(longest));
        const auto near = faulty.lower_bound(number - around);
        if (number <= first || (near != faulty.end() && *near <= number + around)) lines.push_back({number, text});
    }
    return lines;
}

/// The first values in a unit that is asked about, under each reading of it.
QuestionRows rowsIn(const Table& table, const Question& question) {
    constexpr std::size_t most = 5;
    QuestionRows rows;
    const auto isAsked = [&](const Column& c) { return unknownUnitOf(c.name, c.unit) == question.unit; };
    const auto column = std::find_if(table.columns.begin(), table.columns.end(), isAsked);
    if (column == table.columns.end()) return rows;
    rows.column = column->name;
    for (std::size_t i = 0; i < column->values.size() && rows.rows.size() < most; ++i) {
        const double value = column->values[i];
        if (!std::isfinite(value)) continue;
        QuestionRow row{static_cast<int>(i) + 1, fmt::format("{:.10g} {}", value, question.unit), {}};
        for (const Reading& reading : question.readings) {
            const std::string& unit = reading.options.unitNames.at(question.unit);
            row.values.push_back(unit == "1" ? phrase("{:.10g}", value) : phrase("{:.10g} {}", value, unit));
        }
        rows.rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace

ImportPanel::Preview ImportPanel::previewOfText(const std::string& path, const ReadOptions& options,
                                                const std::set<std::string>& chosen, const Progress& progress) {
    Outcome<LookedAtText> looked = lookAtTextFile(path, options, progress);
    if (!looked) return {looked.diagnostics()};
    constexpr std::size_t rows = 5;
    Preview preview{looked->table,           {}, {}, options, std::move(looked->recording), looked->table.diagnostics(),
                    std::move(looked->asked)};
    if (!preview.asked.empty()) preview.rows = rowsUnder(path, preview.asked.front(), rows);
    if (!looked->table) {
        preview.lines = linesOf(QString::fromStdString(path), preview.told);
        return preview;
    }
    preview.file = *looked->table;
    preview.table = onOneRaster(preview.file, chosen, preview.told);
    return complete(std::move(preview));
}

ImportPanel::Preview ImportPanel::previewOf(const std::string& path, const ReadOptions& options,
                                            const std::set<std::string>& chosen, const Progress& progress) {
    Outcome<Table> read = readTable(path, options, chosen, progress, chosen.empty() ? valuesKept : 0);
    if (!read) return {read.diagnostics()};
    const auto file = std::make_shared<const Table>(std::move(*read));
    Preview preview{onOneRaster(file, {}, read.diagnostics()), {}, file, options};
    if (preview.table)
        for (const UnknownUnit& unknown : unknownUnits(**preview.table))
            preview.asked.push_back(askedUnit(unknown, options));
    if (!preview.asked.empty()) preview.rows = rowsIn(**preview.table, preview.asked.front());
    return complete(std::move(preview));
}

Outcome<std::shared_ptr<const Table>> ImportPanel::onOneRaster(const std::shared_ptr<const Table>& file,
                                                               const std::set<std::string>& chosen,
                                                               const Diagnostics& told) {
    const auto taken = chosen.empty() ? file : std::make_shared<const Table>(onlyChannels(*file, chosen));
    Outcome<std::shared_ptr<const Table>> table = allOnOneRaster(taken);
    if (!table) return table;
    Diagnostics all = told;
    all.insert(all.end(), table.diagnostics().begin(), table.diagnostics().end());
    return {*table, std::move(all)};
}

ImportPanel::Preview ImportPanel::complete(Preview preview) {
    if (preview.table) preview.time = proposeTime(**preview.table);
    return preview;
}

}  // namespace analogon::ui
