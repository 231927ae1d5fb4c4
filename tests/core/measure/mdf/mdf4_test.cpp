#include "core/measure/mdf/mdf4.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <cmath>

#include "core/measure/open/open_recording.hpp"
#include "tests/core/measure/mdf/mdf4_writer.hpp"

namespace analogon {
namespace {

using test::Bytes;
using test::Mdf4Writer;
using testing::ElementsAre;
using testing::HasSubstr;

/// A file that is gone when the test is.
class Mdf4 : public testing::Test {
protected:
    ~Mdf4() override { std::filesystem::remove(file); }

    MeasurementFile open(Mdf4Writer& writer, std::uint64_t firstGroup) {
        Outcome<MeasurementFile> opened = openRecording(writer.finish(firstGroup, file));
        EXPECT_TRUE(opened) << format(opened.diagnostics());
        return opened ? std::move(*opened) : MeasurementFile{};
    }
    static std::vector<double> numbers(const MeasurementFile& recording, std::size_t group, std::size_t channel) {
        const Outcome<ChannelValues> values = readValues(recording, group, channel);
        EXPECT_TRUE(values) << format(values.diagnostics());
        return values ? values->numbers : std::vector<double>{};
    }
    static std::string notes(const MeasurementFile& recording) {
        std::string all;
        for (const Text& note : recording.notes) all += note.english() + "\n";
        return all;
    }

