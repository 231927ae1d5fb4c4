#include "core/measure/mdf/mdf_reader.hpp"

#include <cmath>
#include <limits>

#include "core/measure/mdf/record_walk.hpp"

namespace analogon::mdf {

namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();
/// Texts are short; a file in which they take more memory than this is damaged.
constexpr std::uint64_t textLimit = std::uint64_t{1} << 28;

bool isInvalid(const std::uint8_t* invalidation, std::uint64_t bit) { return (invalidation[bit / 8] >> (bit % 8)) & 1; }

/// One channel while the records go by.
struct Column {
    const StoredChannel* channel{};
    ChannelValues* values{};
    bool isText{};
    bool isInexact{};
    std::vector<std::uint8_t> variable{};  // what the offsets of a channel of variable length point into
    std::vector<std::uint64_t> offsets{};
};

/// Texts that stand for numbers become these.
double valueOfText(const Conversion& conversion, const std::string& text) {
    for (const Conversion::Entry& entry : conversion.entries)
        if (entry.text == text) return entry.value;
    return conversion.fallback ? conversion.fallback->value : gap;
}

class MdfReader final : public RecordingReader {
public:
    MdfReader(StoredFile file, std::string name) : file_(std::move(file)), name_(std::move(name)) {}

    Outcome<std::vector<ChannelValues>> read(std::size_t group, std::span<const std::size_t> channels,
                                             const Progress& progress) const override {
        std::vector<ChannelValues> values(channels.size());
        Diagnostics remarks;
        // channels that lie in the same records are read in one pass; a master may lie in those of another group
        std::map<std::size_t, std::vector<Column>> columns;
        for (std::size_t i = 0; i < channels.size(); ++i) {
            const StoredChannel& channel = file_.channels[group][channels[i]];
            columns[channel.records].push_back({&channel, &values[i]});
        }
        for (auto& [records, together] : columns) {
            const bool isDone = readTogether(file_.recordGroups[records], together, remarks, progress);
            if (!isDone) return fileError(phrase("reading was stopped"), name_);
        }
        return {std::move(values), std::move(remarks)};
    }

private:
    static bool holdsText(const StoredChannel& channel) {
        return channel.storage == StoredChannel::Storage::Elsewhere ||
               (channel.storage == StoredChannel::Storage::InRecord && !channel.layout.isNumber());
    }

    void prepare(const RecordGroup& group, Column& column, Diagnostics& remarks) const {
        const StoredChannel& channel = *column.channel;
        column.isText = holdsText(channel);
        if (!column.isText) {
            column.values->numbers.assign(group.samples, gap);
            return;
        }
        column.values->texts.assign(group.samples, std::nullopt);
        if (channel.storage != StoredChannel::Storage::Elsewhere) return;
        if (channel.elsewhereId)
            column.variable = variableRecords(file_.dataGroups[group.dataGroup], *channel.elsewhereId);
        else if (channel.elsewhere)
            column.variable = gathered(*channel.elsewhere, textLimit);
        if (column.variable.empty() && group.samples > 0)
            remarks.push_back(warningHere(phrase("the texts of a channel are missing in the file, or too long")));
    }

    /// As in a block of its own: each text behind its length.
    static std::vector<std::uint8_t> variableRecords(const DataGroup& data, std::uint64_t id) {
        std::vector<std::uint8_t> out;
        walkVariable(data, id, [&](ByteView bytes) {
            if (out.size() + bytes.size() > textLimit) return;
            const auto length = static_cast<std::uint32_t>(bytes.size());
            for (unsigned i = 0; i < 4; ++i) out.push_back(static_cast<std::uint8_t>(length >> (8 * i)));
            out.insert(out.end(), bytes.data(), bytes.data() + bytes.size());
        });
        return out;
    }

    bool readTogether(const RecordGroup& group, std::vector<Column>& columns, Diagnostics& remarks,
                      const Progress& progress) const {
        const DataGroup& data = file_.dataGroups[group.dataGroup];
        for (Column& column : columns) prepare(group, column, remarks);
        std::uint64_t textBytes = 0;
        WayThrough way(*file_.memory);
        const WalkResult walk = walkRecords(
            data, group, group.samples,
            [&](const RecordRun& run) {
                for (Column& column : columns) take(group, data, run, column, textBytes);
                way.pass(run.count * run.stride);
            },
            progress);
        if (walk.wasStopped) return false;
        if (data.hasInvalidationApart) invalidateApart(group, data, columns, progress);
        if (walk.lost > 0)
            remarks.push_back(
                warningHere(phrase("a packed block is damaged: {} samples are lost and read as gaps", walk.lost)));
        if (walk.metUnknownId || walk.records < group.samples)
            remarks.push_back(
                warningHere(phrase("the data end after {} of {} samples: what follows is damaged or missing",
                                   walk.records, group.samples)));
        if (textBytes > textLimit)
            remarks.push_back(warningHere(phrase("the texts of a channel are missing in the file, or too long")));
        for (Column& column : columns) finish(column, remarks);
        return true;
    }

