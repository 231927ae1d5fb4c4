#include "core/measure/mdf/record_walk.hpp"

namespace analogon::mdf {

namespace {

/// So many bytes of records at a time: several channels are taken from them while they are in the cache.
constexpr std::size_t blockBytes = 1 << 16;

std::uint64_t unsignedOf(ByteView bytes, unsigned count, bool isBigEndian) {
    std::uint64_t value = 0;
    for (unsigned i = 0; i < count; ++i) value = (value << 8) | bytes.data()[isBigEndian ? i : count - 1 - i];
    return value;
}

WalkResult walkSorted(const DataStream& stream, std::size_t stride, std::uint64_t limit, const RunSink& sink,
                      const Progress& progress) {
    WalkResult result;
    ByteFeed feed(stream);
    const std::uint64_t together = std::max<std::uint64_t>(1, blockBytes / stride);
    while (result.records < limit) {
        const ByteFeed::Run run = feed.takeRun(stride, std::min(together, limit - result.records));
        if (run.count == 0) break;
        if (progress.stopRequested()) {
            result.wasStopped = true;
            break;
        }
        sink({run.first, stride, static_cast<std::size_t>(run.count), result.records});
        result.records += run.count;
        if (!run.first) result.lost += run.count;
    }
    return result;
}

/// One record after the other of mixed ones: `sink(id, bytes)` until it says false.
template <class Sink>
bool eachRecord(const DataGroup& data, Sink sink) {
    ByteFeed feed(data.records);
    while (true) {
        const ByteFeed::Run head = feed.takeRun(data.idBytes, 1);
        if (head.count == 0) return true;
        if (!head.first) return false;  // without this id nobody knows where the next record begins
        const std::uint64_t id = unsignedOf(ByteView(head.first, data.idBytes), data.idBytes, data.isBigEndian);
        const auto known = data.bytesOfId.find(id);
        const bool isVariable = data.isVariable.contains(id);
        if (known == data.bytesOfId.end() && !isVariable) return false;
        std::uint64_t bytes = isVariable ? 4 : known->second;
        if (isVariable) {
            const ByteFeed::Run length = feed.takeRun(4, 1);
            if (length.count == 0) return true;
            if (!length.first) return false;
            bytes = unsignedOf(ByteView(length.first, 4), 4, data.isBigEndian);
        }
        ByteFeed::Run record{nullptr, 1};
        static constexpr std::uint8_t nothing{};
        if (bytes > 0)
            record = feed.takeRun(static_cast<std::size_t>(bytes), 1);
        else
            record.first = &nothing;
        if (record.count == 0) return true;
        if (!sink(id, record.first, static_cast<std::size_t>(bytes))) return true;
        if (data.hasIdBehind && feed.takeRun(data.idBytes, 1).count == 0) return true;
    }
}

}  // namespace

WalkResult walkRecords(const DataGroup& data, const RecordGroup& group, std::uint64_t limit, const RunSink& sink,
                       const Progress& progress) {
    const auto stride = static_cast<std::size_t>(data.hasInvalidationApart ? group.dataBytes : group.bytes());
    if (data.idBytes == 0 && stride > 0) return walkSorted(data.records, stride, limit, sink, progress);
    WalkResult result;
    if (data.idBytes == 0) {  // every channel is virtual
        static constexpr std::uint8_t nothing{};
        sink({&nothing, 0, static_cast<std::size_t>(limit), 0});
        result.records = limit;
        return result;
    }
    if (limit == 0) return result;
    const bool isWhole = eachRecord(data, [&](std::uint64_t id, const std::uint8_t* record, std::size_t) {
        if (id != group.id) return true;
        sink({record, stride, 1, result.records});
        ++result.records;
        if (!record) ++result.lost;
        result.wasStopped = result.records % 4096 == 0 && progress.stopRequested();
        return result.records < limit && !result.wasStopped;
    });
    result.metUnknownId = !isWhole;
    return result;
}

WalkResult walkVariable(const DataGroup& data, std::uint64_t id, const BytesSink& sink) {
    WalkResult result;
    if (data.idBytes == 0) return result;
    result.metUnknownId = !eachRecord(data, [&](std::uint64_t met, const std::uint8_t* record, std::size_t bytes) {
        if (met != id) return true;
        ++result.records;
        if (record)
            sink(ByteView(record, bytes));
        else
            ++result.lost;
        return record != nullptr;
    });
    return result;
}

std::map<std::uint64_t, std::uint64_t> countRecords(const DataGroup& data) {
    std::map<std::uint64_t, std::uint64_t> counts;
    if (data.idBytes > 0)
        eachRecord(data, [&](std::uint64_t id, const std::uint8_t*, std::size_t) {
            ++counts[id];
            return true;
        });
    return counts;
}

}  // namespace analogon::mdf
