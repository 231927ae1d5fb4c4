#include "core/flat/table_file.hpp"

#include <gtest/gtest.h>
#include <matio.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace analogon {
namespace {

namespace fs = std::filesystem;

TEST(TableFile, IsReadFromTextAndCsv) {
    const fs::path folder = fs::temp_directory_path() / ("analogon-table-" + std::to_string(getpid()));
    fs::create_directories(folder);
    const std::string text = (folder / "t.txt").string(), csv = (folder / "t.csv").string();
    std::ofstream(text) << "#1\ndouble other(1,2)\n 0 0\ndouble tab(3,2) # a comment\n 0 1\n 1 2.5 # more\n 2 -3e1\n";
    std::ofstream(csv) << "a;b\n0;1\n1;2.5\n";
    const auto read = readTableFile(text, "tab", ",", 0);
    ASSERT_TRUE(read) << format(read.diagnostics());
    EXPECT_EQ(read->rows, 3u);
    EXPECT_DOUBLE_EQ((*read)(2, 1), -30);
    const auto cells = readTableFile(csv, "Values", ";", 1);
    ASSERT_TRUE(cells) << format(cells.diagnostics());
    EXPECT_DOUBLE_EQ((*cells)(1, 1), 2.5);
    EXPECT_FALSE(readTableFile(text, "none", ",", 0));
    fs::remove_all(folder);
}

class MatlabTableFile : public testing::TestWithParam<mat_ft> {
protected:
    ~MatlabTableFile() override { fs::remove(file); }
    void write(const char* name, std::vector<double> columns, std::size_t rows) const {
        std::size_t dimensions[2] = {rows, columns.size() / rows};
        mat_t* mat = Mat_CreateVer(file.c_str(), nullptr, GetParam());
        matvar_t* variable = Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dimensions, columns.data(), 0);
        Mat_VarWrite(mat, variable, MAT_COMPRESSION_NONE);
        Mat_VarFree(variable);
        Mat_Close(mat);
    }
    const std::string file =
        (fs::temp_directory_path() / ("analogon-table-" + std::to_string(getpid()) + ".mat")).string();
};

INSTANTIATE_TEST_SUITE_P(Levels, MatlabTableFile, testing::Values(MAT_FT_MAT4, MAT_FT_MAT5, MAT_FT_MAT73));

TEST_P(MatlabTableFile, IsReadByRows) {
    write("tab", {0, 1, 2, 10, 11, 12}, 3);
    const auto read = readTableFile(file, "tab", ",", 0);
    ASSERT_TRUE(read) << format(read.diagnostics());
    EXPECT_EQ(read->rows, 3u);
    EXPECT_EQ(read->columns, 2u);
    EXPECT_DOUBLE_EQ((*read)(1, 1), 11);
    const auto none = readTableFile(file, "other", ",", 0);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.diagnostics()[0].message, "the file holds no table \"other\"");
}

// Whatever a damaged file does to the library that reads it, this program goes on.
TEST_P(MatlabTableFile, ThatIsDamagedCostsNoMoreThanTheFile) {
    write("tab", {0, 1, 2, 10, 11, 12}, 3);
    std::ostringstream content;
    content << std::ifstream(file, std::ios::binary).rdbuf();
    const std::string whole = content.str();
    unsigned state = 7, read = 0;
    for (int i = 0; i < 100; ++i) {
        std::string bytes = whole;
        state = state * 1664525u + 1013904223u;
        bytes[(state >> 8) % bytes.size()] = static_cast<char>(state >> 24);
        std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
        read += readTableFile(file, "tab", ",", 0).hasValue();
    }
    EXPECT_GT(read, 0u);
    EXPECT_LT(read, 100u);
}

}  // namespace
}  // namespace analogon
