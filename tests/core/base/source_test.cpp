#include "core/base/source.hpp"

#include <gtest/gtest.h>

namespace analogon {
namespace {

TEST(Source, CountsLinesAndColumnsFromOne) {
    const Source source("a.mo", "ab\ncd\n");
    EXPECT_EQ(source.position(0).line, 1);
    EXPECT_EQ(source.position(0).column, 1);
    EXPECT_EQ(source.position(4).line, 2);
    EXPECT_EQ(source.position(4).column, 2);
    EXPECT_EQ(source.position(6).line, 3);
    EXPECT_EQ(source.position(6).column, 1);
}

TEST(Source, TakesEveryKindOfLineEnd) {
    const Source source("a.mo", "one\r\ntwo\rthree\nfour");
    EXPECT_EQ(source.line(1), "one");
    EXPECT_EQ(source.line(2), "two");
    EXPECT_EQ(source.line(3), "three");
    EXPECT_EQ(source.line(4), "four");
    EXPECT_EQ(source.line(5), "");
    EXPECT_EQ(source.line(0), "");
    EXPECT_EQ(source.position(5).line, 2);
}

TEST(Source, AnOffsetBehindTheTextIsItsEnd) {
    const Source source("a.mo", "abc");
    EXPECT_EQ(source.position(99).column, 4);
}

TEST(Source, EmptyTextHasOneEmptyLine) {
    const Source source("a.mo", "");
    EXPECT_EQ(source.position(0).line, 1);
    EXPECT_EQ(source.line(1), "");
}

TEST(Span, CoversBothInEitherOrder) {
    const Source source("a.mo", "a + b*c");
    const Span a{&source, 0, 1}, c{&source, 6, 7};
    EXPECT_EQ(cover(a, c).text(), "a + b*c");
    EXPECT_EQ(cover(c, a).text(), "a + b*c");
    EXPECT_EQ(cover(a, Span{}).text(), "a");
    EXPECT_EQ(cover(Span{}, c).text(), "c");
}

}  // namespace
}  // namespace analogon
