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

TEST(MatMessage, ThatWasCutIsAFault) {
    const std::string whole = encoded(std::vector<ChannelValues>{{{1, 2, 3}, {}}});
    for (std::size_t length = 0; length < whole.size(); ++length)
        EXPECT_FALSE(decodedValues(whole.substr(0, length))) << length;
}

}  // namespace
}  // namespace analogon::mat
