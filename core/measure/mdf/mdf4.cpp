#include "core/measure/mdf/mdf4.hpp"

#include <fmt/format.h>

#include <chrono>

#include "core/measure/mdf/mdf4_blocks.hpp"
#include "core/measure/mdf/mdf4_conversion.hpp"
#include "core/measure/mdf/mdf4_data.hpp"
#include "core/measure/mdf/mdf_channel.hpp"
#include "core/measure/mdf/mdf_reader.hpp"
#include "core/measure/mdf/mdf_samples.hpp"

namespace analogon::mdf {

namespace {

constexpr std::uint64_t mostElements = 4096;  // of an array, as channels of their own
constexpr int deepestComposition = 8;
constexpr std::uint16_t variableGroup = 1, plainBusEvents = 4, remoteMaster = 8;
constexpr std::uint32_t busEvent = 1u << 10;

/// ISO 8601, with the zone where it is known.
std::string startTime(const Block4& header) {
    const auto nanoseconds = header.data.little<std::uint64_t>(0);
    if (nanoseconds == 0) return {};
    const auto flags = header.data.little<std::uint8_t>(12);
    const bool isLocal = (flags & 1) != 0, hasOffset = !isLocal && (flags & 2) != 0;
    const int offset =
        hasOffset ? header.data.little<std::int16_t>(8) + header.data.little<std::int16_t>(10) : 0;  // minutes
    const std::int64_t seconds = static_cast<std::int64_t>(nanoseconds / 1000000000u) + offset * 60;
    const auto day = std::chrono::floor<std::chrono::days>(std::chrono::sys_seconds(std::chrono::seconds(seconds)));
    const std::chrono::year_month_day date(day);
    const auto ofDay = seconds - std::chrono::duration_cast<std::chrono::seconds>(day.time_since_epoch()).count();
    std::string text = fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}", static_cast<int>(date.year()),
                                   static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), ofDay / 3600,
                                   ofDay / 60 % 60, ofDay % 60);
    std::string fraction = fmt::format(".{:09}", nanoseconds % 1000000000u);
    while (fraction.back() == '0') fraction.pop_back();
    if (fraction.size() > 1) text += fraction;
    if (isLocal) return text;
    if (!hasOffset) return text + "Z";
    return text + fmt::format("{}{:02}:{:02}", offset < 0 ? '-' : '+', std::abs(offset) / 60, std::abs(offset) % 60);
}

MasterKind masterOf(unsigned synchronisation) {
    switch (synchronisation) {
        case 1:
            return MasterKind::Time;
        case 2:
            return MasterKind::Angle;
        case 3:
            return MasterKind::Distance;
        case 4:
            return MasterKind::Index;
        default:
            return MasterKind::None;
    }
}

const char* usualUnit(MasterKind master) {
    switch (master) {
        case MasterKind::Time:
            return "s";
        case MasterKind::Angle:
            return "rad";
        case MasterKind::Distance:
            return "m";
        default:
            return "";
    }
}

class Reader4 {
public:
    Reader4(std::shared_ptr<const MappedFile> file, const std::string& name)
        : blocks_(file->bytes()), conversions_(blocks_) {
        stored_.memory = std::move(file);
        recording_.file = name;
    }

