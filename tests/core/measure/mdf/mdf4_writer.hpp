#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

/// Composes small files of format 4, block by block, for tests.
namespace analogon::test {

class Bytes {
public:
    template <class T>
    Bytes& put(T value) {
        const auto* raw = reinterpret_cast<const char*>(&value);
        text.append(raw, sizeof(T));
        return *this;
    }
    template <class T>
    Bytes& putBig(T value) {
        const auto* raw = reinterpret_cast<const char*>(&value);
        for (std::size_t i = sizeof(T); i-- > 0;) text.push_back(raw[i]);
        return *this;
    }
    Bytes& put(const std::string& more) {
        text += more;
        return *this;
    }
    std::string text;
};

class Mdf4Writer {
public:
    explicit Mdf4Writer(const std::string& version = "4.10", bool isUnfinished = false, std::uint16_t flags = 0) {
        Bytes head;
        head.put(std::string(isUnfinished ? "UnFinMF " : "MDF     "));
        std::string padded = version;
        padded.resize(8, ' ');
        head.put(padded).put(std::string("test    ")).put(std::uint32_t{0});
        head.put(static_cast<std::uint16_t>(410)).put(std::string(30, '\0')).put(flags).put(std::uint16_t{0});
        out_ = head.text;
        // the header block at 64, its links are filled in by finish()
        block("HD", std::vector<std::uint64_t>(6), std::string(31, '\0') + std::string(1, '\0'));
    }

    /// The address of the new block.
    std::uint64_t block(const std::string& id, const std::vector<std::uint64_t>& links, const std::string& data,
                        std::uint64_t toldLength = 0) {
        out_.resize((out_.size() + 7) / 8 * 8, '\0');
        const std::uint64_t address = out_.size();
        Bytes bytes;
        bytes.put("##" + id).put(std::uint32_t{0});
        bytes.put(toldLength ? toldLength : std::uint64_t{24 + 8 * links.size() + data.size()});
        bytes.put(static_cast<std::uint64_t>(links.size()));
        for (const std::uint64_t link : links) bytes.put(link);
        out_ += bytes.text + data;
        return address;
    }

    std::uint64_t text(const std::string& words) {
        return words.empty() ? 0 : block("TX", {}, words + std::string(1 + (7 - words.size() % 8), '\0'));
    }

    struct Channel {
        std::string name, unit;
        unsigned type{};  // 0 value, 1 variable length, 2 master, 3 virtual master, 6 virtual
        unsigned dataType{4};
        unsigned bits{64}, byteOffset{}, bitOffset{};
        std::uint64_t conversion{}, data{}, composition{};
        std::uint32_t flags{}, invalidationBit{};
    };

    std::uint64_t channel(const Channel& c, std::uint64_t next) {
        Bytes data;
        data.put(static_cast<std::uint8_t>(c.type)).put(static_cast<std::uint8_t>(c.type == 2 || c.type == 3 ? 1 : 0));
        data.put(static_cast<std::uint8_t>(c.dataType)).put(static_cast<std::uint8_t>(c.bitOffset));
        data.put(std::uint32_t{c.byteOffset}).put(std::uint32_t{c.bits}).put(c.flags).put(c.invalidationBit);
        data.put(std::string(52, '\0'));
        return block("CN", {next, c.composition, text(c.name), 0, c.conversion, c.data, text(c.unit), 0}, data.text);
    }

    std::uint64_t conversion(unsigned type, const std::vector<double>& values,
                             const std::vector<std::uint64_t>& references = {}) {
        Bytes data;
        data.put(static_cast<std::uint8_t>(type)).put(std::uint8_t{0}).put(std::uint16_t{0});
        data.put(static_cast<std::uint16_t>(references.size())).put(static_cast<std::uint16_t>(values.size()));
        data.put(0.0).put(0.0);
        for (const double value : values) data.put(value);
        std::vector<std::uint64_t> links{0, 0, 0, 0};
        links.insert(links.end(), references.begin(), references.end());
        return block("CC", links, data.text);
    }

    std::uint64_t channelGroup(const std::string& name, std::uint64_t firstChannel, std::uint64_t samples,
                               unsigned recordBytes, unsigned invalidationBytes = 0, std::uint64_t id = 0,
                               std::uint64_t next = 0, unsigned flags = 0) {
        Bytes data;
        data.put(id).put(samples).put(static_cast<std::uint16_t>(flags)).put(std::uint16_t{0}).put(std::uint32_t{0});
        data.put(std::uint32_t{recordBytes}).put(std::uint32_t{invalidationBytes});
        return block("CG", {next, firstChannel, text(name), 0, 0, 0}, data.text);
    }

    std::uint64_t dataGroup(std::uint64_t firstGroup, std::uint64_t data, unsigned idBytes = 0,
                            std::uint64_t next = 0) {
        return block("DG", {next, firstGroup, data, 0},
                     std::string(1, static_cast<char>(idBytes)) + std::string(7, '\0'));
    }

    /// Channels, one group, sorted records.
    std::uint64_t simple(const std::string& name, std::vector<Channel> channels, std::uint64_t samples,
                         unsigned recordBytes, std::uint64_t data, unsigned invalidationBytes = 0) {
        std::uint64_t next = 0;
        for (std::size_t i = channels.size(); i-- > 0;) next = channel(channels[i], next);
        return dataGroup(channelGroup(name, next, samples, recordBytes, invalidationBytes), data);
    }

    std::filesystem::path finish(std::uint64_t firstDataGroup, const std::filesystem::path& file) {
        std::memcpy(out_.data() + 64 + 24, &firstDataGroup, 8);
        std::ofstream(file, std::ios::binary) << out_;
        return file;
    }
    std::string& bytes() { return out_; }

private:
    std::string out_;
};

}  // namespace analogon::test
