#include "core/measure/mdf/mdf3.hpp"

#include <fmt/format.h>

#include <chrono>
#include <set>

#include "core/measure/mdf/mdf3_conversion.hpp"
#include "core/measure/mdf/mdf_channel.hpp"
#include "core/measure/mdf/mdf_reader.hpp"
#include "core/measure/mdf/mdf_samples.hpp"

namespace analogon::mdf {

namespace {

/// One block: its fields by their offsets from its beginning; a field behind its end is 0 (older versions are shorter).
struct Block3 {
    ByteView bytes;
    bool isBigEndian{};

    template <class T>
    T at(std::uint64_t offset) const {
        return bytes.number<T>(offset, isBigEndian == (std::endian::native == std::endian::little));
    }
    std::uint32_t link(std::uint64_t offset) const { return at<std::uint32_t>(offset); }
};

class Reader3 {
public:
    Reader3(std::shared_ptr<const MappedFile> file, const std::string& name) : bytes_(file->bytes()) {
        stored_.memory = std::move(file);
        recording_.file = name;
    }

    Outcome<MeasurementFile> read() {
        recording_.format = "ASAM MDF " + text3(bytes_.part(8, 8));
        isBigEndian_ = bytes_.little<std::uint16_t>(24) != 0;
        const bool isUnfinished = bytes_.part(0, 8).text() == "UnFinMF ";
        const std::optional<Block3> header = block(64, "HD");
        if (!header)
            return fileError(phrase("the header of the file is damaged"), recording_.file, 0, 0,
                             phrase("copy it again from where it was recorded"));
        recording_.start = startTime(*header);
        if (isUnfinished)
            recording_.notes.push_back(phrase("the recorder did not close the file: what it had written is read"));
        for (std::uint32_t address = header->link(4); address != 0;) address = dataGroup(address);
        readData(isUnfinished);
        settleSamples(stored_, recording_, isUnfinished);
        noteGroups();
        recording_.reader = makeReader(std::move(stored_), recording_.file);
        return std::move(recording_);
    }

private:
    std::optional<Block3> block(std::uint64_t address, std::string_view id) const {
        if (address == 0 || bytes_.part(address, 2).text() != id || !bytes_.has(address, 4)) return std::nullopt;
        const Block3 head{bytes_.part(address, 4), isBigEndian_};
        return Block3{bytes_.part(address, std::max<std::uint64_t>(4, head.at<std::uint16_t>(2))), isBigEndian_};
    }
    bool enter(std::uint64_t address) {
        if (entered_.insert(address).second) return true;
        recording_.notes.push_back(phrase("the file is damaged: its blocks refer to each other in a circle"));
        return false;
    }
    void noteLost(std::uint64_t address) {
        recording_.notes.push_back(phrase("the file is damaged: no block of the expected kind at byte {}", address));
    }
    std::string text(std::uint64_t address) const { return textBlock3(bytes_, address, isBigEndian_); }

    /// "15:06:2024" and "10:30:00"; from version 3.2 on nanoseconds of the local time and its offset in hours.
    static std::string startTime(const Block3& header) {
        const std::string date = text3(header.bytes.part(18, 10)), time = text3(header.bytes.part(28, 8));
        if (const auto nanoseconds = header.at<std::uint64_t>(164); nanoseconds != 0) {
            const auto seconds = static_cast<std::int64_t>(nanoseconds / 1000000000u);
            const auto day =
                std::chrono::floor<std::chrono::days>(std::chrono::sys_seconds(std::chrono::seconds(seconds)));
            const std::chrono::year_month_day local(day);
            const std::int64_t ofDay = seconds - std::chrono::seconds(day.time_since_epoch()).count();
            std::string text = fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}", static_cast<int>(local.year()),
                                           static_cast<unsigned>(local.month()), static_cast<unsigned>(local.day()),
                                           ofDay / 3600, ofDay / 60 % 60, ofDay % 60);
            std::string fraction = fmt::format(".{:09}", nanoseconds % 1000000000u);
            while (fraction.back() == '0') fraction.pop_back();
            if (fraction.size() > 1) text += fraction;
            const auto hours = header.at<std::int16_t>(172);
            return text + fmt::format("{}{:02}:00", hours < 0 ? '-' : '+', std::abs(int{hours}) % 100);
        }
        if (date.size() != 10 || time.size() != 8) return {};
        return date.substr(6) + "-" + date.substr(3, 2) + "-" + date.substr(0, 2) + "T" + time;
    }

