#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/archive/zip_directory.hpp"

/// What an archive may hold. A small file can say that it unpacks to anything, so this is asked of the list of its
/// entries before the first is unpacked; while they are, none gives more than the list says.
namespace analogon {

struct ArchiveLimits {
    std::size_t entries{20'000};
    std::uint64_t entryBytes{2ull << 30};  // of one entry, unpacked
    std::uint64_t textBytes{64ull << 20};  // of study.json and of each model
    std::uint64_t studyBytes{4ull << 30};  // of all of them
    /// How many times its size an archive may unpack to. A recording of nothing but zeros reaches 1000; what has
    /// digits that change stays below 50.
    std::uint64_t expansion{250};
    std::uint64_t freeBytes{32ull << 20};  // may be reached by any expansion
};

/// The first limit that is passed.
Outcome<Done> checkLimits(const std::filesystem::path& archive, const std::vector<ZipEntry>& entries,
                          const ArchiveLimits& limits = {});

}  // namespace analogon
