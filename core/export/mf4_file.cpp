#include "core/export/mf4_file.hpp"

#include <QString>
#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>

#include "core/base/file_fault.hpp"

namespace analogon {

namespace {

static_assert(std::endian::native == std::endian::little, "a file of MDF 4 is little-endian");

/// The fields of a block, one after the other.
class Fields {
public:
    template <class T>
    Fields& put(T value) {
        char raw[sizeof(T)];
        std::memcpy(raw, &value, sizeof(T));
        bytes_.append(raw, sizeof(T));
        return *this;
    }
    Fields& zeros(std::size_t count) {
        bytes_.append(count, '\0');
        return *this;
    }
    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

std::string escaped(const std::string& text) { return QString::fromStdString(text).toHtmlEscaped().toStdString(); }

/// A block is written behind all those that it links to, so that their addresses are known; the links of the header are
/// filled in at the end.
class Mf4Writer {
public:
    Mf4Writer(std::ostream& out, const Progress& progress) : out_(out), progress_(progress) {}

    bool write(const std::vector<Mf4Group>& groups, const std::string& comment) {
        put(mf4Begin() + std::string(4, '\0') + Fields().put(std::uint16_t{410}).zeros(34).bytes());
        header({0, 0, 0, 0, 0, 0});
        std::uint64_t next = 0;
        for (std::size_t g = groups.size(); g-- > 0;) {
            if (progress_.stopRequested()) return false;
            next = dataGroup(groups[g], next);
        }
        const std::uint64_t words = markup("HDcomment", comment), history = historyOf(comment);
        out_.seekp(headerAt);
        at_ = headerAt;
        header({next, history, 0, 0, 0, words});
        return true;
    }

private:
    static constexpr std::uint64_t headerAt = 64;

    void put(const std::string& bytes) {
        out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        at_ += bytes.size();
    }

    std::uint64_t begin(const char* id, const std::vector<std::uint64_t>& links, std::uint64_t dataBytes) {
        put(std::string((8 - at_ % 8) % 8, '\0'));
        const std::uint64_t address = at_;
        Fields head;
        put(std::string("##") + id);
        head.zeros(4).put(std::uint64_t{24 + 8 * links.size() + dataBytes}).put(std::uint64_t{links.size()});
        for (const std::uint64_t link : links) head.put(link);
        put(head.bytes());
        return address;
    }

    std::uint64_t block(const char* id, const std::vector<std::uint64_t>& links, const std::string& data) {
        const std::uint64_t address = begin(id, links, data.size());
        put(data);
        return address;
    }

    void header(const std::vector<std::uint64_t>& links) { block("HD", links, Fields().zeros(32).bytes()); }

    /// 0: there is nothing to say.
    std::uint64_t text(const std::string& words) {
        return words.empty() ? 0 : block("TX", {}, words + std::string(8 - words.size() % 8, '\0'));
    }

    std::uint64_t markup(const std::string& element, const std::string& words, const std::string& more = {}) {
        if (words.empty() && more.empty()) return 0;
        const std::string xml = "<" + element + " xmlns=\"http://www.asam.net/mdf/v4\"><TX>" + escaped(words) +
                                "</TX>" + more + "</" + element + ">";
        return block("MD", {}, xml + std::string(8 - xml.size() % 8, '\0'));
    }

    std::uint64_t historyOf(const std::string& comment) {
        const std::uint64_t words = markup("FHcomment", comment,
                                           "<tool_id>Analogon</tool_id><tool_vendor>Analogon</tool_vendor>"
                                           "<tool_version>1</tool_version>");
        return block("FH", {0, words}, Fields().zeros(16).bytes());
    }

    /// The records of all channels, one after the other.
    std::uint64_t records(const Mf4Group& group) {
        const std::size_t rows = group.channels.front().values.size(), width = group.channels.size();
        constexpr std::size_t together = 8192;  // rows
        const std::uint64_t address = begin("DT", {}, 8 * rows * width);
        std::string part;
        for (std::size_t row = 0; row < rows; ++row) {
            Fields record;
            for (const Mf4Channel& channel : group.channels) record.put(channel.values[row]);
            part += record.bytes();
            if (row % together != together - 1) continue;
            put(part);
            part.clear();
        }
        put(part);
        return address;
    }

    std::uint64_t channel(const Mf4Channel& channel, std::size_t index, std::uint64_t next) {
        constexpr std::uint8_t fixedLength = 0, master = 2, none = 0, time = 1, littleFloat = 4;
        const std::uint64_t name = text(channel.name), unit = text(channel.unit), comment = text(channel.comment);
        Fields data;
        data.put(index == 0 ? master : fixedLength).put(index == 0 ? time : none).put(littleFloat);
        data.put(std::uint8_t{0}).put(static_cast<std::uint32_t>(8 * index)).put(std::uint32_t{64}).zeros(60);
        return block("CN", {next, 0, name, 0, 0, 0, unit, comment}, data.bytes());
    }

    std::uint64_t dataGroup(const Mf4Group& group, std::uint64_t next) {
        const std::uint64_t data = records(group);
        std::uint64_t first = 0;
        for (std::size_t c = group.channels.size(); c-- > 0;) first = channel(group.channels[c], c, first);
        const std::uint64_t name = text(group.name), comment = text(group.comment);
        Fields counts;
        counts.put(std::uint64_t{0}).put(static_cast<std::uint64_t>(group.channels.front().values.size())).zeros(8);
        counts.put(static_cast<std::uint32_t>(8 * group.channels.size())).put(std::uint32_t{0});
        const std::uint64_t channels = block("CG", {0, first, name, 0, 0, comment}, counts.bytes());
        return block("DG", {next, channels, data, 0}, Fields().zeros(8).bytes());
    }

    std::ostream& out_;
    const Progress& progress_;
    std::uint64_t at_{};
};

}  // namespace

std::string mf4Begin() { return "MDF     4.10    Analogon"; }

Outcome<Done> writeMf4(const std::vector<Mf4Group>& groups, const std::string& comment,
                       const std::filesystem::path& file, const Progress& progress) {
    std::ofstream out(file, std::ios::binary);
    if (!Mf4Writer(out, progress).write(groups, comment)) return fileError(phrase("interrupted"), file.string());
    out.close();
    if (!out) return cannotWrite(file, phrase("the disk may be full"));
    return Done{};
}

}  // namespace analogon
