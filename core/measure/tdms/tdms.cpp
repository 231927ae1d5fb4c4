#include "core/measure/tdms/tdms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "core/base/unit.hpp"
#include "core/measure/encoding.hpp"
#include "core/measure/tdms/tdms_scaling.hpp"
#include "core/measure/tdms/tdms_segments.hpp"
#include "core/measure/time_name.hpp"

namespace analogon {

namespace {

using namespace tdms;

constexpr std::uint64_t textLimit = std::uint64_t{1} << 28;

/// A channel of the recording: an object of the file, or the time that the steps of a waveform make.
struct Source {
    std::size_t object{};
    bool isWaveformTime{};
    bool isClock{};  // stamps, as seconds since the first one
    double start{}, step{};
    std::uint64_t samples{};
};

template <class T>
void extract(const Piece& piece, const std::uint8_t* from, double* out) {
    const ByteView bytes(from, static_cast<std::size_t>((piece.count - 1) * piece.stride + sizeof(T)));
    const bool swaps = piece.isBigEndian == (std::endian::native == std::endian::little);
    for (std::uint64_t i = 0; i < piece.count; ++i)
        out[i] = static_cast<double>(bytes.number<T>(i * piece.stride, swaps));
}

void extractPiece(const Piece& piece, const std::uint8_t* from, double* out) {
    switch (piece.type) {
        case Int8:
            return extract<std::int8_t>(piece, from, out);
        case Int16:
            return extract<std::int16_t>(piece, from, out);
        case Int32:
            return extract<std::int32_t>(piece, from, out);
        case Int64:
            return extract<std::int64_t>(piece, from, out);
        case Uint8:
        case Boolean:
            return extract<std::uint8_t>(piece, from, out);
        case Uint16:
            return extract<std::uint16_t>(piece, from, out);
        case Uint32:
            return extract<std::uint32_t>(piece, from, out);
        case Uint64:
            return extract<std::uint64_t>(piece, from, out);
        case Float32:
        case Float32WithUnit:
            return extract<float>(piece, from, out);
        default:
            return extract<double>(piece, from, out);
    }
}

/// A channel of stamps that is called a time.
bool isTimeOfDay(const Object& object) {
    return object.type == Timestamp && namesTime(object.channel) && object.values() > 1;
}

/// The difference is taken in whole numbers: the seconds since 1904 leave few digits for their decimals.
std::vector<double> secondsSinceFirst(const Object& object) {
    std::vector<double> seconds;
    std::optional<TimePoint> first;
    for (const Piece& piece : object.pieces)
        for (std::uint64_t chunk = 0; chunk < piece.repeats; ++chunk)
            for (std::uint64_t i = 0; i < piece.count; ++i) {
                const std::uint64_t at = chunk * piece.repeatStride + i * piece.stride;
                const TimePoint time = timePointAt(piece.bytes, at, piece.isBigEndian);
                if (!first) first = time;
                constexpr double whole = 18446744073709551616.0;  // 2^64
                const double part = static_cast<double>(time.fraction) - static_cast<double>(first->fraction);
                seconds.push_back(static_cast<double>(time.seconds) - static_cast<double>(first->seconds) +
                                  part / whole);
            }
    return seconds;
}

class TdmsReader final : public RecordingReader {
public:
    TdmsReader(std::shared_ptr<const MappedFile> memory, File file, std::vector<std::vector<Source>> sources,
               std::string name)
        : memory_(std::move(memory)), file_(std::move(file)), sources_(std::move(sources)), name_(std::move(name)) {}

    const Object& objectOf(const Source& source) const { return file_.objects[source.object]; }
    void setSources(std::vector<std::vector<Source>> sources) { sources_ = std::move(sources); }

    Outcome<std::vector<ChannelValues>> read(std::size_t group, std::span<const std::size_t> channels,
                                             const Progress& progress) const override {
        std::vector<ChannelValues> values;
        Diagnostics remarks;
        for (const std::size_t channel : channels) {
            if (progress.stopRequested()) return fileError(phrase("reading was stopped"), name_);
            values.push_back(readOne(sources_[group][channel], remarks));
        }
        return {std::move(values), std::move(remarks)};
    }

private:
    ChannelValues readOne(const Source& source, Diagnostics& remarks) const {
        ChannelValues values;
        if (source.isWaveformTime) {
            values.numbers.resize(source.samples);
            for (std::uint64_t i = 0; i < source.samples; ++i)
                values.numbers[i] = source.start + static_cast<double>(i) * source.step;
            return values;
        }
        const Object& object = file_.objects[source.object];
        if (source.isClock) {
            values.numbers = secondsSinceFirst(object);
            return values;
        }
        if (object.type == String || object.type == Timestamp) {
            readTexts(object, values.texts);
            return values;
        }
        values.numbers.resize(object.values());
        double* out = values.numbers.data();
        WayThrough way(*memory_);
        for (const Piece& piece : object.pieces)
            for (std::uint64_t i = 0; i < piece.repeats; ++i, out += piece.count) {
                extractPiece(piece, piece.bytes.data() + i * piece.repeatStride, out);
                way.pass(piece.repeatStride);
            }
        const auto isLarge = [](double x) { return std::abs(x) > 9007199254740992.0; };  // 2^53
        if ((object.type == Int64 || object.type == Uint64) &&
            std::any_of(values.numbers.begin(), values.numbers.end(), isLarge)) {
            Diagnostic remark = fileError(phrase("whole numbers above 2^53 were rounded to 53 bits"), name_);
            remark.severity = Severity::Warning;
            remarks.push_back(std::move(remark));
        }
        Scaling(object).apply(values.numbers);
        return values;
    }

