#include "core/measure/xlsx/xlsx.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <quazip/quazip.h>
#include <quazip/quazipfile.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "core/measure/open/open_recording.hpp"
#include "core/measure/xlsx/cell_value.hpp"

namespace analogon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Xlsx : public testing::Test {
protected:
    ~Xlsx() override { std::filesystem::remove(file); }

    /// A workbook of one sheet; styles: 1 a date, 2 percent.
    Outcome<MeasurementFile> open(const std::string& rows) {
        QuaZip archive(QString::fromStdString(file.string()));
        archive.open(QuaZip::mdCreate);
        const auto put = [&](const char* name, const std::string& content) {
            QuaZipFile part(&archive);
            part.open(QIODevice::WriteOnly, QuaZipNewInfo(name));
            part.write(content.data(), static_cast<qint64>(content.size()));
            part.close();
        };
        put("xl/workbook.xml",
            R"(<workbook xmlns:r="r"><sheets><sheet name="Run" sheetId="1" r:id="rId1"/></sheets></workbook>)");
        put("xl/_rels/workbook.xml.rels",
            R"(<Relationships><Relationship Id="rId1" Target="worksheets/sheet1.xml"/></Relationships>)");
        put("xl/styles.xml",
            R"(<styleSheet><cellXfs><xf numFmtId="0"/><xf numFmtId="22"/><xf numFmtId="10"/></cellXfs></styleSheet>)");
        put("xl/worksheets/sheet1.xml", "<worksheet><sheetData>" + rows + "</sheetData></worksheet>");
        archive.close();
        return openRecording(file);
    }
    static std::string word(const std::string& cell, const std::string& text) {
        return "<c r=\"" + cell + "\" t=\"inlineStr\"><is><t>" + text + "</t></is></c>";
    }
    static std::string number(const std::string& cell, const std::string& value, int style = 0) {
        return "<c r=\"" + cell + "\" s=\"" + std::to_string(style) + "\"><v>" + value + "</v></c>";
    }
    static std::string row(int number, const std::string& cells) {
        return "<row r=\"" + std::to_string(number) + "\">" + cells + "</row>";
    }
    static std::vector<double> numbers(const MeasurementFile& recording, std::size_t group, std::size_t channel) {
        const Outcome<ChannelValues> values = readValues(recording, group, channel);
        EXPECT_TRUE(values) << format(values.diagnostics());
        return values ? values->numbers : std::vector<double>{};
    }

    std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("analogon-xlsx-" + std::to_string(getpid()) + ".xlsx");
};

TEST_F(Xlsx, EachColumnOfNumbersWrittenAsTextHasItsMark) {
    std::string rows = row(1, word("A1", "t [s]") + word("B1", "u [V]") + word("C1", "n [rpm]"));
    const char* times[] = {"0.5", "1.5", "2.5"};
    const char* volts[] = {"20,5", "21,25", "1.234,5"};
    const char* speeds[] = {"0.500", "0.625", "1.000"};  // no thousands begin with a zero
    for (int i = 0; i < 3; ++i) {
        const std::string r = std::to_string(i + 2);
        rows += row(i + 2, word("A" + r, times[i]) + word("B" + r, volts[i]) + word("C" + r, speeds[i]));
    }
    const Outcome<MeasurementFile> opened = open(rows);
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    EXPECT_THAT(numbers(*opened, 0, 0), ElementsAre(0.5, 1.5, 2.5));
    EXPECT_THAT(numbers(*opened, 0, 1), ElementsAre(20.5, 21.25, 1234.5));
    EXPECT_THAT(numbers(*opened, 0, 2), ElementsAre(0.5, 0.625, 1));
}