    void take(const RecordGroup& group, const DataGroup& data, const RecordRun& run, Column& column,
              std::uint64_t& textBytes) const {
        const StoredChannel& channel = *column.channel;
        if (!run.first || channel.isAllInvalid) return;
        if (column.isText) {
            for (std::size_t i = 0; i < run.count; ++i)
                takeText(group, data, run.first + i * run.stride, run.index + i, column, textBytes);
            return;
        }
        double* const out = column.values->numbers.data() + run.index;
        if (channel.storage == StoredChannel::Storage::Counted)
            for (std::size_t i = 0; i < run.count; ++i) out[i] = static_cast<double>(run.index + i);
        else if (extractNumbers(channel.layout, run.first, run.stride, run.count, out))
            column.isInexact = true;
        if (!channel.invalidationBit || data.hasInvalidationApart) return;
        const std::uint8_t* invalidation = run.first + group.dataBytes;
        for (std::size_t i = 0; i < run.count; ++i, invalidation += run.stride)
            if (isInvalid(invalidation, *channel.invalidationBit)) out[i] = gap;
    }

    void takeText(const RecordGroup& group, const DataGroup& data, const std::uint8_t* record, std::uint64_t index,
                  Column& column, std::uint64_t& textBytes) const {
        const StoredChannel& channel = *column.channel;
        if (channel.invalidationBit && !data.hasInvalidationApart &&
            isInvalid(record + group.dataBytes, *channel.invalidationBit))
            return;
        if (textBytes > textLimit) return;
        std::optional<std::string>& text = column.values->texts[index];
        if (channel.storage == StoredChannel::Storage::InRecord) {
            const ByteView bytes(record + channel.layout.byteOffset, static_cast<std::size_t>(channel.layout.bytes()));
            text = textOf(channel.layout.type, bytes);
        } else {
            const ByteView all(column.variable.data(), column.variable.size());
            const auto offset = ByteView(record + channel.layout.byteOffset, 8).little<std::uint64_t>(0);
            if (!all.has(offset, 4)) return;
            text = textOf(channel.elsewhereType, all.part(offset + 4, all.little<std::uint32_t>(offset)));
        }
        textBytes += text->size();
    }

    /// Storage by columns keeps the invalidation bits of all records in blocks of their own.
    void invalidateApart(const RecordGroup& group, const DataGroup& data, std::vector<Column>& columns,
                         const Progress& progress) const {
        DataGroup apart;
        apart.records = data.invalidation;
        RecordGroup bits;
        bits.dataBytes = group.invalidationBytes;
        if (bits.dataBytes == 0) return;
        walkRecords(
            apart, bits, group.samples,
            [&](const RecordRun& run) {
                for (Column& column : columns) {
                    if (!column.channel->invalidationBit || !run.first) continue;
                    for (std::size_t i = 0; i < run.count; ++i) {
                        if (!isInvalid(run.first + i * run.stride, *column.channel->invalidationBit)) continue;
                        if (column.isText)
                            column.values->texts[run.index + i].reset();
                        else
                            column.values->numbers[run.index + i] = gap;
                    }
                }
            },
            progress);
    }

    void finish(Column& column, Diagnostics& remarks) const {
        if (column.isInexact)
            remarks.push_back(warningHere(phrase("whole numbers above 2^53 were rounded to 53 bits")));
        const Conversion* conversion = column.channel->conversion.get();
        if (!conversion) return;
        ChannelValues& values = *column.values;
        if (!column.isText) return convert(*conversion, values.numbers);
        if (conversion->kind == Conversion::Kind::FromText) {
            for (const std::optional<std::string>& text : values.texts)
                values.numbers.push_back(text ? valueOfText(*conversion, *text) : gap);
            values.texts.clear();
        }
    }

    Diagnostic warningHere(Text message) const {
        Diagnostic remark = fileError(std::move(message), name_);
        remark.severity = Severity::Warning;
        return remark;
    }

    StoredFile file_;
    std::string name_;
};

}  // namespace

std::shared_ptr<const RecordingReader> makeReader(StoredFile file, std::string name) {
    return std::make_shared<MdfReader>(std::move(file), std::move(name));
}

}  // namespace analogon::mdf