    std::uint32_t dataGroup(std::uint32_t address) {
        const std::optional<Block3> group = block(address, "DG");
        if (!group) return noteLost(address), 0;
        if (!enter(address)) return 0;
        DataGroup data;
        const auto ids = group->at<std::uint16_t>(22);
        if (ids > 2) {
            recording_.notes.push_back(phrase("a group is left out: {} record ids for each record cannot be", ids));
            return group->link(4);
        }
        data.idBytes = ids == 0 ? 0 : 1;
        data.hasIdBehind = ids == 2;
        data.isBigEndian = isBigEndian_;
        stored_.dataGroups.push_back(std::move(data));
        dataLinks_.push_back(group->link(16));
        for (std::uint32_t next = group->link(8); next != 0;) next = channelGroup(next);
        return group->link(4);
    }

    std::uint32_t channelGroup(std::uint32_t address) {
        const std::optional<Block3> block3 = block(address, "CG");
        if (!block3) return noteLost(address), 0;
        if (!enter(address)) return 0;
        RecordGroup group;
        group.id = block3->at<std::uint16_t>(16) & 0xFF;
        group.dataBytes = block3->at<std::uint16_t>(20);
        group.samples = block3->at<std::uint32_t>(22);
        group.dataGroup = stored_.dataGroups.size() - 1;
        stored_.dataGroups.back().bytesOfId[group.id] = group.dataBytes;
        RecordedGroup recorded;
        recorded.name = text(block3->link(12));  // a comment, whose first line names what was recorded
        recorded.name.resize(std::min(recorded.name.find_first_of("\r\n"), recorded.name.size()));
        stored_.recordGroups.push_back(group);
        stored_.channels.emplace_back();
        recording_.groups.push_back(std::move(recorded));
        for (std::uint32_t next = block3->link(8); next != 0;) {
            const std::optional<Block3> found = block(next, "CN");
            if (!found) {
                noteLost(next);
                break;
            }
            if (!enter(next)) break;
            channel(*found);
            next = found->link(4);
        }
        return block3->link(4);
    }

    std::string sourceName(std::uint32_t address) const {
        const std::optional<Block3> source = block(address, "CE");
        if (!source) return {};
        const auto type = source->at<std::uint16_t>(4);
        if (type == 2) return text3(source->bytes.part(12, 80));   // ECU: its description
        if (type == 19) return text3(source->bytes.part(14, 36));  // CAN: the message
        return {};
    }

    static bool setType(ValueLayout& layout, unsigned type, bool isBigEndian) {
        using Type = ValueLayout::Type;
        layout.isBigEndian = type >= 9 && type <= 12 ? true : type >= 13 && type <= 16 ? false : isBigEndian;
        switch (type) {
            case 0:
            case 9:
            case 13:
                layout.type = Type::Unsigned;
                return true;
            case 1:
            case 10:
            case 14:
                layout.type = Type::Signed;
                return true;
            case 2:
            case 3:
            case 11:
            case 12:
            case 15:
            case 16:
                layout.type = Type::Float;
                return true;
            case 7:
                layout.type = Type::Windows1252;
                return true;
            case 8:
                layout.type = Type::Bytes;
                return true;
            default:
                return false;
        }
    }

