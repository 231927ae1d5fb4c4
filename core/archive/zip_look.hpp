#pragma once

#include <QFile>
#include <filesystem>
#include <string>

/// Looks at a zip file that is not taken in: what it says of itself.
namespace analogon {

/// Opened by its bytes: a name that is no UTF-8 is no QString.
bool openForReading(QFile& file, const std::filesystem::path& path);

/// The comment of a zip file; empty: it has none, or this is no sound zip file.
std::string zipComment(const std::filesystem::path& file);

/// The first bytes of an entry; empty: there is no such entry, or this is no sound zip file.
std::string beginningOfEntry(const std::filesystem::path& file, const std::string& entry, std::size_t bytes);

}  // namespace analogon
