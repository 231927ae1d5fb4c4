#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/measure/open/open_recording.hpp"
#include "core/measure/table.hpp"
#include "core/measure/text/text_recording.hpp"

/// Files as instruments write them, with what is known of each; passed over where they are not at hand.
namespace analogon {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

fs::path folder() {
    const fs::path beside = fs::path(ANALOGON_ROOT) / ".." / "shared" / "field" / "measurements";
    return fs::exists(beside) ? beside : fs::path(ANALOGON_ROOT) / ".." / ".." / "shared" / "field" / "measurements";
}

struct Expected {
    const char* file;
    std::size_t rows;
    double firstTime, lastTime;  // in the file's unit
    const char* channel;
    const char* unit;
    double first, last;
};

const std::vector<Expected> expectedFiles{
    {"01-tek-scope-preamble/tek0001ALL.csv", 200, -0.020, 0.179, "CH1", "V", -5.11761e-3, 12.0099},
    {"02-digilent-waveforms/acq0001.csv", 60, -1.30832912e-4, 1.344167088e-3, "Channel 1", "V", -0.0060645429367,
     3.2736229370832},
    {"04-rigol-counter-and-increment/NewFile1.csv", 80, -0.004, 0.0355, "CH1", "Volt", -8.68e-2, 24.1},
    {"05-picoscope-brackets-and-infinity/20230412-0001.csv", 40, -0.005008, 0.092648, "Channel A", "V", 12.10568969,
     9.42302037},
    {"08-hioki-hicorder/WAVE0001.CSV", 100, 0, 9.9, "CH-7", "degC", 35.8476, 55.5442},
    {"10-hobo-quoted-header/10412345.csv", 60, 0, 590, "Temp (LGR S/N: 10412345, SEN S/N: 10412345, LBL: heater)",
     "\xC2\xB0"
     "C",
     21.4, 63.084},
    {"11-date-and-time-in-two-columns/bench.csv", 50, 0, 48583.5, "Temperature", "", 23.5, 28.4},
    {"13-repeated-stamps/densely_sampled.csv", 1000, 0, 999, "A", "A", 0, -0.0377},
    {"18-a-time-column-for-each-channel/scope_export.csv", 40, 0, 195, "Motor.Voltage", "V", 12, 12.042},
    {"19-blank-rasters/blank.csv", 0, 0, 0, "T_motor",
     "\xC2\xB0"
     "C",
     41, NAN},
    {"20-unit-in-every-row/dmm.csv", 9, 0.2, 1.8, "Value", "V", -0.00023, 0.0551},
    {"20-unit-in-every-row/can_decoded.csv", 3, 0, 0.2, "EngineSpeed", "rpm", 812.5, 816.5},
    {"21-rows-only-on-change/digital.csv", 7, 0, 12, "valve", "", 0, 0},
    {"22-battery-tester/module_ir.csv", 59, 1, 50, "Voltage", "", 4.129, 3.784},
    {"24-encoder-that-wraps/motor_data.csv", 0, 1110, 1400, "position_value", "degree", 7.82, 246.80},
    {"25-comma-in-a-name/quoted.csv", 4, 0, 0.03, "Torque, Request", "", 0, 5},
    {"26-modelica-table-file/tcDat.csv", 12, 0, 5.5, "c3", "", 20, 23.3},
    {"29-units-of-the-bench/bench.csv", 3, 0, 2, "p_abs", "kPa abs", 101.3, 101.3},
};

void expectSame(double value, double expected, const std::string& what) {
    if (std::isnan(expected))
        EXPECT_TRUE(std::isnan(value)) << what;
    else
        EXPECT_NEAR(value, expected, 1e-9 * std::max(1.0, std::abs(expected))) << what;
}

TEST(FieldFiles, GiveWhatIsKnownOfThem) {
    if (!fs::exists(folder())) GTEST_SKIP() << "the files are not at hand";
    for (const Expected& expected : expectedFiles) {
        const Outcome<MeasurementFile> opened = openRecording(folder() / expected.file);
        ASSERT_TRUE(opened) << expected.file << format(opened.diagnostics());
        const RecordedGroup& group = opened->groups.front();
        if (expected.rows > 0) {
            EXPECT_EQ(group.samples, expected.rows) << expected.file;
        }
        ASSERT_TRUE(group.masterChannel) << expected.file;
        const Outcome<ChannelValues> time = readValues(*opened, 0, *group.masterChannel);
        if (expected.rows > 0) {
            expectSame(time->numbers.front(), expected.firstTime, expected.file);
            expectSame(time->numbers.back(), expected.lastTime, expected.file);
        }
        bool isFound = false;
        for (std::size_t i = 0; i < group.channels.size(); ++i) {
            if (group.channels[i].name != expected.channel) continue;
            isFound = true;
            EXPECT_EQ(group.channels[i].unit, expected.unit) << expected.file;
            const Outcome<ChannelValues> values = readValues(*opened, 0, i);
            expectSame(values->numbers.front(), expected.first, expected.file);
            expectSame(values->numbers.back(), expected.last, expected.file);
        }
        EXPECT_TRUE(isFound) << expected.file << ": " << expected.channel;
    }
}

TEST(FieldFiles, AreRefusedInWordsThatHelp) {
    if (!fs::exists(folder())) GTEST_SKIP() << "the files are not at hand";
    const Outcome<MeasurementFile> four = openRecording(folder() / "15-four-channels/four_channels.csv");
    ASSERT_FALSE(four);
    EXPECT_EQ(four.diagnostics().front().place.line, 2);
    EXPECT_THAT(format(four.diagnostics()), HasSubstr("twice as many"));
    const Outcome<MeasurementFile> names = openRecording(folder() / "25-comma-in-a-name/dummy.csv");
    ASSERT_FALSE(names);
    EXPECT_THAT(format(names.diagnostics()), HasSubstr("this row has 4 cells, the header has 6"));
}

TEST(FieldFiles, KeepTheSecondRasterOfAFile) {
    if (!fs::exists(folder())) GTEST_SKIP() << "the files are not at hand";
    const Outcome<MeasurementFile> opened =
        openRecording(folder() / "18-a-time-column-for-each-channel/scope_export.csv");
    ASSERT_TRUE(opened);
    ASSERT_EQ(opened->groups.size(), 2u);
    const Outcome<ChannelValues> time = readValues(*opened, 1, 0), temperature = readValues(*opened, 1, 1);
    EXPECT_EQ(time->numbers.size(), 10u);
    EXPECT_EQ(time->numbers.back(), 183);
    EXPECT_EQ(temperature->numbers.back(), 28.6);
}

TEST(FieldFiles, HaveAnEvenTimeWhereItsDigitsAreTooFew) {
    if (!fs::exists(folder())) GTEST_SKIP() << "the files are not at hand";
    const Outcome<Table> table = readTextTables(folder() / "28-time-with-too-few-digits/ds1042c.csv", {});
    ASSERT_TRUE(table);
    const std::vector<double>& time = table->columns[0].values;
    EXPECT_NEAR(time.back() - time.front(), 399 * 5e-6, 1e-8);
}

}  // namespace
}  // namespace analogon
