#include "core/base/visible.hpp"

#include <gtest/gtest.h>

#include "core/base/diagnostic.hpp"

namespace analogon {
namespace {

TEST(Visible, EscapesWhatATerminalObeys) {
    EXPECT_EQ(visible("a\x1b[31mb\x07"), "a\\u{1b}[31mb\\u{7}");
    EXPECT_EQ(visible("\xc2\x9b"
                      "2J"),
              "\\u{9b}2J");  // the same command as one character
    EXPECT_EQ(visible("a\x7f\r"), "a\\u{7f}\\u{d}");
    EXPECT_EQ(visible(std::string_view("\0", 1)), "\\u{0}");
}

TEST(Visible, EscapesWhatCannotBeSeenOrTurnsTheText) {
    EXPECT_EQ(visible("a\u202eb"), "a\\u{202e}b");
    EXPECT_EQ(visible("a\u200bb\ufeff"), "a\\u{200b}b\\u{feff}");
    EXPECT_EQ(visible("\u2066x\u2069"), "\\u{2066}x\\u{2069}");
    EXPECT_EQ(visible("a\U000e0041"), "a\\u{e0041}");
}

TEST(Visible, EscapesWhatIsNoUtf8) {
    EXPECT_EQ(visible("\xb0"), "\\xb0");
    EXPECT_EQ(visible("\xc0\x8a"), "\\xc0\\x8a");           // a line end, written too long
    EXPECT_EQ(visible("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // half a pair
    EXPECT_EQ(visible("a\xe2\x82"), "a\\xe2\\x82");         // cut off
}

TEST(Visible, LeavesWordsAsTheyAre) {
    EXPECT_EQ(visible("T [°C]\tµ\n„ä“ 日本 10⁻¹¹"), "T [°C]\tµ\n„ä“ 日本 10⁻¹¹");
    EXPECT_EQ(visibleName("a\nb\tc"), "a\\u{a}b\\u{9}c");
    EXPECT_EQ(visibleName(std::string(300, 'x'), 10), "xxxxxxxxxx…");
}

TEST(Visible, ShortensBetweenCharacters) {
    EXPECT_EQ(shortened("abc", 3), "abc");
    EXPECT_EQ(shortened("abcd", 3), "abc…");
    EXPECT_EQ(shortened("a\u00b5\u00b5", 2), "a…");
}

TEST(Visible, HoldsForAllOfAMessage) {
    Diagnostic fault = fileError(phrase("there is no column '{}'", "\x1b]0;x\x07\nerror: y"), "a\x1b[2J.csv", 3, 2,
                                 phrase("Did you mean '{}'?", "\u202ez"));
    fault.place.lineText = "a\u202eb\x1b[1m";
    EXPECT_EQ(format(fault),
              "a\\u{1b}[2J.csv:3:2: error: there is no column '\\u{1b}]0;x\\u{7}\\u{a}error: y'\n"
              "    a?b?[1m\n"
              "     ^\n"
              "    hint: Did you mean '\\u{202e}z'?\n");
}

TEST(Visible, KeepsAMessageShort) {
    const std::string name(1 << 20, 'x');
    EXPECT_LT(format(error(phrase("the class '{}'", name))).size(), 5000u);
    const Diagnostics many(100000, error("a fault"));
    EXPECT_LT(format(many).size(), 5000u);
    EXPECT_NE(format(many).find("and 99900 more"), std::string::npos);
}

}  // namespace
}  // namespace analogon
