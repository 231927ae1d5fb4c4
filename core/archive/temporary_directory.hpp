#pragma once

#include <filesystem>
#include <memory>

#include "core/base/outcome.hpp"

namespace analogon {

/// A directory of its own below the system's place for temporary files; removed with the object. What a process that
/// was killed has left behind is removed by the next one.
class TemporaryDirectory {
public:
    static Outcome<std::shared_ptr<const TemporaryDirectory>> make();
    ~TemporaryDirectory();
    TemporaryDirectory(const TemporaryDirectory&) = delete;
    TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    explicit TemporaryDirectory(std::filesystem::path path) : path_(std::move(path)) {}

    std::filesystem::path path_;
};

}  // namespace analogon
