#include "core/measure/xlsx/xlsx.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "core/measure/xlsx/sheet_table.hpp"
#include "core/measure/xlsx/workbook.hpp"

namespace analogon {

namespace {

using namespace xlsx;

class SheetValues final : public RecordingReader {
public:
    Outcome<std::vector<ChannelValues>> read(std::size_t group, std::span<const std::size_t> channels,
                                             const Progress&) const override {
        std::vector<ChannelValues> values;
        for (const std::size_t channel : channels) values.push_back(groups[group][channel]);
        return values;
    }
    std::vector<std::vector<ChannelValues>> groups;
};

/// A day has 86 400 000 ms; a date as a number resolves less than a microsecond.
std::string isoOfDays(double days) {
    if (!(days >= 1 && days < 4e6)) return {};  // below 1 it is a clock without a date
    const auto milliseconds = static_cast<std::int64_t>(std::llround(days * 86400000.0));
    const std::chrono::sys_time<std::chrono::milliseconds> time{
        std::chrono::sys_days(std::chrono::year(1899) / 12 / 30) + std::chrono::milliseconds(milliseconds)};
    const auto day = std::chrono::floor<std::chrono::days>(time);
    const std::chrono::year_month_day date(day);
    const std::int64_t ofDay = (time - day).count();
    std::string text = fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}", static_cast<int>(date.year()),
                                   static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                                   ofDay / 3600000, ofDay / 60000 % 60, ofDay / 1000 % 60);
    return ofDay % 1000 == 0 ? text : text + fmt::format(".{:03}", ofDay % 1000);
}

/// Dates become seconds since the first.
void makeRelative(SheetColumn& column) {
    double first = NAN;
    for (double& value : column.numbers) {
        if (std::isnan(first)) first = value;
        // the noise of a date as a number is below 1e-6 s
        value = std::round((value - first) * 86400 * 1e5) / 1e5;
    }
    column.unit = "s";
}

}  // namespace

bool isZip(ByteView bytes) { return bytes.part(0, 4).text() == "PK\x03\x04"; }

Outcome<MeasurementFile> openXlsx(const std::string& file) {
    const Outcome<std::vector<Sheet>> sheets = readWorkbook(file);
    if (!sheets) return sheets.diagnostics();
    MeasurementFile recording;
    recording.file = file;
    recording.format = "XLSX";
    auto values = std::make_shared<SheetValues>();
    for (const Sheet& sheet : *sheets) {
        std::vector<SheetTable> tables = readTables(sheet, recording.notes);
        if (tables.empty()) recording.notes.push_back(phrase("sheet \"{}\" has no numbers", sheet.name));
        for (SheetTable& table : tables) {
            RecordedGroup group;
            group.name = sheet.name;
            group.masterChannel = table.time;
            group.master = table.time ? MasterKind::Time : MasterKind::None;
            if (!table.time)
                recording.notes.push_back(
                    phrase("group \"{}\" has no time: its samples can only be counted", sheet.name));
            std::vector<ChannelValues>& channels = values->groups.emplace_back();
            for (std::size_t c = 0; c < table.columns.size(); ++c) {
                SheetColumn& column = table.columns[c];
                if (column.isDate) {
                    if (recording.start.empty() && !column.numbers.empty())
                        recording.start = isoOfDays(column.numbers.front());
                    makeRelative(column);
                }
                group.samples = column.isText ? column.texts.size() : column.numbers.size();
                group.channels.push_back({column.name,
                                          column.unit,
                                          {},
                                          {},
                                          column.isText ? ChannelKind::Text : ChannelKind::Number,
                                          group.samples});
                channels.push_back({std::move(column.numbers), std::move(column.texts)});
            }
            recording.groups.push_back(std::move(group));
        }
    }
    if (recording.groups.empty())
        return fileError(phrase("no column of numbers is in this workbook ({} sheets looked at)", sheets->size()),
                         file);
    recording.reader = std::move(values);
    return recording;
}

}  // namespace analogon
