#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSplitter>
#include <QToolButton>
#include <QTreeWidget>

#include "tests/ui/panels_fixture.hpp"
#include "ui/effect/result_panel.hpp"
#include "ui/fit/fit_panel.hpp"
#include "ui/signals/plot_layout.hpp"

namespace analogon::ui {

namespace {

/// What runs leave behind, by mouse and keys.
class Runs : public Panels {
protected:
    FitPanel* runs() const { return panel<FitPanel>(); }
    void showRuns() {
        auto* dock = window.findChild<QDockWidget*>("runs");
        dock->show();
        dock->raise();
        QTest::qWait(20);
    }
    void click(int row, Qt::KeyboardModifiers keys = Qt::NoModifier) {
        QTreeWidget* list = runs()->history();
        const QRect at = list->visualItemRect(list->topLevelItem(row));
        QTest::mouseClick(list->viewport(), Qt::LeftButton, keys, at.center());
    }
    void arrange(const QString& formula) {
        StudySettings settings = settingsOf(document().study());
        settings.plots = withPlotLayout(settings.plots, {{}, {formula}});
        document().applySettings(std::move(settings), "arrange");
    }
    bool saveAndReopen(const QString& name) {
        const QString file = directory.filePath(name + ".analogon");
        window.saveTo(file);
        if (!QTest::qWaitFor([&] { return !document().isModified(); }, 10000)) return false;
        window.open(lambdaFile("between"));
        if (!QTest::qWaitFor([&] { return document().title() == "between" && document().before(); }, 20000))
            return false;
        window.open(file);
        return QTest::qWaitFor([&] { return document().title() == name && document().before(); }, 20000);
    }
};

std::vector<double> numbers(const Eigen::VectorXd& values) { return {values.data(), values.data() + values.size()}; }

}  // namespace

TEST_F(Runs, ShowsTheResultOfThenWhenAStudyIsOpenedAgain) {
    openLambda();
    run(RunKind::Fit);
    const auto before = document().before(), after = document().after();
    ASSERT_TRUE(before && after);
    const double error = after->parameters.front().standardError;
    ASSERT_GT(error, 0);
    ASSERT_TRUE(saveAndReopen("kept"));
    EXPECT_FALSE(document().isModified());
    ASSERT_TRUE(document().finding());
    EXPECT_FALSE(document().isResultStale());
    ASSERT_TRUE(document().after());
    EXPECT_EQ(numbers(document().after()->experiments[0].outputs[0].simulated),
              numbers(after->experiments[0].outputs[0].simulated));
    EXPECT_EQ(numbers(document().before()->experiments[0].outputs[0].simulated),
              numbers(before->experiments[0].outputs[0].simulated));
    EXPECT_EQ(document().after()->parameters.front().standardError, error);
    const auto* results = panel<ResultPanel>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return results->comparison() != nullptr; }, 5000)) << "filled as it was left";
    EXPECT_GT(results->comparison()->topLevelItemCount(), 0);
}

TEST_F(Runs, HaveNamesNotesAndPinsThatAreInTheProject) {
    openLambda();
    run(RunKind::Fit);
    run(RunKind::Fit);
    showRuns();
    EXPECT_TRUE(runs()->nameField()->isHidden() || !runs()->nameField()->isVisible()) << "of no run";
    click(0);
    ASSERT_TRUE(runs()->nameField()->isVisible());
    QTest::mouseClick(runs()->nameField(), Qt::LeftButton);
    QTest::keyClicks(runs()->nameField(), "cold sample");
    QTest::keyClick(runs()->nameField(), Qt::Key_Return);
    QTest::mouseClick(runs()->noteField(), Qt::LeftButton);
    QTest::keyClicks(runs()->noteField(), "fan off");
    QTest::keyClick(runs()->noteField(), Qt::Key_Return);
    QTest::mouseClick(runs()->pinButton(), Qt::LeftButton);
    EXPECT_TRUE(document().isModified());
    EXPECT_EQ(runs()->history()->topLevelItem(0)->text(0), QString::fromUtf8("cold sample – fan off"));
    EXPECT_FALSE(runs()->history()->topLevelItem(0)->icon(0).isNull());
    ASSERT_TRUE(saveAndReopen("named"));
    ASSERT_EQ(document().history().size(), 2u);
    EXPECT_EQ(document().history()[0].name, "cold sample");
    EXPECT_EQ(document().history()[0].note, "fan off");
    EXPECT_TRUE(document().history()[0].isPinned);
    EXPECT_FALSE(document().history()[1].isPinned);
    const Study ranOn = document().study();
    const RunResult result = *document().result();
    for (int i = 0; i < 45; ++i) document().setResult(RunKind::Fit, result, ranOn, i);
    EXPECT_EQ(document().history().front().name, "cold sample") << "however many runs follow";
    EXPECT_EQ(document().history().size(), 41u);
}

