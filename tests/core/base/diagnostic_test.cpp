#include "core/base/diagnostic.hpp"

#include <gtest/gtest.h>

#include "core/base/outcome.hpp"

namespace analogon {
namespace {

TEST(Diagnostic, ShowsPlaceLineCaretAndHint) {
    const Source source("m.mo", "model A\n  Real x\n  Real y;\nend A;\n");
    const Diagnostic diagnostic = error("expected \";\"", Span{&source, 10, 14}, "end the declaration");
    EXPECT_EQ(format(diagnostic),
              "m.mo:2:3: error: expected \";\"\n"
              "    Real x\n"
              "    ^~~~\n"
              "    hint: end the declaration\n");
}

TEST(Diagnostic, CaretStandsUnderTheCharacterNotTheByte) {
    const Source source("m.mo", "\tReal T \"in °C\" = µ;");
    const auto at = static_cast<std::uint32_t>(source.text().find("µ"));
    EXPECT_EQ(format(error("bad", Span{&source, at, at + 2})),
              "m.mo:1:20: error: bad\n"
              "    Real T \"in °C\" = µ;\n"
              "                     ^\n");
}

TEST(Diagnostic, CutsALongLineAroundTheCaret) {
    const Source source("m.mo", std::string(50000, 'a') + "!" + std::string(50000, 'b'));
    const std::string text = format(error("bad", Span{&source, 50000, 50001}));
    EXPECT_LT(text.size(), 400u);
    EXPECT_NE(text.find("a!b"), std::string::npos);
    const auto lines = [&] {
        std::vector<std::string> result{""};
        for (const char c : text) {
            if (c == '\n')
                result.emplace_back();
            else
                result.back() += c;
        }
        return result;
    }();
    // "…" takes three bytes and one column.
    EXPECT_EQ(lines[1].find('!') - 2, lines[2].find('^'));
}

TEST(Diagnostic, ShowsWhatCannotBePrintedAsQuestionMarks) {
    const Source source("m.mo", "a\x01\xff z");
    EXPECT_EQ(format(error("bad", Span{&source, 4, 5})), "m.mo:1:5: error: bad\n    a?? z\n        ^\n");
}

TEST(Diagnostic, ASpanOverSeveralLinesIsMarkedInItsFirst) {
    const Source source("m.mo", "ab(\n  c)");
    EXPECT_EQ(format(error("bad", Span{&source, 2, 8})), "m.mo:1:3: error: bad\n    ab(\n      ^\n");
}

TEST(Diagnostic, AnEmptySpanAtTheEndOfALineHasACaretBehindIt) {
    const Source source("m.mo", "Real x");
    EXPECT_EQ(format(error("bad", Span{&source, 6, 6})), "m.mo:1:7: error: bad\n    Real x\n          ^\n");
}

TEST(Diagnostic, FaultsOfFilesHaveRowAndColumn) {
    EXPECT_EQ(format(fileError("not a number", "train.csv", 17, 3)), "train.csv:17:3: error: not a number\n");
    EXPECT_EQ(format(fileError("not a number", "train.csv")), "train.csv: error: not a number\n");
    EXPECT_EQ(format(error("no model")), "error: no model\n");
    EXPECT_EQ(format(warning("odd")), "warning: odd\n");
}

TEST(Diagnostic, OutlivesItsSource) {
    Diagnostic diagnostic;
    {
        const Source source("m.mo", "Real x");
        diagnostic = error("bad", Span{&source, 0, 4});
    }
    EXPECT_NE(format(diagnostic).find("Real x"), std::string::npos);
}

TEST(Diagnostics, WarningsAreNoErrors) {
    EXPECT_FALSE(hasError({warning("a"), warning("b")}));
    EXPECT_TRUE(hasError({warning("a"), error("b")}));
    EXPECT_EQ(format(Diagnostics{warning("a"), error("b")}), "warning: a\nerror: b\n");
}

TEST(Suggestion, FindsTheMisspeltName) {
    const std::vector<std::string> names{"flange_a", "flange_b", "heatPort", "phi"};
    EXPECT_EQ(suggestion("flagne_b", names), "flange_b");
    EXPECT_EQ(suggestion("heatport", names), "heatPort");
    EXPECT_EQ(suggestion("heat_port", names), "heatPort");
    EXPECT_EQ(suggestion("phj", names), "phi");
}

TEST(Suggestion, StaysSilentWhenNothingIsNear) {
    EXPECT_EQ(suggestion("temperature", {"flange_a", "phi"}), "");
    EXPECT_EQ(suggestion("ab", {"cd", "xy"}), "");
    EXPECT_EQ(suggestion("x", {}), "");
}

TEST(Outcome, HoldsAValueWithWarningsOrFaults) {
    const Outcome<int> good(3, {warning("odd")});
    ASSERT_TRUE(good);
    EXPECT_EQ(*good, 3);
    EXPECT_EQ(good.diagnostics().size(), 1u);
    const Outcome<int> bad(error("broken"));
    EXPECT_FALSE(bad);
    EXPECT_EQ(bad.diagnostics().front().message, "broken");
}

}  // namespace
}  // namespace analogon
