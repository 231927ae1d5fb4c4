#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>

#include "core/base/stop.hpp"
#include "core/measure/channel.hpp"
#include "core/measure/open/read_table.hpp"
#include "core/measure/table.hpp"
#include "core/measure/text/text_recording.hpp"

namespace analogon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Table read(std::string_view text, const ReadOptions& options = {}) {
    Outcome<Table> table = textTables(text, "test.csv", options);
    EXPECT_TRUE(table.hasValue()) << format(table.diagnostics());
    return table ? *table : Table{};
}

Diagnostic faultOf(std::string_view text) {
    const Outcome<Table> table = textTables(text, "test.csv");
    EXPECT_FALSE(table.hasValue());
    return table ? Diagnostic{} : table.diagnostics().front();
}

TEST(Csv, ReadsNamesUnitsAndValues) {
    const Table table = read("t [s],T_exhaust [degC],u\n0,18.05,1\n0.5,-2e1,2\n");
    EXPECT_THAT(table.names(), ElementsAre("t", "T_exhaust", "u"));
    EXPECT_EQ(table.columns[1].unit, "degC");
    EXPECT_EQ(table.columns[2].unit, "");
    EXPECT_THAT(table.columns[1].values, ElementsAre(18.05, -20.0));
    EXPECT_THAT(table.lines, ElementsAre(2, 3));
}

TEST(Csv, IsNotReadToItsEndWhereItIsStopped) {
    std::stop_source source;
    source.request_stop();
    const StopScope scope(source.get_token());
    EXPECT_THROW(static_cast<void>(textTables("t [s],u\n0,1\n1,2\n", "long.csv", {})), Stopped);
}

TEST(Csv, ReadsUnitsInEveryUsualWriting) {
    const Table table = read("t in s;T (degC);v [km/h];F / N;M/N.m;m/s;x (2)\n1;2;3;4;5;6;7\n");
    EXPECT_THAT(table.names(), ElementsAre("t", "T", "v", "F", "M", "m/s", "x (2)"));
    std::vector<std::string> units;
    for (const Column& column : table.columns) units.push_back(column.unit);
    EXPECT_THAT(units, ElementsAre("s", "degC", "km/h", "N", "N.m", "", ""));
}

TEST(Csv, ReadsSemicolonsDecimalCommaAndUnitsRow) {
    const Table table = read("t;U_M;w_out\r\ns;V;rad/s\r\n0;0;-0,0089\r\n0,02;1,5;0\r\n");
    EXPECT_EQ(table.columns[2].unit, "rad/s");
    EXPECT_THAT(table.columns[0].values, ElementsAre(0, 0.02));
    EXPECT_THAT(table.columns[2].values, ElementsAre(-0.0089, 0));
    EXPECT_THAT(table.lines, ElementsAre(3, 4));
}

TEST(Csv, TakesADimensionlessUnitInAUnitsRow) {
    const Table table = read("t,duty,x\ns,1,-\n0,0.5,3\n");
    EXPECT_EQ(table.columns[1].unit, "1");
    EXPECT_EQ(table.rows(), 1u);
}

TEST(Csv, FindsEachSeparator) {
    for (const char separator : {',', ';', '\t', '|', ' '}) {
        std::string text = "a,b,c\n1,2,3\n4,5,6\n";
        std::replace(text.begin(), text.end(), ',', separator);
        const Table table = read(text);
        ASSERT_EQ(table.columns.size(), 3u) << "separator " << static_cast<int>(separator);
        EXPECT_THAT(table.columns[2].values, ElementsAre(3, 6));
    }
}

TEST(Csv, SkipsCommentsByteOrderMarkAndBlankLines) {
    const Table table = read("\xEF\xBB\xBF# bench 4\n% run 7\n// x\n\nt,u\n0,1\n\n# pause\n1,2\n");
    EXPECT_THAT(table.columns[1].values, ElementsAre(1, 2));
    EXPECT_THAT(table.lines, ElementsAre(6, 9));
}

TEST(Csv, TakesACommentedHeader) {
    const Table table = read("# measured on Monday\n# t [s], u [V]\n0, 1\n1, 2\n");
    EXPECT_THAT(table.names(), ElementsAre("t", "u"));
    EXPECT_EQ(table.columns[1].unit, "V");
}