    Outcome<MeasurementFile> read() {
        const ByteView bytes = blocks_.file();
        const std::string_view version = bytes.part(8, 8).text();
        recording_.format = "ASAM MDF " + std::string(version.substr(0, version.find_first_of(" \0", 0, 2)));
        unfinished_ = bytes.little<std::uint16_t>(60);
        const std::optional<Block4> header = blocks_.block(64, "HD");
        if (!header)
            return fileError(phrase("the header of the file is damaged"), recording_.file, 0, 0,
                             phrase("copy it again from where it was recorded"));
        recording_.start = startTime(*header);
        if (unfinished_ != 0)
            recording_.notes.push_back(phrase("the recorder did not close the file: what it had written is read"));
        for (std::uint64_t address = header->link(0); address != 0;) address = dataGroup(address);
        for (const auto& [group, master] : mastersElsewhere_) takeMaster(group, master);
        readData();
        settleSamples(stored_, recording_, unfinished_ != 0);
        noteGroups();
        if (blocks_.hasLostText())
            recording_.notes.push_back(phrase("the file is damaged: names, units or comments are missing"));
        recording_.reader = makeReader(std::move(stored_), recording_.file);
        return std::move(recording_);
    }

private:
    bool enter(std::uint64_t address) {
        if (blocks_.enter(address)) return true;
        recording_.notes.push_back(phrase("the file is damaged: its blocks refer to each other in a circle"));
        return false;
    }
    void noteLost(std::uint64_t address) {
        recording_.notes.push_back(phrase("the file is damaged: no block of the expected kind at byte {}", address));
    }

    /// Address of the next one.
    std::uint64_t dataGroup(std::uint64_t address) {
        const std::optional<Block4> block = blocks_.block(address, "DG");
        if (!block) return noteLost(address), 0;
        if (!enter(address)) return 0;
        DataGroup data;
        data.idBytes = block->data.little<std::uint8_t>(0);
        if (data.idBytes > 8 || (data.idBytes & (data.idBytes - 1)) != 0) {
            recording_.notes.push_back(phrase("a group is left out: record ids of {} bytes cannot be", data.idBytes));
            return block->link(0);
        }
        stored_.dataGroups.push_back(std::move(data));
        dataLinks_.push_back(block->link(2));
        for (std::uint64_t group = block->link(1); group != 0;) group = channelGroup(group);
        return block->link(0);
    }

    std::uint64_t channelGroup(std::uint64_t address) {
        const std::optional<Block4> block = blocks_.block(address, "CG");
        if (!block) return noteLost(address), 0;
        if (!enter(address)) return 0;
        const ByteView& head = block->data;
        const auto flags = head.little<std::uint16_t>(16);
        RecordGroup group;
        group.id = head.little<std::uint64_t>(0);
        group.samples = head.little<std::uint64_t>(8);
        group.dataBytes = head.little<std::uint32_t>(24);
        group.invalidationBytes = head.little<std::uint32_t>(28);
        group.dataGroup = stored_.dataGroups.size() - 1;
        DataGroup& data = stored_.dataGroups.back();
        if ((flags & variableGroup) != 0) {
            data.isVariable[group.id] = true;
            variableGroups_[address] = group.id;
            return block->link(0);
        }
        data.bytesOfId[group.id] = group.bytes();
        RecordedGroup recorded;
        recorded.name = blocks_.text(block->link(2));
        if (recorded.name.empty()) recorded.name = sourceName(block->link(3));
        if (recorded.name.empty()) recorded.name = blocks_.text(block->link(5));
        groupOfBlock_[address] = stored_.recordGroups.size();
        stored_.recordGroups.push_back(group);
        stored_.channels.emplace_back();
        recording_.groups.push_back(std::move(recorded));
        busFrames_.push_back((flags & plainBusEvents) != 0);
        busName_.push_back(busName(block->link(3)));
        if ((flags & remoteMaster) != 0)
            mastersElsewhere_.emplace_back(stored_.recordGroups.size() - 1, block->link(6));
        channelList(block->link(1), "", 0, 0, 0);
        return block->link(0);
    }

    std::string sourceName(std::uint64_t address) {
        const std::optional<Block4> block = blocks_.block(address, "SI");
        return block ? blocks_.text(block->link(0)) : std::string();
    }
    std::string busName(std::uint64_t address) {
        static constexpr const char* names[] = {"", "", "CAN", "LIN", "MOST", "FlexRay", "K-Line", "Ethernet", "USB"};
        const std::optional<Block4> block = blocks_.block(address, "SI");
        const unsigned type = block ? block->data.little<std::uint8_t>(1) : 0;
        return type < std::size(names) ? names[type] : "";
    }

