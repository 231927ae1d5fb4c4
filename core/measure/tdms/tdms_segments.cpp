#include "core/measure/tdms/tdms_segments.hpp"

#include <fmt/format.h>

#include <chrono>
#include <set>

#include "core/measure/encoding.hpp"

namespace analogon::tdms {

namespace {

constexpr std::uint64_t leadBytes = 28;
constexpr std::uint64_t notClosed = UINT64_MAX;
enum Contents : std::uint32_t { hasMeta = 2, newList = 4, hasRaw = 8, isInterleaved = 32, bigEndian = 64 };

/// Where the raw values of an object lie within each chunk of a segment.
struct RawIndex {
    bool hasData{};
    std::uint32_t type{};
    std::uint64_t count{};
    std::uint64_t bytes{};  // String: of a chunk
    // DAQmx
    bool isDaqMx{};
    std::uint32_t buffer{}, offset{}, scaleId{};
    std::vector<std::uint32_t> widths{};  // of the buffers
};

/// Reads one field after the other; once something is missing, nothing more.
class Cursor {
public:
    Cursor(ByteView bytes, bool isBigEndian) : bytes_(bytes), isBigEndian_(isBigEndian) {}

    template <class T>
    T take() {
        if (!bytes_.has(at_, sizeof(T))) {
            isGood_ = false;
            return T{};
        }
        const T value = bytes_.number<T>(at_, isBigEndian_ == (std::endian::native == std::endian::little));
        at_ += sizeof(T);
        return value;
    }
    std::string takeText() {
        const auto length = take<std::uint32_t>();
        if (!isGood_ || !bytes_.has(at_, length)) {
            isGood_ = false;
            return {};
        }
        const std::string_view text = bytes_.part(at_, length).text();
        at_ += length;
        return inUtf8(text);
    }
    TimePoint takeTime() {
        const TimePoint time = timePointAt(bytes_, at_, isBigEndian_);
        skip(16);
        return time;
    }
    void skip(std::uint64_t bytes) {
        isGood_ = isGood_ && bytes_.has(at_, bytes);
        at_ += isGood_ ? bytes : 0;
    }
    bool isGood() const { return isGood_; }
    void fail() { isGood_ = false; }

private:
    ByteView bytes_;
    std::uint64_t at_{};
    bool isBigEndian_;
    bool isGood_{true};
};

/// "/'group'/'channel'", a quote in a name is written twice.
std::vector<std::string> namesOf(const std::string& path) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < path.size();) {
        if (path[i++] != '\'') continue;
        std::string name;
        for (; i < path.size(); ++i) {
            if (path[i] == '\'' && (i + 1 == path.size() || path[i + 1] != '\'')) break;
            if (path[i] == '\'') ++i;
            name.push_back(path[i]);
        }
        ++i;
        names.push_back(std::move(name));
    }
    return names;
}

class SegmentReader {
public:
    explicit SegmentReader(ByteView bytes) : bytes_(bytes) {}

    File read() {
        std::uint64_t at = 0;
        while (bytes_.has(at, leadBytes) && bytes_.part(at, 4).text() == "TDSm") {
            const auto contents = bytes_.little<std::uint32_t>(at + 4);
            isBigEndian_ = (contents & bigEndian) != 0;
            const bool swaps = isBigEndian_ == (std::endian::native == std::endian::little);
            const auto length = bytes_.number<std::uint64_t>(at + 12, swaps);
            const auto rawAt = bytes_.number<std::uint64_t>(at + 20, swaps);
            const std::uint64_t begin = at + leadBytes;
            const bool isOpen = length == notClosed || length > bytes_.size() - begin;
            file_.isIncomplete = file_.isIncomplete || isOpen;
            const ByteView segment = bytes_.part(begin, isOpen ? bytes_.size() : length);
            if (rawAt > segment.size()) {
                file_.isDamaged = file_.isDamaged || !isOpen;
                break;
            }
            if ((contents & newList) != 0) {
                list_.clear();
                listed_.clear();
            }
            if ((contents & hasMeta) != 0 && !readMeta(segment.part(0, rawAt))) {
                file_.isDamaged = true;
                break;
            }
            if ((contents & hasRaw) != 0) placeValues(segment.part(rawAt), (contents & isInterleaved) != 0);
            if (isOpen) break;
            at = begin + length;
        }
        if (bytes_.size() > at && bytes_.part(at, 4).text() != "TDSm") file_.isDamaged = true;
        return std::move(file_);
    }

private:
    bool readMeta(ByteView meta) {
        Cursor cursor(meta, isBigEndian_);
        const auto count = cursor.take<std::uint32_t>();
        for (std::uint32_t i = 0; i < count && cursor.isGood(); ++i) readObject(cursor);
        return cursor.isGood();
    }

