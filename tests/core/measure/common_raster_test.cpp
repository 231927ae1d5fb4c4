#include "core/measure/common_raster.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/measure/all_channels.hpp"
#include "core/measure/channel_place.hpp"

namespace analogon {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsNan;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A group: its stamps, and one channel.
std::shared_ptr<Table> group(std::size_t number, const std::string& name, std::vector<double> stamps,
                             const std::string& channel, std::vector<double> values) {
    auto table = std::make_shared<Table>();
    table->file = "run.mf4";
    for (std::size_t i = 0; i < stamps.size(); ++i) table->lines.push_back(static_cast<int>(i) + 1);
    Column time{"t", "s", std::move(stamps), {}}, column{channel, "V", std::move(values), {}};
    for (std::size_t i = 0; i < column.values.size(); ++i)
        if (std::isnan(column.values[i])) column.blanks.push_back({static_cast<std::uint32_t>(i), 0});
    for (Column* each : {&time, &column}) {
        each->group = name;
        each->groupNumber = number;
    }
    table->columns = {time, column};
    table->time = 0;
    return table;
}

/// An output every second, an input every half second, a command on its changes.
std::shared_ptr<const Table> recording() {
    auto file = group(1, "slow", {0, 1, 2, 3}, "y", {10, 11, 12, 13});
    file->others = {group(2, "fast", {0, 0.5, 1, 1.5, 2, 2.5, 3}, "u", {0, 1, 2, 3, 4, 5, 6}),
                    group(3, "events", {0, 0.75, 2}, "on", {0, 1, 0})};
    return file;
}

/// An output, and an input of which nothing is told.
RasterRequest ofOneInput() {
    RasterRequest wanted;
    wanted.time = {"t", {}};
    wanted.outputs = {{"y", {}}};
    wanted.inputs = {{{"u", {}}, Interpolation::Automatic}};
    return wanted;
}

RasterRequest request(Interpolation ofCommand = Interpolation::Hold) {
    RasterRequest wanted = ofOneInput();
    wanted.inputs.push_back({{"on", {}}, ofCommand});
    return wanted;
}

Table joined(const std::shared_ptr<const Table>& file, const RasterRequest& wanted) {
    const Outcome<std::shared_ptr<const Table>> table = onCommonRaster(file, wanted);
    EXPECT_TRUE(table.hasValue()) << format(table.diagnostics());
    return table ? **table : Table{};
}

TEST(CommonRaster, ATableOfOneRasterIsTakenAsItIs) {
    const std::shared_ptr<const Table> file = group(1, "", {0, 1}, "y", {1, 2});
    const Outcome<std::shared_ptr<const Table>> table = onCommonRaster(file, request());
    ASSERT_TRUE(table);
    EXPECT_EQ(table->get(), file.get());
}

TEST(CommonRaster, OutputsAreWhereTheyWereMeasuredAndAHeldInputStepsAtItsOwnMoments) {
    const Table table = joined(recording(), request());
    EXPECT_THAT(table.find("t")->values, ElementsAre(0, 0.75, 1, 2, 3));
    EXPECT_THAT(table.find("y")->values, ElementsAre(10, IsNan(), 11, 12, 13));
    EXPECT_THAT(table.find("u")->values, ElementsAre(0, 1.5, 2, 4, 6));
    EXPECT_THAT(table.find("on")->values, ElementsAre(0, 1, 1, 0, 0));
    EXPECT_TRUE(table.find("y")->blanks.empty()) << "what lies between samples is no gap of the measurement";
    EXPECT_EQ(table.lines.size(), 5u);
}

TEST(CommonRaster, AnInputThatTheFileCallsAStatusIsHeldUnlessLinesAreAskedFor) {
    auto file = std::make_shared<Table>(*recording());
    auto events = std::make_shared<Table>(*file->others[1]);
    events->columns[1].isHeld = true;
    file->others[1] = events;
    EXPECT_THAT(joined(file, request(Interpolation::Automatic)).find("on")->values, ElementsAre(0, 1, 1, 0, 0));
    const Table lines = joined(file, request(Interpolation::Linear));
    EXPECT_THAT(lines.find("t")->values, ElementsAre(0, 1, 2)) << "nothing is known behind its last sample";
    EXPECT_THAT(lines.find("on")->values, ElementsAre(0, 0.8, 0));
}

TEST(CommonRaster, StampsThatDifferByRoundingAreOneMoment) {
    auto file = group(1, "a", {0, 0.1, 0.2, 0.30000000000000004}, "y", {1, 2, 3, 4});
    file->others = {group(2, "b", {0, 0.3}, "z", {5, 6}), group(3, "c", {0, 0.30000000000000004}, "u", {0, 1})};
    RasterRequest wanted;
    wanted.time = {"t", {}};
    wanted.outputs = {{"y", {}}, {"z", {}}};
    wanted.inputs = {{{"u", {}}, Interpolation::Hold}};
    const Table table = joined(file, wanted);
    EXPECT_EQ(table.rows(), 4u);
    EXPECT_THAT(table.find("z")->values, ElementsAre(5, IsNan(), IsNan(), 6));
    EXPECT_EQ(table.find("u")->values.back(), 1) << "not the value before the jump";
}

TEST(CommonRaster, WhereAnInputIsNotKnownTheRecordingEndsAndThatIsSaid) {
    auto file = group(1, "a", {0, 1, 2, 3, 4}, "y", {1, 2, 3, 4, 5});
    file->others = {group(2, "b", {0.5, 3.5}, "u", {1, 2})};
    const RasterRequest wanted = ofOneInput();
    const Outcome<std::shared_ptr<const Table>> table = onCommonRaster(file, wanted);
    ASSERT_TRUE(table);
    EXPECT_THAT((*table)->find("t")->values, ElementsAre(1, 2, 3));
    ASSERT_EQ(table.diagnostics().size(), 1u);
    EXPECT_THAT(table.diagnostics()[0].message.english(), HasSubstr("2 of 5 stamps of the outputs lie outside"));
    file->others = {group(2, "b", {10, 11}, "u", {1, 2})};
    const Outcome<std::shared_ptr<const Table>> apart = onCommonRaster(file, wanted);
    ASSERT_FALSE(apart);
    EXPECT_THAT(apart.diagnostics()[0].message.english(), HasSubstr("'u' is not known in that time"));
}

TEST(CommonRaster, ARasterCanBeThatOfAChannelOrOfEqualSteps) {
    RasterRequest wanted = request();
    wanted.raster = {Raster::Kind::Channel, {"u", {}}, 0};
    const Table fast = joined(recording(), wanted);
    EXPECT_THAT(fast.find("t")->values, ElementsAre(0, 0.5, 0.75, 1, 1.5, 2, 2.5, 3));
    EXPECT_THAT(fast.find("y")->values, ElementsAre(10, IsNan(), IsNan(), 11, IsNan(), 12, IsNan(), 13));
    wanted.raster = {Raster::Kind::Steps, {}, 1.5};
    wanted.inputs.pop_back();
    const Outcome<std::shared_ptr<const Table>> steps = onCommonRaster(recording(), wanted);
    ASSERT_TRUE(steps);
    EXPECT_THAT((*steps)->find("t")->values, ElementsAre(0, 1.5, 3));
    EXPECT_THAT((*steps)->find("y")->values, ElementsAre(10, IsNan(), 13));
    ASSERT_FALSE(steps.diagnostics().empty());
    EXPECT_THAT(steps.diagnostics()[0].message.english(), HasSubstr("2 of 4 values of 'y' lie on no stamp"));
}

TEST(CommonRaster, AnInputThatIsFasterThanTheRasterIsTold) {
    auto file = group(1, "a", {0, 1, 2}, "y", {1, 2, 3});
    file->others = {group(2, "b", {0, 0.5, 1, 1.5, 2}, "u", {0, 5, 0, 5, 0})};
    const RasterRequest wanted = ofOneInput();
    const Outcome<std::shared_ptr<const Table>> table = onCommonRaster(file, wanted);
    ASSERT_TRUE(table);
    ASSERT_EQ(table.diagnostics().size(), 1u);
    EXPECT_THAT(table.diagnostics()[0].message.english(), HasSubstr("departs from straight lines by up to 1e+02 %"));
    EXPECT_THAT(table.diagnostics()[0].hint.english(), HasSubstr("\"raster\": \"u\""));
}

TEST(CommonRaster, GapsOfAnInputAreBridgedWhereTheStudySaysHow) {
    auto file = group(1, "a", {0, 1, 2}, "y", {1, none, 3});
    file->others = {group(2, "b", {0, 1, 2}, "u", {0, none, 4})};
    RasterRequest wanted = ofOneInput();
    wanted.raster = {Raster::Kind::Steps, {}, 1};
    const Outcome<std::shared_ptr<const Table>> fault = onCommonRaster(file, wanted);
    ASSERT_FALSE(fault);
    EXPECT_THAT(fault.diagnostics()[0].hint.english(), HasSubstr("\"interpolation\": \"hold\" or \"linear\""));
    wanted.inputs[0].interpolation = Interpolation::Linear;
    const Table lines = joined(file, wanted);
    EXPECT_THAT(lines.find("u")->values, ElementsAre(0, 2, 4));
    EXPECT_THAT(lines.find("y")->values, ElementsAre(1, IsNan(), 3));
    EXPECT_EQ(lines.find("y")->blanks.size(), 1u) << "a gap of the measurement stays one";
    wanted.inputs[0].interpolation = Interpolation::Hold;
    EXPECT_THAT(joined(file, wanted).find("u")->values, ElementsAre(0, 0, 4));
}

TEST(CommonRaster, StampsThatFallAreAFaultAndThoseOfAJumpOfAnInputAreNone) {
    auto file = group(1, "a", {0, 2, 1}, "y", {1, 2, 3});
    file->others = {group(2, "b", {0, 1, 1, 2}, "u", {0, 0, 5, 5})};
    const RasterRequest wanted = ofOneInput();
    const Outcome<std::shared_ptr<const Table>> falls = onCommonRaster(file, wanted);
    ASSERT_FALSE(falls);
    EXPECT_THAT(falls.diagnostics()[0].message.english(), HasSubstr("goes back in 1 of 3 rows"));
    file->columns[0].values = {0, 1, 2};
    EXPECT_THAT(joined(file, wanted).find("u")->values, ElementsAre(0, 5, 5));
}

TEST(CommonRaster, TellsChannelsOfOneNameApart) {
    auto file = group(1, "a", {0, 1}, "U", {1, 2});
    file->others = {group(2, "b", {0, 1}, "U", {3, 4})};
    EXPECT_EQ(placesOf(*file, {"U", {}}).size(), 2u);
    EXPECT_EQ(placesOf(*file, {"U", {"b", 0, false}})[0].column->values[0], 3);
    EXPECT_EQ(placesOf(*file, {"U", {"", 1, false}})[0].column->values[0], 1);
    EXPECT_EQ(labelOf(*file, file->others[0]->columns[1]), "U (b)");
    EXPECT_EQ(channelOf(*file, "U (b)"), (ChannelName{"U", {"b", 0, false}}));
    RasterRequest wanted;
    wanted.time = {"t", {}};
    wanted.outputs = {{"U", {"a", 0, false}}, {"U", {"b", 0, false}}};
    const Table table = joined(file, wanted);
    EXPECT_THAT(table.find("U", {"b", 0, false})->values, ElementsAre(3, 4));
    EXPECT_THAT(table.find("U", {"", 1, false})->values, ElementsAre(1, 2));
}

TEST(CommonRaster, AllChannelsCanBeLookedAtTogether) {
    const Outcome<std::shared_ptr<const Table>> table = allOnOneRaster(recording());
    ASSERT_TRUE(table) << format(table.diagnostics());
    EXPECT_THAT((*table)->find("t")->values, ElementsAre(0, 0.5, 1, 1.5, 2, 2.5, 3));
    EXPECT_THAT((*table)->find("y")->values, ElementsAre(10, 10.5, 11, 11.5, 12, 12.5, 13));
    EXPECT_EQ((*table)->find("y")->group, "slow");
}

TEST(CommonRaster, ChannelsThatAreOnlyLookedAtAreNoInputsOfAnything) {
    auto file = std::make_shared<Table>(*recording());
    const std::size_t rows = 40;
    std::vector<double> times, values;
    for (std::size_t i = 0; i < rows; ++i) {
        times.push_back(0.082 * static_cast<double>(i));
        values.push_back(1);
    }
    file->others = {group(2, "long", times, "u", values)};
    const Outcome<std::shared_ptr<const Table>> table = allOnOneRaster(file);
    ASSERT_TRUE(table) << format(table.diagnostics());
    const std::string told = format(table.diagnostics());
    EXPECT_THAT(told, HasSubstr("from 0 s to 3 s every channel was recorded"));
    EXPECT_THAT(told, HasSubstr("The channel 'y' is recorded for a shorter time."));
    EXPECT_THAT(told, testing::Not(HasSubstr("input")));
}

TEST(AllChannels, AreNamedWithoutReadingOrJoiningThem) {
    auto file = std::make_shared<Table>(*recording());
    const Table names = namesOfAll(*file);
    EXPECT_THAT(names.names(), ElementsAre("y", "u"));  // the events end before the others do
    EXPECT_EQ(names.columns[1].groupName(), (GroupName{"fast", 0, false}));
    EXPECT_TRUE(names.columns[1].values.empty());
    EXPECT_FALSE(isOnOneRaster(*file));
    file->others.clear();
    EXPECT_TRUE(isOnOneRaster(*file));
}

TEST(ChannelLabels, CallChannelsAsThoseThatAreFoundOneByOne) {
    auto file = std::make_shared<Table>(*recording());
    file->others.push_back(group(4, "", {0, 1}, "u", {1, 2}));
    const ChannelLabels labels(*file);
    for (const Table* const each : tablesOf(*file))
        for (const Column& column : each->columns) {
            EXPECT_EQ(labels.of(column), labelOf(*file, column));
            EXPECT_EQ(labels.nameOf(column), channelOf(*file, labelOf(*file, column)));
        }
}

}  // namespace
}  // namespace analogon