    void channelList(std::uint64_t address, const std::string& suffix, std::int64_t shift, std::uint64_t bitShift,
                     int depth) {
        std::set<std::uint64_t> met;
        while (address != 0) {
            const std::optional<Block4> block = blocks_.block(address, "CN");
            if (!block) return noteLost(address);
            // the members of an array of structures are entered once for each element
            if (depth == 0 ? !enter(address) : !met.insert(address).second) return;
            channel(*block, suffix, shift, bitShift, depth);
            address = block->link(0);
        }
    }

    void channel(const Block4& block, const std::string& suffix, std::int64_t shift, std::uint64_t bitShift,
                 int depth) {
        const ByteView& head = block.data;
        const unsigned type = head.little<std::uint8_t>(0);
        const bool isMaster = type == 2 || type == 3;
        if (!isMaster && isBusFrame(head.little<std::uint32_t>(12))) return;
        const std::uint64_t composition = block.link(1);
        const std::string_view composed = blocks_.idAt(composition);
        if (depth < deepestComposition && composed == "CN")
            return channelList(composition, suffix, shift, bitShift, depth + 1);
        if (depth < deepestComposition && composed == "CA")
            return array(block, composition, suffix, shift, bitShift, depth);
        element(block, suffix, shift, bitShift);
    }

    bool isBusFrame(std::uint32_t flags) {
        const bool isFrame = busFrames_.back() || (flags & busEvent) != 0;
        if (isFrame) busFrames_.back() = true;
        return isFrame;
    }

    /// name[i][j] for each element, the last index fastest.
    void array(const Block4& block, std::uint64_t address, const std::string& suffix, std::int64_t shift,
               std::uint64_t bitShift, int depth) {
        const std::optional<Block4> shape = blocks_.block(address, "CA");
        const std::string name = blocks_.text(block.link(2)) + suffix;
        const unsigned dimensions = shape ? shape->data.little<std::uint16_t>(2) : 0;
        std::vector<std::uint64_t> sizes;
        std::uint64_t count = 1;
        for (unsigned i = 0; i < dimensions && count > 0 && count <= mostElements; ++i) {
            sizes.push_back(shape->data.little<std::uint64_t>(16 + 8 * i));
            count = sizes.back() > mostElements ? mostElements + 1 : count * sizes.back();
        }
        const bool isInRecord = shape && shape->data.little<std::uint8_t>(1) == 0;
        elements_ += count;
        if (!isInRecord || sizes.size() != dimensions || dimensions == 0 || count > mostElements ||
            elements_ > 16 * mostElements) {
            recording_.notes.push_back(phrase("array \"{}\" is left out: its form cannot be read", name));
            return;
        }
        const auto step = shape->data.little<std::int32_t>(8);
        const auto bitStep = shape->data.little<std::uint32_t>(12);
        const bool isColumnMajor = (shape->data.little<std::uint32_t>(4) & 64) != 0;
        for (std::uint64_t i = 0; i < count; ++i) {
            std::string indices;
            std::uint64_t place = 0, rest = i;
            std::vector<std::uint64_t> index(sizes.size());
            for (std::size_t d = sizes.size(); d-- > 0; rest /= sizes[d]) index[d] = rest % sizes[d];
            for (std::size_t d = 0; d < sizes.size(); ++d) {
                const std::size_t e = isColumnMajor ? sizes.size() - 1 - d : d;
                place = place * sizes[e] + index[e];
                indices += fmt::format("[{}]", index[d]);
            }
            const std::int64_t at = shift + static_cast<std::int64_t>(place) * step;
            const std::uint64_t bit = bitShift + place * bitStep;
            const std::uint64_t inner = shape->link(0);
            if (blocks_.idAt(inner) == "CN")
                channelList(inner, suffix + indices, at, bit, depth + 1);
            else if (blocks_.idAt(inner) == "CA" && depth + 1 < deepestComposition)
                array(block, inner, suffix + indices, at, bit, depth + 1);
            else
                element(block, suffix + indices, at, bit);
        }
    }