    void readObject(Cursor& cursor) {
        const std::string path = cursor.takeText();
        if (!cursor.isGood()) return;
        const auto [known, isNew] = indexOf_.try_emplace(path, file_.objects.size());
        if (isNew) {
            const std::vector<std::string> names = namesOf(path);
            Object object;
            if (!names.empty()) object.group = names[0];
            if (names.size() > 1) object.channel = names[1];
            file_.objects.push_back(std::move(object));
            raw_.emplace_back();
        }
        const std::size_t index = known->second;
        const auto head = cursor.take<std::uint32_t>();
        RawIndex& raw = raw_[index];
        if (head == 0xFFFFFFFF)
            raw.hasData = false;
        else if (head == 0x1269 || head == 0x126A)
            readDaqMx(cursor, raw, head == 0x126A);
        else if (head != 0)
            readIndex(cursor, raw);
        else
            raw.hasData = true;
        if (listed_.insert(index).second) list_.push_back(index);
        const auto properties = cursor.take<std::uint32_t>();
        for (std::uint32_t i = 0; i < properties && cursor.isGood(); ++i) readProperty(cursor, file_.objects[index]);
    }

    static void readIndex(Cursor& cursor, RawIndex& raw) {
        raw = {};
        raw.type = cursor.take<std::uint32_t>();
        cursor.take<std::uint32_t>();  // dimension, always 1
        raw.count = cursor.take<std::uint64_t>();
        raw.bytes = raw.type == String ? cursor.take<std::uint64_t>() : 0;
        raw.hasData = true;
    }

    static void readDaqMx(Cursor& cursor, RawIndex& raw, bool isDigital) {
        static constexpr std::uint32_t types[] = {Uint8, Int8, Uint16, Int16, Uint32, Int32};
        raw = {};
        raw.isDaqMx = raw.hasData = true;
        cursor.take<std::uint32_t>();  // data type: DAQmx
        cursor.take<std::uint32_t>();  // dimension
        raw.count = cursor.take<std::uint64_t>();
        const auto scalers = cursor.take<std::uint32_t>();
        for (std::uint32_t i = 0; i < scalers && cursor.isGood(); ++i) {
            const auto type = cursor.take<std::uint32_t>();
            const auto buffer = cursor.take<std::uint32_t>();
            const auto offset = cursor.take<std::uint32_t>();
            if (isDigital)
                cursor.take<std::uint8_t>();
            else
                cursor.take<std::uint32_t>();
            const auto scaleId = cursor.take<std::uint32_t>();
            if (i > 0) continue;
            raw.type = type < std::size(types) && !isDigital ? types[type] : 0;
            raw.buffer = buffer;
            raw.offset = offset;
            raw.scaleId = scaleId;
        }
        const auto buffers = cursor.take<std::uint32_t>();
        for (std::uint32_t i = 0; i < buffers && cursor.isGood(); ++i)
            raw.widths.push_back(cursor.take<std::uint32_t>());
    }

