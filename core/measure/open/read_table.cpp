#include "core/measure/open/read_table.hpp"

#include <numeric>

#include "core/base/file_fault.hpp"
#include "core/measure/csv_dialect.hpp"
#include "core/measure/open/open_recording.hpp"
#include "core/measure/text/text_recording.hpp"
#include "core/measure/unknown_unit.hpp"

namespace analogon {

namespace {

std::size_t valuesOf(const MeasurementFile& recording) {
    std::size_t count = 0;
    for (const RecordedGroup& group : recording.groups) count += group.samples * group.channels.size();
    return count;
}

/// From the groups of a binary file to tables.
class TableReader {
public:
    TableReader(std::shared_ptr<const MeasurementFile> source, const std::set<std::string>& wanted,
                std::size_t mostValues)
        : source_(std::move(source)),
          wanted_(wanted),
          isWhole_(valuesOf(*source_) <= mostValues),
          isChosen_(mostValues == 0) {}

    Outcome<Table> read(const Progress& progress) {
        std::vector<Table> tables;
        for (std::size_t g = 0; g < source_->groups.size(); ++g) {
            if (source_->groups[g].samples == 0) continue;
            progress.report({"reading", {}, static_cast<double>(g) / static_cast<double>(source_->groups.size())});
            Outcome<Table> table = readGroup(g, progress);
            if (!table) return table;
            if (!table->columns.empty() || !table->texts.empty()) tables.push_back(std::move(*table));
        }
        if (tables.empty())
            return fileError(phrase("this file has no samples of any channel"), source_->file, 0, 0,
                             phrase("Is it the recording? 'analogon-cli channels' lists what it holds."));
        Table first = std::move(tables.front());
        for (std::size_t i = 1; i < tables.size(); ++i)
            first.others.push_back(std::make_shared<const Table>(std::move(tables[i])));
        if (unread_ > 0 && !isChosen_) tellUnread();
        return {std::move(first), std::move(told_)};
    }

private:
    bool isRead(const RecordedGroup& group, std::size_t channel) const {
        return isWhole_ || group.masterChannel == channel || wanted_.contains(group.channels[channel].name);
    }

    Outcome<Table> readGroup(std::size_t g, const Progress& progress) {
        const RecordedGroup& group = source_->groups[g];
        const bool isAlone = source_->groups.size() == 1;
        Table table;
        table.file = source_->file;
        table.source = source_;
        table.lines.resize(group.samples);
        std::iota(table.lines.begin(), table.lines.end(), 1);
        std::vector<std::size_t> chosen, columns;
        for (std::size_t c = 0; c < group.channels.size(); ++c) {
            const RecordedChannel& channel = group.channels[c];
            if (channel.kind == ChannelKind::Text) {
                table.texts.push_back(channel.name);
                continue;
            }
            if (group.masterChannel == c && group.master == MasterKind::Time) table.time = table.columns.size();
            Column column{channel.name, channel.unit, {}, {}};
            column.isHeld = channel.isInteger || channel.kind == ChannelKind::Status;
            if (!isAlone) column.group = group.name;
            column.groupNumber = g + 1;
            column.channel = c;
            if (isRead(group, c)) {
                chosen.push_back(c);
                columns.push_back(table.columns.size());
            } else {
                ++unread_;
            }
            table.columns.push_back(std::move(column));
        }
        Outcome<std::vector<ChannelValues>> values = source_->reader->read(g, chosen, progress);
        if (!values) return values.diagnostics();
        told_.insert(told_.end(), values.diagnostics().begin(), values.diagnostics().end());
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            Column& column = table.columns[columns[i]];
            column.values = std::move((*values)[i].numbers);
            column.blanks = blanksOf(column.values);
        }
        return table;
    }

    void tellUnread() {
        told_.push_back(asWarning(fileError(
            phrase("this file is large: {} of its channels, which the study does not name, are left unread and are not "
                   "looked at as causes",
                   unread_),
            source_->file, 0, 0, phrase("Map what may be a cause, or export the recording with fewer channels."))));
    }

    std::shared_ptr<const MeasurementFile> source_;
    const std::set<std::string>& wanted_;
    bool isWhole_, isChosen_;
    std::size_t unread_{};
    Diagnostics told_;
};

Diagnostic needless(const std::filesystem::path& file, const std::string& format) {
    return asWarning(fileError(phrase("\"read\" tells how a text is written, and this is {}: it has no effect", format),
                               file.string()));
}

/// Wide text that was told has zeros, and may be of no kind that is known.
bool isReadAsText(bool isText, const ReadOptions& options) {
    return isText || options.encoding.starts_with("utf-16") || options.encoding.starts_with("utf-32");
}

/// What the ending of a file's name says beside that.
ReadOptions withEnding(const std::filesystem::path& file, ReadOptions options) {
    const std::string ending = inLowerCase(file.extension().string());
    if (!options.separator && (ending == ".tsv" || ending == ".tab")) options.separator = '\t';
    return options;
}

}  // namespace

Outcome<LookedAtText> lookAtTextFile(const std::filesystem::path& file, const ReadOptions& options,
                                     const Progress& progress) {
    LookedAtText looked = lookAtText(file, withEnding(file, options), progress);
    if (looked.table)
        for (const UnknownUnit& unknown : unknownUnits(**looked.table))
            looked.asked.push_back(askedUnit(unknown, options));
    return looked;
}

Outcome<Table> readTable(const std::filesystem::path& file, const ReadOptions& options,
                         const std::set<std::string>& wanted, const Progress& progress, std::size_t mostValues) {
    const Outcome<bool> isText = isTextRecording(file);
    if (!isText) return isText.diagnostics();
    if (isReadAsText(*isText, options)) return readTextTables(file, withEnding(file, options), progress);
    Outcome<MeasurementFile> recording = openRecording(file, options);
    if (!recording) return recording.diagnostics();
    Diagnostics told = recording.diagnostics();
    ReadOptions ofTexts = options;
    ofTexts.unitNames.clear();
    if (ofTexts != ReadOptions{}) told.push_back(needless(file, recording->format));
    Outcome<Table> table =
        TableReader(std::make_shared<const MeasurementFile>(std::move(*recording)), wanted, mostValues).read(progress);
    if (!table) return table;
    told.insert(told.end(), table.diagnostics().begin(), table.diagnostics().end());
    return {std::move(*table), std::move(told)};
}

}  // namespace analogon
