#include "core/measure/unknown_unit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "core/measure/channel.hpp"
#include "core/measure/open/open_recording.hpp"
#include "core/measure/open/read_table.hpp"
#include "tests/core/measure/mdf/mdf4_writer.hpp"

namespace analogon {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class UnknownUnits : public testing::Test {
protected:
    ~UnknownUnits() override { fs::remove(file_); }
    void put(const std::string& text) const { std::ofstream(file_, std::ios::binary | std::ios::trunc) << text; }
    void putMdf4() const {
        test::Mdf4Writer writer;
        test::Bytes data;
        for (int i = 0; i < 5; ++i) data.put(0.5 * i).put(10.0 + i);
        const std::uint64_t group =
            writer.simple("", {{"time", "s", 2}, {"p", "mpa", 0, 4, 64, 8}}, 5, 16, writer.block("DT", {}, data.text));
        writer.finish(group, file_);
    }
    std::vector<std::string> labels(const Question& question) const {
        std::vector<std::string> all;
        for (const Reading& reading : question.readings) all.push_back(reading.options.unitNames.at(question.unit));
        return all;
    }

    fs::path file_ = fs::temp_directory_path() / ("analogon-unknown-unit-" + std::to_string(getpid()));
};

TEST_F(UnknownUnits, OfATextAreAskedWithAllThatIsNear) {
    put("t [s],p1 [mpa],T [degC],p2 [mpa],x [foobars]\n0,1,2,3,4\n1,2,3,4,5\n2,3,4,5,6\n");
    const Outcome<LookedAtText> looked = lookAtTextFile(file_);
    ASSERT_TRUE(looked && looked->table) << "it is read nevertheless";
    ASSERT_EQ(looked->asked.size(), 2u);
    EXPECT_EQ(looked->asked[0].unit, "mpa");
    EXPECT_EQ(looked->asked[0].kind, Question::Kind::Unit);
    EXPECT_EQ(looked->asked[0].line, 1);
    EXPECT_THAT(labels(looked->asked[0]), ElementsAre("MPa", "mPa", "1"));
    const Outcome<LookedAtText> answered = lookAtTextFile(file_, looked->asked[0].readings[0].options);
    ASSERT_TRUE(answered && answered->table);
    ASSERT_EQ(answered->asked.size(), 1u) << "what was answered is asked no more";
    EXPECT_EQ(answered->asked[0].unit, "foobars");
    EXPECT_EQ((*answered->table)->find("p2")->unit, "MPa");
    const Outcome<LookedAtText> both = lookAtTextFile(file_, answered->asked[0].readings.back().options);
    ASSERT_TRUE(both);
    EXPECT_THAT(both->asked, IsEmpty());
    EXPECT_EQ((*both->table)->find("p1")->unit, "MPa") << "an answer keeps those before it";
}

TEST_F(UnknownUnits, OfAnyFormatCanBeTold) {
    putMdf4();
    const Outcome<MeasurementFile> opened = openRecording(file_);
    ASSERT_TRUE(opened);
    std::string notes;
    for (const Text& note : opened->notes) notes += note.english() + "\n";
    EXPECT_THAT(notes, HasSubstr("the unit 'mpa' of p is not known here: did you mean 'MPa' or 'mPa'?"));
    EXPECT_THAT(notes, HasSubstr(R"("unit_names": {"mpa": "MPa"})"));
    ReadOptions options;
    options.unitNames["mpa"] = "MPa";
    const Outcome<Table> table = readTable(file_, options);
    ASSERT_TRUE(table);
    EXPECT_EQ(table->find("p")->unit, "MPa");
    EXPECT_THAT(table.diagnostics(), IsEmpty()) << "it has an effect";
    ChannelMapping mapping;
    mapping.column = "p";
    const Outcome<std::vector<double>> values = readChannel(*table, mapping, "Pa");
    ASSERT_TRUE(values);
    EXPECT_EQ(values->front(), 10e6);
}

TEST_F(UnknownUnits, StandBehindANameInRoundBrackets) {
    put("t (s),p (kPaa),speed (corrected),n (rpm)\n0,1,2,3\n1,2,3,4\n2,3,4,5\n");
    const Outcome<LookedAtText> looked = lookAtTextFile(file_);
    ASSERT_TRUE(looked && looked->table);
    ASSERT_EQ(looked->asked.size(), 1u) << "a remark is no unit";
    EXPECT_EQ(looked->asked[0].unit, "kPaa");
    const Outcome<LookedAtText> answered = lookAtTextFile(file_, looked->asked[0].readings[0].options);
    ASSERT_TRUE(answered && answered->table);
    EXPECT_EQ((*answered->table)->columns[1].unit, "kPa");
}

TEST_F(UnknownUnits, AreNoneWhereNothingIsWritten) {
    put("t [s],a [-],b [1],c [],d\n0,1,2,3,4\n1,2,3,4,5\n2,3,4,5,6\n");
    const Outcome<LookedAtText> looked = lookAtTextFile(file_);
    ASSERT_TRUE(looked && looked->table);
    EXPECT_THAT(looked->asked, IsEmpty());
}

}  // namespace
}  // namespace analogon
