#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace analogon {

/// Where a cell that is not a finite number stands, for the message when the column is used after all.
struct BlankCell {
    std::uint32_t row{};  // index into Column::values
    int position{};       // 1-based byte in the line
};

/// The places of what is no finite number, by row.
std::vector<BlankCell> blanksOf(const std::vector<double>& values);

/// Which group of a file is meant, as a study says it.
struct GroupName {
    std::string name{};    // of a group, or of a sheet; empty: told by its number, or not at all
    std::size_t number{};  // from 1; 0: told by its name, or not at all
    bool isSheet{};        // it was called a sheet

    bool isTold() const { return !name.empty() || number > 0; }
    friend bool operator==(const GroupName&, const GroupName&) = default;
};

/// A channel as a study names it.
struct ChannelName {
    std::string column;
    GroupName group{};

    friend bool operator==(const ChannelName&, const ChannelName&) = default;
};

/// One column of a measurement file, in its own unit.
struct Column {
    std::string name;               // without the unit
    std::string unit;               // as written; empty: none given
    std::vector<double> values;     // NaN: an empty cell
    std::vector<BlankCell> blanks;  // NaN and infinite cells, by row
    std::string header{};           // as written, with the unit
    int line{}, position{};         // where the header stands (1-based); 0: nowhere
    bool isHeld{};                  // a status or a whole number, as the file says: nothing lies between two samples
    bool isOnOtherRaster{};         // NaN beside `blanks` lie between its samples
    std::string group{};            // that it was taken from; empty: the file has one
    std::size_t groupNumber{1};     // of that group, from 1
    std::size_t channel{};          // among those of its group in Table::source

    bool isOf(const GroupName& wanted) const;
    /// How a study says its group: by its name, or by its number where it has none.
    GroupName groupName() const;
};

struct MeasurementFile;

/// A measurement file as it is: one table, or, where it has several groups, that of the first with the others beside
/// it.
struct Table {
    std::string file;
    std::vector<Column> columns;
    std::vector<int> lines;                              // line of each row in a text, else its number (1-based)
    std::optional<std::size_t> time{};                   // the column of its stamps, where the file says which
    std::vector<std::string> texts{};                    // columns of words, which have no values
    std::vector<std::shared_ptr<const Table>> others{};  // groups of the same file, each over a raster of its own
    std::shared_ptr<const MeasurementFile> source{};     // from which columns without values can still be read

    /// By name, or by the header as written.
    const Column* find(std::string_view name, const GroupName& group = {}) const;
    std::size_t rows() const {
        return lines.empty() && !columns.empty() ? columns.front().values.size() : lines.size();
    }
    std::vector<std::string> names() const;
    /// Rows first … last-1 alone.
    Table slice(std::size_t first, std::size_t last) const;
    /// Whether columns of it are left in the file: it has very many values.
    bool hasUnread() const;
};

/// Comma-separated text of a table, headers as `name [unit]`; reads back as the same values.
std::string writeCsv(const Table& table);

/// A text as a CSV cell: quoted where needed; one that a spreadsheet would run as a formula (= + - @ and the like in
/// front) is led by an apostrophe.
std::string csvCell(std::string_view text);

}  // namespace analogon
