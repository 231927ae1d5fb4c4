#pragma once

#include <filesystem>
#include <optional>

#include "core/base/file_handle.hpp"
#include "core/base/outcome.hpp"
#include "core/measure/encoding.hpp"
#include "core/measure/text/text_view.hpp"

namespace analogon {

/// A text file as UTF-8, or as it is: in memory it takes as much as is looked at, not as much as the file is long.
class FileText final : public TextSupply {
public:
    /// `encoding`: as it was told; empty: it is found out. Its mark, and zeros at the end of the file, are left out.
    static Outcome<std::unique_ptr<FileText>> open(const std::filesystem::path& file, const std::string& encoding);
    ~FileText() override;
    FileText(const FileText&) = delete;
    FileText& operator=(const FileText&) = delete;

    TextView view() { return {std::string_view(memory_, size_), this}; }
    /// What went wrong while it was read: the text seems to end there. None: nothing.
    const std::optional<Diagnostic>& fault() const { return fault_; }

    const char* loaded() const override { return memory_ + shown_; }
    void loadMore() override;
    void letGo(const char* begin, const char* end) override;
    void changeLines(std::function<void(char* begin, char* end)> change) override;

private:
    FileText(FileHandle handle, const std::filesystem::path& file) : handle_(std::move(handle)), file_(file) {}
    bool findExtent(const std::string& encoding);
    bool reserve();
    /// How many bytes there were: fewer than asked for only where the file ends, or cannot be read.
    std::size_t readInto(char* to, std::uint64_t begin, std::size_t count);
    bool readPart(std::uint64_t begin, std::size_t count, std::string& bytes);
    std::string_view wholeLetters(std::string_view bytes) const;
    bool fail(Text what);

    FileHandle handle_;
    std::filesystem::path file_;
    Encoding encoding_{Encoding::AsIs};
    std::uint64_t begin_{}, end_{}, next_{};      // in the file
    char* memory_{};                              // of the whole text; what is not loaded takes none
    std::size_t size_{}, capacity_{}, loaded_{};  // [byte]
    std::size_t shown_{};                         // of what is loaded, what was changed as it is to be
    std::function<void(char*, char*)> change_;
    std::optional<Diagnostic> fault_;
    std::string part_;
};

}  // namespace analogon
