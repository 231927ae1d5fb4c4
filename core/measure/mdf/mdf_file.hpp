#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/measure/mapped_file.hpp"
#include "core/measure/mdf/conversion.hpp"
#include "core/measure/mdf/data_stream.hpp"
#include "core/measure/mdf/value_layout.hpp"

/// How the values of a file lie in it, the same for format 3 and format 4: what the reader of values works with.
namespace analogon::mdf {

/// A channel in its record.
struct StoredChannel {
    enum class Storage {
        InRecord,
        Counted,   // virtual: the number of the record, from 0
        Elsewhere  // of variable length: the record has its offset in `elsewhere`, or in the records `elsewhereId`
    };
    Storage storage{Storage::InRecord};
    ValueLayout layout;
    ValueLayout::Type elsewhereType{ValueLayout::Type::Utf8};
    std::shared_ptr<const Conversion> conversion;
    std::optional<std::uint64_t> invalidationBit;  // counted from the end of the record's data
    bool isAllInvalid{};
    std::shared_ptr<const DataStream> elsewhere;
    std::optional<std::uint64_t> elsewhereId;
    std::size_t records{};  // index of the RecordGroup that has it
};

/// Records of one kind.
struct RecordGroup {
    std::uint64_t id{};
    std::uint64_t dataBytes{};
    std::uint64_t invalidationBytes{};
    std::uint64_t samples{};
    std::size_t dataGroup{};

    std::uint64_t bytes() const { return dataBytes + invalidationBytes; }
};

/// Records of one or several kinds, mixed, each led by its id.
struct DataGroup {
    DataStream records;
    DataStream invalidation;  // of a storage in which the bits lie apart
    bool hasInvalidationApart{};
    unsigned idBytes{};                                // 0: one kind alone, without ids
    bool hasIdBehind{};                                // format 3: once more behind the record
    bool isBigEndian{};                                // lengths and ids
    std::map<std::uint64_t, std::uint64_t> bytesOfId;  // record id: bytes of its records
    std::map<std::uint64_t, bool> isVariable;          // record id: its records are a length and so many bytes
};

struct StoredFile {
    std::shared_ptr<const MappedFile> memory;
    std::vector<DataGroup> dataGroups;
    std::vector<RecordGroup> recordGroups;
    std::vector<std::vector<StoredChannel>> channels;  // by group and channel of the recording
};

}  // namespace analogon::mdf