    bool setType(StoredChannel& stored, unsigned dataType) {
        using Type = ValueLayout::Type;
        static constexpr Type types[] = {Type::Unsigned,    Type::Unsigned,    Type::Signed,     Type::Signed,
                                         Type::Float,       Type::Float,       Type::Latin1,     Type::Utf8,
                                         Type::Utf16Little, Type::Utf16Big,    Type::Bytes,      Type::Bytes,
                                         Type::Bytes,       Type::CanOpenDate, Type::CanOpenTime};
        if (dataType >= std::size(types)) return false;
        stored.layout.type = types[dataType];
        stored.layout.isBigEndian = dataType == 1 || dataType == 3 || dataType == 5;
        return true;
    }

    /// A channel of variable length: its record has but the place of its value.
    void setElsewhere(StoredChannel& stored) {
        stored.storage = StoredChannel::Storage::Elsewhere;
        stored.elsewhereType = stored.layout.type;
        stored.layout.type = ValueLayout::Type::Unsigned;
        stored.layout.bits = 64;
        stored.layout.bitOffset = 0;
    }

    void element(const Block4& block, const std::string& suffix, std::int64_t shift, std::uint64_t bitShift) {
        const ByteView& head = block.data;
        const unsigned type = head.little<std::uint8_t>(0);
        const bool isMaster = type == 2 || type == 3;
        RecordedChannel channel;
        channel.name = blocks_.text(block.link(2)) + suffix;
        channel.unit = blocks_.unit(block.link(6));
        channel.comment = blocks_.text(block.link(7));
        channel.source = sourceName(block.link(3));
        StoredChannel stored;
        stored.records = stored_.recordGroups.size() - 1;
        stored.layout.byteOffset = head.little<std::uint32_t>(4) + static_cast<std::uint64_t>(shift);
        stored.layout.bitOffset = head.little<std::uint8_t>(3);
        stored.layout.bits = head.little<std::uint32_t>(8);
        const unsigned dataType = head.little<std::uint8_t>(2);
        if (!setType(stored, dataType)) {
            recording_.notes.push_back(
                phrase("channel \"{}\" is left out: values of type {} cannot be read", channel.name, dataType));
            return;
        }
        if (type == 3 || type == 6) stored.storage = StoredChannel::Storage::Counted;
        if (type == 1) setElsewhere(stored);
        const auto flags = head.little<std::uint32_t>(12);
        stored.isAllInvalid = (flags & 1) != 0;
        if ((flags & 2) != 0 && type != 3 && type != 6)
            stored.invalidationBit = head.little<std::uint32_t>(16) + bitShift;
        if (!fitsItsRecord(stored, stored_.recordGroups.back(), channel.name, recording_.notes)) return;
        stored.conversion = conversions_.read(block.link(4), stored.layout.isInteger());
        describeByConversion(stored, channel, recording_.notes);
        if (stored.isAllInvalid)
            recording_.notes.push_back(
                phrase("channel \"{}\": the file marks all its values as invalid", channel.name));
        if (isMaster) setMaster(head.little<std::uint8_t>(1), channel);
        if (type == 1)
            lateLinks_.push_back({recording_.groups.size() - 1, stored_.channels.back().size(), block.link(5)});
        recording_.groups.back().channels.push_back(std::move(channel));
        stored_.channels.back().push_back(std::move(stored));
    }

    void setMaster(unsigned synchronisation, RecordedChannel& channel) {
        RecordedGroup& group = recording_.groups.back();
        if (group.masterChannel) return;
        group.master = masterOf(synchronisation);
        group.masterChannel = group.channels.size();
        if (channel.unit.empty()) channel.unit = usualUnit(group.master);
    }

