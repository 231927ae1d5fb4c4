#include "core/measure/text/file_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "core/measure/text/text_line.hpp"
#include "core/measure/text/text_recording.hpp"

namespace analogon {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class FileTexts : public testing::Test {
protected:
    ~FileTexts() override { fs::remove(file_); }
    void put(const std::string& bytes) const { std::ofstream(file_, std::ios::binary | std::ios::trunc) << bytes; }
    std::unique_ptr<FileText> open(const std::string& encoding = {}) const {
        Outcome<std::unique_ptr<FileText>> text = FileText::open(file_, encoding);
        return text ? std::move(*text) : nullptr;
    }
    std::vector<std::string> lines(FileText& text) const {
        std::vector<std::string> all;
        LineReader reader(text.view());
        for (TextLine line; reader.next(line);) all.emplace_back(line.text);
        return all;
    }
    static std::vector<std::string> linesOf(std::string_view text) {
        std::vector<std::string> all;
        LineReader reader(text);
        for (TextLine line; reader.next(line);) all.emplace_back(line.text);
        return all;
    }
    /// Lines of every length, longer than is loaded at once.
    static std::string longText(const std::string& end) {
        std::string text;
        for (int i = 0; i < 40'000; ++i) text += std::string(static_cast<std::size_t>(i % 97), 'a' + i % 26) + end;
        return text + "the last one";
    }

    fs::path file_ = fs::temp_directory_path() / ("analogon-file-text-" + std::to_string(getpid()) + ".csv");
};

TEST_F(FileTexts, HaveTheLinesOfTheWholeTextWhateverEndsThem) {
    for (const char* const end : {"\n", "\r\n", "\r", "\n\r\n"}) {
        const std::string text = longText(end);
        ASSERT_GT(text.size(), std::size_t{1} << 20);
        put(text);
        const auto opened = open();
        ASSERT_TRUE(opened);
        EXPECT_EQ(lines(*opened), linesOf(text));
        EXPECT_FALSE(opened->fault());
    }
}

TEST_F(FileTexts, AreDecodedPartByPart) {
    // letters of one, two and three bytes and such of two halves, none of which may be cut
    std::string text, little = "\xFF\xFE", big = "\xFE\xFF";
    const std::vector<std::pair<std::string, std::vector<unsigned>>> letters{{"a", {0x61}},
                                                                             {"\xC2\xB0", {0xB0}},
                                                                             {"\xE2\x84\xA6", {0x2126}},
                                                                             {"\xF0\x9F\x9A\x97", {0xD83D, 0xDE97}},
                                                                             {"\n", {0x0A}}};
    for (int i = 0; i < 300'001; ++i) {
        const auto& [letter, units] = letters[static_cast<std::size_t>(i * i + i / 7) % letters.size()];
        text += letter;
        for (const unsigned unit : units) {
            little += static_cast<char>(unit & 0xFF);
            little += static_cast<char>(unit >> 8);
            big += static_cast<char>(unit >> 8);
            big += static_cast<char>(unit & 0xFF);
        }
    }
    for (const std::string& wide : {little, big, little + std::string(5000, '\0')}) {
        put(wide);
        const auto opened = open();
        ASSERT_TRUE(opened);
        EXPECT_EQ(lines(*opened), linesOf(text));
    }
    std::string single;
    for (int i = 0; i < 400'000; ++i) single += i % 60 == 59 ? '\n' : '\xB0';
    put(single);
    const auto opened = open("windows-1252");
    ASSERT_TRUE(opened);
    EXPECT_EQ(lines(*opened).front().substr(0, 2), "\xC2\xB0");
    EXPECT_EQ(lines(*opened).size(), linesOf(single).size());
}

TEST_F(FileTexts, EndBeforeZerosThatWereNeverWritten) {
    put("t,u\n0,1\n" + std::string(3'000'000, '\0'));
    const auto opened = open();
    ASSERT_TRUE(opened);
    EXPECT_EQ(opened->view().text.size(), 8u);
    put(std::string(10'000, '\0'));
    EXPECT_EQ(open()->view().text.size(), 0u);
    put("");
    EXPECT_EQ(open()->view().text.size(), 0u);
}

TEST_F(FileTexts, ThatBecomeShorterMeanwhileAreAFaultAndNoZeros) {
    put("t,u\n" + longText("\n"));
    const auto opened = open();
    ASSERT_TRUE(opened);
    LineReader reader(opened->view());
    TextLine line;
    ASSERT_TRUE(reader.next(line));
    fs::resize_file(file_, 1000);
    while (reader.next(line)) {
    }
    ASSERT_TRUE(opened->fault());
    EXPECT_THAT(format(Diagnostics{*opened->fault()}), HasSubstr("became shorter"));
}

/// Values of a long file with names in front of the numbers and stamps, of which parts are loaded and let go.
TEST_F(FileTexts, AreReadAsTextsInMemoryAre) {
    std::string labelled, german = "Zeit;Zustand;U [V]\n", modelica = "#1\ndouble tab(60000,2)\n", quoted = "t,u\n";
    for (int i = 0; i < 60'000; ++i) {
        const std::string n = std::to_string(i), ms = std::to_string(1000 + i % 1000).substr(1);
        labelled += "t=" + n + ".5 U:" + std::to_string(i % 371) + ".25\n";
        german += "05.03.2024 " + std::to_string(10 + i / 60'000) + ":" + std::to_string(10 + i / 1000 / 60) + ":" +
                  std::to_string(100 + i / 1000 % 60).substr(1) + "," + ms + ";" + (i % 900 < 300 ? "ein" : "aus") +
                  ";" + std::to_string(i % 371) + ",5\n";
        modelica += n + " " + std::to_string(i % 77) + "\n";
        quoted += "\"" + n + "\",\"" + std::to_string(i % 11) + ".5\"\r\n";
    }
    for (const std::string& text : {labelled, german, modelica, quoted}) {
        put(text);
        const Outcome<Table> inMemory = textTables(text, file_.string());
        const Outcome<Table> fromFile = readTextTables(file_, {});
        ASSERT_TRUE(inMemory && fromFile) << format(fromFile.diagnostics()) << text.substr(0, 60);
        ASSERT_EQ(inMemory->columns.size(), fromFile->columns.size());
        for (std::size_t i = 0; i < inMemory->columns.size(); ++i) {
            EXPECT_EQ(inMemory->columns[i].name, fromFile->columns[i].name);
            EXPECT_EQ(inMemory->columns[i].values, fromFile->columns[i].values) << inMemory->columns[i].name;
            EXPECT_EQ(fromFile->columns[i].values.size(), 60'000u);
        }
        EXPECT_EQ(inMemory->lines, fromFile->lines);
    }
}

}  // namespace
}  // namespace analogon
