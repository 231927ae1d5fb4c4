#pragma once

#include <functional>

#include "core/base/progress.hpp"
#include "core/measure/mdf/mdf_file.hpp"

namespace analogon::mdf {

/// Records one behind the other; first null: they are lost. `index` counts the records of the group.
struct RecordRun {
    const std::uint8_t* first{};
    std::size_t stride{};
    std::size_t count{};
    std::uint64_t index{};
};

/// What came to light on the way through the records.
struct WalkResult {
    std::uint64_t records{};  // that were met, lost ones with them
    std::uint64_t lost{};
    bool metUnknownId{};  // and ended there
    bool wasStopped{};
};

using RunSink = std::function<void(const RecordRun&)>;
using BytesSink = std::function<void(ByteView)>;

/// Every record of a group, at most `limit`.
WalkResult walkRecords(const DataGroup& data, const RecordGroup& group, std::uint64_t limit, const RunSink& sink,
                       const Progress& progress);

/// Every record of variable length with this id, without its length.
WalkResult walkVariable(const DataGroup& data, std::uint64_t id, const BytesSink& sink);

/// How many records of each id a data group has.
std::map<std::uint64_t, std::uint64_t> countRecords(const DataGroup& data);

}  // namespace analogon::mdf