TEST(Csv, ReadsQuotedCellsAndDecimalCommasInThem) {
    const Table table = read("\"t, run\",\"say \"\"u\"\"\"\n\"0,5\",\"1,25\"\n");
    EXPECT_THAT(table.names(), ElementsAre("t, run", "say \"u\""));
    EXPECT_THAT(table.columns[1].values, ElementsAre(1.25));
}

TEST(Csv, NamesColumnsOfAFileWithoutHeader) {
    const Outcome<Table> table = textTables("0,1\n0.1,2\n", "test.csv");
    ASSERT_TRUE(table.hasValue());
    EXPECT_THAT(table->names(), ElementsAre("c1", "c2"));
    ASSERT_EQ(table.diagnostics().size(), 1u);
    EXPECT_EQ(table.diagnostics()[0].severity, Severity::Warning);
}

TEST(Csv, RenamesDuplicatesWithAWarning) {
    const Outcome<Table> table = textTables("time,u,u,u_2\n0,1,2,3\n", "test.csv");
    ASSERT_TRUE(table.hasValue());
    EXPECT_THAT(table->names(), ElementsAre("time", "u", "u_2", "u_2_2"));
    EXPECT_EQ(table.diagnostics().size(), 2u);
    EXPECT_EQ(table.diagnostics()[0].place.column, 8);
}

TEST(Csv, ReadsMissingAndInfiniteCellsAndKeepsTheirPlaces) {
    const Table table = read("time,u\n0,nan\n1,inf\n2,1e999\n3,-1.#IND\n4,\n5,NaN\n6,1e-400\n7,---\n8,-----\n");
    const Column& u = table.columns[1];
    EXPECT_TRUE(std::isnan(u.values[0]));
    EXPECT_TRUE(std::isinf(u.values[2]));
    EXPECT_EQ(u.values[6], 0);
    ASSERT_EQ(u.blanks.size(), 8u);
    EXPECT_EQ(u.blanks[4].row, 4u);
    EXPECT_EQ(u.blanks[4].position, 3);
    for (const std::size_t row : {7u, 8u})
        EXPECT_TRUE(std::isnan(u.values[row])) << "dashes where nothing was measured";
}

TEST(Csv, ReadsLatin1AndUtf16) {
    EXPECT_EQ(read("time,T [\xB0"
                   "C]\n0,1\n")
                  .columns[1]
                  .unit,
              "°C");
    std::string wide = "\xFF\xFE";
    for (const char c : std::string("t,u\n0,1\n")) wide += {c, '\0'};
    EXPECT_THAT(read(wide).columns[1].values, ElementsAre(1));
}

TEST(Csv, DropsTheEmptyColumnBehindATrailingSeparator) {
    EXPECT_EQ(read("t;u;\n0;1;\n1;2;\n").columns.size(), 2u);
    EXPECT_EQ(read("t,u\n0,1,\n1,2,\n").columns.size(), 2u);
}

TEST(Csv, NamesATextCellWithItsPlace) {
    const Diagnostic fault = faultOf("time,u\n0,1\n1, on\n");
    EXPECT_EQ(fault.message, "'on' in column 'u' is not a number");
    EXPECT_EQ(fault.place.line, 3);
    EXPECT_EQ(fault.place.column, 4);
    EXPECT_EQ(fault.place.lineText, "1, on");
    EXPECT_FALSE(fault.hint.empty());
}

TEST(Csv, NamesMixedDecimalMarks) {
    const Diagnostic fault = faultOf("time;u\n0,0;1.5\n0.1;2,5\n");
    EXPECT_EQ(fault.message, "'1.5' in column 'u' has a decimal point, line 2 has a decimal comma");
    EXPECT_EQ(fault.place.line, 2);
    EXPECT_EQ(fault.place.column, 5);
    EXPECT_THAT(faultOf("t;u\n0.5;1\n1.5;2,5\n").message, HasSubstr("line 2 has a decimal point"));
}

