#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QTreeView>
#include <QTreeWidget>

#include "tests/ui/panels_fixture.hpp"
#include "tests/working_time.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/effect/result_panel.hpp"
#include "ui/find/find_dialog.hpp"
#include "ui/fit/fit_panel.hpp"
#include "ui/inspector/parameter_panel.hpp"
#include "ui/signals/signal_browser.hpp"
#include "ui/style/style.hpp"
#include "ui/style/translator.hpp"
#include "ui/text/text_view.hpp"

namespace analogon::ui {

namespace {

using Kind = StudyEntry::Kind;

TEST(StudyEntries, AreFoundByEachWordKindByKindWithTheBeginningFirst) {
    std::vector<StudyEntry> entries;
    const auto add = [&](Kind kind, const QString& name, const QString& detail = {}) {
        entries.push_back(withWords({kind, name, detail, name}));
    };
    add(Kind::Component, "motor", "DC machine");
    add(Kind::Component, "pump", "driven by the motor");
    add(Kind::Parameter, "motor.R", "1.2 Ohm");
    add(Kind::Parameter, "R_motor");
    add(Kind::Text, "Motor motor;");
    EXPECT_EQ(matchingEntries(entries, "MOTOR"), (std::vector<int>{0, 1, 2, 3, 4}));
    EXPECT_EQ(matchingEntries(entries, "R_m"), (std::vector<int>{3}));
    EXPECT_EQ(matchingEntries(entries, "r mot"), (std::vector<int>{0, 1, 3, 2, 4})) << "R_motor begins with r";
    EXPECT_EQ(matchingEntries(entries, "motor ohm"), (std::vector<int>{2}));
    EXPECT_EQ(matchingEntries(entries, ""), (std::vector<int>{0, 1, 2, 3})) << "texts once something is asked for";
    EXPECT_TRUE(matchingEntries(entries, "xyz").empty());
}

TEST(StudyEntries, TwentyThousandAreFilteredBetweenTwoKeys) {
    std::vector<StudyEntry> entries;
    for (int i = 0; i < 20000; ++i)
        entries.push_back(withWords({static_cast<Kind>(i / 5000),
                                     QStringLiteral("body%1.port.Q_flow").arg(i),
                                     "heat flow rate into the component · W",
                                     {}}));
    EntryModel model;
    model.setEntries(entries);
    QTreeView list;
    list.setModel(&model);
    list.setUniformRowHeights(true);
    list.show();
    for (const char* query : {"b", "bo", "body1", "body1 heat", "none of them", ""}) {
        const double search = test::leastMilliseconds(3, [&] {
            model.search("nothing of this name");
            model.search(query);
        });
        EXPECT_LT(search, 50) << "[ms] " << query;
    }
    EXPECT_EQ(model.matches(), 20000);
    EXPECT_EQ(model.rowCount(), 20004) << "and a heading for each kind";
}

/// Ctrl+Shift+F, and where it leads.
class FindInStudy : public Panels {
protected:
    FindDialog* open() {
        window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
        QTest::keyClick(&window, Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
        auto* dialog = window.findChild<FindDialog*>();
        EXPECT_TRUE(dialog && dialog->isVisible());
        return dialog;
    }
    /// Goes to the first that is found; false: another kind is the first.
    bool goTo(const QString& words, Kind kind) {
        FindDialog* dialog = open();
        QTest::keyClicks(dialog->field(), words);
        for (int step = 0; step < dialog->model().rowCount(); ++step) {
            const StudyEntry* now = dialog->model().entryAt(dialog->list()->currentIndex());
            if (now && now->kind == kind) break;
            QTest::keyClick(dialog->field(), Qt::Key_Down);
        }
        const StudyEntry* chosen = dialog->model().entryAt(dialog->list()->currentIndex());
        const bool isRight = chosen && chosen->kind == kind;
        QTest::keyClick(dialog->field(), Qt::Key_Return);
        QTest::qWait(20);
        EXPECT_FALSE(window.findChild<FindDialog*>()) << "it is left";
        return isRight;
    }
};

TEST_F(FindInStudy, EnterLeadsToComponentParameterSignalRecordingAndText) {
    openLambda();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document().facts().variables.empty(); }, 20000));
    ASSERT_TRUE(goTo("exhaust", Kind::Component));
    EXPECT_EQ(panel<DiagramScene>()->selectedItems().size(), 1);
    ASSERT_TRUE(goTo("element.C", Kind::Parameter));
    EXPECT_TRUE(window.findChild<QDockWidget*>("parameters")->isVisible());
    ASSERT_TRUE(goTo("u_heater", Kind::Signal));
    auto* browser = panel<SignalBrowser>();
    EXPECT_EQ(browser->model().referenceAt(browser->tree()->currentIndex()).name, "u_heater");
    ASSERT_TRUE(goTo("drive cycle", Kind::Recording));
    ASSERT_TRUE(goTo("PrescribedTemperature exhaust", Kind::Text));
    auto* text = panel<TextView>();
    EXPECT_TRUE(text->textCursor().block().text().contains("PrescribedTemperature exhaust"))
        << text->textCursor().block().text().toStdString();
}

