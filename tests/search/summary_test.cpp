#include "tests/search/summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace analogon::net {
namespace {

const std::string report = R"({"format": "analogon-report-1", "program": {"name": "analogon", "version": "1.2"},
  "finding": "effect", "seconds": 3.25,
  "final": {"convergence": {"seconds": 0.1, "iterations": 5}},
  "effects": [{"kind": "friction.coulomb", "at": "rotor", "class": "A", "parameters": {"tau_c": {"value": 0.123456789}}}],
  "candidates": [{"kind": "sensor.lag", "at": "output w", "class": "B", "round": 1, "score": 1.5},
                 {"kind": "sensor.lag", "at": "output w", "class": "B", "round": 2, "score": 2.5}],
  "warnings": []})";
const std::string trace =
    R"({"number":0,"step":"screen","key":"B@output w@@","path":0,"round":0,"figures":{"score":1.5},"verdict":"visible"}
{"number":1,"step":"choose","key":"A@rotor@@","path":1,"round":1,"figures":{"evidence":4641.0},"verdict":"chosen"}
{"number":2,"step":"choose","key":"A@rotor@@","path":1,"round":1,"verdict":"chosen","reason":"again"}
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

TEST(NetSummary, TellsLinesByWhatTheyAreOf) {
    const Summary summary = summaryOf(report, trace);
    EXPECT_EQ(summary.at("finding"), "effect");
    EXPECT_EQ(summary.at("effects/friction.coulomb at rotor (A)/parameters/tau_c/value"), "0.123457");
    EXPECT_EQ(summary.at("candidates/sensor.lag at output w (B) round 2/score"), "2.5");
    EXPECT_EQ(summary.at("trace 1.1 choose: A@rotor@@"), "chosen; evidence 4641");
    EXPECT_EQ(summary.at("trace 1.1 choose: A@rotor@@ #2"), "chosen; again");
    EXPECT_EQ(summary.at("warnings"), "[]");
}

TEST(NetSummary, LeavesOutTimesAndVersion) {
    const Summary summary = summaryOf(report, trace);
    for (const auto& [name, value] : summary) {
        EXPECT_EQ(name.find("seconds"), std::string::npos);
        EXPECT_EQ(name.find("version"), std::string::npos);
    }
    EXPECT_TRUE(differences(summary, summaryOf(replaced(report, "3.25", "9.5"), trace)).empty());
    EXPECT_TRUE(differences(summary, summaryOf(replaced(report, "\"1.2\"", "\"2\""), trace)).empty());
}

TEST(NetSummary, SeesADigitBehindTheSixth) {
    const auto all = differences(summaryOf(report, trace), summaryOf(replaced(report, "456789", "456788"), trace));
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].name, "exact");
}

TEST(NetSummary, ReadsWhatItHasWritten) {
    const Summary summary = summaryOf(report, trace);
    EXPECT_EQ(summaryFrom(textOf(summary)), summary);
}

TEST(NetSummary, IsCondensedToWhatIsDecidedOnce) {
    const Summary whole = summaryOf(report, trace), small = condensed(whole);
    EXPECT_LT(small.size(), whole.size());
    EXPECT_EQ(small.at("trace 1.1 choose: A@rotor@@"), "chosen; evidence 4641");
    EXPECT_THAT(small.at("trace 0.0 screen"), testing::StartsWith("1 lines, "));
    EXPECT_TRUE(differences(small, whole).empty());
    const auto all = differences(small, summaryOf(replaced(report, "2.5}", "2.6}"), trace));
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].name, "candidates");
}

TEST(NetSummary, TellsWhatIsNewAndWhatIsGone) {
    const auto all = differences(summaryOf(report, trace),
                                 summaryOf(replaced(report, R"("warnings": [])", R"("warnings": ["slow"])"),
                                           replaced(trace, "@rotor", "@shaft")));
    std::vector<std::string> lines;
    for (const Difference& d : all) lines.push_back(d.name + ": " + d.before + " -> " + d.after);
    EXPECT_THAT(lines, testing::IsSupersetOf({std::string("warnings: [] -> -"), std::string("warnings/0: - -> slow"),
                                              std::string("trace 1.1 choose: A@shaft@@: - -> chosen; evidence 4641")}));
}

}  // namespace
}  // namespace analogon::net
