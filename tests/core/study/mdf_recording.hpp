#pragma once

#include <string>
#include <vector>

#include "../measure/mdf/mdf4_writer.hpp"

namespace analogon::test {

/// A channel of a group; whole: bytes, that are a state.
struct MdfChannel {
    std::string name, unit;
    std::vector<double> values;
    bool isWhole{};
};

struct MdfGroup {
    std::string name;
    std::vector<MdfChannel> channels;  // the first one holds the stamps
};

inline void putMdf(const std::filesystem::path& file, const std::vector<MdfGroup>& groups) {
    test::Mdf4Writer writer;
    std::uint64_t next = 0;
    for (std::size_t g = groups.size(); g-- > 0;) {
        const std::vector<MdfChannel>& channels = groups[g].channels;
        std::vector<test::Mdf4Writer::Channel> stored;
        unsigned offset = 0;
        for (const MdfChannel& channel : channels) {
            test::Mdf4Writer::Channel c;
            c.name = channel.name;
            c.unit = channel.unit;
            c.type = stored.empty() ? 2 : 0;
            c.dataType = channel.isWhole ? 0 : 4;
            c.bits = channel.isWhole ? 8 : 64;
            c.byteOffset = offset;
            offset += c.bits / 8;
            stored.push_back(c);
        }
        test::Bytes records;
        for (std::size_t row = 0; row < channels[0].values.size(); ++row)
            for (const MdfChannel& channel : channels)
                if (channel.isWhole)
                    records.put(static_cast<std::uint8_t>(channel.values[row]));
                else
                    records.put(channel.values[row]);
        const std::uint64_t data = writer.block("DT", {}, records.text);
        std::uint64_t first = 0;
        for (std::size_t c = stored.size(); c-- > 0;) first = writer.channel(stored[c], first);
        next = writer.dataGroup(writer.channelGroup(groups[g].name, first, channels[0].values.size(), offset), data, 0,
                                next);
    }
    writer.finish(next, file);
}

}  // namespace analogon::test