TEST_F(FindInStudy, EnterLeadsToWhatWasTriedAndToRuns) {
    openLambda();
    run(RunKind::Discover);
    ASSERT_TRUE(document().finding() && !document().finding()->candidates.empty());
    document().describeRun(document().history().front().number, "night shift", "with the new valve");
    ASSERT_TRUE(goTo("valve", Kind::Run));
    EXPECT_TRUE(panel<FitPanel>()->history()->topLevelItem(0)->isSelected());
    const CandidateResult& tried = document().finding()->candidates.back();
    ASSERT_TRUE(goTo(QString::fromStdString(tried.kind), Kind::Tried));
    const QTreeWidgetItem* row = panel<ResultPanel>()->candidates()->currentItem();
    ASSERT_TRUE(row);
    EXPECT_EQ(row->data(0, ResultPanel::KindRole).toString(), QString::fromStdString(tried.kind));
}

TEST_F(FindInStudy, SaysWhenNothingIsFoundAndEscapeLeaves) {
    openLambda();
    FindDialog* dialog = open();
    QTest::keyClicks(dialog->field(), "qqqq");
    EXPECT_EQ(dialog->model().matches(), 0);
    EXPECT_EQ(dialog->count()->text(), "Nothing of the study is called so.");
    QTest::keyClick(dialog->field(), Qt::Key_Return);
    EXPECT_TRUE(dialog->isVisible()) << "there is nowhere to go";
    QTest::keyClick(dialog->field(), Qt::Key_Escape);
    EXPECT_FALSE(dialog->isVisible());
}

/// On a small screen, light and dark, in German.
TEST(FindInStudyPictures, HaveRoomForEveryWord) {
    for (const style::Theme theme : {style::Theme::Light, style::Theme::Dark}) {
        Translator german;
        if (german.loadLanguage("de")) QCoreApplication::installTranslator(&german);
        style::apply(*qApp, theme);
        MainWindow window;
        window.resize(1024, 700);
        window.show();
        window.open(QStringLiteral(ANALOGON_ROOT "/examples/lambda-sensor-heating"));
        ASSERT_TRUE(QTest::qWaitFor([&] { return window.document().before() != nullptr; }, 30000));
        window.findChild<QAction*>("find-in-study-action")->trigger();
        auto* dialog = window.findChild<FindDialog*>();
        ASSERT_TRUE(dialog);
        dialog->field()->setText("heater");
        QTest::qWait(50);
        dialog->grab().save(QStringLiteral(ANALOGON_PICTURES) + "/find-in-study-de" +
                            (theme == style::Theme::Dark ? "-dark" : "") + ".png");
        QCoreApplication::removeTranslator(&german);
    }
    style::apply(*qApp, style::Theme::Light);
}

}  // namespace

}  // namespace analogon::ui
