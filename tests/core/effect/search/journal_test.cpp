#include "core/effect/search/journal.hpp"

#include <gtest/gtest.h>

#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {
namespace {

TEST(Journal, SaysNothingWhereNobodyAsks) {
    const Journal journal(nullptr);
    journal.add("screen", "a", {}, "visible");
    journal.test("missed", "a", {}, "kept");
    journal.finding({});
}

TEST(Journal, TellsWhereTheSearchIsAndTheTestsByTheirNames) {
    const auto trace = std::make_shared<DecisionTrace>();
    Journal journal(trace);
    journal.path = 2;
    journal.round = 3;
    Acceptance test;
    test.evidence = 42;
    journal.test("missed", "a@x", test, "kept");
    const std::vector<Decision> decisions = trace->decisions();
    ASSERT_EQ(decisions.size(), 1u);
    EXPECT_EQ(decisions[0].path, 2);
    EXPECT_EQ(decisions[0].round, 3);
    EXPECT_EQ(decisions[0].figures.at(1), (std::pair<std::string, double>("evidence", 42)));
}

TEST(Journal, TellsOfARoundWhatWasScreenedAskedAndRefitted) {
    DiscoverOptions options;
    options.trace = std::make_shared<DecisionTrace>();
    WarmSearch of(laggingBody(3), options);
    const Round round = tryAll(of.search, of.base);
    std::map<std::string, std::size_t> count;
    for (const Decision& d : options.trace->decisions()) ++count[d.step];
    EXPECT_EQ(count["screen"], round.screened.size());
    EXPECT_EQ(count["trial"], round.trials.size());
    EXPECT_EQ(count["threshold"], 1u);
}

}  // namespace
}  // namespace analogon
