#pragma once

#include <filesystem>
#include <memory>

#include "core/base/owned_directory.hpp"

namespace analogon {

/// A directory of its own below the system's place for temporary files; removed with the object. What a process that
/// was killed has left behind is removed by the next one.
class TemporaryDirectory {
public:
    static Outcome<std::shared_ptr<const TemporaryDirectory>> make();
    TemporaryDirectory(const TemporaryDirectory&) = delete;
    TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// What it lies below: the system's place for temporary files.
    std::filesystem::path place() const { return around_.path().parent_path(); }

private:
    TemporaryDirectory(OwnedDirectory around, std::filesystem::path path)
        : around_(std::move(around)), path_(std::move(path)) {}

    OwnedDirectory around_;  // holds the marker, so that `path` holds nothing but what is put there
    std::filesystem::path path_;
};

}  // namespace analogon
