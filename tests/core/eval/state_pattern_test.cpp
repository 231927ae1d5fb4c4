#include "core/eval/state_pattern.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/core/simulate/text_models.hpp"

namespace analogon {
namespace {

/// A chain of n masses; `hub`: one more that all of them heat.
std::string chainText(int n, bool hub) {
    std::string text = "model Chain\n  output Real y;\n", equations = "equation\n";
    for (int i = 1; i <= n; ++i) {
        text += fmt::format("  Real T{}(start = 1, fixed = true);\n", i);
        equations += fmt::format("  der(T{0}) = 0 ", i);
        if (i > 1) equations += fmt::format("+ T{}^2 - T{}^2 ", i - 1, i);
        if (i < n) equations += fmt::format("+ T{} - T{} ", i + 1, i);
        equations += ";\n";
    }
    if (hub) {
        text += "  Real H(start = 0, fixed = true);\n";
        equations += "  der(H) = 0";
        for (int i = 1; i <= n; ++i) equations += fmt::format(" + T{}", i);
        equations += ";\n";
    }
    return text + equations + "  y = T1;\nend Chain;\n";
}

std::set<std::pair<std::string, std::string>> pairsOf(const System& system, const StatePattern& pattern) {
    std::set<std::pair<std::string, std::string>> pairs;
    for (int j = 0; j < pattern.states(); ++j)
        for (int e = pattern.starts[static_cast<std::size_t>(j)]; e < pattern.starts[static_cast<std::size_t>(j) + 1];
             ++e)
            pairs.emplace(system.states()[static_cast<std::size_t>(pattern.rows[static_cast<std::size_t>(e)])].name,
                          system.states()[static_cast<std::size_t>(j)].name);
    return pairs;
}

TEST(StatePattern, OfAChainHasTheNeighboursAloneAndThreeGroups) {
    const SystemPtr system = test::compileText(chainText(30, false), "Chain");
    ASSERT_TRUE(system);
    const StatePattern* pattern = system->statePattern();
    ASSERT_TRUE(pattern);
    std::set<std::pair<std::string, std::string>> expected;
    for (int i = 1; i <= 30; ++i)
        for (int j = std::max(1, i - 1); j <= std::min(30, i + 1); ++j)
            expected.emplace(fmt::format("T{}", i), fmt::format("T{}", j));
    EXPECT_EQ(pairsOf(*system, *pattern), expected);
    EXPECT_EQ(pattern->groups, 3);
}

TEST(StatePattern, PutsNoTwoColumnsWithARowInCommonIntoAGroup) {
    const SystemPtr system = test::compileText(chainText(30, true), "Chain");
    ASSERT_TRUE(system);
    const StatePattern* pattern = system->statePattern();
    ASSERT_TRUE(pattern);
    std::set<std::pair<int, int>> taken;  // row, group
    for (int j = 0; j < pattern->states(); ++j)
        for (int e = pattern->starts[static_cast<std::size_t>(j)]; e < pattern->starts[static_cast<std::size_t>(j) + 1];
             ++e)
            EXPECT_TRUE(
                taken.emplace(pattern->rows[static_cast<std::size_t>(e)], pattern->groupOf[static_cast<std::size_t>(j)])
                    .second);
    EXPECT_EQ(pattern->groups, 30);  // every mass is in the row of the hub
}

TEST(StatePattern, OfFewOrFullyCoupledStatesIsNotKept) {
    EXPECT_FALSE(test::compileText(chainText(5, false), "Chain")->statePattern());
    std::vector<std::vector<int>> full(20, std::vector<int>(20));
    for (auto& row : full)
        for (int j = 0; j < 20; ++j) row[static_cast<std::size_t>(j)] = j;
    EXPECT_FALSE(statePatternOf(full));
}

}  // namespace
}  // namespace analogon