TEST(Csv, NamesRaggedRows) {
    const Diagnostic fewer = faultOf("t,u,y\n0,1,2\n1,2\n");
    EXPECT_EQ(fewer.message, "this row has 2 cells, the header has 3");
    EXPECT_EQ(fewer.place.line, 3);
    const Diagnostic more = faultOf("t,u\n0,5,1,5\n1,5,2,5\n");
    EXPECT_THAT(more.hint, HasSubstr("decimal marks"));
    EXPECT_EQ(more.place.column, 5);
}

TEST(Csv, RefusesOpenQuoteEmptyFileAndHeaderOnly) {
    const Diagnostic quote = faultOf("time,u\n0,\"1\n0.1,2\n");
    EXPECT_EQ(quote.place.line, 2);
    EXPECT_EQ(quote.place.column, 3);
    EXPECT_THAT(faultOf("").message, HasSubstr("empty"));
    EXPECT_THAT(faultOf("time,u\n").message, HasSubstr("no data rows"));
    EXPECT_THAT(faultOf(std::string_view("a\0b", 3)).message, HasSubstr("not a text file"));
}

TEST(Csv, ReadsMarksBetweenThousandsThatCanBeNothingElse) {
    EXPECT_THAT(read("t;u\n0;1,234.5\n").columns[1].values, ElementsAre(1234.5));
    EXPECT_THAT(faultOf("t;u\n0;0,5\n1;1,23.5\n").hint, HasSubstr("thousands"));
}

TEST(Csv, ObeysGivenOptions) {
    ReadOptions options;
    options.separator = ';';
    options.decimal = ',';
    options.hasUnitsRow = true;
    const Table table = read("t;u\ns;furlong\n0;1,5\n", options);
    EXPECT_EQ(table.columns[1].unit, "furlong");
    EXPECT_THAT(table.columns[1].values, ElementsAre(1.5));
}

TEST(Csv, WritesWhatItReads) {
    const Table table = read("t [s],\"a,b [V]\",c\n0,1,\n0.1,2.25,3\n");
    const Table again = read(writeCsv(table));
    EXPECT_EQ(again.names(), table.names());
    EXPECT_EQ(again.columns[1].unit, "V");
    EXPECT_EQ(again.columns[1].values, table.columns[1].values);
    EXPECT_TRUE(std::isnan(again.columns[2].values[0]));
}

TEST(Csv, EscapesFormulas) {
    EXPECT_EQ(csvCell("=cmd|' /C calc'!A0"), "\"'=cmd|' /C calc'!A0\"");
    EXPECT_EQ(csvCell("speed [rpm]"), "speed [rpm]");
    EXPECT_EQ(csvCell("a\"b,c"), "\"a\"\"b,c\"");
}

TEST(Csv, ReadsAMillionValuesFast) {
    std::string text = "t [s],a,b,c,d\n";
    for (int i = 0; i < 200000; ++i) text += fmt::format("{},{},0.25,{},-1.5e-3\n", i * 0.001, i * 0.37, i);
    const std::clock_t begin = std::clock();  // of this process: others do not count
    const Table table = read(text);
    const double took = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    EXPECT_EQ(table.rows(), 200000u);
    EXPECT_LT(took, 2.0);  // about 0.1 s in a release build
}

TEST(Csv, NamesTheFileThatCannotBeOpened) {
    const Outcome<Table> table = readTextTables("/nowhere/at all.csv", {});
    ASSERT_FALSE(table.hasValue());
    EXPECT_EQ(table.diagnostics()[0].place.file, "/nowhere/at all.csv");
}

TEST(Csv, MeetsTheExpectationsOfTheHostileFiles) {
    const std::filesystem::path root = ANALOGON_ROOT "/../shared/verification/hostile";
    if (!std::filesystem::exists(root)) GTEST_SKIP() << "the shared verification files are not here";
    std::ifstream manifest(root / "MANIFEST.csv");
    int checked = 0;
    for (std::string line; std::getline(manifest, line);) {
        if (!line.starts_with("csv/")) continue;
        const std::string file = line.substr(0, line.find(','));
        std::string expected = line.substr(line.find(',', file.size() + 1) + 1);
        expected = expected.substr(0, expected.find(','));
        const std::clock_t begin = std::clock();  // of this process: others do not count
        const Outcome<Table> table = readTable(root / file);
        bool rejected = !table;
        if (table && expected.starts_with("reject")) rejected = !readTime(*table, table->names().front());
        if (expected == "reject_or_warn") rejected = rejected || !table.diagnostics().empty();
        const double took = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        EXPECT_LT(took, 3.0) << file;
        if (expected.starts_with("reject")) {
            EXPECT_TRUE(rejected) << file;
        } else {
            EXPECT_TRUE(table.hasValue()) << file << ": " << format(table.diagnostics());
        }
        ++checked;
    }
    EXPECT_GE(checked, 16);
}

