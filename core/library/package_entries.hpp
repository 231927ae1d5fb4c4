#pragma once

#include <string>
#include <vector>

namespace analogon {

class Library;
struct LibraryClass;

/// A class of a package, which need not have been read.
struct PackageEntry {
    std::string name;            // "Inertia"
    const LibraryClass* read{};  // null: not yet
};

/// The public classes directly in a package, of empty text the outermost ones with the packages of searched directories
/// (packageDirectories). What lies in the directory of such a package is named after its file and not read for it.
std::vector<PackageEntry> packageEntries(const Library& library, const std::string& package);

}  // namespace analogon