TEST_F(Runs, AreComparedOnAsManyRowsAsAreChosen) {
    openLambda();
    for (int i = 0; i < 3; ++i) run(RunKind::Fit);
    document().describeRun(document().history()[1].number, "middle", {});
    showRuns();
    click(0);
    click(1, Qt::ControlModifier);
    click(2, Qt::ControlModifier);
    const QTreeWidget* table = runs()->comparison();
    ASSERT_TRUE(table->isVisible());
    ASSERT_EQ(table->columnCount(), 4);
    EXPECT_EQ(table->headerItem()->text(2), "middle");
    EXPECT_TRUE(table->headerItem()->text(1).startsWith("A "));
    EXPECT_TRUE(table->headerItem()->text(3).startsWith("B "));
    for (int c = 1; c < 4; ++c) {
        EXPECT_TRUE(table->topLevelItem(0)->text(c).endsWith("%"));
        EXPECT_LE(table->columnViewportPosition(c) + table->columnWidth(c), table->viewport()->width());
    }
    ASSERT_TRUE(document().comparedRuns());
    EXPECT_EQ(document().comparedRuns()->first.number, document().history()[0].number);
    EXPECT_EQ(document().comparedRuns()->second.number, document().history()[2].number);
    click(1);
    EXPECT_FALSE(document().comparedRuns());
    EXPECT_EQ(runs()->nameField()->text(), "middle");
}

/// The plots belong to the run: back at it, they are arranged as they were.
TEST_F(Runs, BringTheirPlotsWithThem) {
    openLambda();
    run(RunKind::Fit);
    arrange("1+1");
    run(RunKind::Fit);
    arrange("2+2");
    ASSERT_TRUE(saveAndReopen("arranged"));
    showRuns();
    click(0);
    QTest::mouseClick(runs()->restoreButton(), Qt::LeftButton);
    EXPECT_EQ(plotLayoutOf(document().study().extraJson).formulas, std::vector<QString>{"1+1"});
    EXPECT_EQ(document().shownRun(), document().history()[0].number);
}

TEST_F(Runs, CtrlFFindsThemByNameNoteAndEffect) {
    openLambda();
    run(RunKind::Fit);
    run(RunKind::Fit);
    showRuns();
    document().describeRun(document().history()[0].number, "night shift", "new valve");
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    runs()->history()->setFocus();
    QTest::keyClick(runs()->history(), Qt::Key_F, Qt::ControlModifier);
    QLineEdit* field = runs()->filterField();
    ASSERT_TRUE(field->isVisible());
    EXPECT_TRUE(field->hasFocus());
    QTest::keyClicks(field, "VALVE night");
    EXPECT_FALSE(runs()->history()->topLevelItem(0)->isHidden());
    EXPECT_TRUE(runs()->history()->topLevelItem(1)->isHidden());
    run(RunKind::Fit);
    EXPECT_TRUE(runs()->history()->topLevelItem(2)->isHidden()) << "the filter holds for runs that follow";
    field->setFocus();
    QTest::keyClick(field, Qt::Key_Escape);
    EXPECT_FALSE(field->isVisible());
    for (int row = 0; row < 3; ++row) EXPECT_FALSE(runs()->history()->topLevelItem(row)->isHidden());
}

}  // namespace analogon::ui
