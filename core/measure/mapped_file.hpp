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
    /// through more of a file than is kept of it: each `letGoBytes`.
    void letGo() const;
    static constexpr std::size_t letGoBytes = std::size_t{8} << 20;

private:
    explicit MappedFile(ByteView bytes) : bytes_(bytes) {}
    ByteView bytes_;
};

}  // namespace analogon
