#include "core/archive/zip_directory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <string_view>

#include "core/base/file_fault.hpp"
#include "core/base/regular_file.hpp"
#include "core/base/visible.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t localSignature = 0x04034b50, centralSignature = 0x02014b50, endSignature = 0x06054b50;
constexpr std::size_t localSize = 30, centralSize = 46, endSize = 22, longestComment = 65535, longestName = 1024;

/// Little-endian numbers of a byte range; every read is checked by the caller through `has`.
class Bytes {
public:
    explicit Bytes(std::string_view bytes) : bytes_(bytes) {}
    bool has(std::size_t at, std::size_t count) const { return at <= bytes_.size() && count <= bytes_.size() - at; }
    std::uint32_t u16(std::size_t at) const { return byte(at) | byte(at + 1) << 8; }
    std::uint32_t u32(std::size_t at) const { return u16(at) | u16(at + 2) << 16; }
    std::string text(std::size_t at, std::size_t count) const { return std::string(bytes_.substr(at, count)); }
    std::size_t size() const { return bytes_.size(); }

private:
    std::uint32_t byte(std::size_t at) const { return static_cast<unsigned char>(bytes_[at]); }
    std::string_view bytes_;
};

/// What is wrong with a name; empty: nothing.
Text nameFault(const std::string& name) {
    if (name.empty()) return phrase("an entry has no name");
    if (name.size() > longestName) return phrase("a name has {} bytes, more than {}", name.size(), longestName);
    const std::string shown = visibleName(name);
    if (name.find('\0') != std::string::npos) return phrase("the entry \"{}\" holds a NUL in its name", shown);
    if (name.find('\\') != std::string::npos) return phrase("the entry \"{}\" holds a backslash in its name", shown);
    if (name.front() == '/' || (name.size() > 1 && name[1] == ':'))
        return phrase("the entry \"{}\" has an absolute path", shown);
    for (std::size_t at = 0; at <= name.size();) {
        const std::size_t end = std::min(name.find('/', at), name.size());
        const std::string part = name.substr(at, end - at);
        if (part == ".." || part == ".") return phrase("the entry \"{}\" leads out of the archive", shown);
        if (part.empty() && end != name.size()) return phrase("the entry \"{}\" has an empty part in its path", shown);
        at = end + 1;
    }
    return {};
}

class ZipReader {
public:
    explicit ZipReader(const fs::path& file) : file_(file), stream_(file, std::ios::binary) {}

    Outcome<std::vector<ZipEntry>> read() {
        if (!stream_)
            return fault(phrase("the file cannot be opened"), phrase("Check its name and its access rights."));
        stream_.seekg(0, std::ios::end);
        size_ = static_cast<std::uint64_t>(stream_.tellg());
        if (size_ == 0) return fault(phrase("the file is empty"));
        if (!findEnd())
            return fault(phrase("this is no zip archive, or it is cut off"),
                         phrase("Get the file again from where it came from."));
        if (const Text wrong = readCentral(); !wrong.empty()) return fault(wrong);
        if (const Text wrong = compareLocal(); !wrong.empty()) return fault(wrong);
        Diagnostics warnings;
        for (const ZipEntry& e : entries_)
            if (visibleName(e.name) != e.name) {
                warnings.push_back(asWarning(
                    fault(phrase("an entry has invisible characters in its name: \"{}\"", visibleName(e.name)), {})));
            }
        std::erase_if(entries_, [](const ZipEntry& e) { return e.name.ends_with('/'); });
        return {std::move(entries_), std::move(warnings)};
    }

private:
    Diagnostic fault(const Text& message,
                     const Text& hint = phrase("Do not trust this file: it was damaged or made by hand.")) const {
        return fileError(message, file_.string(), 0, 0, hint);
    }