    static void readTexts(const Object& object, std::vector<std::optional<std::string>>& texts) {
        std::uint64_t taken = 0;
        for (const Piece& piece : object.pieces)
            for (std::uint64_t chunk = 0; chunk < piece.repeats; ++chunk) {
                const ByteView bytes = piece.bytes.part(chunk * piece.repeatStride);
                std::uint32_t begin = 0;
                for (std::uint64_t i = 0; i < piece.count; ++i) {
                    if (object.type == Timestamp) {
                        texts.push_back(isoText(timePointAt(bytes, i * piece.stride, piece.isBigEndian)));
                        continue;
                    }
                    // first where each text ends, then the texts
                    const bool swaps = piece.isBigEndian == (std::endian::native == std::endian::little);
                    const auto end = bytes.number<std::uint32_t>(4 * i, swaps);
                    const std::string_view text = bytes.part(0, piece.textBytes)
                                                      .part(4 * piece.count + begin, end < begin ? 0 : end - begin)
                                                      .text();
                    taken += text.size();
                    texts.push_back(taken > textLimit ? std::nullopt : std::optional(inUtf8(text)));
                    begin = end;
                }
            }
    }

    std::shared_ptr<const MappedFile> memory_;
    File file_;
    std::vector<std::vector<Source>> sources_;  // by group and channel
    std::string name_;
};

std::string textProperty(const Object& object, std::initializer_list<const char*> names) {
    for (const char* name : names) {
        const auto found = object.properties.find(name);
        if (found == object.properties.end()) continue;
        if (const auto* text = std::get_if<std::string>(&found->second); text && !text->empty()) return *text;
    }
    return {};
}

double numberProperty(const Object& object, const char* name) {
    const auto found = object.properties.find(name);
    const double* number = found == object.properties.end() ? nullptr : std::get_if<double>(&found->second);
    return number ? *number : 0.0;
}

class TdmsOpener {
public:
    TdmsOpener(std::shared_ptr<const MappedFile> memory, std::string name) : memory_(std::move(memory)) {
        recording_.file = std::move(name);
        recording_.format = "TDMS";
    }

    Outcome<MeasurementFile> open() {
        File file = readSegments(memory_->bytes());
        if (file.isIncomplete)
            recording_.notes.push_back(
                phrase("the recorder did not close the file: its last part is incomplete, what is there is read"));
        if (file.isDamaged) recording_.notes.push_back(phrase("the file is damaged: a part of its data is left out"));
        for (std::size_t i = 0; i < file.objects.size(); ++i)
            if (!file.objects[i].channel.empty()) place(file.objects[i], i);
        if (recording_.groups.empty())
            return fileError(phrase("the file holds no channel with values"), recording_.file, 0, 0,
                             recording_.notes.empty() ? Text{} : recording_.notes.back());
        reader_ = std::make_shared<TdmsReader>(memory_, std::move(file), sources_, recording_.file);
        recording_.reader = reader_;
        for (std::size_t g = 0; g < recording_.groups.size(); ++g) findMaster(g);
        return std::move(recording_);
    }

private:
    void place(const Object& object, std::size_t index) {
        if (object.isSkipped) {
            recording_.notes.push_back(
                phrase("channel \"{}\" is left out: values of type {} cannot be read", object.channel, object.type));
            return;
        }
        if (recording_.start.empty())
            if (const auto start = object.properties.find("wf_start_time"); start != object.properties.end())
                if (const auto* time = std::get_if<TimePoint>(&start->second); time && time->seconds != 0)
                    recording_.start = isoText(*time);
        const double step = numberProperty(object, "wf_increment");
        const double start = numberProperty(object, "wf_start_offset");
        const std::uint64_t samples = object.values();
        const std::size_t group = groupOf(object.group, step > 0 ? step : 0, start, samples);
        RecordedChannel channel;
        channel.name = object.channel;
        channel.unit = textProperty(object, {"unit_string", "NI_UnitDescription", "Unit", "unit"});
        channel.comment = textProperty(object, {"description", "NI_ChannelDescription", "Description", "comment"});
        channel.samples = samples;
        channel.isInteger = object.type >= Int8 && object.type <= Uint64 && Scaling(object).isNone();
        if (object.type == String || object.type == Timestamp) channel.kind = ChannelKind::Text;
        if (const Scaling scaling(object); !scaling.unreadable().empty()) {
            channel.unit.clear();  // of what the conversion would give
            recording_.notes.push_back(
                phrase("channel \"{}\": its conversion \"{}\" cannot be read, its values are those of the record",
                       channel.name, scaling.unreadable()));
        }
        if (samples == 0) recording_.notes.push_back(phrase("channel \"{}\" has no samples", channel.name));
        recording_.groups[group].channels.push_back(std::move(channel));
        sources_[group].push_back({index, false, false, 0, 0, samples});
    }

