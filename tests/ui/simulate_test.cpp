#include <QAction>
#include <QDesktopServices>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QTextBrowser>
#include <QToolButton>
#include <QTreeView>
#include <QTreeWidget>

#include "core/report/words.hpp"
#include "core/study/free_run.hpp"
#include "tests/ui/panels_fixture.hpp"
#include "ui/fit/fit_panel.hpp"
#include "ui/measurement/practice_dialog.hpp"
#include "ui/plot/plot_panel.hpp"
#include "ui/signals/signal_browser.hpp"
#include "ui/signals/signal_values.hpp"
#include "ui/style/style.hpp"
#include "ui/style/translator.hpp"

namespace analogon::ui {

namespace {

/// A study without a recording.
class Simulate : public Panels {
protected:
    void start(const std::string& text) {
        Study study;
        study.name = "lag";
        study.className = "M";
        study.models["model.mo"] = text;
        document().startWith(study);
        ASSERT_TRUE(
            QTest::qWaitFor([&] { return document().isOpen() && !document().facts().variables.empty(); }, 20000));
    }
    void startLag() {
        start(R"(model M
  Analogon.Sources.Step step(height=2, startTime=0.5);
  Analogon.Signals.FirstOrder lag(T=0.4);
  Analogon.Interfaces.RealOutput y(unit="K");
equation
  connect(step.y, lag.u);
  connect(lag.y, y);
end M;
)");
    }
    void simulate() {
        const unsigned long before = document().history().size();
        QTest::keyClick(&window, Qt::Key_F4);
        ASSERT_TRUE(QTest::qWaitFor([&] { return document().history().size() == before + 1; }, 20000));
    }
    const ExperimentState& shown() { return document().after()->experiments.front(); }
    static double last(const ExperimentState& of) { return of.outputs.front().simulated.tail(1)[0]; }
    QString messages() {
        QStringList all;
        for (const Message& m : document().messages())
            all << QString::fromStdString(m.diagnostic.message.english() + " " + m.diagnostic.hint.english());
        return all.join('\n');
    }
};

TEST_F(Simulate, ShowsAModelWithoutARecordingAsARunLikeOthers) {
    startLag();
    simulate();
    auto* const plots = panel<PlotPanel>();
    ASSERT_EQ(plots->plots().size(), 1u);
    EXPECT_TRUE(plots->plots().front()->isVisible());
    EXPECT_TRUE(plots->plots().front()->legendText(TraceRole::Measured).isEmpty()) << "nothing was measured";
    EXPECT_EQ(plots->plots().front()->legendText(TraceRole::After), "simulated");
    EXPECT_FALSE(plots->plots().front()->residual()->isVisible());
    EXPECT_FALSE(plots->residualButton()->isVisible());
    EXPECT_EQ(document().history().back().kind, RunKind::Simulate);
    EXPECT_EQ(panel<FitPanel>()->history()->topLevelItemCount(), 1);
    EXPECT_NEAR(last(shown()), 2 * (1 - std::exp(-0.5 / 0.4)), 1e-4);
    window.grab().save(QStringLiteral(ANALOGON_PICTURES) + "/simulate.png");
}

TEST_F(Simulate, EndsWhenIsTypedAndTheModelKeepsIt) {
    startLag();
    QTest::keyClick(&window, Qt::Key_5, Qt::ControlModifier);  // the runs
    auto* const stop = window.findChild<QLineEdit*>("stop-time");
    ASSERT_TRUE(stop && stop->isVisible());
    EXPECT_EQ(stop->text(), "1 s");
    stop->setFocus();
    stop->selectAll();
    QTest::keyClicks(stop, "2,5");
    QTest::keyClick(stop, Qt::Key_Return);
    EXPECT_EQ(stop->text(), "2.5 s");
    EXPECT_TRUE(document().modelText().contains("annotation (experiment(StopTime=2.5));"));
    simulate();
    EXPECT_DOUBLE_EQ(shown().time.back(), 2.5);
    document().undoStack().undo();
    EXPECT_EQ(stop->text(), "1 s");
    stop->selectAll();
    QTest::keyClicks(stop, "soon");
    QTest::keyClick(stop, Qt::Key_Return);
    EXPECT_EQ(stop->text(), "1 s") << "what is no time changes nothing";
}

TEST_F(Simulate, FollowsTheModelOnceItWasSimulated) {
    startLag();
    simulate();
    document().setParameterValue("lag.T", 0.1);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            const auto now = document().before();
            return now && !document().after() && std::abs(last(now->experiments.front()) - 1.98652) < 1e-3;
        },
        20000));
    EXPECT_EQ(panel<PlotPanel>()->plots().size(), 1u);
    EXPECT_EQ(document().history().size(), 1u) << "looking is no run";
}

