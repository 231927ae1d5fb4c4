#include "core/measure/open/read_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "../mdf/mdf4_writer.hpp"
#include "core/measure/channel_place.hpp"
#include "core/measure/common_raster.hpp"

namespace analogon {
namespace {

using test::Bytes;
using test::Mdf4Writer;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A file that is gone when the test is.
class ReadTable : public ::testing::Test {
protected:
    ~ReadTable() override { std::filesystem::remove(file_); }

    /// A time, a state of one byte, and two numbers.
    void putMdf() {
        Mdf4Writer writer;
        Bytes records;
        for (int row = 0; row < 3; ++row)
            records.put(0.5 * row).put(static_cast<std::uint8_t>(row % 2)).put(1.0 * row).put(10.0 * row);
        const std::uint64_t data = writer.block("DT", {}, records.text);
        writer.finish(
            writer.simple("one",
                          {{"t", "s", 2}, {"on", "", 0, 0, 8, 8}, {"a", "V", 0, 4, 64, 9}, {"b", "A", 0, 4, 64, 17}}, 3,
                          25, data),
            file_);
    }
    Table read(const std::set<std::string>& wanted = {}, std::size_t mostValues = valuesKept) const {
        Outcome<Table> table = readTable(file_, {}, wanted, {}, mostValues);
        EXPECT_TRUE(table.hasValue()) << format(table.diagnostics());
        return table ? std::move(*table) : Table{};
    }

    std::filesystem::path file_ =
        std::filesystem::temp_directory_path() / ("analogon-read-table-" + std::to_string(getpid()) + ".bin");
};

TEST_F(ReadTable, TellsABinaryFileByItsContentAndAStateByItsType) {
    putMdf();
    const Table table = read();
    EXPECT_EQ(table.time, 0u);
    EXPECT_THAT(table.names(), ElementsAre("t", "on", "a", "b"));
    EXPECT_TRUE(table.find("on")->isHeld);
    EXPECT_FALSE(table.find("a")->isHeld);
    EXPECT_THAT(table.find("b")->values, ElementsAre(0, 10, 20));
    EXPECT_THAT(table.lines, ElementsAre(1, 2, 3));
}

TEST_F(ReadTable, OfALargeFileOnlyWhatIsNamedIsReadAndTheRestWhenItIsUsed) {
    putMdf();
    const Outcome<Table> read = readTable(file_, {}, {"a"}, {}, 5);
    ASSERT_TRUE(read);
    ASSERT_EQ(read.diagnostics().size(), 1u);
    EXPECT_THAT(read.diagnostics()[0].message.english(), HasSubstr("2 of its channels"));
    EXPECT_THAT(read->find("a")->values, ElementsAre(0, 1, 2));
    EXPECT_THAT(read->find("b")->values, IsEmpty());
    EXPECT_TRUE(read->hasUnread());
    EXPECT_THAT(namesIn(*read), ElementsAre("t", "on", "a", "b"));
    RasterRequest request;
    request.time = {"t", {}};
    request.outputs = {{"b", {}}};
    request.inputs = {{{"a", {}}, Interpolation::Automatic}};
    const auto joined = onCommonRaster(std::make_shared<const Table>(*read), request);
    ASSERT_TRUE(joined) << format(joined.diagnostics());
    EXPECT_THAT((*joined)->find("b")->values, ElementsAre(0, 10, 20));
    EXPECT_FALSE((*joined)->find("on")) << "nobody has asked for it";
}

TEST_F(ReadTable, WordsOfATextHaveNoValuesButAName) {
    std::ofstream(file_) << "t,on,note\n0,off,a b\n1,on,c d\n2,on,e f\n";
    const Table table = read();
    EXPECT_THAT(table.texts, ElementsAre("note"));
    EXPECT_TRUE(table.find("on")->isHeld);
    EXPECT_THAT(table.find("on")->values, ElementsAre(0, 1, 1));
}

TEST_F(ReadTable, EachTimeColumnOfATextHasAGroupOfItsOwn) {
    std::ofstream(file_) << "time_u [s],u [V],time_T [s],T [degC]\n0,1,0.5,20\n1,2,1.5,21\n2,3,,\n";
    const Table table = read();
    ASSERT_EQ(table.others.size(), 1u);
    EXPECT_EQ(table.rows(), 3u);
    EXPECT_EQ(table.others[0]->rows(), 2u);
    EXPECT_EQ(table.others[0]->columns[1].groupNumber, 2u);
    RasterRequest request;
    request.time = {"time_u", {}};
    request.outputs = {{"u", {}}};
    request.inputs = {{{"T", {}}, Interpolation::Hold}};
    const auto joined = onCommonRaster(std::make_shared<const Table>(table), request);
    ASSERT_TRUE(joined) << format(joined.diagnostics());
    EXPECT_THAT((*joined)->find("time_u")->values, ElementsAre(1, 1.5, 2));
    EXPECT_THAT((*joined)->find("T")->values, ElementsAre(20, 21, 21));
}

TEST_F(ReadTable, AFileWithoutSamplesSaysSo) {
    Mdf4Writer writer;
    writer.finish(writer.simple("one", {{"t", "s", 2}}, 0, 8, 0), file_);
    const Outcome<Table> table = readTable(file_);
    ASSERT_FALSE(table);
    EXPECT_THAT(table.diagnostics()[0].message.english(), HasSubstr("no samples of any channel"));
}

}  // namespace
}  // namespace analogon