    /// Channels with a step share a group with their like; the others with those of the same length, or an empty one.
    std::size_t groupOf(const std::string& name, double step, double start, std::uint64_t samples) {
        for (std::size_t i = 0; i < keys_.size(); ++i) {
            auto& [knownName, knownStep, knownStart, knownSamples] = keys_[i];
            if (knownName != name || knownStep != step || (step > 0 && knownStart != start)) continue;
            if (step == 0 && knownSamples == 0) recording_.groups[i].samples = knownSamples = samples;
            if (knownSamples == samples || (step == 0 && samples == 0)) return i;
        }
        keys_.emplace_back(name, step, start, samples);
        RecordedGroup group;
        group.name = name;
        group.samples = samples;
        sources_.emplace_back();
        if (step > 0) {
            group.master = MasterKind::Time;
            group.masterChannel = 0;
            group.channels.push_back({"time", "s", {}, {}, ChannelKind::Number, samples});
            sources_.back().push_back({0, true, false, start, step, samples});
        }
        recording_.groups.push_back(std::move(group));
        return keys_.size() - 1;
    }

    /// Where there are neither steps nor a channel of numbers that is the time, stamps that are called one are.
    void addClock(std::size_t g) {
        RecordedGroup& group = recording_.groups[g];
        for (const Source& source : sources_[g]) {
            const Object& object = reader_->objectOf(source);
            if (!isTimeOfDay(object) || object.values() != group.samples) continue;
            const std::vector<double> seconds = secondsSinceFirst(object);
            if (!std::is_sorted(seconds.begin(), seconds.end())) continue;
            const Piece& first = object.pieces.front();
            if (recording_.start.empty()) recording_.start = isoText(timePointAt(first.bytes, 0, first.isBigEndian));
            const Source clock{source.object, false, true, 0, 0, source.samples};
            group.master = MasterKind::Time;
            group.masterChannel = 0;
            group.channels.insert(group.channels.begin(),
                                  {"time", "s", {}, {}, ChannelKind::Number, static_cast<std::size_t>(source.samples)});
            sources_[g].insert(sources_[g].begin(), clock);
            reader_->setSources(sources_);
            return;
        }
    }

    /// Without steps a rising channel in seconds, or one that is called time, is what the others are counted by.
    void findMaster(std::size_t g) {
        RecordedGroup& group = recording_.groups[g];
        if (group.masterChannel) return;
        for (std::size_t c = 0; c < group.channels.size(); ++c) {
            const RecordedChannel& channel = group.channels[c];
            const bool isTime = channel.unit.empty() ? namesTime(channel.name) : areConvertible(channel.unit, "s");
            if (!isTime || channel.kind != ChannelKind::Number || channel.samples < 2 ||
                channel.samples != group.samples)
                continue;
            const Outcome<ChannelValues> values = readValues(recording_, g, c);
            if (!values || !std::is_sorted(values->numbers.begin(), values->numbers.end())) continue;
            group.master = MasterKind::Time;
            group.masterChannel = c;
            return;
        }
        addClock(g);
        if (group.samples > 0 && !group.masterChannel)
            recording_.notes.push_back(
                phrase("group \"{}\" has no time: its samples can only be counted", groupLabel(group, g)));
    }

    std::shared_ptr<const MappedFile> memory_;
    MeasurementFile recording_;
    std::shared_ptr<TdmsReader> reader_;
    std::vector<std::tuple<std::string, double, double, std::uint64_t>> keys_;
    std::vector<std::vector<Source>> sources_;
};

}  // namespace

bool isTdms(ByteView bytes) { return bytes.part(0, 4).text() == "TDSm"; }

Outcome<MeasurementFile> openTdms(std::shared_ptr<const MappedFile> file, const std::string& name) {
    return TdmsOpener(std::move(file), name).open();
}

}  // namespace analogon