    std::string bytesAt(std::uint64_t at, std::size_t count) {
        std::string bytes(count, '\0');
        stream_.clear();
        stream_.seekg(static_cast<std::streamoff>(at));
        stream_.read(bytes.data(), static_cast<std::streamsize>(count));
        bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, stream_.gcount())));
        return bytes;
    }

    /// The end record, whose comment must reach exactly to the end of the file.
    bool findEnd() {
        const std::size_t tail = static_cast<std::size_t>(std::min<std::uint64_t>(size_, endSize + longestComment));
        const std::string text = bytesAt(size_ - tail, tail);
        const Bytes bytes(text);
        if (text.size() < endSize) return false;
        for (std::size_t at = text.size() - endSize + 1; at-- > 0;) {
            if (bytes.u32(at) != endSignature || at + endSize + bytes.u16(at + 20) != text.size()) continue;
            endAt_ = size_ - tail + at;
            count_ = bytes.u16(at + 10);
            isOneDisk_ = bytes.u16(at + 4) == 0 && bytes.u16(at + 6) == 0 && bytes.u16(at + 8) == count_;
            centralBytes_ = bytes.u32(at + 12);
            centralAt_ = bytes.u32(at + 16);
            return true;
        }
        return false;
    }

    Text readCentral() {
        if (!isOneDisk_) return phrase("the archive is split over several files");
        if (count_ == 0xffff || centralAt_ == 0xffffffff)
            return phrase("the archive is in the format for more than 4 GB, which a study does not use");
        if (centralAt_ + centralBytes_ > endAt_) return phrase("the list of its entries lies outside the file");
        if (centralAt_ + centralBytes_ < endAt_)
            return phrase("there is data before or between the parts of the archive");
        const std::string text = bytesAt(centralAt_, centralBytes_);
        const Bytes bytes(text);
        std::set<std::string> seen;
        std::size_t at = 0;
        for (unsigned i = 0; i < count_; ++i) {
            if (!bytes.has(at, centralSize) || bytes.u32(at) != centralSignature)
                return phrase("the list of its entries is damaged");
            const std::size_t nameSize = bytes.u16(at + 28), extra = bytes.u16(at + 30), comment = bytes.u16(at + 32);
            if (!bytes.has(at, centralSize + nameSize + extra + comment))
                return phrase("the list of its entries is cut off");
            ZipEntry entry;
            entry.name = bytes.text(at + centralSize, nameSize);
            entry.method = static_cast<int>(bytes.u16(at + 10));
            entry.crc = bytes.u32(at + 16);
            entry.packedSize = bytes.u32(at + 20);
            entry.size = bytes.u32(at + 24);
            entry.offset = bytes.u32(at + 42);
            if (const Text wrong = nameFault(entry.name); !wrong.empty()) return wrong;
            const std::string shown = visibleName(entry.name);
            if (!seen.insert(entry.name).second) return phrase("the entry \"{}\" stands twice", shown);
            if (bytes.u16(at + 8) & 1) return phrase("the entry \"{}\" is encrypted", shown);
            if (entry.method != 0 && entry.method != 8)
                return phrase("the entry \"{}\" is compressed by method {}, which is not known", shown, entry.method);
            if (entry.method == 0 && entry.size != entry.packedSize)
                return phrase("the entry \"{}\" has two different sizes", shown);
            entries_.push_back(std::move(entry));
            at += centralSize + nameSize + extra + comment;
        }
        if (at != text.size()) return phrase("the list of its entries has data behind its end");
        return belowFiles(seen);
    }

    /// What a file lies below must be a directory.
    static Text belowFiles(const std::set<std::string>& names) {
        for (const std::string& name : names)
            for (std::size_t end = name.find('/'); end != std::string::npos; end = name.find('/', end + 1))
                if (const std::string around = name.substr(0, end); names.contains(around))
                    return phrase("the entry \"{}\" lies below the entry \"{}\", which is a file", visibleName(name),
                                  visibleName(around));
        return {};
    }

    /// Local headers must say the same, and no two entries may share bytes.
    Text compareLocal() {
        std::vector<std::pair<std::uint64_t, std::uint64_t>> ranges;
        for (const ZipEntry& entry : entries_) {
            const std::string shown = visibleName(entry.name);
            const std::string text = bytesAt(entry.offset, localSize + entry.name.size());
            const Bytes bytes(text);
            if (!bytes.has(0, localSize) || bytes.u32(0) != localSignature)
                return phrase("the entry \"{}\" is not where the list says", shown);
            const std::size_t nameSize = bytes.u16(26), extra = bytes.u16(28);
            if (nameSize != entry.name.size() || bytes.text(localSize, nameSize) != entry.name)
                return phrase("the entry \"{}\" has another name at its data", shown);
            if (static_cast<int>(bytes.u16(8)) != entry.method)
                return phrase("the entry \"{}\" has two different methods of compression", shown);
            const std::uint64_t end = entry.offset + localSize + nameSize + extra + entry.packedSize;
            if (end > centralAt_) return phrase("the data of \"{}\" is cut off", shown);
            ranges.emplace_back(entry.offset, end);
        }
        std::sort(ranges.begin(), ranges.end());
        for (std::size_t i = 1; i < ranges.size(); ++i)
            if (ranges[i].first < ranges[i - 1].second) return phrase("entries share their data");
        if (!ranges.empty() && ranges.front().first != 0) return phrase("there is data before the archive");
        return {};
    }

    fs::path file_;
    std::ifstream stream_;
    std::uint64_t size_{}, endAt_{}, centralAt_{}, centralBytes_{};
    unsigned count_{};
    bool isOneDisk_{};
    std::vector<ZipEntry> entries_;
};

}  // namespace

Outcome<std::vector<ZipEntry>> readZipDirectory(const std::filesystem::path& file) {
    if (const Outcome<Done> isFile = checkRegularFile(file); !isFile) return isFile.diagnostics();
    return ZipReader(file).read();
}

}  // namespace analogon