TEST_F(Simulate, NamesTheInputThatNothingDrivesAndWhatToDo) {
    start("model M\n  input Real u;\n  output Real y;\nequation\n  der(y) = u - y;\nend M;\n");
    QTest::keyClick(&window, Qt::Key_F4);
    ASSERT_TRUE(QTest::qWaitFor([&] { return messages().contains("'u'"); }, 20000)) << messages().toStdString();
    EXPECT_TRUE(messages().contains("Connect a source")) << messages().toStdString();
    EXPECT_TRUE(document().history().empty());
}

TEST_F(Simulate, GivesAnyVariableToTheBrowserOfSignals) {
    startLag();
    simulate();
    SignalValues values(document());
    const SignalRef u{SignalKind::Variable, "Simulation", "lag.u"};
    ASSERT_TRUE(QTest::qWaitFor([&] { return values.at(u) != nullptr; }, 20000));
    ASSERT_TRUE(values.at(u)->time) << values.at(u)->fault.toStdString();
    EXPECT_DOUBLE_EQ(values.at(u)->values[0], 0);
    EXPECT_DOUBLE_EQ(values.at(u)->values[values.at(u)->values.size() - 1], 2);
}

TEST_F(Simulate, StaysInTheFileOfTheStudy) {
    startLag();
    simulate();
    const QString file = directory.filePath("lag.analogon");
    window.saveTo(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document().isModified(); }, 20000));
    window.open(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document().isReading() && document().history().size() == 1; }, 20000));
    EXPECT_EQ(document().history().front().kind, RunKind::Simulate);
    ASSERT_TRUE(document().after());
    EXPECT_NEAR(last(shown()), 2 * (1 - std::exp(-0.5 / 0.4)), 1e-4);
}

TEST_F(Simulate, BecomesARecordingToPractiseOnInOneStep) {
    startLag();
    EXPECT_FALSE(window.findChild<QAction*>("practice")->isEnabled()) << "nothing was simulated yet";
    simulate();
    window.findChild<QAction*>("practice")->trigger();
    auto* const dialog = window.findChild<PracticeDialog*>();
    ASSERT_TRUE(dialog && dialog->isVisible());
    EXPECT_EQ(dialog->noiseTable()->item(0, 0)->text(), "y [K]");
    dialog->grab().save(QStringLiteral(ANALOGON_PICTURES) + "/practice.png");

    const QString file = directory.filePath("practised.csv");
    const auto type = [](QLineEdit* field, const QString& text) {
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
    };
    type(dialog->sampleTimeField(), "nothing");
    EXPECT_FALSE(dialog->recordButton()->isEnabled());
    type(dialog->sampleTimeField(), "0,002");
    type(dialog->fileField(), directory.filePath("missing/x.csv"));
    EXPECT_FALSE(dialog->recordButton()->isEnabled());
    type(dialog->fileField(), file);
    dialog->noiseTable()->item(0, 1)->setText("0.05");
    ASSERT_TRUE(dialog->recordButton()->isEnabled()) << dialog->faultLabel()->text().toStdString();
    const int steps = document().undoStack().count();
    QTest::mouseClick(dialog->recordButton(), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document().study().experiments.empty(); }, 20000));
    EXPECT_EQ(document().undoStack().count(), steps + 1);
    const StudyExperiment made = document().study().experiments.front();
    EXPECT_EQ(made.name, "practised");
    ASSERT_TRUE(made.outputs.contains("y"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().canRun() && document().before(); }, 20000));
    // what is told of it is its noise
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            const auto now = document().before();
            return now && now->experiments.size() == 2 && now->experiments.back().name == "practised";
        },
        20000));
    EXPECT_NEAR(document().before()->experiments.back().outputs.front().figures.rmse, 0.05, 0.006);

    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    simulate();  // over the recording, too
    ASSERT_TRUE(document().after());
    EXPECT_EQ(document().after()->experiments.size(), 2u);
    const double error = errorPercent(*document().after(), Role::Fit);
    EXPECT_TRUE(error > 1 && error < 6) << error;
    window.writeReport(directory.filePath("report"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return QFileInfo::exists(directory.filePath("report/report.pdf")); }, 60000))
        << messages().toStdString();
    EXPECT_TRUE(QFileInfo::exists(directory.filePath("report/report.html")));
    document().undoStack().undo();
    EXPECT_TRUE(document().study().experiments.empty());
    EXPECT_TRUE(QFileInfo::exists(file));
}

TEST_F(Simulate, OverwritesNoFile) {
    startLag();
    simulate();
    QFile taken(directory.filePath("taken.csv"));
    ASSERT_TRUE(taken.open(QIODevice::WriteOnly));
    taken.write("mine");
    taken.close();
    window.findChild<QAction*>("practice")->trigger();
    auto* const dialog = window.findChild<PracticeDialog*>();
    dialog->fileField()->setText(taken.fileName());
    EXPECT_FALSE(dialog->recordButton()->isEnabled());
    EXPECT_TRUE(dialog->faultLabel()->text().contains("already"));
    QTest::keyClick(dialog, Qt::Key_Escape);
    EXPECT_FALSE(dialog->isVisible());
}