    static void readProperty(Cursor& cursor, Object& object) {
        const std::string name = cursor.takeText();
        switch (cursor.take<std::uint32_t>()) {
            case Int8:
                object.properties[name] = static_cast<double>(cursor.take<std::int8_t>());
                break;
            case Int16:
                object.properties[name] = static_cast<double>(cursor.take<std::int16_t>());
                break;
            case Int32:
                object.properties[name] = static_cast<double>(cursor.take<std::int32_t>());
                break;
            case Int64:
                object.properties[name] = static_cast<double>(cursor.take<std::int64_t>());
                break;
            case Uint8:
            case Boolean:
                object.properties[name] = static_cast<double>(cursor.take<std::uint8_t>());
                break;
            case Uint16:
                object.properties[name] = static_cast<double>(cursor.take<std::uint16_t>());
                break;
            case Uint32:
                object.properties[name] = static_cast<double>(cursor.take<std::uint32_t>());
                break;
            case Uint64:
                object.properties[name] = static_cast<double>(cursor.take<std::uint64_t>());
                break;
            case Float32:
            case Float32WithUnit:
                object.properties[name] = static_cast<double>(cursor.take<float>());
                break;
            case Float64:
            case Float64WithUnit:
                object.properties[name] = cursor.take<double>();
                break;
            case String:
                object.properties[name] = cursor.takeText();
                break;
            case Timestamp:
                object.properties[name] = cursor.takeTime();
                break;
            case 11:  // extended precision
            case 0x1B:
                cursor.skip(16);
                break;
            case 0x08000C:
                cursor.skip(8);
                break;
            case 0x10000D:
                cursor.skip(16);
                break;
            default:
                cursor.fail();  // nobody knows how long it is
        }
    }

    /// Bytes of an object's values in one chunk.
    static std::uint64_t bytesOf(const RawIndex& raw) {
        if (raw.type == String) return std::min(raw.bytes, UINT64_MAX / 64);
        const std::uint64_t size = sizeOf(raw.type);
        return size != 0 && raw.count > UINT64_MAX / 64 / size ? UINT64_MAX / 64 : raw.count * size;
    }

    void placeValues(ByteView data, bool interleaved) {
        std::vector<std::size_t> active;
        bool isDaqMx = false;
        for (const std::size_t index : list_)
            if (raw_[index].hasData) {
                active.push_back(index);
                isDaqMx = isDaqMx || raw_[index].isDaqMx;
            }
        for (const std::size_t index : active) {
            Object& object = file_.objects[index];
            const RawIndex& raw = raw_[index];
            // of each text the file has where it ends
            const bool isReadable = raw.type == String ? raw.count <= raw.bytes / 4 : sizeOf(raw.type) != 0;
            if (!isReadable) {
                object.isSkipped = true;
                // how many bytes it takes is not known, nor where the others lie
                if (!raw.isDaqMx) return;
            }
            if (object.type != 0 && object.type != raw.type) object.isSkipped = true;
            object.type = raw.type;
        }
        if (active.empty() || data.empty()) return;
        if (isDaqMx)
            placeDaqMx(active, data);
        else if (interleaved)
            placeInterleaved(active, data);
        else
            placeContiguous(active, data);
    }

    void add(std::size_t index, Piece piece) {
        const RawIndex& raw = raw_[index];
        piece.type = raw.type;
        piece.isBigEndian = isBigEndian_;
        Object& object = file_.objects[index];
        object.isDaqMx = raw.isDaqMx;
        object.scaleId = raw.scaleId;
        if (piece.values() > 0) object.pieces.push_back(std::move(piece));
    }

    void placeContiguous(const std::vector<std::size_t>& active, ByteView data) {
        std::uint64_t chunk = 0;
        for (const std::size_t index : active) chunk = std::min(chunk + bytesOf(raw_[index]), UINT64_MAX / 64);
        if (chunk == 0) return;
        const std::uint64_t chunks = data.size() / chunk;
        std::uint64_t at = 0, rest = chunks * chunk;
        file_.isIncomplete = file_.isIncomplete || data.size() % chunk != 0;
        for (const std::size_t index : active) {
            const RawIndex& raw = raw_[index];
            const std::uint64_t bytes = bytesOf(raw);
            const std::size_t size = raw.type == String ? 0 : sizeOf(raw.type);
            if (chunks > 0)
                add(index, {data.part(at), size, raw.count, chunks, chunk, 0, false, raw.type == String ? bytes : 0});
            // the last chunk may have been written in part: what there is of it, channel by channel
            if (rest < data.size() && size > 0)
                add(index,
                    {data.part(rest), size, std::min(raw.count, (data.size() - rest) / size), 1, 0, 0, false, 0});
            at += bytes;
            rest = std::min<std::uint64_t>(data.size(), rest + bytes);
        }
    }

