#include "core/measure/mdf/mdf4_data.hpp"

namespace analogon::mdf {

namespace {

/// The best that deflate can do is 1032 : 1. A block that claims more lies.
constexpr std::uint64_t largestRatio = 1032;
constexpr std::uint64_t largestUnpacked = std::uint64_t{1} << 28;

class DataReader {
public:
    DataReader(Blocks4& blocks, bool isUnfinished) : blocks_(blocks), isUnfinished_(isUnfinished) {}

    Data4 read(std::uint64_t address) {
        if (address == 0) return std::move(data_);
        const std::string_view id = blocks_.idAt(address);
        if (id == "HL") {
            const auto list = blocks_.block(address, "HL");
            if (list)
                dataList(list->link(0));
            else
                data_.isDamaged = true;
        } else if (id == "DL") {
            dataList(address);
        } else if (id == "LD") {
            columnList(address);
        } else {
            block(address, data_.records, true);
        }
        return std::move(data_);
    }

private:
    void block(std::uint64_t address, DataStream& stream, bool isLast) {
        if (address == 0) return;
        const std::string_view id = blocks_.idAt(address);
        // a block in two places of a list: the list was damaged, and could grow without end
        if (!met_.insert(address).second) {
            data_.isDamaged = true;
        } else if (id == "DZ") {
            packed(address, stream);
        } else if (id == "DT" || id == "SD" || id == "DV" || id == "DI" || id == "RD") {
            plain(address, id, stream, isLast);
        } else {
            data_.isDamaged = true;
        }
    }

    void plain(std::uint64_t address, std::string_view id, DataStream& stream, bool isLast) {
        const std::optional<Block4> found = blocks_.block(address, id);
        if (!found) {
            data_.isDamaged = true;
            return;
        }
        data_.isCut = data_.isCut || found->isCut;
        ByteView bytes = found->data;
        if (isUnfinished_ && isLast && (bytes.empty() || found->isCut)) {
            const std::uint64_t begin = address + 24;
            bytes = blocks_.file().part(begin, blocks_.nextBehind(address) - begin);
            data_.wasOpen = true;
            data_.isCut = false;
        }
        stream.append({bytes, bytes.size(), Fragment::Packing::Plain, 0});
    }

    void packed(std::uint64_t address, DataStream& stream) {
        const std::optional<Block4> found = blocks_.block(address, "DZ");
        if (!found || found->data.size() < 24) {
            data_.isDamaged = true;
            return;
        }
        const ByteView& head = found->data;
        const auto kind = head.little<std::uint8_t>(2);
        const auto unpacked = head.little<std::uint64_t>(8);
        const ByteView bytes = head.part(24, head.little<std::uint64_t>(16));
        const bool isPossible = kind <= 1 && unpacked <= bytes.size() * largestRatio && unpacked <= largestUnpacked;
        if (!isPossible) {
            data_.isDamaged = true;
            return;
        }
        data_.isCut = data_.isCut || found->isCut;
        stream.append({bytes, unpacked, kind == 0 ? Fragment::Packing::Deflated : Fragment::Packing::Transposed,
                       head.little<std::uint32_t>(4)});
    }

    void dataList(std::uint64_t address) {
        while (address != 0) {
            const std::optional<Block4> list =
                met_.insert(address).second ? blocks_.block(address, "DL") : std::nullopt;
            if (!list || list->linkCount() == 0) {
                data_.isDamaged = true;
                return;
            }
            const std::uint64_t told = list->data.little<std::uint32_t>(4);
            const std::uint64_t there = list->linkCount() - 1;
            if (told > there) data_.isDamaged = true;
            const std::uint64_t count = isUnfinished_ ? there : std::min(told, there);
            const std::uint64_t next = list->link(0);
            for (std::uint64_t i = 0; i < count; ++i)
                block(list->link(1 + i), data_.records, next == 0 && i + 1 == count);
            address = next;
        }
    }

    /// Format 4.2: blocks of values, and blocks of their invalidation bits beside them.
    void columnList(std::uint64_t address) {
        while (address != 0) {
            const std::optional<Block4> list =
                met_.insert(address).second ? blocks_.block(address, "LD") : std::nullopt;
            if (!list) {
                data_.isDamaged = true;
                return;
            }
            const bool isApart = (list->data.little<std::uint32_t>(0) & 0x80000000u) != 0;
            data_.hasInvalidationApart = data_.hasInvalidationApart || isApart;
            const std::uint64_t count = list->data.little<std::uint32_t>(4);
            const std::uint64_t links = list->linkCount() - std::min<std::uint64_t>(list->linkCount(), 1);
            if (count > links) data_.isDamaged = true;
            const std::uint64_t next = list->link(0);
            for (std::uint64_t i = 0; i < std::min(count, links); ++i) {
                block(list->link(1 + i), data_.records, next == 0 && i + 1 == count);
                if (isApart) block(list->link(1 + count + i), data_.invalidation, false);
            }
            address = next;
        }
    }

    Blocks4& blocks_;
    bool isUnfinished_;
    std::set<std::uint64_t> met_;
    Data4 data_;
};

}  // namespace

Data4 readData4(Blocks4& blocks, std::uint64_t address, bool isUnfinished) {
    Data4 data = DataReader(blocks, isUnfinished).read(address);
    // values that lie by columns have their invalidation bits nowhere else
    if (blocks.idAt(address) == "DV") data.hasInvalidationApart = true;
    return data;
}

}  // namespace analogon::mdf
