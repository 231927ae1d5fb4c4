#include "core/measure/channel.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/measure/text/text_recording.hpp"

namespace analogon {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

Table table(std::string_view text) {
    Outcome<Table> out = textTables(text, "run.csv");
    EXPECT_TRUE(out.hasValue()) << format(out.diagnostics());
    return out ? *out : Table{};
}

ChannelMapping column(std::string name, std::string unit = {}) {
    ChannelMapping mapping;
    mapping.column = std::move(name);
    mapping.unit = std::move(unit);
    return mapping;
}

template <class T>
Diagnostic faultOf(const Outcome<T>& outcome) {
    EXPECT_FALSE(outcome.hasValue());
    return outcome ? Diagnostic{} : outcome.diagnostics().front();
}

TEST(Channel, ConvertsToTheUnitOfTheModel) {
    const Table file = table("t [s],T [degC],I [mA],duty [%],n [rpm]\n0,20,1500,50,60\n");
    EXPECT_THAT(*readChannel(file, column("T"), "K"), ElementsAre(DoubleNear(293.15, 1e-9)));
    EXPECT_THAT(*readChannel(file, column("I"), "A"), ElementsAre(DoubleNear(1.5, 1e-12)));
    EXPECT_THAT(*readChannel(file, column("duty"), "1"), ElementsAre(DoubleNear(0.5, 1e-12)));
    EXPECT_THAT(*readChannel(file, column("n"), "rad/s"), ElementsAre(DoubleNear(6.283185307179586, 1e-9)));
}

TEST(Channel, PutsTheMappingsUnitAboveTheFiles) {
    const Table file = table("t [s],T [K]\n0,20\n");
    EXPECT_THAT(*readChannel(file, column("T", "degC"), "K"), ElementsAre(DoubleNear(293.15, 1e-9)));
}

TEST(Channel, TakesAColumnWithoutUnitAsItIs) {
    const Table file = table("t,u\n0,3\n");
    EXPECT_THAT(*readChannel(file, column("u"), "V"), ElementsAre(3));
}

TEST(Channel, ScalesAndShiftsBehindTheConversion) {
    const Table file = table("t,I [mA]\n0,1000\n");
    ChannelMapping mapping = column("I");
    mapping.scale = -2;
    mapping.offset = 0.5;
    EXPECT_THAT(*readChannel(file, mapping, "A"), ElementsAre(DoubleNear(-1.5, 1e-12)));
}

TEST(Channel, IsFoundByItsWholeHeaderToo) {
    const Table file = table("t [s],T [K],T [degC]\n0,300,27\n");
    EXPECT_THAT(*readChannel(file, column("T [K]"), "K"), ElementsAre(300));
}

TEST(Channel, SuggestsTheNameThatWasMeant) {
    const Diagnostic fault = faultOf(readChannel(table("t,u_heater\n0,1\n"), column("u_heatr"), "V"));
    EXPECT_EQ(fault.message, "there is no column 'u_heatr'");
    EXPECT_THAT(fault.hint, HasSubstr("'u_heater'"));
    EXPECT_EQ(fault.place.file, "run.csv");
}

TEST(Channel, NamesUnknownAndInconvertibleUnits) {
    const Table file = table("t [s],a [blorb],b [V]\n0,1,2\n");
    EXPECT_EQ(faultOf(readChannel(file, column("a"), "K")).message, "the unit 'blorb' of column 'a' is not known");
    const Diagnostic fault = faultOf(readChannel(file, column("b"), "K"));
    EXPECT_EQ(fault.message, "column 'b' is in 'V', which cannot be converted to the 'K' of the model");
}

TEST(Channel, NamesWhatIsNearAnUnknownUnitAndNeverTheModels) {
    const Table file = table("t [s],p [kPa gauge],q [mbarr],r [blorb]\n0,1,2,3\n");
    const Diagnostic gauge = faultOf(readChannel(file, column("p"), "Pa"));
    EXPECT_THAT(gauge.hint.english(), Not(HasSubstr("Did you mean")));
    EXPECT_THAT(gauge.hint.english(), HasSubstr("{\"column\": \"p\", \"unit\": …}"));
    EXPECT_EQ(gauge.place.line, 1);
    EXPECT_EQ(gauge.place.column, 7);
    EXPECT_THAT(faultOf(readChannel(file, column("q"), "Pa")).hint.english(), HasSubstr("Did you mean 'mbar'?"));
    for (const char* name : {"p", "q", "r"})
        EXPECT_THAT(faultOf(readChannel(file, column(name), "Pa")).hint.english(), Not(HasSubstr("'Pa'"))) << name;
}

TEST(Channel, TakesAUnitInRoundBracketsForOne) {
    const Table file =
        table("Time (msec),p (kPa abs),n (r/s),T (Deg C),I (A rms)\n0,101.3,41.5,84,4.2\n100,101.3,41.5,85,4.2\n");
    EXPECT_THAT(*readTime(file, "Time"), ElementsAre(0, DoubleNear(0.1, 1e-12)));
    EXPECT_NEAR(readChannel(file, column("p"), "Pa")->front(), 101300, 1e-6);
    EXPECT_NEAR(readChannel(file, column("p (kPa abs)"), "Pa")->front(), 101300, 1e-6);
    EXPECT_NEAR(readChannel(file, column("n"), "rad/s")->front(), 260.752, 1e-3);
    EXPECT_NEAR(readChannel(file, column("T"), "K")->front(), 357.15, 1e-9);
    EXPECT_EQ(readChannel(file, column("I"), "A")->front(), 4.2);
}

TEST(Channel, NeverTakesTheModelsUnitInSilence) {
    const Table file = table("t,p (kPa gauge),T (ambient),u (2)\n0,1,2,3\n");
    EXPECT_THAT(faultOf(readChannel(file, column("p (kPa gauge)"), "Pa")).message,
                HasSubstr("the unit 'kPa gauge' of column 'p (kPa gauge)' is not known"));
    const auto ambient = readChannel(file, column("T (ambient)"), "K");
    ASSERT_TRUE(ambient);
    ASSERT_EQ(ambient.diagnostics().size(), 1u) << "a word in brackets may be a part of the name, and is told";
    EXPECT_EQ(ambient.diagnostics()[0].severity, Severity::Warning);
    EXPECT_THAT(ambient.diagnostics()[0].message, HasSubstr("'(ambient)'"));
    EXPECT_EQ(ambient.diagnostics()[0].place.column, 17);
    EXPECT_TRUE(readChannel(file, column("T (ambient)", "degC"), "K").diagnostics().empty()) << "the study says it";
    EXPECT_TRUE(readChannel(file, column("u (2)"), "V").diagnostics().empty()) << "a number is an index";
}

TEST(Channel, DoesNotTakeASpeedForATime) {
    EXPECT_THAT(faultOf(readTime(table("n [rpm],u\n1,1\n2,2\n"), "n")).message, HasSubstr("cannot be converted"));
}

TEST(Channel, NamesTheFirstCellWithoutANumber) {
    const Diagnostic fault = faultOf(readChannel(table("t,u\n0,1\n1,\n2,3\n3,nan\n"), column("u"), ""));
    EXPECT_EQ(fault.place.line, 3);
    EXPECT_EQ(fault.place.column, 3);
    EXPECT_EQ(fault.message, "column 'u' has no number here (data row 2; 2 cells in all, the last in line 5)");
    EXPECT_THAT(faultOf(readChannel(table("t,u\n0,inf\n"), column("u"), "")).message, HasSubstr("infinite"));
}

TEST(Channel, TakesEmptyCellsOfAnOutputForNotMeasured) {
    const Table file = table("t,y\n0,1\n1,\n2,3\n3,nan\n");
    const Outcome<std::vector<double>> read = readChannel(file, column("y"), "", EmptyCells::NotMeasured);
    ASSERT_TRUE(read) << format(read.diagnostics());
    EXPECT_EQ((*read)[2], 3);
    EXPECT_TRUE(std::isnan((*read)[1]) && std::isnan((*read)[3]));
    ASSERT_EQ(read.diagnostics().size(), 1u);
    const Diagnostic& note = read.diagnostics().front();
    EXPECT_EQ(note.severity, Severity::Warning);
    EXPECT_EQ(note.message, "column 'y' was not measured in 2 of 4 rows, first in data row 2");
    EXPECT_EQ(note.place.line, 3);
    // of an input they stay a fault, whose hint says so
    EXPECT_THAT(faultOf(readChannel(file, column("y"), "")).hint, HasSubstr("Only outputs may have empty cells"));
    // a column of nothing measures nothing, and an infinite value is none
    EXPECT_FALSE(readChannel(table("t,y\n0,\n1,\n"), column("y"), "", EmptyCells::NotMeasured));
    const Diagnostic infinite =
        faultOf(readChannel(table("t,y\n0,\n1,2\n2,inf\n"), column("y"), "", EmptyCells::NotMeasured));
    EXPECT_THAT(infinite.message, HasSubstr("infinite"));
    EXPECT_EQ(infinite.place.line, 4);
}

TEST(Channel, ForgetsBlankCellsThatWereCutOff) {
    const Table file = table("t,u\n0,\n1,5\n2,6\n").slice(1, 3);
    EXPECT_THAT(*readChannel(file, column("u"), ""), ElementsAre(5, 6));
    const Table later = table("t,u\n0,1\n1,5\n2,\n").slice(1, 3);
    EXPECT_EQ(faultOf(readChannel(later, column("u"), "")).place.line, 4);
}

TEST(Time, IsReadInSeconds) {
    EXPECT_THAT(*readTime(table("t [ms],u\n0,1\n500,2\n"), "t"), ElementsAre(0, 0.5));
    EXPECT_THAT(*readTime(table("t [min],u\n0,1\n1,2\n"), "t"), ElementsAre(0, 60));
}

TEST(Time, RefusesFallingRepeatedAndConstantStamps) {
    const Diagnostic falling = faultOf(readTime(table("t,u\n0,1\n1,2\n0.5,3\n2,4\n"), "t"));
    EXPECT_EQ(falling.message, "the time in column 't' goes back in 1 of 4 rows: 0.5 after 1 (line 4)");
    EXPECT_EQ(falling.place.line, 4);
    EXPECT_THAT(faultOf(readTime(table("t,u\n0,1\n1,2\n1,3\n"), "t")).message, HasSubstr("repeats"));
    EXPECT_THAT(faultOf(readTime(table("t,u\n1,1\n1,2\n1,3\n"), "t")).message, HasSubstr("stands still"));
    EXPECT_THAT(faultOf(readTime(table("t,u\n1,1\n"), "t")).message, HasSubstr("only one row"));
}

TEST(Time, SaysWhatRepeatedStampsMayMeanAndNeverToSpoilTheData) {
    // a counter beside them: no row was written twice
    const Diagnostic counted = faultOf(readTime(
        table("No,time [ms],u\n1,0,0\n2,100,1\n3,200,2\n4,200,2.5\n5,300,3\n6,300,4\n7,300,5\n8,400,6\n9,400,7\n"),
        "time"));
    EXPECT_EQ(counted.message,
              "the time in column 'time' repeats in 4 of 9 rows: 200 after 200 (line 5), 300 after 300 (line 7), "
              "300 after 300 (line 8), …");
    EXPECT_EQ(counted.place.line, 5);
    EXPECT_THAT(counted.hint.english(), HasSubstr("'No' counts on there, so no row was written twice"));
    EXPECT_THAT(counted.hint.english(), HasSubstr("write the second a little later, by 0.0001 s"));
    // the same row twice
    EXPECT_THAT(faultOf(readTime(table("t,u\n0,1\n1,2\n1,2\n2,3\n"), "t")).hint.english(),
                HasSubstr("These rows are copies of those before them"));
    for (const char* const text : {"t,u\n0,1\n1,2\n1,3\n2,3\n", "t,u\n0,1\n1,2\n0,3\n1,3\n"})
        EXPECT_THAT(faultOf(readTime(table(text), "t")).hint.english(),
                    testing::Not(testing::AnyOf(HasSubstr("Remove the"), HasSubstr("Sort the rows"))));
}

TEST(Time, SaysWhatReturningStampsMayMean) {
    const Diagnostic anew = faultOf(readTime(table("t,u\n0,1\n1,2\n2,3\n3,3\n4,3\n5,3\n0,1\n1,2\n2,3\n"), "t"));
    EXPECT_THAT(anew.hint.english(), HasSubstr("split the file before line 8, or use its first part alone (\"range\": "
                                               "[0, 5]). If the clock was set back, add 6 s"));
    const Diagnostic mixed = faultOf(readTime(table("t,u\n0,1\n1,2\n3,3\n2,3\n4,3\n5,3\n"), "t"));
    EXPECT_THAT(mixed.hint.english(), HasSubstr("stamps of two loggers may be mixed"));
}

TEST(Time, WarnsOfGapsOnce) {
    const Outcome<std::vector<double>> time =
        readTime(table("t,u\n0,1\n1,1\n2,1\n3,1\n4,1\n104,1\n105,1\n205,1\n"), "t");
    ASSERT_TRUE(time.hasValue());
    ASSERT_EQ(time.diagnostics().size(), 1u);
    EXPECT_EQ(time.diagnostics()[0].severity, Severity::Warning);
    EXPECT_EQ(time.diagnostics()[0].place.line, 7);
    EXPECT_THAT(time.diagnostics()[0].message, HasSubstr("2 such gaps"));
}

TEST(Channel, TellsThatANameEndsInAnotherUnitThanTheModels) {
    const Table file = table("t,i_mA,n_rpm,T_C,u_V,T_max\n0,1500,60,20,12,5\n1,1500,60,20,12,5\n");
    for (const auto& [name, end, unit] :
         {std::tuple{"i_mA", "mA", "A"}, {"n_rpm", "rpm", "rad/s"}, {"T_C", "degC", "K"}}) {
        const auto read = readChannel(file, column(name), unit);
        ASSERT_TRUE(read);
        ASSERT_EQ(read.diagnostics().size(), 1u) << name;
        EXPECT_THAT(read.diagnostics()[0].message.english(), HasSubstr("ends in '" + std::string(end) + "'"));
        EXPECT_THAT(read.diagnostics()[0].hint.english(), HasSubstr("\"unit\": \"" + std::string(end) + "\""));
        EXPECT_THAT(read.diagnostics()[0].hint.english(), HasSubstr("\"unit\": \"" + std::string(unit) + "\""));
        EXPECT_TRUE(readChannel(file, column(name, end), unit).diagnostics().empty()) << "it is told";
    }
    EXPECT_TRUE(readChannel(file, column("u_V"), "V").diagnostics().empty());
    EXPECT_TRUE(readChannel(file, column("T_max"), "K").diagnostics().empty());
    ChannelMapping scaled = column("i_mA");
    scaled.scale = 0.001;
    EXPECT_TRUE(readChannel(file, scaled, "A").diagnostics().empty()) << "whoever scales knows the unit";
}

}  // namespace
}  // namespace analogon
