#pragma once

#include <filesystem>
#include <system_error>

/// Single steps of the file system: each happens whole or not at all, whenever the program is ended.
namespace analogon {

/// The fault of the last call of the system.
std::error_code lastFault();

/// What has come to the disk survives a loss of power, too. A new name is only safe once the directory that holds it
/// is on the disk as well.
void syncToDisk(const std::filesystem::path& path);

/// Two paths change places. errc::invalid_argument, errc::function_not_supported: the file system cannot.
std::error_code exchange(const std::filesystem::path& a, const std::filesystem::path& b);

/// A rename onto a path where nothing is; errc::file_exists: something is there.
std::error_code renameToNew(const std::filesystem::path& from, const std::filesystem::path& to);

/// The content and the rights of a file in one that does not exist yet; the fault is the one of the system, as "No
/// space left on device" (std::filesystem::copy_file calls that "Input/output error").
std::error_code copyToNew(const std::filesystem::path& from, const std::filesystem::path& to);

/// A regular file, and no link to one.
bool isPlainFile(const std::filesystem::path& path);
/// A directory, and no link to one.
bool isPlainDirectory(const std::filesystem::path& path);

}  // namespace analogon
