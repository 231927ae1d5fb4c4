#include <QMenu>
#include <QPushButton>
#include <QStatusBar>

#include "tests/ui/panels_fixture.hpp"
#include "tests/ui/sample_finding.hpp"
#include "ui/effect/finding_words.hpp"
#include "ui/effect/result_panel.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {
namespace {

/// A search that ends at its limit of work, and what is offered then.
class LongerSearch : public Panels {
protected:
    ResultPanel* results() const { return panel<ResultPanel>(); }
    QAction* action() const { return window.findChild<QAction*>("search-longer"); }
    /// Steps that were simulated, search by search.
    static std::vector<double> workOf(const DecisionTrace& trace) {
        std::vector<double> work;
        for (const Decision& decision : trace.decisions())
            if (decision.step == "work") work.push_back(decision.figures.front().second);
        return work;
    }
    void TearDown() override { document().undoStack().setClean(); }
};

TEST_F(LongerSearch, IsOfferedInTheResultAndInTheMenuAsLongAsItApplies) {
    openLambda();
    EXPECT_FALSE(action()->isVisible());
    RunResult result = sampleFinding(document(), "thermal.radiation", "Analogon.Effects.Thermal.Radiation",
                                     "Heat radiation", "element.solid", "port", "epsilon");
    result.finding.end.isAtLimitOfWork = true;
    document().setResult(RunKind::Discover, result, document().study());
    ASSERT_TRUE(QTest::qWaitFor([&] { return results()->longerButton() != nullptr; }, 5000));
    EXPECT_TRUE(results()->longerButton()->isVisibleTo(results()));
    EXPECT_TRUE(action()->isVisible());
    EXPECT_TRUE(action()->isEnabled());
    document().setParameterValue("heater.R", 4);
    EXPECT_TRUE(QTest::qWaitFor([&] { return results()->longerButton() == nullptr; }, 5000)) << "of another study";
    EXPECT_FALSE(action()->isVisible());
    document().undoStack().undo();
    EXPECT_TRUE(QTest::qWaitFor([&] { return results()->longerButton() != nullptr; }, 5000));
    result.finding.end.isAtLimitOfWork = false;
    document().setResult(RunKind::Discover, result, document().study());
    EXPECT_TRUE(QTest::qWaitFor([&] { return results()->longerButton() == nullptr; }, 5000));
    EXPECT_FALSE(action()->isVisible());
}

TEST_F(LongerSearch, HasTenTimesTheWorkOfTheOneBefore) {
    openLambda();
    constexpr double hardlyAny = 1e-2;
    window.controller().options().discover.patience = hardlyAny;
    window.controller().options().discover.trace = std::make_shared<DecisionTrace>();
    run(RunKind::Discover);
    ASSERT_TRUE(document().finding());
    ASSERT_TRUE(document().finding()->end.isAtLimitOfWork);
    EXPECT_EQ(window.statusBar()->currentMessage(), "Discover ended at its limit of work; what it has found is shown.");
    ASSERT_TRUE(QTest::qWaitFor([&] { return results()->longerButton() != nullptr; }, 5000));
    QStringList told;
    for (const Text& text : document().finding()->warnings) told << inWords(text);
    EXPECT_TRUE(told.join('\n').contains("Search ten times as long")) << qPrintable(told.join('\n'));
    EXPECT_FALSE(told.join('\n').contains("--patience"));
    const unsigned long first = document().shownRun();
    results()->longerButton()->click();
    ASSERT_TRUE(window.controller().isRunning());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.controller().isRunning(); }, 120000));
    EXPECT_NE(document().shownRun(), first);
    ASSERT_TRUE(document().finding());
    const std::vector<double> work = workOf(*window.controller().options().discover.trace);
    ASSERT_EQ(work.size(), 2u);
    EXPECT_GT(work[1], work[0]);
    EXPECT_LT(work[1], 30 * work[0]) << "ten times, and what was under way";
    EXPECT_EQ(window.controller().options().discover.patience, hardlyAny) << "what others begin with stays";
}

TEST(FindingWords, SayThatASearchEndedAtItsLimitAndWasNotStopped) {
    Finding finding;
    finding.kind = FindingKind::Interrupted;
    finding.end.interrupted = true;
    EXPECT_EQ(findingWords(finding, RunKind::Discover).title, "Search stopped");
    finding.end.isAtLimitOfWork = true;
    EXPECT_EQ(findingWords(finding, RunKind::Discover).title, "Search ended at its limit of work");
    EXPECT_EQ(findingWords(finding, RunKind::Discover).sentence, "What it has found is shown; the rest was not tried.");
}

}  // namespace
}  // namespace analogon::ui