TEST_F(Xlsx, AMarkThatMayBeBothIsToldAndNotGuessed) {
    std::string rows = row(1, word("A1", "t [s]") + word("B1", "n [rpm]"));
    for (int i = 2; i < 6; ++i)
        rows += row(i, number("A" + std::to_string(i), std::to_string(i)) + word("B" + std::to_string(i), "1.234"));
    const Outcome<MeasurementFile> opened = open(rows);
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    EXPECT_EQ(opened->groups.at(0).channels.at(1).kind, ChannelKind::Text);
    std::string notes;
    for (const Text& note : opened->notes) notes += note.english();
    EXPECT_THAT(notes, HasSubstr("write them as numbers"));
}

TEST_F(Xlsx, AHeaderAndARowOfUnitsStandAboveTheData) {
    const Outcome<MeasurementFile> opened =
        open(row(1, word("A1", "Bench 3")) + row(3, word("A3", "t") + word("B3", "p")) +
             row(4, word("A4", "s") + word("B4", "bar")) + row(5, number("A5", "0") + number("B5", "1.5")) +
             row(6, number("A6", "1") + "<c r=\"B6\" t=\"e\"><v>#DIV/0!</v></c>") +
             row(7, number("A7", "2") + "<c r=\"B7\"><f>1+1</f><v>2</v></c>"));
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    const RecordedGroup& group = opened->groups.at(0);
    EXPECT_EQ(group.name, "Run");
    EXPECT_EQ(group.masterChannel, 0u);
    EXPECT_EQ(group.channels[1].name, "p");
    EXPECT_EQ(group.channels[1].unit, "bar");
    const std::vector<double> p = numbers(*opened, 0, 1);
    ASSERT_EQ(p.size(), 3u);
    EXPECT_EQ(p[0], 1.5);
    EXPECT_TRUE(std::isnan(p[1]));
    EXPECT_EQ(p[2], 2);
}

TEST_F(Xlsx, DatesAreSecondsSinceTheFirstAndALineBelowTheDataIsNone) {
    const Outcome<MeasurementFile> opened = open(row(1, word("A1", "when") + word("B1", "u [V]")) +
                                                 row(2, number("A2", "45458.4375", 1) + number("B2", "1")) +
                                                 row(3, number("A3", "45458.438194444447", 1) + number("B3", "2")) +
                                                 row(4, word("A4", "mean") + number("B4", "1.5")));
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    EXPECT_EQ(opened->start, "2024-06-15T10:30:00");
    EXPECT_THAT(numbers(*opened, 0, 0), ElementsAre(0, 60));
    EXPECT_THAT(numbers(*opened, 0, 1), ElementsAre(1, 2));
    std::string notes;
    for (const Text& note : opened->notes) notes += note.english();
    EXPECT_THAT(notes, HasSubstr("1 rows without a time"));
}

TEST_F(Xlsx, DaysWithoutTheFormOfADateAreNoSeconds) {
    const Outcome<MeasurementFile> opened =
        open(row(1, word("A1", "Zeit") + word("B1", "p")) + row(2, number("A2", "45356.41667") + number("B2", "1")) +
             row(3, number("A3", "45356.41668") + number("B3", "2")) +
             row(4, number("A4", "45356.41669") + number("B4", "3")));
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    EXPECT_EQ(opened->groups[0].channels[0].unit, "d");
    ASSERT_FALSE(opened->notes.empty());
    EXPECT_THAT(opened->notes.back().english(), HasSubstr("are taken for days"));
}

TEST_F(Xlsx, AClockPassesMidnight) {
    const Outcome<MeasurementFile> opened = open(row(1, word("A1", "Uhrzeit") + word("B1", "u [V]")) +
                                                 row(2, number("A2", "0.99998842592592595", 1) + number("B2", "1")) +
                                                 row(3, number("A3", "0", 1) + number("B3", "2")) +
                                                 row(4, number("A4", "1.1574074074074073E-5", 1) + number("B4", "3")));
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    const std::vector<double> time = numbers(*opened, 0, 0);
    ASSERT_EQ(time.size(), 3u);
    for (std::size_t i = 0; i < time.size(); ++i) EXPECT_NEAR(time[i], static_cast<double>(i), 1e-6);
    EXPECT_EQ(opened->groups.at(0).masterChannel, 0u);
}