    /// Format 4.2: the master of a group may be that of another.
    void takeMaster(std::size_t group, std::uint64_t address) {
        const auto from = groupOfBlock_.find(address);
        const std::optional<std::size_t> master =
            from == groupOfBlock_.end() ? std::nullopt : recording_.groups[from->second].masterChannel;
        if (!master || recording_.groups[group].masterChannel || from->second == group) return;
        const StoredChannel stored = stored_.channels[from->second][*master];
        const RecordedChannel channel = recording_.groups[from->second].channels[*master];
        RecordedGroup& recorded = recording_.groups[group];
        recorded.master = recording_.groups[from->second].master;
        recorded.masterChannel = recorded.channels.size();
        recorded.channels.push_back(channel);
        stored_.channels[group].push_back(stored);
    }

    /// After all links were followed: an open block ends where the next one begins.
    void readData() {
        const bool isOpen = (unfinished_ & (4 | 16)) != 0;
        bool isCut = false, isDamaged = false;
        std::map<std::uint64_t, std::shared_ptr<const DataStream>> signals;
        for (std::size_t i = 0; i < dataLinks_.size(); ++i) {
            Data4 data = readData4(blocks_, dataLinks_[i], isOpen);
            isCut = isCut || data.isCut;
            isDamaged = isDamaged || data.isDamaged;
            stored_.dataGroups[i].records = std::move(data.records);
            stored_.dataGroups[i].invalidation = std::move(data.invalidation);
            stored_.dataGroups[i].hasInvalidationApart = data.hasInvalidationApart;
        }
        for (const LateLink& late : lateLinks_) {
            StoredChannel& channel = stored_.channels[late.group][late.channel];
            if (const auto group = variableGroups_.find(late.address); group != variableGroups_.end()) {
                channel.elsewhereId = group->second;
                continue;
            }
            auto& stream = signals[late.address];
            if (!stream) stream = std::make_shared<DataStream>(readData4(blocks_, late.address, isOpen).records);
            channel.elsewhere = stream;
        }
        if (isCut) recording_.notes.push_back(phrase("the file ends in the middle of its data (a broken copy?)"));
        if (isDamaged) recording_.notes.push_back(phrase("the file is damaged: a part of its data is left out"));
    }

    void noteGroups() {
        bool hasSignals = false;
        for (std::size_t i = 0; i < recording_.groups.size(); ++i) {
            const RecordedGroup& group = recording_.groups[i];
            const std::string label = groupLabel(group, i);
            const std::size_t signals = group.channels.size() - (group.masterChannel ? 1 : 0);
            hasSignals = hasSignals || signals > 0;
            if (busFrames_[i] && group.samples > 0)
                recording_.notes.push_back(
                    phrase("group \"{}\" holds {} raw frames of the bus {}, no signals: decode them with the bus's "
                           "database (DBC, ARXML) in the recording tool and export the signals",
                           label, group.samples, busName_[i].empty() ? label : busName_[i]));
            else if (group.samples == 0 && signals > 0)
                recording_.notes.push_back(phrase("group \"{}\" has no samples", label));
            if (!group.masterChannel && signals > 0)
                recording_.notes.push_back(phrase("group \"{}\" has no time: its samples can only be counted", label));
        }
        if (!hasSignals) recording_.notes.push_back(phrase("the file holds no channel with values"));
    }

    struct LateLink {
        std::size_t group, channel;
        std::uint64_t address;
    };

    Blocks4 blocks_;
    Conversions4 conversions_;
    StoredFile stored_;
    MeasurementFile recording_;
    std::uint16_t unfinished_{};
    std::uint64_t elements_{};
    std::vector<std::uint64_t> dataLinks_;                                 // by data group
    std::vector<LateLink> lateLinks_;                                      // data of channels of variable length
    std::map<std::uint64_t, std::uint64_t> variableGroups_;                // block: record id
    std::map<std::uint64_t, std::size_t> groupOfBlock_;                    // block: group
    std::vector<std::pair<std::size_t, std::uint64_t>> mastersElsewhere_;  // group, block of the one that has it
    std::vector<bool> busFrames_;
    std::vector<std::string> busName_;
};

}  // namespace

Outcome<MeasurementFile> openMdf4(std::shared_ptr<const MappedFile> file, const std::string& name) {
    return Reader4(std::move(file), name).read();
}

}  // namespace analogon::mdf
