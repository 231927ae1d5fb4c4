#include "core/syntax/text_edit.hpp"

#include <gtest/gtest.h>

#include <random>

namespace analogon::syntax {
namespace {

TEST(TextEdit, ReplacesInsertsAndDeletes) {
    const TextEdit edit{"change", {{10, 11, "1"}, {0, 0, "// "}, {4, 6, ""}}};
    const AppliedEdit applied = apply("Real long = 2;", edit);
    EXPECT_EQ(applied.text, "// Realong 1 2;");
    EXPECT_EQ(apply(applied.text, applied.inverse).text, "Real long = 2;");
    EXPECT_EQ(applied.inverse.what, "change");
}

TEST(TextEdit, InsertionsAtOneOffsetKeepTheirOrder) {
    const AppliedEdit applied = apply("ab", TextEdit{"", {{1, 1, "1"}, {1, 2, "B"}, {1, 1, "2"}}});
    EXPECT_EQ(applied.text, "a12B");
    EXPECT_EQ(apply(applied.text, applied.inverse).text, "ab");
}

TEST(TextEdit, AnEmptyEditChangesNothing) {
    const AppliedEdit applied = apply("text", {});
    EXPECT_EQ(applied.text, "text");
    EXPECT_TRUE(applied.inverse.replacements.empty());
}

TEST(TextEdit, TheInverseRestoresEveryByte) {
    std::mt19937 random(7);
    const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
    const auto someText = [&](std::size_t longest) {
        std::string text;
        for (std::size_t i = below(longest + 1); i > 0; --i) text += static_cast<char>(below(256));
        return text;
    };
    for (int round = 0; round < 2000; ++round) {
        const std::string text = someText(40);
        TextEdit edit;
        std::uint32_t at = 0;
        while (at <= text.size() && edit.replacements.size() < 6) {
            const auto begin = static_cast<std::uint32_t>(at + below(text.size() - at + 1));
            const auto end = static_cast<std::uint32_t>(begin + below(text.size() - begin + 1) / 3);
            edit.replacements.push_back({begin, end, someText(5)});
            at = end;
            if (below(3) == 0) break;
        }
        const AppliedEdit applied = apply(text, edit);
        const AppliedEdit restored = apply(applied.text, applied.inverse);
        ASSERT_EQ(restored.text, text);
        ASSERT_EQ(apply(restored.text, restored.inverse).text, applied.text);
    }
}

}  // namespace
}  // namespace analogon::syntax
