#include "core/measure/mdf/mdf_samples.hpp"

#include "core/measure/mdf/record_walk.hpp"

namespace analogon::mdf {

namespace {

/// Records without bytes cost nothing in the file, so that any number may be told; a longer one is damage.
constexpr std::uint64_t mostWithoutBytes = std::uint64_t{1} << 26;

void settleSorted(const DataGroup& data, RecordGroup& group, const std::string& label, MeasurementFile& recording,
                  bool isUnfinished) {
    const std::uint64_t stride = data.hasInvalidationApart ? group.dataBytes : group.bytes();
    if (stride == 0) {
        if (group.samples <= mostWithoutBytes) return;
        recording.notes.push_back(phrase("group \"{}\": {} samples without data cannot be", label, group.samples));
        group.samples = 0;
        return;
    }
    const std::uint64_t there = data.records.size() / stride;
    const std::uint64_t rest = data.records.size() % stride;
    if (isUnfinished) {
        if (rest > 0)
            recording.notes.push_back(phrase(
                "group \"{}\": the last record is incomplete ({} of {} bytes) and left out", label, rest, stride));
        group.samples = there;
    } else if (group.samples > there) {
        recording.notes.push_back(
            phrase("group \"{}\": {} of {} samples are there, the file is shorter than it says (a broken copy?)", label,
                   there, group.samples));
        group.samples = there;
    } else if (group.samples < there) {
        recording.notes.push_back(
            phrase("group \"{}\": data of {} samples are there, {} are told and read", label, there, group.samples));
    }
}

/// The bytes that all records of a data group take, by what the file says.
std::uint64_t toldBytes(const StoredFile& file, std::size_t index) {
    const DataGroup& data = file.dataGroups[index];
    std::uint64_t bytes = 0;
    for (const RecordGroup& group : file.recordGroups) {
        if (group.dataGroup != index) continue;
        const std::uint64_t each = data.bytesOfId.contains(group.id) ? data.bytesOfId.at(group.id) : 0;
        const std::uint64_t whole = each + data.idBytes * (data.hasIdBehind ? 2u : 1u);
        if (whole == 0 || group.samples > data.records.size() / whole) return UINT64_MAX;
        bytes += group.samples * whole;
    }
    return bytes;
}

}  // namespace

void settleSamples(StoredFile& file, MeasurementFile& recording, bool isUnfinished) {
    for (std::size_t i = 0; i < file.dataGroups.size(); ++i) {
        const DataGroup& data = file.dataGroups[i];
        // with records of variable length the sum is not known without looking at each
        const bool mustCount =
            data.idBytes > 0 && (isUnfinished || !data.isVariable.empty() || toldBytes(file, i) != data.records.size());
        const std::map<std::uint64_t, std::uint64_t> counts =
            mustCount ? countRecords(data) : std::map<std::uint64_t, std::uint64_t>{};
        for (std::size_t g = 0; g < file.recordGroups.size(); ++g) {
            RecordGroup& group = file.recordGroups[g];
            if (group.dataGroup != i) continue;
            const std::string label = groupLabel(recording.groups[g], g);
            if (data.idBytes == 0) {
                settleSorted(data, group, label, recording, isUnfinished);
            } else if (mustCount) {
                const auto met = counts.find(group.id);
                const std::uint64_t there = met == counts.end() ? 0 : met->second;
                if (!isUnfinished && there != group.samples)
                    recording.notes.push_back(phrase("group \"{}\": {} samples are told, {} are there and read", label,
                                                     group.samples, there));
                group.samples = there;
            }
        }
    }
    for (std::size_t g = 0; g < recording.groups.size(); ++g) {
        recording.groups[g].samples = file.recordGroups[g].samples;
        for (std::size_t c = 0; c < recording.groups[g].channels.size(); ++c)
            recording.groups[g].channels[c].samples = file.recordGroups[file.channels[g][c].records].samples;
    }
}

}  // namespace analogon::mdf
