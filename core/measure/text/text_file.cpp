#include "core/measure/text/text_file.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/file_fault.hpp"
#include "core/base/limits.hpp"
#include "core/base/visible.hpp"
#include "core/measure/encoding.hpp"
#include "core/measure/text/column_meaning.hpp"
#include "core/measure/text/file_text.hpp"
#include "core/measure/text/labelled.hpp"
#include "core/measure/text/layout.hpp"
#include "core/measure/text/modelica_table.hpp"
#include "core/measure/text/rasters.hpp"
#include "core/measure/text/remark.hpp"
#include "core/measure/text/stamp_column.hpp"
#include "core/measure/text/time_column.hpp"
#include "core/measure/unknown_unit.hpp"

namespace analogon {

namespace {

Diagnostics checkOptions(const ReadOptions& options, const std::string& file) {
    const auto isOf = [](std::optional<char> mark, std::string_view known) {
        return !mark || known.find(*mark) != std::string_view::npos;
    };
    const auto wrong = [&](const char* key, const Text& what) {
        return Diagnostics{fileError(phrase("\"{}\" of \"read\" is not known here", key), file, 0, 0, what)};
    };
    if (!isOf(options.separator, knownSeparators)) return wrong("separator", phrase("It is , ; | a tab or a blank."));
    if (!isOf(options.decimal, knownDecimals)) return wrong("decimal", phrase("It is . or ,"));
    if (!isOf(options.thousands, knownThousands)) return wrong("thousands", phrase("It is . , ' or a blank."));
    if (!options.encoding.empty() && !decodeText("", options.encoding))
        return wrong("encoding",
                     phrase("It is utf-8, utf-16le, utf-16be, utf-32le, utf-32be, windows-1252 or iso-8859-1."));
    return {};
}

void append(Diagnostics& told, Diagnostics more) {
    for (Diagnostic& diagnostic : more) told.push_back(std::move(diagnostic));
}

/// ISO 8601 of a date and a clock that stand in the lines in front of the table.
std::string startOf(const PreambleFacts& facts) {
    const std::optional<Stamp> stamp = readStamp(facts.startText);
    if (!stamp || !stamp->hasDate()) return {};
    std::optional<std::int64_t> day;
    for (const DateOrder order : {DateOrder::YearMonthDay, DateOrder::DayMonthYear, DateOrder::MonthDayYear}) {
        if (!stamp->allows(order)) continue;
        const auto found = dayOf(*stamp, order);
        if (day && found && *found != *day) return {};  // in two ways
        if (found) day = found;
    }
    constexpr std::int64_t nanoseconds = 86400'000'000'000;
    return day ? isoText(*day * nanoseconds + stamp->nanoseconds, stamp->zone) : std::string();
}

Outcome<TextFile> readModelica(TextView text, const std::string& name) {
    Outcome<std::vector<ModelicaTable>> tables = readModelicaTables(text, name);
    if (!tables) return tables.diagnostics();
    TextFile file;
    file.format = "Modelica table";
    file.found = phrase(
        "a table of the Modelica Standard Library: its columns have no names and are called by their "
        "numbers, the first is the time in seconds");
    for (ModelicaTable& table : *tables) {
        TextGroup group;
        group.name = table.name;
        group.table = std::move(table.table);
        group.kinds.assign(group.table.columns.size(), CellKind::Number);
        group.words.resize(group.kinds.size());
        group.statuses.resize(group.kinds.size());
        group.comments.resize(group.kinds.size());
        group.time = timeColumn(group.table, group.kinds);
        file.groups.push_back(std::move(group));
    }
    return file;
}

Outcome<TextFile> readPlainTable(TextView text, const std::string& name, const ReadOptions& options,
                                 const Progress& progress, Questions& asked) {
    std::string store;
    const std::optional<LabelledText> labelled = withoutLabels(text, store);
    const std::optional<UnframedText> unframed = labelled ? std::nullopt : withoutFrames(text, store);
    if (labelled) text = labelled->text;
    if (unframed) text = unframed->text;
    Outcome<Layout> layout = findLayout(text, name, options, asked, unframed ? &*unframed : nullptr);
    if (!layout) return layout.diagnostics();
    if (labelled) nameByLabels(*layout, *labelled);
    for (LayoutColumn& column : layout->columns) column.unit = unitMeant(column.name, column.unit, options);
    Diagnostics told = layout->warnings;
    Outcome<RawTable> raw = readRows(text, name, *layout, options, progress, asked);
    if (!raw) return raw.diagnostics();
    append(told, raw.diagnostics());
    std::map<std::string, std::string> comments;
    for (const LayoutColumn& column : layout->columns) comments[column.name] = column.comment;

    const std::optional<NamedRows> named = findNamedRows(*raw);
    Diagnostics meaning = named ? Diagnostics{} : applyUnitColumns(*raw);
    if (hasError(meaning)) return meaning;
    append(told, std::move(meaning));
    const Outcome<std::string> start = makeSeconds(*raw, options, asked);
    if (!start) return start.diagnostics();
    append(told, start.diagnostics());
    append(told, putOldestFirst(*raw));
    append(told, addCountedTime(*raw, layout->facts, options, asked));
    applyToldUnit(*raw, options);

    TextFile file;
    file.format = "text";
    file.start = start->empty() ? startOf(layout->facts) : *start;
    file.found = described(*layout);
    if (unframed && !unframed->pairs.empty()) file.found += phrase(", settings beside the first rows");
    if (labelled && !labelled->names.empty()) file.found += phrase(", names in front of the numbers");
    if (!isUtf8(text.text.substr(0, layout->offset))) file.found += phrase(", letters of Windows-1252");
    file.groups = groupsOf(std::move(*raw), named, comments, options, told, asked);
    if (hasError(told)) return told;
    return {std::move(file), std::move(told)};
}

/// UTF-8, or letters of one byte.
Outcome<TextFile> readDecoded(TextView text, const std::string& name, const ReadOptions& options,
                              const Progress& progress, Questions& asked) {
    if (text.front(4096).find('\0') != std::string_view::npos)
        return fileError(phrase("this is not a text file"), name, 1, 0,
                         phrase("Export the measurement as comma-separated values."));
    if (isModelicaTable(text)) return readModelica(text, name);
    return readPlainTable(text, name, options, progress, asked);
}

}  // namespace

Outcome<TextFile> readTextFile(std::string_view bytes, const std::string& name, const ReadOptions& options,
                               const Progress& progress, Questions& asked) {
    if (Diagnostics faults = checkOptions(options, name); !faults.empty()) return faults;
    std::string decoded;
    if (!options.encoding.empty() || isWideText(bytes)) {
        decoded = options.encoding.empty() ? decodeText(bytes) : *decodeText(bytes, options.encoding);
        bytes = decoded;
    }
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    bytes = bytes.substr(0, bytes.find_last_not_of('\0') + 1);  // of a file that was larger than what was written
    return readDecoded(bytes, name, options, progress, asked);
}

Outcome<TextFile> readTextFile(std::string_view bytes, const std::string& name, const ReadOptions& options,
                               const Progress& progress) {
    Questions asked;
    return readTextFile(bytes, name, options, progress, asked);
}

Outcome<TextFile> readTextFile(const std::filesystem::path& file, const ReadOptions& options, const Progress& progress,
                               Questions& asked) {
    const std::string name = file.string();
    if (Diagnostics faults = checkOptions(options, name); !faults.empty()) return faults;
    const Outcome<std::unique_ptr<FileText>> text = FileText::open(file, options.encoding);
    if (!text) return text.diagnostics();
    Outcome<TextFile> read = readDecoded((*text)->view(), name, options, progress, asked);
    if ((*text)->fault()) return *(*text)->fault();
    return read;
}

}  // namespace analogon