    void placeInterleaved(const std::vector<std::size_t>& active, ByteView data) {
        std::uint64_t row = 0;
        for (const std::size_t index : active) row += sizeOf(raw_[index].type);
        if (row == 0) return;
        file_.isIncomplete = file_.isIncomplete || data.size() % row != 0;
        std::uint64_t at = 0;
        for (const std::size_t index : active) {
            if (raw_[index].type == String) return;  // texts cannot be interleaved
            add(index, {data.part(at), static_cast<std::size_t>(row), data.size() / row, 1, 0, 0, false, 0});
            at += sizeOf(raw_[index].type);
        }
    }

    /// Rows of each buffer one behind the other, the buffers one behind the other, chunk by chunk.
    void placeDaqMx(const std::vector<std::size_t>& active, ByteView data) {
        const RawIndex& first = raw_[active.front()];
        std::uint64_t row = 0;
        for (const std::uint32_t width : first.widths) row += width;
        if (row == 0 || first.count == 0 || row > data.size() / first.count) {
            file_.isIncomplete = true;
            return;
        }
        const std::uint64_t chunk = row * first.count;
        const std::uint64_t chunks = data.size() / chunk;
        file_.isIncomplete = file_.isIncomplete || data.size() % chunk != 0;
        for (const std::size_t index : active) {
            const RawIndex& raw = raw_[index];
            if (raw.buffer >= first.widths.size() || sizeOf(raw.type) == 0 ||
                raw.offset + sizeOf(raw.type) > first.widths[raw.buffer]) {
                file_.objects[index].isSkipped = true;
                continue;
            }
            std::uint64_t at = raw.offset;
            for (std::uint32_t i = 0; i < raw.buffer; ++i) at += first.widths[i] * first.count;
            if (chunks > 0)
                add(index, {data.part(at), first.widths[raw.buffer], first.count, chunks, chunk, 0, false, 0});
        }
    }

    ByteView bytes_;
    bool isBigEndian_{};
    File file_;
    std::map<std::string, std::size_t> indexOf_;
    std::vector<RawIndex> raw_;      // by object
    std::vector<std::size_t> list_;  // the objects of the segment at hand
    std::set<std::size_t> listed_;   // the same
};

}  // namespace

std::size_t sizeOf(std::uint32_t type) {
    switch (type) {
        case Int8:
        case Uint8:
        case Boolean:
            return 1;
        case Int16:
        case Uint16:
            return 2;
        case Int32:
        case Uint32:
        case Float32:
        case Float32WithUnit:
            return 4;
        case Int64:
        case Uint64:
        case Float64:
        case Float64WithUnit:
            return 8;
        case Timestamp:
            return 16;
        default:
            return 0;
    }
}

TimePoint timePointAt(ByteView bytes, std::uint64_t offset, bool isBigEndian) {
    if (isBigEndian) return {bytes.big<std::int64_t>(offset), bytes.big<std::uint64_t>(offset + 8)};
    return {bytes.little<std::int64_t>(offset + 8), bytes.little<std::uint64_t>(offset)};
}

std::string isoText(const TimePoint& time) {
    constexpr std::int64_t epoch = 2082844800;  // from 1904 to 1970
    constexpr std::int64_t furthest = std::int64_t{1} << 38;
    if (time.seconds > furthest || time.seconds < -furthest) return {};
    // rounded to milliseconds
    const auto thousandths =
        static_cast<std::int64_t>(static_cast<double>(time.fraction) / 18446744073709551616.0 * 1000 + 0.5);
    const std::int64_t all = (time.seconds - epoch) * 1000 + thousandths;
    const auto day = std::chrono::floor<std::chrono::days>(
        std::chrono::sys_time<std::chrono::milliseconds>(std::chrono::milliseconds(all)));
    const std::chrono::year_month_day date(day);
    const std::int64_t ofDay = all - std::chrono::milliseconds(day.time_since_epoch()).count();
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", static_cast<int>(date.year()),
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), ofDay / 3600000,
                       ofDay / 60000 % 60, ofDay / 1000 % 60, ofDay % 1000);
}

std::uint64_t Object::values() const {
    std::uint64_t all = 0;
    for (const Piece& piece : pieces) all += piece.values();
    return all;
}

File readSegments(ByteView bytes) { return SegmentReader(bytes).read(); }

}  // namespace analogon::tdms
