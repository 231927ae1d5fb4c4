#include "core/measure/mat/mat_message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace analogon::mat {
namespace {

using testing::ElementsAre;

Channels someChannels() {
    Channels channels;
    RecordedGroup group{"Scope", MasterKind::Time, 0, 3, {}};
    group.channels.push_back({"Scope.time", "s", "", {}, ChannelKind::Number, 3, false});
    group.channels.push_back({"T_\xB0",
                              "\xB0"
                              "C",
                              "in Windows-1252",
                              {},
                              ChannelKind::Number,
                              3,
                              true});
    channels.groups.push_back(group);
    channels.notes.push_back(
        phrase("channel \"{}\": its fields scale and offset are applied, data*{} + {}", "T", 0.5, 2.0));
    channels.places = {
        {{"Scope", {{"time", 0}}, 0, 1, 3, 1, 0}, {"Scope", {{"signals", 0}, {"values", 2}}, 1, 2, 3, 0.5, -2}}};
    return channels;
}

TEST(MatMessage, OfChannelsGivesThemBack) {
    const Outcome<Channels> decoded = decodedChannels(encoded(someChannels()));
    ASSERT_TRUE(decoded);
    ASSERT_EQ(decoded->groups.size(), 1u);
    const RecordedGroup& group = decoded->groups[0];
    EXPECT_EQ(group.name, "Scope");
    EXPECT_EQ(group.master, MasterKind::Time);
    EXPECT_EQ(group.masterChannel, 0u);
    ASSERT_EQ(group.channels.size(), 2u);
    EXPECT_EQ(group.channels[1].name, "T_\xB0");
    EXPECT_EQ(group.channels[1].comment, "in Windows-1252");
    EXPECT_TRUE(group.channels[1].isInteger);
    EXPECT_EQ(decoded->notes, someChannels().notes);
    EXPECT_EQ(decoded->notes[0].pattern(), someChannels().notes[0].pattern());
    EXPECT_TRUE(decoded->notes[0].arguments()[1].isNumber());
    const VariablePlace& place = decoded->places[0][1];
    EXPECT_EQ(place.steps[1].field, "values");
    EXPECT_EQ(place.steps[1].index, 2u);
    EXPECT_EQ(place.stride, 2u);
    EXPECT_EQ(place.offset, -2);
}

TEST(MatMessage, OfValuesGivesThemBackToTheLastBit) {
    const std::vector<ChannelValues> values{{{0.1, -0.0, 1e-310}, {}}, {{}, {}}, {{3}, {}}};
    const Outcome<std::vector<ChannelValues>> decoded = decodedValues(encoded(values));
    ASSERT_TRUE(decoded);
    ASSERT_EQ(decoded->size(), 3u);
    EXPECT_THAT((*decoded)[0].numbers, ElementsAre(0.1, -0.0, 1e-310));
    EXPECT_TRUE((*decoded)[1].numbers.empty());
    EXPECT_THAT((*decoded)[2].numbers, ElementsAre(3));
}

TEST(MatMessage, OfAFaultGivesItsWordsPlaceAndHint) {
    const auto decoded = decodedChannels(encoded(Outcome<Channels>(fileError("no", "a.mat", 0, 0, "do this"))));
    ASSERT_FALSE(decoded);
    EXPECT_EQ(decoded.diagnostics()[0].message, "no");
    EXPECT_EQ(decoded.diagnostics()[0].place.file, "a.mat");
    EXPECT_EQ(decoded.diagnostics()[0].hint, "do this");
}

/// The process that writes it works with damaged input.
TEST(MatMessage, ThatIsDamagedEndsInChannelsThatFitTogetherOrInAFault) {
    const std::string whole = encoded(someChannels());
    std::uint32_t state = 11;
    int faults = 0;
    for (int i = 0; i < 20'000; ++i) {
        std::string bytes = whole;
        for (int changes = 0; changes <= i % 3; ++changes) {
            state = state * 1664525u + 1013904223u;
            bytes[(state >> 8) % bytes.size()] = static_cast<char>(state);
        }
        const Outcome<Channels> decoded = decodedChannels(bytes);
        faults += decoded ? 0 : 1;
        if (!decoded) continue;
        ASSERT_EQ(decoded->places.size(), decoded->groups.size());
        for (std::size_t g = 0; g < decoded->groups.size(); ++g) {
            const RecordedGroup& group = decoded->groups[g];
            ASSERT_EQ(decoded->places[g].size(), group.channels.size());
            ASSERT_LT(group.masterChannel.value_or(0), group.channels.size());
        }
    }
    EXPECT_GT(faults, 1000);
}

TEST(MatMessage, WithoutItsPartsIsAFault) {
    const auto message = [](const std::string& cbor) {
        const std::uint64_t length = cbor.size();
        return std::string(reinterpret_cast<const char*>(&length), sizeof length) + cbor;
    };
    for (const char* const head : {"\xA0",
                                   "\xA1\x66"
                                   "groups"
                                   "\x80",
                                   "\xF6", "\x80"}) {
        EXPECT_FALSE(decodedChannels(message(head)));
        EXPECT_FALSE(decodedValues(message(head)));
    }
}

TEST(MatMessage, ThatWasCutIsAFault) {
    const std::string whole = encoded(std::vector<ChannelValues>{{{1, 2, 3}, {}}});
    for (std::size_t length = 0; length < whole.size(); ++length)
        EXPECT_FALSE(decodedValues(whole.substr(0, length))) << length;
}

}  // namespace
}  // namespace analogon::mat