TEST_F(Xlsx, ADurationThatGrowsIsNoTimeOfOtherChannels) {
    const Outcome<MeasurementFile> opened =
        open(row(1, word("A1", "t [s]") + word("B1", "delay [ms]") + word("C1", "i [A]")) +
             row(2, number("A2", "0") + number("B2", "1") + number("C2", "5")) +
             row(3, number("A3", "1") + number("B3", "3") + number("C3", "6")));
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    ASSERT_EQ(opened->groups.size(), 1u);
    EXPECT_EQ(opened->groups[0].channels.size(), 3u);
}

TEST_F(Xlsx, EachColumnBelongsToTheTimeOnItsLeft) {
    const Outcome<MeasurementFile> opened =
        open(row(1, word("A1", "t") + word("B1", "u") + word("C1", "t") + word("D1", "i")) +
             row(2, number("A2", "0") + number("B2", "1") + number("C2", "0") + number("D2", "5")) +
             row(3, number("A3", "1") + number("B3", "2") + number("C3", "0.5") + number("D3", "6")) +
             row(4, number("A4", "2") + number("B4", "3")));
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    ASSERT_EQ(opened->groups.size(), 2u);
    EXPECT_EQ(opened->groups[0].samples, 3u);
    EXPECT_THAT(numbers(*opened, 1, 0), ElementsAre(0, 0.5));
    EXPECT_THAT(numbers(*opened, 1, 1), ElementsAre(5, 6));
}

TEST_F(Xlsx, NamesStandInTheRowThatCoversEveryColumnOrBelowACellOverSeveral) {
    const std::string data = row(4, number("A4", "0") + number("B4", "1") + number("C4", "2")) +
                             row(5, number("A5", "1") + number("B5", "3") + number("C5", "4"));
    const Outcome<MeasurementFile> described =
        open(row(1, word("A1", "Zeit") + word("B1", "n") + word("C1", "M")) +
             row(2, word("B2", "Drehzahl") + word("C2", "Moment")) +
             row(3, word("A3", "s") + word("B3", "1/min") + word("C3", "Nm")) + data);
    ASSERT_TRUE(described) << format(described.diagnostics());
    EXPECT_EQ(described->groups[0].channels[1].name, "n");
    EXPECT_EQ(described->groups[0].channels[0].unit, "s");
    const Outcome<MeasurementFile> merged =
        open(row(1, word("A1", "Zeit") + word("B1", "Motor")) +
             row(2, word("B2", "Vorlauf") + word("C2",
                                                 "R\xC3\xBC"
                                                 "cklauf")) +
             row(3, word("A3", "s") + word("B3", "degC") + word("C3", "degC")) + data);
    ASSERT_TRUE(merged) << format(merged.diagnostics());
    EXPECT_EQ(merged->groups[0].channels[0].name, "Zeit");
    EXPECT_EQ(merged->groups[0].channels[1].name, "Vorlauf");
}

TEST_F(Xlsx, DateAndClockInTwoColumnsAreOneTimeOverMidnight) {
    const std::string head = row(1, word("A1", "Datum") + word("B1", "Uhrzeit") + word("C1", "u [V]"));
    const Outcome<MeasurementFile> opened =
        open(head + row(2, number("A2", "45458", 1) + number("B2", "0.75", 1) + number("C2", "1")) +
             row(3, number("A3", "45459", 1) + number("B3", "0.25", 1) + number("C3", "2")));
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    EXPECT_EQ(opened->start, "2024-06-15T18:00:00");
    EXPECT_THAT(numbers(*opened, 0, 0), ElementsAre(0, 43200));
    const Outcome<MeasurementFile> clock = open(head + row(2, word("B2", "10:30:00,5") + number("C2", "1")) +
                                                row(3, word("B3", "10:30:02") + number("C3", "2")));
    ASSERT_TRUE(clock) << format(clock.diagnostics());
    EXPECT_EQ(clock->start, "");
    EXPECT_THAT(numbers(*clock, 0, 0), ElementsAre(0, 1.5));
}