    void channel(const Block3& block3) {
        RecordedChannel channel;
        channel.name = text(block3.link(218));
        if (channel.name.empty()) channel.name = text3(block3.bytes.part(26, 32));
        channel.comment = text(block3.link(20));
        if (channel.comment.empty()) channel.comment = text3(block3.bytes.part(58, 128));
        channel.source = sourceName(block3.link(12));
        StoredChannel stored;
        stored.records = stored_.recordGroups.size() - 1;
        const auto firstBit = block3.at<std::uint16_t>(186);
        stored.layout.byteOffset = std::uint64_t{block3.at<std::uint16_t>(226)} + firstBit / 8;
        stored.layout.bitOffset = firstBit % 8;
        stored.layout.bits = block3.at<std::uint16_t>(188);
        const auto type = block3.at<std::uint16_t>(190);
        const auto rate = block3.at<double>(210);
        const bool isMaster = block3.at<std::uint16_t>(24) == 1;
        if (!setType(stored.layout, type, isBigEndian_)) {
            recording_.notes.push_back(
                phrase("channel \"{}\" is left out: values of type {} cannot be read", channel.name, unsigned{type}));
            return;
        }
        const std::optional<Block3> conversion = block(block3.link(8), "CC");
        if (conversion)
            stored.conversion = readConversion3(bytes_, conversion->bytes, isBigEndian_, stored.layout.isInteger());
        // a time without bits of its own is counted
        if (isMaster && stored.layout.bits == 0) {
            stored.storage = StoredChannel::Storage::Counted;
            if (!stored.conversion && rate > 0) stored.conversion = countedBy(rate);
        }
        if (!fitsItsRecord(stored, stored_.recordGroups.back(), channel.name, recording_.notes)) return;
        describeByConversion(stored, channel, recording_.notes);
        RecordedGroup& group = recording_.groups.back();
        if (isMaster && !group.masterChannel) {
            group.master = MasterKind::Time;
            group.masterChannel = group.channels.size();
            if (channel.unit.empty()) channel.unit = "s";
        }
        group.channels.push_back(std::move(channel));
        stored_.channels.back().push_back(std::move(stored));
    }

    static std::shared_ptr<const Conversion> countedBy(double interval) {
        auto conversion = std::make_shared<Conversion>();
        conversion->kind = Conversion::Kind::Linear;
        conversion->numbers = {0, interval};
        return conversion;
    }

    /// The data of a group have no length: what its records need, or what there is to the end of the file.
    void readData(bool isUnfinished) {
        for (std::size_t i = 0; i < dataLinks_.size(); ++i) {
            DataGroup& data = stored_.dataGroups[i];
            const std::uint64_t begin = dataLinks_[i];
            std::uint64_t needed = 0;
            for (const RecordGroup& group : stored_.recordGroups)
                if (group.dataGroup == i)
                    needed += group.samples * (group.bytes() + data.idBytes * (data.hasIdBehind ? 2u : 1u));
            if (begin == 0 || (needed == 0 && !isUnfinished)) continue;
            const ByteView bytes = bytes_.part(begin, isUnfinished ? UINT64_MAX : needed);
            data.records.append({bytes, bytes.size(), Fragment::Packing::Plain, 0});
        }
    }

    void noteGroups() {
        bool hasSignals = false;
        for (std::size_t i = 0; i < recording_.groups.size(); ++i) {
            const RecordedGroup& group = recording_.groups[i];
            const std::size_t signals = group.channels.size() - (group.masterChannel ? 1 : 0);
            hasSignals = hasSignals || signals > 0;
            if (group.samples == 0 && signals > 0)
                recording_.notes.push_back(phrase("group \"{}\" has no samples", groupLabel(group, i)));
            if (!group.masterChannel && signals > 0)
                recording_.notes.push_back(
                    phrase("group \"{}\" has no time: its samples can only be counted", groupLabel(group, i)));
        }
        if (!hasSignals) recording_.notes.push_back(phrase("the file holds no channel with values"));
    }

    ByteView bytes_;
    bool isBigEndian_{};
    StoredFile stored_;
    MeasurementFile recording_;
    std::set<std::uint64_t> entered_;
    std::vector<std::uint64_t> dataLinks_;  // by data group
};

}  // namespace

Outcome<MeasurementFile> openMdf3(std::shared_ptr<const MappedFile> file, const std::string& name) {
    return Reader3(std::move(file), name).read();
}

}  // namespace analogon::mdf