TEST(Csv, ReadsEveryMeasurementOfTheCasesAndRealData) {
    const std::filesystem::path shared = ANALOGON_ROOT "/../shared";
    if (!std::filesystem::exists(shared / "cases")) GTEST_SKIP() << "the shared cases are not here";
    int count = 0;
    for (const char* folder : {"cases", "data"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(shared / folder)) {
            if (entry.path().extension() != ".csv") continue;
            const Outcome<Table> table = readTable(entry.path());
            ASSERT_TRUE(table.hasValue()) << format(table.diagnostics());
            const Outcome<std::vector<double>> time = readTime(*table, table->names().front());
            EXPECT_TRUE(time.hasValue()) << format(time.diagnostics());
            ++count;
        }
    EXPECT_GE(count, 28);
}

TEST(Csv, KeepsItsMessagesShort) {
    const std::string longName(5'000'000, 'x');
    const Diagnostic name = faultOf("t," + longName + "\n0,1\n");
    EXPECT_THAT(name.message.english(), HasSubstr("a name of 5000000 bytes, more than 4096: 'xxx"));
    EXPECT_LT(format(name).size(), 1000u);
    const std::string shortName(4000, 'y');
    const Diagnostic cell = faultOf("t," + shortName + "\n0,1\n1," + longName + "\n");
    EXPECT_LT(format(cell).size(), 1000u);
    std::string same = "t";
    for (int i = 0; i < 10000; ++i) same += ",a";
    const Outcome<Table> table = textTables(same + "\n", "test.csv");
    EXPECT_LT(format(table.diagnostics()).size(), 2000u);
}

/// Each cell of a header is looked at in several ways (a number? a unit?): five million of them took ten seconds.
TEST(Csv, RefusesTooManyColumnsBeforeItLooksAtThem) {
    std::string names = "t", values = "0";
    for (int i = 0; i < 100'000; ++i) {
        names += ",c";
        values += ",1";
    }
    for (const std::string& line : {names, values})
        EXPECT_THAT(faultOf(line + "\n" + values + "\n" + values + "\n").message.english(),
                    HasSubstr("this line has 100001 columns, more than 100000"));
}

TEST(Csv, TellsOfManyColumnsOfOneNameInOneSentence) {
    const Outcome<Table> table = textTables("t,a,a,a,a,a,a,a,a\n0,1,2,3,4,5,6,7,8\n", "test.csv");
    ASSERT_TRUE(table);
    ASSERT_EQ(table.diagnostics().size(), 6u);
    EXPECT_EQ(table.diagnostics().back().message, "2 further columns have the name of another one");
    EXPECT_EQ(table->columns.back().name, "a_8");
}

TEST(Csv, RefusesMoreColumnsThanARecordingHas) {
    const std::string header(200'000, ',');
    EXPECT_THAT(faultOf("t" + header + "\n").message.english(), HasSubstr("200001 columns, more than 100000"));
}

TEST(Csv, SaysBeforeReadingThatThereIsNoMemoryForIt) {
    setenv("ANALOGON_MEMORY", "1", 1);
    std::string text = "t,u\n";
    for (int i = 0; i < 100'000; ++i) text += fmt::format("{},{}\n", i, i % 7);
    const Diagnostic fault = faultOf(text);
    unsetenv("ANALOGON_MEMORY");
    EXPECT_THAT(fault.message.english(), HasSubstr("rows and 2 columns would take"));
    EXPECT_EQ(fault.place.file, "test.csv");
}

}  // namespace
}  // namespace analogon