    std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("analogon-mdf4-" + std::to_string(getpid()) + ".mf4");
};

const Mdf4Writer::Channel time{"t", "s", 2};

std::string packed(const std::string& data, unsigned kind, std::uint32_t columns) {
    std::string body = data;
    if (kind == 1) {
        const std::size_t rows = data.size() / columns;
        for (std::size_t row = 0; row < rows; ++row)
            for (std::size_t column = 0; column < columns; ++column)
                body[column * rows + row] = data[row * columns + column];
    }
    uLongf size = compressBound(body.size());
    std::string out(size, '\0');
    compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(body.data()), body.size());
    out.resize(size);
    Bytes block;
    block.put(std::string("DT")).put(static_cast<std::uint8_t>(kind)).put(std::uint8_t{0}).put(columns);
    block.put(std::uint64_t{data.size()}).put(std::uint64_t{out.size()}).put(out);
    return block.text;
}

std::string ramp(int first, int count) {
    Bytes data;
    for (int i = first; i < first + count; ++i) data.put(0.1 * i).put(static_cast<std::int16_t>(3 * i - 5));
    return data.text;
}

const std::vector<Mdf4Writer::Channel> rampChannels{time, {"y", "V", 0, 2, 16, 8}};

TEST_F(Mdf4, FindsGroupsChannelsUnitsAndValues) {
    Mdf4Writer writer;
    const std::uint64_t data = writer.block("DT", {}, ramp(0, 4));
    const MeasurementFile recording = open(writer, writer.simple("run", rampChannels, 4, 10, data));
    ASSERT_EQ(recording.groups.size(), 1u);
    const RecordedGroup& group = recording.groups[0];
    EXPECT_EQ(group.name, "run");
    EXPECT_EQ(group.master, MasterKind::Time);
    EXPECT_EQ(group.masterChannel, 0u);
    EXPECT_EQ(group.channels[1].unit, "V");
    EXPECT_THAT(numbers(recording, 0, 0), ElementsAre(0.0, 0.1, 0.2, 0.1 * 3));
    EXPECT_THAT(numbers(recording, 0, 1), ElementsAre(-5, -2, 1, 4));
}

TEST_F(Mdf4, ReadsIntegersThatBeginWithinAByteInBothByteOrders) {
    // 13 bits from bit 3 on: 0b1'0000'0000'0011 is -4093 with a sign, 4099 without
    Mdf4Writer writer;
    Bytes data;
    data.put(static_cast<std::uint16_t>(0x1003u << 3)).putBig(static_cast<std::uint16_t>(0x1003u << 3));
    const std::uint64_t block = writer.block("DT", {}, data.text);
    const MeasurementFile recording = open(writer, writer.simple("",
                                                                 {{"u", "", 0, 0, 13, 0, 3},
                                                                  {"s", "", 0, 2, 13, 0, 3},
                                                                  {"ub", "", 0, 1, 13, 2, 3},
                                                                  {"sb", "", 0, 3, 13, 2, 3}},
                                                                 1, 4, block));
    EXPECT_THAT(numbers(recording, 0, 0), ElementsAre(4099));
    EXPECT_THAT(numbers(recording, 0, 1), ElementsAre(-4093));
    EXPECT_THAT(numbers(recording, 0, 2), ElementsAre(4099));
    EXPECT_THAT(numbers(recording, 0, 3), ElementsAre(-4093));
}

TEST_F(Mdf4, ReadsASixtyFourBitIntegerOverNineBytesAndHalfFloats) {
    Mdf4Writer writer;
    Bytes data;
    data.put(std::uint64_t{0x123456789ABCD} << 4).put(std::uint8_t{0});
    data.put(std::uint16_t{0x3C00}).putBig(std::uint16_t{0xC000}).put(std::uint16_t{0x0001});
    const std::uint64_t block = writer.block("DT", {}, data.text);
    const MeasurementFile recording = open(writer, writer.simple("",
                                                                 {{"wide", "", 0, 0, 64, 0, 4},
                                                                  {"half", "", 0, 4, 16, 9},
                                                                  {"halfBig", "", 0, 5, 16, 11},
                                                                  {"tiny", "", 0, 4, 16, 13}},
                                                                 1, 15, block));
    EXPECT_THAT(numbers(recording, 0, 0), ElementsAre(static_cast<double>(0x123456789ABCD)));
    EXPECT_THAT(numbers(recording, 0, 1), ElementsAre(1.0));
    EXPECT_THAT(numbers(recording, 0, 2), ElementsAre(-2.0));
    EXPECT_THAT(numbers(recording, 0, 3), ElementsAre(std::ldexp(1.0, -24)));
}

TEST_F(Mdf4, SaysThatALargeIntegerWasRounded) {
    Mdf4Writer writer;
    Bytes data;
    data.put((std::uint64_t{1} << 60) + 1);
    const std::uint64_t block = writer.block("DT", {}, data.text);
    const MeasurementFile recording = open(writer, writer.simple("", {{"n", "", 0, 0, 64, 0}}, 1, 8, block));
    const Outcome<ChannelValues> values = readValues(recording, 0, 0);
    ASSERT_TRUE(values);
    EXPECT_THAT(format(values.diagnostics()), HasSubstr("2^53"));
}

TEST_F(Mdf4, PutsRecordsTogetherThatLieInTwoBlocks) {
    const std::string data = ramp(0, 100);
    Mdf4Writer writer;
    const std::uint64_t first = writer.block("DT", {}, data.substr(0, 333));
    const std::uint64_t second = writer.block("DZ", {}, packed(data.substr(333, 444), 0, 0));
    const std::uint64_t third = writer.block("DZ", {}, packed(data.substr(777), 1, 10));
    Bytes list;
    list.put(std::uint32_t{0})
        .put(std::uint32_t{3})
        .put(std::uint64_t{0})
        .put(std::uint64_t{333})
        .put(std::uint64_t{777});
    const std::uint64_t dl = writer.block("DL", {0, first, second, third}, list.text);
    const std::uint64_t hl = writer.block("HL", {dl}, std::string(8, '\0'));
    const MeasurementFile recording = open(writer, writer.simple("", rampChannels, 100, 10, hl));
    const std::vector<double> values = numbers(recording, 0, 1);
    ASSERT_EQ(values.size(), 100u);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(values[static_cast<std::size_t>(i)], 3 * i - 5);
}

TEST_F(Mdf4, ADamagedPackedBlockCostsItsOwnSamplesAlone) {
    const std::string data = ramp(0, 30);
    std::string broken = packed(data.substr(100, 100), 1, 10);
    broken[24 + 8] = static_cast<char>(broken[24 + 8] ^ 0x55);
    broken[24 + 9] = static_cast<char>(broken[24 + 9] ^ 0x55);
    Mdf4Writer writer;
    const std::uint64_t first = writer.block("DT", {}, data.substr(0, 100));
    const std::uint64_t second = writer.block("DZ", {}, broken);
    const std::uint64_t third = writer.block("DT", {}, data.substr(200));
    Bytes list;
    list.put(std::uint32_t{1}).put(std::uint32_t{3}).put(std::uint64_t{100});
    const MeasurementFile recording =
        open(writer, writer.simple("", rampChannels, 30, 10, writer.block("DL", {0, first, second, third}, list.text)));
    const Outcome<ChannelValues> values = readValues(recording, 0, 1);
    ASSERT_TRUE(values);
    EXPECT_EQ(values->numbers[9], 22);
    EXPECT_EQ(values->numbers[20], 55);
    EXPECT_EQ(summaryOf(*values).gaps, 10u);
    EXPECT_THAT(format(values.diagnostics()), HasSubstr("10 samples are lost"));
}

TEST_F(Mdf4, AppliesConversions) {
    Mdf4Writer writer;
    Bytes data;
    for (const int x : {0, 2, 5, 9}) data.put(static_cast<std::uint8_t>(x));
    const std::uint64_t block = writer.block("DT", {}, data.text);
    std::vector<Mdf4Writer::Channel> channels;
    const auto add = [&](std::uint64_t conversion) { channels.push_back({"c", "", 0, 0, 8, 0, 0, conversion}); };
    add(writer.conversion(1, {10, 2}));
    add(writer.conversion(2, {0, 2, 1, 0, 0, 4}));
    add(writer.conversion(3, {}, {writer.text("-X^2 + pow(X, 2) * 3 - sqrt(4)/2")}));
    add(writer.conversion(4, {1, 10, 5, 50}));
    add(writer.conversion(5, {1, 10, 5, 50}));
    add(writer.conversion(6, {0, 2, 7, 3, 5, 8, -1}));
    const MeasurementFile recording = open(writer, writer.simple("", channels, 4, 1, block));
    EXPECT_THAT(numbers(recording, 0, 0), ElementsAre(10, 14, 20, 28));
    EXPECT_THAT(numbers(recording, 0, 1), ElementsAre(0.25, 1.25, 2.75, 4.75));
    EXPECT_THAT(numbers(recording, 0, 2), ElementsAre(-1, 7, 49, 161));
    EXPECT_THAT(numbers(recording, 0, 3), ElementsAre(10, 20, 50, 50));
    EXPECT_THAT(numbers(recording, 0, 4), ElementsAre(10, 10, 50, 50));
    EXPECT_THAT(numbers(recording, 0, 5), ElementsAre(7, 7, 8, -1));
}

TEST_F(Mdf4, AFormulaThatCannotBeReadIsTold) {
    Mdf4Writer writer;
    const std::uint64_t block = writer.block("DT", {}, std::string(1, '\7'));
    const std::uint64_t formula = writer.conversion(3, {}, {writer.text("lookup(X)")});
    const MeasurementFile recording = open(writer, writer.simple("", {{"y", "", 0, 0, 8, 0, 0, formula}}, 1, 1, block));
    EXPECT_THAT(notes(recording), HasSubstr("lookup(X)"));
    EXPECT_THAT(numbers(recording, 0, 0), ElementsAre(7));
}

TEST_F(Mdf4, BlanksAroundAUnitAreNoneOfIt) {
    Mdf4Writer writer;
    const std::uint64_t data = writer.block("DT", {}, ramp(0, 3));
    const std::uint64_t group = writer.simple("", {time, {"n", "U/  min  ", 0, 2, 16, 8}}, 3, 10, data);
    EXPECT_EQ(open(writer, group).groups[0].channels[1].unit, "U/  min");
}

TEST_F(Mdf4, AConversionThatRefersToItselfIsTold) {
    Mdf4Writer writer;
    const std::uint64_t data = writer.block("DT", {}, ramp(0, 3));
    const std::uint64_t conversion = writer.conversion(7, {0}, {0, 0});
    std::memcpy(writer.bytes().data() + conversion + 24 + 8 * 5, &conversion, 8);  // that of all other values
    const std::uint64_t group = writer.simple("", {time, {"y", "V", 0, 2, 16, 8, 0, conversion}}, 3, 10, data);
    const MeasurementFile recording = open(writer, group);
    EXPECT_THAT(notes(recording), HasSubstr("channel \"y\": its conversion \"?\" cannot be read"));
    EXPECT_THAT(numbers(recording, 0, 1), ElementsAre(-5, -2, 1));
}

TEST_F(Mdf4, AFileThatIsMarkedAsUnfinishedIsToldWhateverItsName) {
    Mdf4Writer writer("4.10", false, 1);
    const std::uint64_t data = writer.block("DT", {}, ramp(0, 3));
    const std::uint64_t group = writer.simple("", rampChannels, 3, 10, data);
    EXPECT_THAT(notes(open(writer, group)), HasSubstr("the recorder did not close the file"));
}

TEST_F(Mdf4, AStatusKeepsItsNumbersAndNamesThem) {
    Mdf4Writer writer;
    const std::uint64_t block = writer.block("DT", {}, std::string("\0\1\5", 3));
    const std::uint64_t off = writer.text("off"), on = writer.text("on"), other = writer.text("?");
    const std::uint64_t conversion = writer.conversion(7, {0, 1}, {off, on, other});
    const MeasurementFile recording =
        open(writer, writer.simple("", {{"s", "", 0, 0, 8, 0, 0, conversion}}, 3, 1, block));
    const RecordedChannel& channel = recording.groups[0].channels[0];
    EXPECT_EQ(channel.kind, ChannelKind::Status);
    EXPECT_THAT(numbers(recording, 0, 0), ElementsAre(0, 1, 5));
    EXPECT_EQ(statusTextOf(channel, 1), "on");
    EXPECT_EQ(statusTextOf(channel, 5), "?");
}

TEST_F(Mdf4, AValueThatHasOnlyATextIsAGapInAChannelOfNumbers) {
    Mdf4Writer writer;
    const std::uint64_t block = writer.block("DT", {}, std::string("\1\377", 2));
    const std::uint64_t linear = writer.conversion(1, {0, 0.5});
    const std::uint64_t conversion = writer.conversion(7, {255}, {writer.text("no signal"), linear});
    const MeasurementFile recording =
        open(writer, writer.simple("", {{"s", "", 0, 0, 8, 0, 0, conversion}}, 2, 1, block));
    EXPECT_EQ(recording.groups[0].channels[0].kind, ChannelKind::Number);
    const std::vector<double> values = numbers(recording, 0, 0);
    EXPECT_EQ(values[0], 0.5);
    EXPECT_TRUE(std::isnan(values[1]));
    EXPECT_THAT(notes(recording), HasSubstr("no signal"));
}

TEST_F(Mdf4, InvalidationBitsAreGaps) {
    Mdf4Writer writer;
    const std::uint64_t block = writer.block("DT", {}, std::string("\1\0\2\4\3\0", 6));
    Mdf4Writer::Channel channel{"y", "", 0, 0, 8, 0};
    channel.flags = 2;
    channel.invalidationBit = 2;
    const MeasurementFile recording = open(writer, writer.simple("", {channel}, 3, 1, block, 1));
    const std::vector<double> values = numbers(recording, 0, 0);
    EXPECT_EQ(values[0], 1);
    EXPECT_TRUE(std::isnan(values[1]));
    EXPECT_EQ(values[2], 3);
}

TEST_F(Mdf4, SortsRecordsOfSeveralGroupsAndTextsOfVariableLength) {
    Mdf4Writer writer;
    Bytes data;
    const auto record = [&](std::uint8_t id, auto value) { data.put(id).put(value); };
    record(1, std::int16_t{10});
    record(7, std::uint32_t{2});
    data.put(std::string("ab"));
    record(9, std::uint64_t{0});
    record(1, std::int16_t{11});
    record(7, std::uint32_t{3});
    data.put(std::string("cde"));
    record(9, std::uint64_t{6});
    const std::uint64_t block = writer.block("DT", {}, data.text);
    const std::uint64_t texts = writer.channelGroup("", 0, 2, 5, 0, 7, 0, 1);
    const std::uint64_t words =
        writer.channelGroup("words", writer.channel({"w", "", 1, 7, 64, 0, 0, 0, texts}, 0), 2, 8, 0, 9, texts);
    const std::uint64_t group = writer.channelGroup("fast", writer.channel({"f", "", 0, 2, 16}, 0), 2, 2, 0, 1, words);
    const MeasurementFile recording = open(writer, writer.dataGroup(group, block, 1));
    ASSERT_EQ(recording.groups.size(), 2u);
    EXPECT_THAT(numbers(recording, 0, 0), ElementsAre(10, 11));
    const Outcome<ChannelValues> read = readValues(recording, 1, 0);
    ASSERT_TRUE(read);
    EXPECT_THAT(read->texts, ElementsAre("ab", "cde"));
    EXPECT_EQ(recording.groups[1].channels[0].kind, ChannelKind::Text);
}

TEST_F(Mdf4, CountsVirtualChannelsAndArraysByElements) {
    Mdf4Writer writer;
    const std::uint64_t block = writer.block("DT", {}, std::string("\1\2\3\4\5\6", 6));
    Bytes shape;
    shape.put(std::uint8_t{0}).put(std::uint8_t{0}).put(std::uint16_t{1}).put(std::uint32_t{0}).put(std::int32_t{1});
    shape.put(std::uint32_t{0}).put(std::uint64_t{3});
    Mdf4Writer::Channel array{"a", "", 0, 0, 8, 0};
    array.composition = writer.block("CA", {0}, shape.text);
    Mdf4Writer::Channel counted{"t", "", 3, 0, 0, 0};
    counted.conversion = writer.conversion(1, {5, 0.5});
    const MeasurementFile recording = open(writer, writer.simple("", {counted, array}, 2, 3, block));
    ASSERT_EQ(recording.groups[0].channels.size(), 4u);
    EXPECT_EQ(recording.groups[0].channels[3].name, "a[2]");
    EXPECT_EQ(recording.groups[0].channels[0].unit, "s");
    EXPECT_THAT(numbers(recording, 0, 0), ElementsAre(5, 5.5));
    EXPECT_THAT(numbers(recording, 0, 3), ElementsAre(3, 6));
}

TEST_F(Mdf4, AnUnfinishedFileIsReadToItsLastWholeRecord) {
    Mdf4Writer writer("4.10", true, 1 | 4);
    // the data come last: their block has no length yet
    const std::uint64_t dataAt = 4096;
    const std::uint64_t group = writer.simple("", rampChannels, 0, 10, dataAt);
    writer.bytes().resize(dataAt, '\0');
    ASSERT_EQ(writer.block("DT", {}, ramp(0, 3) + "1234", 24), dataAt);
    const MeasurementFile recording = open(writer, group);
    EXPECT_THAT(numbers(recording, 0, 1), ElementsAre(-5, -2, 1));
    EXPECT_THAT(notes(recording), HasSubstr("did not close"));
    EXPECT_THAT(notes(recording), HasSubstr("4 of 10 bytes"));
}

TEST_F(Mdf4, AChainInACircleAndWildLinksAreTold) {
    Mdf4Writer writer;
    const std::uint64_t data = writer.block("DT", {}, ramp(0, 2));
    const std::uint64_t group = writer.simple("", rampChannels, 2, 10, data);
    std::memcpy(writer.bytes().data() + group + 24, &group, 8);  // the next group is this one
    const MeasurementFile recording = open(writer, group);
    EXPECT_THAT(notes(recording), HasSubstr("circle"));
    EXPECT_THAT(numbers(recording, 0, 1), ElementsAre(-5, -2));
}

TEST_F(Mdf4, ABlockThatClaimsMoreThanCanBeIsLeftOut) {
    Mdf4Writer writer;
    std::string lie = packed(ramp(0, 2), 0, 0);
    const std::uint64_t huge = std::uint64_t{1} << 50;
    std::memcpy(lie.data() + 8, &huge, 8);
    const std::uint64_t data = writer.block("DZ", {}, lie);
    const MeasurementFile recording = open(writer, writer.simple("", rampChannels, 2, 10, data));
    EXPECT_EQ(recording.groups[0].samples, 0u);
    EXPECT_THAT(notes(recording), HasSubstr("damaged"));
}

TEST_F(Mdf4, EveryByteOfASmallFileMayBeDamaged) {
    Mdf4Writer writer;
    const std::uint64_t first = writer.block("DT", {}, ramp(0, 5));
    const std::uint64_t second = writer.block("DZ", {}, packed(ramp(5, 5), 1, 10));
    Bytes list;
    list.put(std::uint32_t{1}).put(std::uint32_t{2}).put(std::uint64_t{50});
    const std::uint64_t dl = writer.block("DL", {0, first, second}, list.text);
    const std::uint64_t conversion = writer.conversion(7, {0, 1}, {writer.text("off"), writer.conversion(1, {1, 2})});
    const std::uint64_t group = writer.simple("", {time, {"y", "V", 0, 2, 16, 8, 0, conversion}}, 10, 10, dl);
    writer.finish(group, file);
    const std::string whole = writer.bytes();
    std::uint32_t state = 1;
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string bytes = whole;
        state = state * 1664525u + 1013904223u;
        bytes[at] = static_cast<char>(bytes[at] ^ static_cast<char>(1u << (state >> 29)));
        bytes[(at + (state >> 8) % 64) % bytes.size()] = static_cast<char>(state >> 16);
        std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
        const Outcome<MeasurementFile> opened = openRecording(file);
        if (!opened) continue;
        for (std::size_t g = 0; g < opened->groups.size(); ++g)
            for (std::size_t c = 0; c < opened->groups[g].channels.size(); ++c) {
                const Outcome<ChannelValues> values = readValues(*opened, g, c);
                if (values) {
                    EXPECT_LE(values->numbers.size(), std::size_t{1} << 26);
                }
            }
    }
}

}  // namespace
}  // namespace analogon
