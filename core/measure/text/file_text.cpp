#include "core/measure/text/file_text.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/base/file_fault.hpp"
#include "core/base/regular_file.hpp"

namespace analogon {

namespace {

constexpr std::size_t partBytes = std::size_t{1} << 18;

}  // namespace

Outcome<std::unique_ptr<FileText>> FileText::open(const std::filesystem::path& file, const std::string& encoding) {
    Outcome<OpenFile> opened = openRegularFile(file);
    if (!opened) return opened.diagnostics();
    std::unique_ptr<FileText> text(new FileText(std::move(opened->handle), file));
    text->end_ = opened->size;
    if (text->findExtent(encoding) && text->reserve()) return text;
    return *text->fault_;
}

FileText::~FileText() {
    if (memory_) munmap(memory_, capacity_);
}

bool FileText::fail(Text what) {
    fault_ = fileError(std::move(what), file_.string());
    return false;
}

std::size_t FileText::readInto(char* to, std::uint64_t begin, std::size_t count) {
    std::size_t done = 0;
    while (done < count) {
        const ssize_t more = pread(handle_.number(), to + done, count - done, static_cast<off_t>(begin + done));
        if (more < 0 && errno == EINTR) continue;
        if (more < 0) fail(phrase("the file cannot be read"));
        if (more <= 0) break;
        done += static_cast<std::size_t>(more);
    }
    return done;
}

bool FileText::readPart(std::uint64_t begin, std::size_t count, std::string& bytes) {
    bytes.resize(count);
    bytes.resize(readInto(bytes.data(), begin, count));
    return !fault_;
}

/// Where the text begins and ends in the file, how it is written, and how long it is as UTF-8.
bool FileText::findExtent(const std::string& encoding) {
    if (!readPart(0, 4096, part_)) return false;
    encoding_ = encoding.empty() ? encodingOf(part_) : encodingNamed(encoding).value_or(Encoding::AsIs);
    if (encoding_ == Encoding::Found) encoding_ = encodingOf(part_);
    begin_ = next_ = markLength(part_, encoding_);
    const bool isWide = unitBytes(encoding_) > 1;
    for (std::uint64_t end = end_; !isWide && end > begin_;) {  // of a file that was larger than what was written
        const std::uint64_t from = std::max(begin_, end > partBytes ? end - partBytes : 0);
        if (!readPart(from, static_cast<std::size_t>(end - from), part_)) return false;
        const std::size_t last = part_.find_last_not_of('\0');
        end_ = last == std::string::npos ? from : from + last + 1;
        if (last != std::string::npos) break;
        end = from;
    }
    size_ = static_cast<std::size_t>(end_ - begin_);
    if (encoding_ == Encoding::AsIs) return true;
    std::size_t length = 0;
    size_ = 0;
    for (std::uint64_t at = begin_; at < end_;) {
        if (!readPart(at, static_cast<std::size_t>(std::min<std::uint64_t>(partBytes, end_ - at)), part_)) return false;
        const std::string_view whole = wholeLetters(part_);
        if (whole.empty()) break;
        const std::string decoded = decodeText(whole, encoding_);
        if (const std::size_t last = decoded.find_last_not_of('\0'); last != std::string::npos)
            size_ = length + last + 1;
        length += decoded.size();
        at += whole.size();
    }
    return true;
}

bool FileText::reserve() {
    capacity_ = std::max<std::size_t>(size_, 1);
    void* const memory =
        mmap(nullptr, capacity_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory == MAP_FAILED) return fail(phrase("the file cannot be read"));
    memory_ = static_cast<char*>(memory);
    return true;
}

/// Without the front of a letter whose end is in the next part.
std::string_view FileText::wholeLetters(std::string_view bytes) const {
    const std::size_t unit = unitBytes(encoding_);
    bytes = bytes.substr(0, bytes.size() / unit * unit);
    if (unit != 2 || bytes.size() < 4) return bytes;
    const auto high =
        static_cast<unsigned char>(bytes[bytes.size() - (encoding_ == Encoding::Utf16LittleEndian ? 1 : 2)]);
    const bool isHalf = high >= 0xD8 && high < 0xDC;
    return isHalf ? bytes.substr(0, bytes.size() - 2) : bytes;
}

void FileText::loadMore() {
    const auto most = static_cast<std::size_t>(std::min<std::uint64_t>(partBytes, end_ - next_));
    std::size_t read = 0;
    if (encoding_ == Encoding::AsIs) {
        read = readInto(memory_ + loaded_, next_, most);
        next_ += read;
        loaded_ += read;
    } else {
        readPart(next_, most, part_);
        read = part_.size();
        const std::string_view whole = wholeLetters(part_);
        next_ += whole.size();
        const std::string decoded = decodeText(whole, encoding_).substr(0, size_ - loaded_);
        std::memcpy(memory_ + loaded_, decoded.data(), decoded.size());
        loaded_ = whole.empty() ? size_ : loaded_ + decoded.size();
    }
    if (!fault_ && read < most) fail(phrase("the file became shorter while it was read"));
    if (fault_ || next_ >= end_) loaded_ = size_;
    const std::size_t before = shown_;
    shown_ = loaded_;
    if (!change_) return;
    if (loaded_ < size_) {  // whole lines
        const auto* const feed = static_cast<const char*>(memrchr(memory_ + before, '\n', loaded_ - before));
        shown_ = feed ? static_cast<std::size_t>(feed - memory_) + 1 : before;
    }
    if (shown_ > before) change_(memory_ + before, memory_ + shown_);
}

void FileText::letGo(const char* begin, const char* end) {
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    const auto from = (static_cast<std::size_t>(begin - memory_) + page - 1) / page * page,
               to = static_cast<std::size_t>(end - memory_) / page * page;
    if (to > from) madvise(memory_ + from, to - from, MADV_DONTNEED);
}

void FileText::changeLines(std::function<void(char* begin, char* end)> change) {
    change_ = std::move(change);
    if (loaded_ < size_) {
        const auto* const feed = static_cast<const char*>(memrchr(memory_, '\n', loaded_));
        shown_ = feed ? static_cast<std::size_t>(feed - memory_) + 1 : 0;
    }
    if (shown_ > 0) change_(memory_, memory_ + shown_);
}

}  // namespace analogon
