#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/base/file_handle.hpp"
#include "core/base/outcome.hpp"

namespace analogon {

constexpr std::uint64_t largestRead = 8ull << 30;  // [byte]

/// The bytes of a file. A directory, a pipe, a socket or a device is refused at once: reading one may never end.
Outcome<std::string> readRegularFile(const std::filesystem::path& file, std::uint64_t largest = largestRead);

/// A file that is open to be read, and how long it was then.
struct OpenFile {
    FileHandle handle;
    std::uint64_t size{};
};
/// Refuses what readRegularFile refuses.
Outcome<OpenFile> openRegularFile(const std::filesystem::path& file);

/// Whether a path leads to a file that can be read to its end, for readers that open it themselves.
Outcome<Done> checkRegularFile(const std::filesystem::path& file);

}  // namespace analogon