TEST_F(Xlsx, NothingIsLeftOutWithoutAWord) {
    const std::string head = row(1, word("A1", "t [s]") + word("B1", "u [V]"));
    const auto data = [](int at, const char* t, const char* u) {
        const std::string n = std::to_string(at);
        return row(at, number("A" + n, t) + number("B" + n, u));
    };
    const Outcome<MeasurementFile> gap =
        open(head + data(2, "0", "1") + data(3, "1", "2") + data(5, "2", "3") + data(6, "3", "4"));
    ASSERT_TRUE(gap) << format(gap.diagnostics());
    EXPECT_THAT(numbers(*gap, 0, 0), ElementsAre(0, 1, 2, 3));
    const Outcome<MeasurementFile> below =
        open(head + data(2, "0", "1") + data(3, "1", "2") + row(6, word("A6", "Mean")) +
             row(7, word("A7", "x") + number("B7", "1.5")) + row(8, word("A8", "y") + number("B8", "1.5")));
    ASSERT_TRUE(below) << format(below.diagnostics());
    EXPECT_THAT(numbers(*below, 0, 0), ElementsAre(0, 1));
    EXPECT_THAT(below->notes.at(0).english(), HasSubstr("from row 6 on, is left out"));
    const Outcome<MeasurementFile> formulas = open(head + row(2, number("A2", "0") + "<c r=\"B2\"><f>A2*2</f></c>") +
                                                   row(3, number("A3", "1") + "<c r=\"B3\"><f>A3*2</f></c>"));
    ASSERT_TRUE(formulas) << format(formulas.diagnostics());
    EXPECT_THAT(formulas->notes.at(0).english(), HasSubstr("2 formulas have no result"));
}

TEST_F(Xlsx, ADamagedPartIsToldAndReadToNoEnd) {
    ASSERT_TRUE(open(row(1, word("A1", "t") + word("B1", "u")) + row(2, number("A2", "0") + number("B2", "1")) +
                     row(3, number("A3", "1") + number("B3", "2"))));
    const Outcome<MeasurementFile> cut = open(row(1, word("A1", "t") + word("B1", "u")) + "<row r=\"2\"><c");
    ASSERT_FALSE(cut);
    EXPECT_THAT(format(cut.diagnostics()), HasSubstr("sheet1.xml"));
}

TEST_F(Xlsx, ASheetWithoutNumbersIsRefused) {
    const Outcome<MeasurementFile> opened = open(row(1, word("A1", "only words")));
    ASSERT_FALSE(opened);
    EXPECT_THAT(format(opened.diagnostics()), HasSubstr("no column of numbers"));
}

TEST(CellValue, ReadsNumbersAndDatesThatWereWrittenAsText) {
    EXPECT_EQ(xlsx::numberOf("1.234,5", ','), 1234.5);
    EXPECT_EQ(xlsx::numberOf("1,234.5", '.'), 1234.5);
    EXPECT_EQ(xlsx::numberOf("3,25", '.'), std::nullopt);
    EXPECT_EQ(xlsx::numberOf("\xC2\xA0"
                             "3,25 ",
                             ','),
              3.25);
    EXPECT_EQ(xlsx::numberOf("-2e-3", '.'), -0.002);
    EXPECT_EQ(xlsx::numberOf("12 V", '.'), std::nullopt);
    const std::optional<double> date = xlsx::dateOf("15.06.2024 10:30:00,5");
    ASSERT_TRUE(date);
    EXPECT_NEAR(*date, 45458.4375 + 0.5 / 86400, 1e-9);
    EXPECT_EQ(xlsx::dateOf("2024-06-15T10:30"), 45458.4375);
    EXPECT_EQ(xlsx::dateOf("31.02.2024"), std::nullopt);
}

}  // namespace
}  // namespace analogon
