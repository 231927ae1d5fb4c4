#pragma once

#include <filesystem>
#include <memory>

#include "core/base/outcome.hpp"
#include "core/measure/byte_view.hpp"

namespace analogon {

/// A file as memory that is read only and found page by page when it is looked at.
class MappedFile {
public:
    static Outcome<std::shared_ptr<const MappedFile>> open(const std::filesystem::path& file);
    ~MappedFile();
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;

    ByteView bytes() const { return bytes_; }
    /// The memory of what was looked at is given back; whatever is looked at again is found again. For whoever goes
    /// through more of a file than is kept of it (WayThrough).
    void letGo() const;

private:
    explicit MappedFile(ByteView bytes) : bytes_(bytes) {}
    ByteView bytes_;
};

/// One who goes through a file: what was looked at is let go of now and then, and at the end.
class WayThrough {
public:
    explicit WayThrough(const MappedFile& file) : file_(file) {}
    ~WayThrough() { file_.letGo(); }
    WayThrough(const WayThrough&) = delete;
    WayThrough& operator=(const WayThrough&) = delete;

    /// So many bytes were looked at.
    void pass(std::size_t bytes) {
        if ((seen_ += bytes) < most) return;
        file_.letGo();
        seen_ = 0;
    }

private:
    static constexpr std::size_t most = std::size_t{8} << 20;
    const MappedFile& file_;
    std::size_t seen_{};
};

}  // namespace analogon
