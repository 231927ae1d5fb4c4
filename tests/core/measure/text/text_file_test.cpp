#include "core/measure/text/text_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "core/measure/channel.hpp"
#include "core/measure/open/open_recording.hpp"
#include "core/measure/text/text_recording.hpp"

namespace analogon {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;

TextFile read(std::string_view text, const ReadOptions& options = {}) {
    Outcome<TextFile> file = readTextFile(text, "test.csv", options);
    EXPECT_TRUE(file.hasValue()) << format(file.diagnostics());
    return file ? *file : TextFile{};
}

std::string told(std::string_view text, const ReadOptions& options = {}) {
    return format(readTextFile(text, "test.csv", options).diagnostics());
}

std::string faultOf(std::string_view text, const ReadOptions& options = {}) {
    const Outcome<TextFile> file = readTextFile(text, "test.csv", options);
    EXPECT_FALSE(file.hasValue());
    return format(file.diagnostics());
}

std::vector<std::string> names(const TextFile& file) { return file.groups.at(0).table.names(); }
const Column& column(const TextFile& file, const std::string& name, std::size_t group = 0) {
    const Column* const found = file.groups.at(group).table.find(name);
    if (!found) throw std::runtime_error("no column " + name);
    return *found;
}
std::vector<double> timeOf(const TextFile& file, std::size_t group = 0) {
    const TextGroup& from = file.groups.at(group);
    return from.time ? from.table.columns[*from.time].values : std::vector<double>{};
}

// ---- what a name says ----

TEST(TextFile, APathIsNoUnitBehindASlash) {
    const TextFile paths = read("time;Motor/T;Motor/n;Bench/u\n0;1;2;3\n1;2;3;4\n");
    EXPECT_THAT(names(paths), ElementsAre("time", "Motor/T", "Motor/n", "Bench/u"));
    EXPECT_EQ(column(paths, "Motor/T").unit, "") << "no tesla";
    const TextFile told = read("t,Model/u,Plant/A\ns,V,rpm\n0,1,2\n1,2,3\n");
    EXPECT_EQ(column(told, "Model/u").unit, "V") << "what the row of units says";
    const TextFile units = read("t/s;u/mV;i/A\n0;1;2\n1;2;3\n");
    EXPECT_THAT(names(units), ElementsAre("t", "u", "i"));
    EXPECT_EQ(column(units, "u").unit, "mV");
}

TEST(TextFile, TimesThatAreNumberedHaveChannelsOfTheirOwn) {
    for (const char* text :
         {"t1 [s];a;t2 [ms];b\n0;1;0;5\n1;2;20;6\n2;3;;\n", "t [s];a;t [s];b\n0;1;0;5\n1;2;0,5;6\n2;3;;\n"}) {
        const TextFile file = read(text);
        ASSERT_EQ(file.groups.size(), 2u) << text;
        EXPECT_EQ(file.groups[1].table.lines.size(), 2u) << text;
        EXPECT_THAT(column(file, "b", 1).values, ElementsAre(5, 6)) << text;
    }
    EXPECT_EQ(read("t [s];t1;t2\n0;20;21\n1;22;23\n2;24;25\n").groups.size(), 1u) << "temperatures";
}

TEST(TextFile, BlanksPartColumnsOfDecimalCommas) {
    const TextFile file = read("t u\n0,0 0,0\n0,5 1,25\n1,0 2,5\n");
    EXPECT_THAT(names(file), ElementsAre("t", "u"));
    EXPECT_THAT(column(file, "u").values, ElementsAre(0, 1.25, 2.5));
}

TEST(TextFile, WordsAloneAreNoMeasurement) {
    EXPECT_THAT(faultOf("{\"t\":a,\"u\":b}\n{\"t\":c,\"u\":d}\n{\"t\":e,\"u\":f}\n"), HasSubstr("no rows of numbers"));
}

TEST(TextFile, APreambleMayBeLongerThanWhatIsLookedAtFirst) {
    std::string text;
    for (int i = 0; i < 400; ++i) text += fmt::format("Param{}: {}\n", i, 3 * i);
    text += "t [s],u [V]\n0,1\n1,2.5\n2,4\n";
    EXPECT_THAT(column(read(text), "u").values, ElementsAre(1, 2.5, 4));
}

// ---- preambles ----

TEST(TextFile, TakesNamesAndUnitsFromBehindAPreamble) {
    const TextFile file = read(
        "Model,X1\nFirmware,1.28.4.8\nHorizontal Units,s\nSample Interval,0.5\nRecord Length,3\nVertical Units,V,A\n"
        "Vertical Scale,4,4\n,,\n,,\nLabel,supply,inrush\nTIME,CH1,CH2\n-0.5,0,1\n0,12,2\n+5.0e-01,12,3\n");
    EXPECT_THAT(names(file), ElementsAre("TIME", "CH1", "CH2"));
    EXPECT_EQ(column(file, "CH2").unit, "A");
    EXPECT_EQ(column(file, "TIME").unit, "s");
    EXPECT_EQ(file.groups[0].comments[1], "supply");
    EXPECT_THAT(timeOf(file), ElementsAre(-0.5, 0, 0.5));
}

TEST(TextFile, MakesTheTimeOfACounterWithStartAndIncrementBesideTheHeader) {
    const TextFile file =
        read("X,CH1,CH2,Start,Increment,\nSequence,Volt,Volt,-4.0e-03,5.0e-04\n0,1,2,\n1,3,4,\n2,5,6,\n");
    EXPECT_THAT(names(file), ElementsAre("time", "X", "CH1", "CH2"));
    EXPECT_THAT(timeOf(file),
                ElementsAre(DoubleNear(-0.004, 1e-12), DoubleNear(-0.0035, 1e-12), DoubleNear(-0.003, 1e-12)));
    EXPECT_EQ(column(file, "CH1").unit, "Volt");
    EXPECT_EQ(column(file, "X").unit, "");
}

TEST(TextFile, ReadsFactsThatStandInCellsOfTheHeader) {
    const TextFile file = read("CH1(V),CH2(V),t0 = -0.002, tInc = 0.001,\n1.5,2.5,,,\n3.5,4.5,,,\n");
    EXPECT_THAT(names(file), ElementsAre("time", "CH1", "CH2"));
    EXPECT_THAT(timeOf(file), ElementsAre(-0.002, -0.001));
}

TEST(TextFile, MakesTheTimeOfASampleRateInAComment) {
    const TextFile file = read("#Sample rate: 40 kHz\n#Date: 2021-04-14\nu (V),i (A)\n1.5,2.5\n3.5,4.5\n2.5,4\n");
    EXPECT_THAT(timeOf(file), ElementsAre(0, DoubleNear(2.5e-5, 1e-15), DoubleNear(5e-5, 1e-15)));
    EXPECT_EQ(file.start, "2021-04-14T00:00:00");
}

TEST(TextFile, ReadsAHeaderOfTheLabelledKind) {
    const TextFile file = read(
        "Measurement\t\nSeparator\tTab\nDecimal_Separator\t.\nX_Columns\tOne\n***End_of_Header***"
        "\t\n\t\nChannels\t2\t\t\n"
        "Samples\t3\t3\t\nY_Unit_Label\tVolts\tAmps\t\nX0\t0.0\t0.0\t\nDelta_X\t0.01\t0.01\t\n***End_of_Header***"
        "\t\t\t\n"
        "X_Value\tsupply\tcurrent\tComment\n0.00\t1.5\t0.1\t\n0.01\t1.6\t0.2\t\n0.02\t1.7\t0.3\t\n");
    EXPECT_THAT(file.groups[0].table.names(), testing::IsSupersetOf({"X_Value", "supply", "current"}));
    EXPECT_EQ(column(file, "supply").unit, "Volts");
    EXPECT_EQ(column(file, "current").unit, "Amps");
    EXPECT_THAT(timeOf(file), ElementsAre(0, 0.01, 0.02));
}

TEST(TextFile, SaysThatAPreambleAndTheTimeDiffer) {
    EXPECT_THAT(told("Sample Interval,0.001\nTime (s),u (V)\n0,1\n0.002,2\n0.004,3\n0.006,1\n"),
                HasSubstr("tell 0.001 s"));
    EXPECT_THAT(told("Sample Interval,0.002\nTime (s),u (V)\n0,1\n0.002,2\n0.004,3\n0.006,1\n"),
                testing::Not(HasSubstr("tell")));
}

TEST(TextFile, ReadsAQuotedRecorderWithAnEmptyColumnOfText) {
    const TextFile file = read(
        "\"File name\",\"W.CSV\",\"V 1\"\n\"Trigger Time\",\"'12-07-01 "
        "09:14:03\"\n\"Ch\",\"Mode\",\"Range\",\"Comment\"\n"
        "\"CH-5\",\"Voltage\",\"100V\",\"supply\"\n\"Time\",\"CH-5[V]\",\"CH-7[C]\",\"Source\",\"Event\",\n"
        "0.0E+00, 2.9E-03, 3.58E+01,\"\",0,\n1.0E-01,-2.8E-03, 3.60E+01,\"\",0,\n2.0E-01, 6.9E-03, 3.61E+01,\"\",0,\n");
    EXPECT_THAT(column(file, "CH-5").values, ElementsAre(2.9e-3, -2.8e-3, 6.9e-3));
    EXPECT_EQ(column(file, "CH-7").unit, "degC");
    EXPECT_THAT(timeOf(file), ElementsAre(0, 0.1, 0.2));
    EXPECT_EQ(file.start, "2012-07-01T09:14:03");
}

TEST(TextFile, SkipsATesterPreambleAndLeavesWordsAside) {
    const TextFile file = read(
        "Test Name,run\nTest Date,4/10/2017 1:51:36 PM\n,\nNotes,  5.25b, MDB\n\n"
        "Exclude,Total Time,Loop,Loop,Step time,Current,Mode,Clock,Data,\n"
        "No,1.0,1,1,1.0,-0.04,REST,4/10/2017 1:51:37 PM,, \nNo,2.0,1,1,2.0,-0.04,REST,4/10/2017 1:51:38 PM,S, \n"
        "No,2.1,1,1,.1,-179.98,DCHG,4/10/2017 1:51:38 PM,, \nNo,2.2,1,1,.2,5.7e-042,DCHG,4/10/2017 1:51:38 PM,, \n");
    EXPECT_THAT(timeOf(file), ElementsAre(1, 2, 2.1, 2.2));
    EXPECT_THAT(column(file, "Step time").values, ElementsAre(1, 2, 0.1, 0.2));
    EXPECT_THAT(column(file, "Current").values, ElementsAre(-0.04, -0.04, -179.98, 5.7e-42));
    EXPECT_TRUE(file.groups[0].table.find("Loop_2"));
}

TEST(TextFile, NeverTakesRowsForAPreamble) {
    EXPECT_THAT(faultOf("t;u;i\n0;1;2\n1;x;3\n2;1;2\n3;1;2\n4;1;2\n5;1;2\n"), HasSubstr("'x' in column 'u'"));
    EXPECT_THAT(faultOf("t;u;i\n0;1;2\n1;5\n2;1;2\n3;1;2\n4;1;2\n5;1;2\n"), HasSubstr("this row has 2 cells"));
}

TEST(TextFile, ReadsNumbersOfChannelsOverTheirUnits) {
    const TextFile file = read("x-axis,1,2\nsecond,Volt,Volt\n-1.0e-3,0.1,0.2\n0,0.3,0.4\n1.0e-3,0.3,0.4\n");
    EXPECT_THAT(names(file), ElementsAre("x-axis", "1", "2"));
    EXPECT_EQ(column(file, "2").unit, "Volt");
    EXPECT_THAT(timeOf(file), ElementsAre(-0.001, 0, 0.001));
    EXPECT_THAT(timeOf(read("Record Length,7000\nsecond,Volt\n-0.5,0.1\n0,0.3\n")), ElementsAre(-0.5, 0));
}

TEST(TextFile, ReadsKeysWithoutAHeaderAndAnEmptyFirstColumn) {
    const TextFile file = read(
        "\"Header Size\",16\n\"TraceName\",\"CH1\",\"CH2\"\n\"VUnit\",\"V\",\"A\"\n\"HResolution\",1.0E-3,1.0E-3\n"
        "\"HOffset\",-2.0E-3,-2.0E-3\n\"HUnit\",\"s\",\"s\"\n\"PhaseShift\",0,0\n,1.5,2.5\n,1.6,2.6\n,1.7,2.7\n");
    EXPECT_THAT(timeOf(file), ElementsAre(-0.002, DoubleNear(-0.001, 1e-15), DoubleNear(0, 1e-15)));
    EXPECT_EQ(column(file, "CH2").unit, "A");
    EXPECT_THAT(column(file, "CH1").values, ElementsAre(1.5, 1.6, 1.7));
}

TEST(TextFile, AKeyWithOneValueTellsNothingOfSeveralColumns) {
    const TextFile file = read("Interval unit,ms\nunit,ms\nDevice,ABC\nTime,Voltage,Current\n0,1,2\n1,2,3\n2,3,4\n");
    EXPECT_THAT(names(file), ElementsAre("Time", "Voltage", "Current"));
    EXPECT_EQ(column(file, "Voltage").unit, "");
    EXPECT_THAT(file.groups[0].comments, ElementsAre("", "", ""));
}

TEST(TextFile, AChannelInMillisecondsBesideAClockKeepsItsNameFromAPreamble) {
    const TextFile file =
        read("Name,Zeit,cycle,U\nEinheit,hh:mm:ss,ms,V\n,10:00:00,10,1\n,10:00:01,12,2\n,10:00:02,11,3\n");
    EXPECT_THAT(names(file), ElementsAre("Zeit", "cycle", "U"));
    EXPECT_THAT(column(file, "cycle").values, ElementsAre(10, 12, 11));
}

TEST(TextFile, TakesUnitsBelowTheNamesThoughColumnsOfWordsHaveNone) {
    const TextFile file = read(
        "Number,Date&Time,ms,CH1,CH2,Alarm1,Alarm2,Out\nNO.,Time,ms,V,degC,A1,A2,A3\n"
        "1,2024/06/15 10:30:00,0,+12.0,+20.0,LL,LL,LL\n2,2024/06/15 10:30:00,100,+12.1,+20.1,LL,LL,LL\n");
    EXPECT_EQ(column(file, "CH1").unit, "V");
    EXPECT_EQ(column(file, "CH2").unit, "degC");
    EXPECT_THAT(timeOf(file), ElementsAre(0, 0.1));
}

TEST(TextFile, FindsNamesAboveUnitsAndSettings) {
    const TextFile file = read(
        "CATMAN\nChannels: 2\n\nTime  1 - default\tForce\ns\tkN\n15.06.2024 10:30:00\t15.06.2024 10:30:00\n"
        "SR=10\tSR=10\n0,0\t1,5\n0,1\t2,5\n0,2\t3,5\n");
    EXPECT_THAT(names(file), ElementsAre("Time  1 - default", "Force"));
    EXPECT_EQ(column(file, "Force").unit, "kN");
    EXPECT_THAT(timeOf(file), ElementsAre(0, 0.1, 0.2));
}

TEST(TextFile, ReadsRowsOfTheHeaderByTheKeysInFrontOfThem) {
    const TextFile file = read(
        "Name;Time;n_Mot;M_Mot\nDescription;Messzeit;Drehzahl;Moment\nUnit;s;1/min;Nm\nSource;ETAS;CAN;CAN\n"
        ";0,0;900,5;1,1\n;0,1;901,5;1,2\n");
    EXPECT_THAT(names(file), ElementsAre("Time", "n_Mot", "M_Mot"));
    EXPECT_EQ(column(file, "M_Mot").unit, "Nm");
    EXPECT_EQ(file.groups[0].comments[1], "Drehzahl; CAN");
}

TEST(TextFile, AColumnOfRemarksMayHaveNoCells) {
    const std::string head = "X_Value\tU\tI\tComment\n";
    EXPECT_THAT(names(read(head + "0\t1\t2\n1\t3\t4\n2\t5\t6\tmarker\n3\t7\t8\n")), ElementsAre("X_Value", "U", "I"));
    const TextFile counted = read("Delta_X\t0.5\t0.5\n" + head + "\t1\t2\n\t3\t4\n\t5\t6\n");
    EXPECT_THAT(names(counted), ElementsAre("time", "U", "I"));
    EXPECT_THAT(timeOf(counted), ElementsAre(0, 0.5, 1));
    EXPECT_THAT(faultOf("a\tb\tc\td\n0\t1\t2\n1\t3\t4\n"), HasSubstr("3 cells, the header has 4"));
}

TEST(TextFile, TakesUnitsOfChannelsFromKeysWithTheirNames) {
    const TextFile file =
        read("Vertical Units,CH1:V,CH2:A\nHorizontal Units,s\nSource,CH1,CH2\nSecond,Value,Value\n-0.1,1,2\n0,3,4\n");
    EXPECT_EQ(column(file, "CH1").unit, "V");
    EXPECT_EQ(column(file, "CH2").unit, "A");
}

TEST(TextFile, TellsTheStartThatStandsBelowTheNames) {
    EXPECT_EQ(read("\"TraceName\",\"CH1\"\n\"VUnit\",\"V\"\n\"HResolution\",1.0E-03\n\"Date\",\"2024/06/15\"\n"
                   "\"Time\",\"10:30:00.5\"\n\n,1.5\n,2.5\n,3.5\n")
                  .start,
              "2024-06-15T10:30:00.5");
}

TEST(TextFile, LeavesRowsOfFiguresBehindTheTableAside) {
    const std::string table = "Time [s],U [V]\n0,1\n1,2\n2,3\n";
    EXPECT_THAT(timeOf(read(table + "\nMin,1\nMax,3\n")), ElementsAre(0, 1, 2));
    EXPECT_THAT(told(table + "\nMin,1\nMax,3\n"), HasSubstr("are left out"));
    EXPECT_THAT(faultOf(table + "x,1\n"), HasSubstr("'x'"));
    EXPECT_THAT(faultOf(table + "\nChannels,2\nX,Y\n0,1\n1,2\n"), HasSubstr("Another table"));
}

TEST(TextFile, ReadsLinesThatEndWithAReturnAloneInOnePass) {
    std::string text = "t,u\r";
    for (int i = 0; i < 200'000; ++i) text += std::to_string(i) + ",1\r";
    EXPECT_EQ(timeOf(read(text)).size(), 200'000u);
}

TEST(TextFile, ReadsColumnsThatBlanksPartWithUnitsInTheHeader) {
    const TextFile file = read("Time (s)   Motor speed (rpm)   T (degC)\n0.0   1500.5   20\n0.1   1501.5   21\n");
    EXPECT_THAT(names(file), ElementsAre("Time", "Motor speed", "T"));
    EXPECT_EQ(column(file, "Motor speed").unit, "rpm");
    EXPECT_THAT(names(read("Time [s] u [V]\n0.0 1.5\n0.1 1.6\n")), ElementsAre("Time", "u"));
}

TEST(TextFile, LosesNoRowsInFrontOfAFaultyOne) {
    std::string rows;
    for (int i = 4; i < 60; ++i) rows += fmt::format("{},{}\n", i, i * 0.5);
    EXPECT_THAT(faultOf("t,u\n0,1.5\n1,2.5\nerror,\n" + rows), HasSubstr("test.csv:4"));
    EXPECT_THAT(faultOf("t,u\n0,1.5\n1,2.5\n\nt,v\n" + rows),
                HasSubstr("the lines 2 to 3 are a table of the same shape"));
    ReadOptions options;
    options.skip = 3;
    EXPECT_EQ(read("t,u\n0,1.5\n1,2.5\n\nt,v\n" + rows, options).groups[0].table.rows(), 56u);
}

// ---- header rows ----

TEST(TextFile, ReadsNamesDescriptionsTypesAndUnits) {
    const TextFile file = read(
        "time\tn\tT\nf8\tf8\tf8\nclock\tspeed of the shaft\thousing\ns\tU/min\t\xC2\xB0"
        "C\n0\t1500\t20.5\n1\t1501\t20.7\n");
    EXPECT_THAT(names(file), ElementsAre("time", "n", "T"));
    EXPECT_EQ(column(file, "n").unit, "U/min");
    EXPECT_THAT(file.groups[0].comments[1], HasSubstr("speed of the shaft"));
}

TEST(TextFile, ReadsBracketsBelowTheNamesAndABlankLine) {
    const TextFile file = read(
        "Time;Channel A;Channel "
        "B\n(ms);(V);(V)\n\n-0,005;12,1;11,4\n0,0;12,1;-\xE2\x88\x9E\n0,005;11,5;\xE2\x88\x9E\n0,01;11,2;10,5\n");
    EXPECT_EQ(column(file, "Time").unit, "ms");
    EXPECT_EQ(column(file, "Channel B").blanks.size(), 2u);
    EXPECT_TRUE(std::isnan(column(file, "Channel B").values[1]));
    EXPECT_THAT(column(file, "Channel B").values[3], 10.5);
    EXPECT_THAT(told("t;u\n0;1\n1;OL\n2;1\n"), HasSubstr("beyond the range of its instrument in line 3"));
}

TEST(TextFile, FindsTheUnitBehindACommaInAQuotedName) {
    const TextFile file = read(
        "\"Plot Title: 1\"\n\"#\",\"Date Time, GMT-05:00\",\"Temp, \xC2\xB0"
        "C (LBL: heater)\",\"Host Connected\",\"End\"\n"
        "1,03/12/22 12:59:50 PM,21.4,Logged,\n2,03/12/22 01:00:00 PM,21.5,,\n3,03/12/22 01:00:10 PM,21.6,,Logged\n");
    EXPECT_EQ(column(file, "Temp (LBL: heater)").unit,
              "\xC2\xB0"
              "C");
    EXPECT_THAT(timeOf(file), ElementsAre(0, 10, 20));
}

TEST(TextFile, ObeysWhatIsToldOfTheHeader) {
    ReadOptions options;
    options.skip = 2;
    options.header = 2;
    options.hasUnitsRow = true;
    const TextFile file = read("junk;1;2\n5;5;5\nt;u;v\ns;furlong;V\n0;1;2\n1;2;3\n", options);
    EXPECT_THAT(names(file), ElementsAre("t", "u", "v"));
    EXPECT_EQ(column(file, "u").unit, "furlong");
    options = {};
    options.header = 0;
    EXPECT_EQ(read("0;1\n1;2\n", options).groups[0].table.rows(), 2u);
}

// ---- numbers ----

TEST(TextFile, AsksWhereAMarkMayBeDecimalOrBetweenThousands) {
    const std::string fault = faultOf("t;p\n1;1,234\n2;1,250\n3;2,125\n");
    EXPECT_THAT(fault, HasSubstr("'1,234' may be 1.234 or 1234"));
    EXPECT_THAT(fault, HasSubstr("\"decimal\": \",\""));
    EXPECT_THAT(fault, HasSubstr("\"thousands\": \",\""));
    ReadOptions decimals, thousands;
    decimals.decimal = ',';
    thousands.thousands = ',';
    EXPECT_THAT(column(read("t;p\n1;1,234\n2;1,250\n", decimals), "p").values, ElementsAre(1.234, 1.25));
    EXPECT_THAT(column(read("t;p\n1;1,234\n2;1,250\n", thousands), "p").values, ElementsAre(1234, 1250));
}

TEST(TextFile, AsksWhereTheOpenMarkComesUpLate) {
    std::string text = "t;p\n";
    for (int i = 0; i < 600; ++i) text += fmt::format("{};{}\n", i, 300 + i);
    EXPECT_THAT(faultOf(text + "600;1,200\n601;1,201\n"), HasSubstr("'1,200' may be 1.2 or 1200"));
}

TEST(TextFile, KnowsAMarkBySeveralOfThem) {
    EXPECT_THAT(column(read("t;p\n0,5;1.234,5\n1,0;999,25\n"), "p").values, ElementsAre(1234.5, 999.25));
    EXPECT_THAT(column(read("t;p\n0;1,234,567\n1;12,345\n"), "p").values, ElementsAre(1234567, 12345));
    EXPECT_THAT(column(read("t;p\n0;1'234.5\n1;12\n"), "p").values, ElementsAre(1234.5, 12));
    EXPECT_THAT(column(read("t;p\n0,1;1\xC2\xA0"
                            "234,5\n1,0;12\n"),
                       "p")
                    .values,
                ElementsAre(1234.5, 12));
    EXPECT_THAT(column(read("t,p\n0,\"1,234.5\"\n1,12\n"), "p").values, ElementsAre(1234.5, 12));
    EXPECT_THAT(column(read("t;p\n0;1.234\n1;1234.5\n"), "p").values, ElementsAre(1.234, 1234.5));
}

TEST(TextFile, ReadsOverflowsSignsApartAndExponents) {
    const TextFile file = read(
        "t,u,v\n0,9.9E37,+  23.5\n1,+OVER,-   0.5\n2,1.5D+01,-----\n3,\xE2\x88\x92"
        "2.5,1e3\n");
    const Column& u = column(file, "u");
    EXPECT_TRUE(std::isnan(u.values[0]) && std::isnan(u.values[1]));
    EXPECT_EQ(u.values[2], 15);
    EXPECT_EQ(u.values[3], -2.5);
    EXPECT_EQ(column(file, "v").values[0], 23.5);
    EXPECT_EQ(column(file, "v").values[1], -0.5);
    EXPECT_EQ(u.blanks.size(), 2u);
}

TEST(TextFile, ReadsUnitsInTheCells) {
    const TextFile file = read("Time,n,T\n0.0,812.5 rpm,84 degC\n0.1,815.0 rpm,84 degC\n");
    EXPECT_THAT(column(file, "n").values, ElementsAre(812.5, 815));
    EXPECT_EQ(column(file, "n").unit, "rpm");
    EXPECT_THAT(column(read("t;u\n0;500 mV\n1;1,5 V\n"), "u").values, ElementsAre(500, 1500));
    EXPECT_THAT(faultOf("t;u\n0;500 mV\n1;1,5 A\n"), HasSubstr("in 'mV' and in 'A'"));
}

TEST(TextFile, ConvertsRowByRowWhereAColumnTellsTheUnit) {
    const TextFile file = read("No,Time,Mode,Value,Unit\n49,0.2,DC,-0.23,mV\n50,0.4,DC,612,mV\n51,0.6,DC,1.205,V\n");
    EXPECT_THAT(column(file, "Value").values,
                ElementsAre(DoubleNear(-0.00023, 1e-12), DoubleNear(0.612, 1e-12), 1.205));
    EXPECT_EQ(column(file, "Value").unit, "V");
    EXPECT_THAT(faultOf("Time,Value,Unit\n0.2,-0.23,mV\n0.4,612,A\n"), HasSubstr("cannot be converted"));
}

TEST(TextFile, TellsOfTwiceAsManyCellsAsNames) {
    const std::string fault = faultOf("Channel 1,Channel 2\n1,75754,1,4548\n1,4844,1,5895\n");
    EXPECT_THAT(fault, HasSubstr("test.csv:2"));
    EXPECT_THAT(fault, HasSubstr("twice as many"));
    EXPECT_THAT(faultOf("time,Torque, Request,Torque, Actual,speed\n0.00,0.0,0.1,0\n0.01,5.0,0.4,2\n"),
                HasSubstr("A name with a comma needs quotation marks"));
}

// ---- time ----

TEST(TextFile, JoinsDateAndClockOverMidnight) {
    const TextFile file =
        read("Date,Time,T\n2026-01-01,23:59:59.500,20.5\n2026-01-02,00:00:00.000,20.6\n2026-01-02,00:00:00.500,20.7\n");
    EXPECT_THAT(timeOf(file), ElementsAre(0, 0.5, 1));
    EXPECT_EQ(file.start, "2026-01-01T23:59:59.5");
    EXPECT_EQ(column(file, "Time").unit, "s");
    EXPECT_FALSE(file.groups[0].table.find("Date"));
}

TEST(TextFile, AddsADayWhereAClockPassesMidnight) {
    const TextFile file = read("Uhrzeit;T\n23:59:59;20,5\n00:00:00;20,6\n00:00:01;20,7\n");
    EXPECT_THAT(column(file, "Uhrzeit").values, ElementsAre(0, 1, 2));
    EXPECT_THAT(told("Uhrzeit;T\n23:59:59;20,5\n00:00:00;20,6\n"), HasSubstr("passes midnight in line 3"));
}

TEST(TextFile, KeepsElapsedTimes) {
    EXPECT_THAT(timeOf(read("Elapsed time,T\n01:00:00.5,20\n01:00:01.0,21\n")), ElementsAre(3600.5, 3601));
    EXPECT_THAT(timeOf(read("Time,T\n00:00:00.5,20\n00:00:01.0,21\n")), ElementsAre(0.5, 1));
}

TEST(TextFile, AddsAColumnOfMilliseconds) {
    const TextFile file = read(
        "NO.,Time,ms,CH1\n1,2020-01-01 10:00:00,0,+  23.5\n2,2020-01-01 10:00:00,500,+  23.6\n3,2020-01-01 "
        "10:00:01,0,+  23.7\n");
    EXPECT_THAT(timeOf(file), ElementsAre(0, 0.5, 1));
}

TEST(TextFile, LeavesAChannelInMillisecondsBesideAClockAsItIs) {
    const TextFile file =
        read("Time,CycleTime [ms]\n2020-01-01 10:00:00,10\n2020-01-01 10:00:01,12\n2020-01-01 10:00:02,11\n");
    EXPECT_THAT(timeOf(file), ElementsAre(0, 1, 2));
    EXPECT_THAT(column(file, "CycleTime").values, ElementsAre(10, 12, 11));
}

TEST(TextFile, AsksForTheOrderOfDayAndMonthWhereItMatters) {
    // within one day either order gives the same time
    EXPECT_THAT(timeOf(read("Time,T\n03/04/2024 10:00:00,1\n03/04/2024 10:00:01,2\n")), ElementsAre(0, 1));
    EXPECT_EQ(read("Time,T\n03/04/2024 10:00:00,1\n03/04/2024 10:00:01,2\n").start, "");
    const std::string over = "Time,T\n03/04/2024 23:00:00,1\n04/04/2024 10:00:00,2\n";
    EXPECT_THAT(faultOf(over), HasSubstr("the day or the month in front"));
    ReadOptions options;
    options.timeFormat = "%d/%m/%Y %H:%M:%S";
    EXPECT_THAT(timeOf(read(over, options)), ElementsAre(0, 11 * 3600));
    EXPECT_EQ(read(over, options).start, "2024-04-03T23:00:00");
}

TEST(TextFile, AsksForMinutesOrHours) {
    EXPECT_THAT(faultOf("Time,T\n10:30,1\n10:31,2\n"), HasSubstr("hours and minutes or minutes and seconds"));
    ReadOptions options;
    options.timeFormat = "%M:%S";
    EXPECT_THAT(timeOf(read("Time,T\n10:30,1\n10:31,2\n", options)), ElementsAre(0, 1));
    EXPECT_THAT(timeOf(read("Time [hh:mm],T\n10:30,1\n10:31,2\n")), ElementsAre(0, 60));
}

TEST(TextFile, ReadsZonesAndAsksForSummerTime) {
    EXPECT_THAT(timeOf(read("t,T\n2024-10-27T02:59:59+02:00,1\n2024-10-27T02:00:00+01:00,2\n")), ElementsAre(0, 1));
    std::string text = "Time;T\n";
    for (const char* clock : {"02:59:58", "02:59:59", "02:00:00", "02:00:01"})
        text += fmt::format("27.10.2024 {};1\n", clock);
    EXPECT_THAT(faultOf(text), HasSubstr("goes back by an hour"));
    ReadOptions options;
    options.timeZone = "Europe/Berlin";
    EXPECT_THAT(timeOf(read(text, options)), ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(
        faultOf("Time;T\n31.03.2024 01:59:58;1\n31.03.2024 01:59:59;1\n31.03.2024 03:00:00;1\n31.03.2024 03:00:01;1\n"),
        HasSubstr("a pause, or summer time"));
    options.timeZone = "Europe/Nowhere";
    EXPECT_THAT(faultOf(text, options), HasSubstr("is not known"));
}

TEST(TextFile, AsksForTheTimeOfRowsThatAreOnlyCounted) {
    EXPECT_THAT(told("X,CH1\n0,1.5\n1,2.5\n2,3.5\n"), HasSubstr("'X' counts the rows"));
    EXPECT_THAT(told("X,CH1\n0,1.5\n1,2.5\n2,3.5\n"), HasSubstr("\"time_format\": \"0.001 s\""));
    EXPECT_TRUE(timeOf(read("X,CH1\n0,1.5\n1,2.5\n2,3.5\n")).empty());
    ReadOptions options;
    options.timeFormat = "2 kHz";
    EXPECT_THAT(timeOf(read("1.5,2.5\n2.5,3.5\n", options)), ElementsAre(0, 0.0005));
}

TEST(TextFile, LaysStampsWithTooFewDigitsOnAnEvenRaster) {
    std::string text = "Time (s),u\n";
    for (int i = 0; i < 400; ++i) text += fmt::format("{:.5e},{}\n", 12.3456 + 5e-6 * i, i);
    const TextFile file = read(text);
    const std::vector<double> time = timeOf(file);
    EXPECT_NEAR((time.back() - time.front()) / 399, 5e-6, 1e-10);
    EXPECT_NEAR(time[200], 12.3456 + 5e-6 * 200, 1e-5);
    EXPECT_THAT(told(text), HasSubstr("too few digits"));
}

TEST(TextFile, SpreadsSingleRepeatedStampsAndKeepsFaults) {
    std::string text = "t [ms],u\n";
    for (int i = 0; i < 100; ++i) text += fmt::format("{},{}\n", i == 40 || i == 41 ? 39 : i, i);
    const std::vector<double> time = timeOf(read(text));
    for (int i = 0; i < 100; ++i) EXPECT_NEAR(time[static_cast<std::size_t>(i)], i, 1e-12);
    EXPECT_THAT(told(text), HasSubstr("lines 42 and 43"));
    // no room for the repeated one: a row too many, or a jump
    EXPECT_THAT(timeOf(read("t [ms],u\n0,0\n100,1\n200,2\n300,3\n300,4\n400,5\n500,6\n600,7\n700,8\n")),
                ElementsAre(0, 100, 200, 300, 300, 400, 500, 600, 700));
}

TEST(TextFile, SaysThatRowsComeOnChange) {
    EXPECT_THAT(told("Time [s],valve\n0,0\n1,1\n3,0\n7.25,1\n7.3,0\n12,0\n"), HasSubstr("\"interpolation\": \"hold\""));
}

TEST(TextFile, KnowsCountsSince1970) {
    const std::string text = "timestamp,u\n1718440200000,1\n1718440200010,2\n1718440200020,3\n";
    EXPECT_EQ(column(read(text), "timestamp").unit, "ms");
    EXPECT_THAT(told(text), HasSubstr("are taken for ms since 1970"));
}

TEST(TextFile, AsksWhetherATimeIsInSecondsOrDays) {
    const std::string text = "Time,u\n45458.4375,1\n45458.43751,2\n45458.43752,3\n";
    EXPECT_THAT(faultOf(text), HasSubstr("may be seconds or days"));
    ReadOptions options;
    options.timeFormat = "d";
    EXPECT_EQ(column(read(text, options), "Time").unit, "d");
    options.timeFormat = "s";
    EXPECT_EQ(column(read(text, options), "Time").unit, "s");
}

TEST(TextFile, SaysWhereTheHeaderStandsAgain) {
    EXPECT_THAT(faultOf("t,u\n0,1\n1,2\n2,3\nt,u\n0,1\n1,2\n"), HasSubstr("The header stands here again"));
}

// ---- rasters, encodings, ends ----

TEST(TextFile, PairsEachChannelWithTheTimeOnItsLeft) {
    const std::string text =
        "Name\tMotor.Voltage\tName\tMotor.Temp\nSymbolUnit\tV\tSymbolUnit\tdegC\nTime [ms]\tMotor.Voltage\tTime "
        "[ms]\tMotor.Temp\n"
        "0.0\t12.0\t3.0\t25.0\n5.0\t12.1\t23.0\t25.4\n10.0\t12.2\t\t\n15.0\t12.3\nEOF\n";
    const TextFile file = read(text);
    ASSERT_EQ(file.groups.size(), 2u);
    EXPECT_THAT(timeOf(file, 0), ElementsAre(0, 5, 10, 15));
    EXPECT_THAT(timeOf(file, 1), ElementsAre(3, 23));
    EXPECT_THAT(column(file, "Motor.Temp", 1).values, ElementsAre(25, 25.4));
    EXPECT_EQ(column(file, "Motor.Temp", 1).unit, "degC");
    const Outcome<Table> table = textTables(text, "test.csv");
    ASSERT_TRUE(table);
    ASSERT_EQ(table->others.size(), 1u);
    EXPECT_THAT(table->others[0]->find("Motor.Temp")->values, ElementsAre(25, 25.4));
}

TEST(TextFile, KeepsBlankCellsOfTwoRasters) {
    const TextFile file = read(
        "time;p;T\ns;mV;\xC2\xB0"
        "C\n0;;41.0\n0.07;5007;\n0.08;5056;\n0.09;;41.6\n");
    EXPECT_EQ(column(file, "p").blanks.size(), 2u);
    EXPECT_EQ(column(file, "T").values[3], 41.6);
}

TEST(TextFile, ReadsEncodings) {
    EXPECT_EQ(column(read("time,T [\xB0"
                          "C]\n0,1\n1,2\n"),
                     "T")
                  .unit,
              "\xC2\xB0"
              "C");
    EXPECT_EQ(column(read("time,U \x96 Br\xFC"
                          "cke [V]\n0,1\n1,2\n"),
                     "U \xE2\x80\x93 Br\xC3\xBC"
                     "cke")
                  .unit,
              "V");
    std::string wide;
    for (const char c : std::string("t,u\n0,1\n1,2\n")) wide += {c, '\0'};
    EXPECT_THAT(column(read(wide), "u").values, ElementsAre(1, 2));
    ReadOptions options;
    options.encoding = "ebcdic";
    EXPECT_THAT(faultOf("t,u\n0,1\n", options), HasSubstr("\"encoding\""));
}

TEST(TextFile, ReadsTablesOfTheModelicaLibrary) {
    const TextFile file = read("#1\ndouble Values(3,2)  # time, u\n 0 1\n 0.5 2\n 1 3");
    EXPECT_EQ(file.format, "Modelica table");
    EXPECT_THAT(timeOf(file), ElementsAre(0, 0.5, 1));
    EXPECT_THAT(column(file, "c2").values, ElementsAre(1, 2, 3));
    const std::string two = "#1\ndouble a(2,2)\n0 1\n1 2\ndouble b(2,2)\n0 3\n1 4\n";
    EXPECT_EQ(read(two).groups.size(), 2u);
    const Outcome<Table> table = textTables(two, "test.csv");
    ASSERT_TRUE(table);
    EXPECT_EQ(table->others.at(0)->columns.at(1).group, "b");
    EXPECT_THAT(faultOf("#1\ndouble a(3,2)\n0 1\n1 2\n"), HasSubstr("ends after 4 of 6"));
}

TEST(TextFile, ReadsSwitchesInWords) {
    const TextFile file = read("t,valve\n0,OFF\n1,ON\n2,off\n");
    EXPECT_THAT(column(file, "valve").values, ElementsAre(0, 1, 0));
    EXPECT_EQ(file.groups[0].statuses[1].size(), 2u);
}

TEST(TextFile, OutlivesEveryMutant) {
    const std::vector<std::string> seeds{
        "Model,X1\nVertical Units,V,A\nSample "
        "Interval,0.5\n,,\nLabel,supply,inrush\nTIME,CH1,CH2\n-0.5,0,1\n0,12,2\n+5.0e-01,12,3\n",
        "X,CH1,CH2,Start,Increment,\nSequence,Volt,Volt,-4.0e-03,5.0e-04\n0,1,2,\n1,3,4,\n2,5,6,\n",
        "Datum;Uhrzeit;T [\xB0"
        "C];Unit\n01.02.2024;23:59:59,5;1.234,5;mV\n02.02.2024;00:00:00,0;12,25;V\n",
        "\"#\",\"Date Time, GMT-05:00\",\"Temp, \xC2\xB0"
        "C (LBL: heater)\"\n1,03/12/22 12:59:50 PM,21.4\n2,03/12/22 01:00:00 PM,OL\n",
        "Time [ms]\tu\tTime [ms]\tT\n0.0\t12.0\t3.0\t25.0\n5.0\t12.1\t23.0\t25.4\n10.0\t12.2\t\t\nEOF\n",
        "#1\ndouble Values(3,2)  # time, u\n 0 1\n 0.5 2\n 1 3"};
    unsigned state = 7;
    const auto next = [&] { return state = state * 1664525u + 1013904223u, state >> 8; };
    for (int round = 0; round < 3000; ++round) {
        std::string text = seeds[next() % seeds.size()];
        for (unsigned changes = 1 + next() % 4; changes > 0; --changes) {
            const std::size_t at = next() % text.size();
            const std::string_view marks = ",;\t\n\r\"'#.:/- 0123456789eE\0\xFF\xB0PMZ()[]";
            switch (next() % 4) {
                case 0:
                    text[at] = marks[next() % marks.size()];
                    break;
                case 1:
                    text.insert(at, 1, marks[next() % marks.size()]);
                    break;
                case 2:
                    text.erase(at, 1 + next() % 12);
                    break;
                default:
                    text.insert(at, text.substr(next() % text.size(), next() % 40));
            }
            if (text.empty()) text = "x";
        }
        const Outcome<TextFile> file = readTextFile(text, "mutant.csv", {});
        if (!file) continue;
        for (const TextGroup& group : file->groups)
            for (std::size_t i = 0; i < group.kinds.size(); ++i) {
                const bool isWords = group.kinds[i] == CellKind::Words;
                EXPECT_EQ(isWords ? group.words[i].size() : group.table.columns[i].values.size(),
                          group.table.lines.size())
                    << text;
            }
        static_cast<void>(textTables(text, "mutant.csv"));
    }
}

TEST(TextFile, RefusesProse) {
    EXPECT_THAT(faultOf("This is a letter.\nIt has no numbers, only words.\nYours\n"), HasSubstr("no rows of numbers"));
}

TEST(TextFile, ANameMayHaveSeveralLines) {
    const TextFile file = read("\"Time\n[s]\",\"Motor\ncurrent [A]\"\n0,1\n1,2\n2,3\n");
    EXPECT_THAT(names(file), ElementsAre("Time", "Motor current"));
    EXPECT_EQ(column(file, "Motor current").unit, "A");
    EXPECT_THAT(file.found.english(), HasSubstr("data from line 4"));
    // a mark for inches opens nothing
    EXPECT_THAT(names(read("t;1/4\" pipe;u\n0;1;2\n1;2;3\n")), ElementsAre("t", "1/4\" pipe", "u"));
}

TEST(TextFile, AUnitWithASignStandsBehindABlank) {
    const TextFile file = read("Time\tTemp \u00B0C\tFlow l/min\tStage two\n0\t1\t2\t3\n1\t2\t3\t4\n");
    EXPECT_THAT(names(file), ElementsAre("Time", "Temp", "Flow", "Stage two"));
    EXPECT_EQ(column(file, "Temp").unit, "\u00B0C");
    EXPECT_EQ(column(file, "Flow").unit, "l/min");
}

TEST(TextFile, ATimeIsInTheUnitThatItsNameTells) {
    for (const auto& [name, unit] : {std::pair{"t_ms", "ms"}, {"time_us", "us"}, {"millis", "ms"}, {"t_s", "s"}}) {
        const std::string text = std::string(name) + ",u\n0,1\n10,2\n20,4\n";
        const TextFile file = read(text);
        ASSERT_EQ(file.groups.at(0).time, 0u) << name;
        EXPECT_EQ(column(file, name).unit, unit);
        EXPECT_EQ(told(text).find("as its name says") == std::string::npos, std::string(unit) == "s") << name;
    }
    ReadOptions seconds;
    seconds.timeFormat = "s";
    EXPECT_EQ(column(read("t_ms,u\n0,1\n10,2\n20,4\n", seconds), "t_ms").unit, "s") << "what is told holds";
}

TEST(TextFile, StampsOfAComputerAreATime) {
    const TextFile file = read("ts;u\n1709629200000;1\n1709629200100;2\n1709629200200;4\n");
    ASSERT_EQ(file.groups.at(0).time, 0u);
    EXPECT_EQ(column(file, "ts").unit, "ms");
}

TEST(TextFile, SaysThatTheTimeGoesBack) {
    EXPECT_THAT(told("t [s],u [V]\n3,1\n1,2\n2,3\n"), HasSubstr("column 't' goes back in line 3"));
}

TEST(TextFile, RowsOfFiguresBelowTheTableAreLeftOut) {
    const std::string text = "t [s],u [V]\n0,1\n1,2\n2,3\nMax,3\nMin,1,2\n";
    EXPECT_THAT(column(read(text), "u").values, ElementsAre(1, 2, 3));
    EXPECT_THAT(told(text), HasSubstr("'Max' stands in front"));
    // one row may be one that is damaged
    EXPECT_THAT(faultOf("t [s],u [V]\n0,1\n1,2\nx,3\n"), HasSubstr("'x' in column 't' is not a number"));
}

TEST(TextFile, ZerosBehindTheTextAreNotOfIt) {
    EXPECT_THAT(column(read(std::string("t,u\n0,1\n1,2\n") + std::string(100, '\0')), "u").values, ElementsAre(1, 2));
}

}  // namespace
}  // namespace analogon
