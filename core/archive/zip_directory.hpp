#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/outcome.hpp"

/// A strict look at a zip file before anything of it is unpacked. Source: PKWARE APPNOTE 6.3, sections 4.3.7 (local
/// header), 4.3.12 (central directory) and 4.3.16 (its end).
namespace analogon {

struct ZipEntry {
    std::string name;  // relative, with / between its parts
    int method{};      // 0 stored, 8 deflated
    std::uint32_t crc{};
    std::uint64_t packedSize{}, size{};  // [byte]
    std::uint64_t offset{};              // of the local header
};

/// The entries in the order of the file, directories left out. Faults: no zip file, cut off, data before the archive,
/// entries that overlap, encrypted, compressed by another method; names that are absolute, lead out of the archive,
/// hold a NUL or a backslash, are overlong, stand twice, or differ between the two places where a zip file holds them.
/// Names with invisible characters (direction marks, controls) are a warning.
Outcome<std::vector<ZipEntry>> readZipDirectory(const std::filesystem::path& file);

}  // namespace analogon
