#include "core/measure/encoding.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/measure/open/open_recording.hpp"

namespace analogon {
namespace {

/// Letters below 0x10000 in four or two bytes each.
std::string wide(std::u16string_view text, std::size_t bytes, bool isBigEndian, bool hasMark) {
    std::string out;
    const auto put = [&](char16_t letter) {
        std::string unit(bytes, '\0');
        unit[0] = static_cast<char>(letter & 0xFF);
        unit[1] = static_cast<char>(letter >> 8);
        if (isBigEndian) std::reverse(unit.begin(), unit.end());
        out += unit;
    };
    if (hasMark) put(0xFEFF);
    for (const char16_t letter : text) put(letter);
    return out;
}

std::u16string table() {
    std::u16string text = u"Zeit [s];\u00D6l [\u00B0C]\n";
    for (int i = 0; i < 300; ++i) {
        const std::string row = std::to_string(i) + ";" + std::to_string(20 + i) + ".5\n";
        text.append(row.begin(), row.end());
    }
    return text;
}

TEST(Encoding, WideTextIsToldByItsMarkOrItsZeros) {
    for (const bool isBigEndian : {false, true})
        for (const bool hasMark : {false, true}) {
            EXPECT_EQ(encodingOf(wide(table(), 4, isBigEndian, hasMark)),
                      isBigEndian ? Encoding::Utf32BigEndian : Encoding::Utf32LittleEndian);
            EXPECT_EQ(encodingOf(wide(table(), 2, isBigEndian, hasMark)),
                      isBigEndian ? Encoding::Utf16BigEndian : Encoding::Utf16LittleEndian);
        }
    EXPECT_EQ(encodingOf(std::string_view("t\0\0\0\1\2\3\4\5\6\7\10", 12)), Encoding::AsIs);
}

TEST(Encoding, LettersThatAreNoneAreReplaced) {
    const std::string bytes("\xFF\xFF\xFF\x7F\x00\xD8\x00\x00\x41\x00\x00\x00", 12);
    EXPECT_EQ(decodeText(bytes, Encoding::Utf32LittleEndian), "\xEF\xBF\xBD\xEF\xBF\xBD\x41");
}

TEST(Encoding, AFileOfFourBytesALetterIsReadAsAnyOther) {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("analogon-wide-" + std::to_string(getpid()) + ".csv");
    for (const bool isBigEndian : {false, true})
        for (const bool hasMark : {false, true}) {
            std::ofstream(path, std::ios::binary | std::ios::trunc) << wide(table(), 4, isBigEndian, hasMark);
            const Outcome<MeasurementFile> opened = openRecording(path);
            ASSERT_TRUE(opened) << format(opened.diagnostics());
            ASSERT_EQ(opened->groups.size(), 1u);
            EXPECT_EQ(opened->groups[0].channels[1].name, "\xC3\x96l");
            const Outcome<ChannelValues> values = readValues(*opened, 0, 1);
            ASSERT_TRUE(values);
            EXPECT_EQ(values->numbers.size(), 300u);
            EXPECT_EQ(values->numbers.back(), 319.5);
        }
    std::filesystem::remove(path);
}

}  // namespace
}  // namespace analogon