TEST_F(Simulate, AReportThatIsWrittenIsOpenedFromTheStatusLine) {
    openLambda();
    run(RunKind::Fit);
    window.writeReport(directory.filePath("report"));
    QToolButton* open = nullptr;
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return (open = window.findChild<QToolButton*>("open-report")) && open->isVisible(); }, 60000));
    QTextBrowser reader;  // in place of the program that the desktop would open it with
    QDesktopServices::setUrlHandler("file", &reader, "setSource");
    QTest::mouseClick(open, Qt::LeftButton);
    QDesktopServices::unsetUrlHandler("file");
    EXPECT_EQ(reader.source().toLocalFile(), directory.filePath("report/report.html"));
    EXPECT_TRUE(QFileInfo::exists(reader.source().toLocalFile()));
    window.grab().save(QStringLiteral(ANALOGON_PICTURES) + "/report-open.png");
    window.startNew();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !open->isVisible(); }, 20000)) << "it belongs to the study before";
}

/// The runs and the dialog as a German user sees them on a small dark screen.
TEST(SimulatePictures, HaveRoomForEveryWord) {
    Translator german;
    if (german.loadLanguage("de")) QCoreApplication::installTranslator(&german);
    style::apply(*qApp, style::Theme::Dark);
    {
        MainWindow window;
        window.resize(1024, 700);
        window.show();
        Study study;
        study.name = "chirp";
        study.className = "M";
        study.models["model.mo"] = R"(model M
  Analogon.Sources.Chirp chirp(f1=0.5, f2=4, duration=8) annotation (Placement(transformation(extent={{-80,-10},{-60,10}})));
  Analogon.Sources.Pulse pulse(period=2, width=30) annotation (Placement(transformation(extent={{-80,30},{-60,50}})));
  Analogon.Sources.Trapezoid trapezoid annotation (Placement(transformation(extent={{-80,-50},{-60,-30}})));
  Analogon.Sources.Ramp ramp annotation (Placement(transformation(extent={{-30,30},{-10,50}})));
  Analogon.Sources.Sine sine annotation (Placement(transformation(extent={{-30,-50},{-10,-30}})));
  Analogon.Sources.TimeTable table annotation (Placement(transformation(extent={{20,30},{40,50}})));
  Analogon.Signals.FirstOrder lag(T=0.1) annotation (Placement(transformation(extent={{-30,-10},{-10,10}})));
  Analogon.Interfaces.RealOutput y annotation (Placement(transformation(extent={{20,-10},{40,10}})));
equation
  connect(chirp.y, lag.u);
  connect(lag.y, y);
  annotation (experiment(StopTime=10));
end M;
)";
        window.document().startWith(study);
        ASSERT_TRUE(QTest::qWaitFor([&] { return window.document().isOpen(); }, 20000));
        QTest::keyClick(&window, Qt::Key_F4);
        ASSERT_TRUE(QTest::qWaitFor([&] { return window.document().history().size() == 1; }, 20000));
        QTest::qWait(300);
        EXPECT_TRUE(window.findChild<QLineEdit*>("stop-time")->isVisible()) << "the list of runs stays in sight";
        window.grab().save(QStringLiteral(ANALOGON_PICTURES) + "/simulate-dark-de.png");
        window.findChild<QAction*>("practice")->trigger();
        auto* const dialog = window.findChild<PracticeDialog*>();
        ASSERT_TRUE(dialog);
        QTest::qWait(100);
        dialog->grab().save(QStringLiteral(ANALOGON_PICTURES) + "/practice-dark-de.png");
        EXPECT_EQ(dialog->windowTitle(), "Als Messung aufzeichnen");
        for (const QPushButton* button : dialog->findChildren<QPushButton*>())
            EXPECT_GE(button->width(), button->sizeHint().width());
    }
    style::apply(*qApp, style::Theme::Light);
    QCoreApplication::removeTranslator(&german);
}

TEST_F(Simulate, OfAStudyWithRecordingsRunsOverThese) {
    openLambda();
    simulate();
    ASSERT_TRUE(document().after());
    EXPECT_EQ(document().after()->experiments.size(), 2u) << "nothing but recordings drives that model";
    EXPECT_TRUE(panel<PlotPanel>()->residualButton()->isVisible());
    EXPECT_TRUE(panel<PlotPanel>()->plots().front()->legendText(TraceRole::After).startsWith("simulated"));
}

}  // namespace
}  // namespace analogon::ui
