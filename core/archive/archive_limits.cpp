#include "core/archive/archive_limits.hpp"

#include <algorithm>

#include "core/base/visible.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;

bool isText(const std::string& name) { return name == "study.json" || name.ends_with(".mo"); }

bool expandsTooFar(std::uint64_t size, std::uint64_t packed, const ArchiveLimits& limits) {
    return size > limits.freeBytes && size / limits.expansion > packed;
}

std::uint64_t times(std::uint64_t size, std::uint64_t packed) { return size / std::max<std::uint64_t>(1, packed); }

}  // namespace

Outcome<Done> checkLimits(const fs::path& archive, const std::vector<ZipEntry>& entries, const ArchiveLimits& limits) {
    const auto fault = [&](const Text& message) {
        return fileError(message, archive.string(), 0, 0,
                         phrase("Do not trust this file, or unpack it with another tool and open its directory."));
    };
    if (entries.size() > limits.entries)
        return fault(phrase("the archive holds {} files, more than {}", entries.size(), limits.entries));
    std::uint64_t size = 0, packed = 0;
    for (const ZipEntry& e : entries) {
        const std::uint64_t most = isText(e.name) ? limits.textBytes : limits.entryBytes;
        if (e.size > most)
            return fault(phrase("the entry \"{}\" unpacks to {} MB, more than {} MB", visibleName(e.name), e.size >> 20,
                                most >> 20));
        if (expandsTooFar(e.size, e.packedSize, limits))
            return fault(phrase("the entry \"{}\" unpacks to {} times its size, more than {}", visibleName(e.name),
                                times(e.size, e.packedSize), limits.expansion));
        size += e.size;
        packed += e.packedSize;
    }
    if (size > limits.studyBytes)
        return fault(phrase("the archive unpacks to {} MB, more than {} MB", size >> 20, limits.studyBytes >> 20));
    if (expandsTooFar(size, packed, limits))
        return fault(
            phrase("the archive unpacks to {} times its size, more than {}", times(size, packed), limits.expansion));
    return Done{};
}

}  // namespace analogon
