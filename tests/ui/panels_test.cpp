#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QDirIterator>
#include <QDockWidget>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QImage>
#include <QLabel>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSpinBox>
#include <QSplitter>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>
#include <QTextStream>
#include <QToolBar>
#include <QToolButton>
#include <QTreeWidget>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numeric>
#include <random>

#include "core/archive/archive.hpp"
#include "core/measure/text/text_recording.hpp"
#include "tests/ui/panels_fixture.hpp"
#include "tests/ui/sample_finding.hpp"
#include "tests/working_time.hpp"
#include "ui/canvas/block_item.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/document/composer.hpp"
#include "ui/document/document.hpp"
#include "ui/document/recovery.hpp"
#include "ui/effect/report_pdf.hpp"
#include "ui/effect/result_panel.hpp"
#include "ui/fit/error_curve.hpp"
#include "ui/fit/fit_panel.hpp"
#include "ui/fit/run_controller.hpp"
#include "ui/inspector/parameter_model.hpp"
#include "ui/inspector/parameter_panel.hpp"
#include "ui/library/chooser.hpp"
#include "ui/library/library_model.hpp"
#include "ui/library/library_panel.hpp"
#include "ui/measurement/import_panel.hpp"
#include "ui/measurement/measurement_panel.hpp"
#include "ui/measurement/values_model.hpp"
#include "ui/measurement/values_page.hpp"
#include "ui/messages/message_panel.hpp"
#include "ui/plot/plot_panel.hpp"
#include "ui/plot/residual_plot.hpp"
#include "ui/plot/run_comparison.hpp"
#include "ui/style/style.hpp"
#include "ui/style/translator.hpp"
#include "ui/text/text_view.hpp"
#include "ui/window/compose_actions.hpp"
#include "ui/window/generate_page.hpp"
#include "ui/window/guide_page.hpp"
#include "ui/window/main_window.hpp"
#include "ui/window/recovered_line.hpp"
#include "ui/window/settings.hpp"
#include "ui/window/start_page.hpp"

namespace analogon::ui {
namespace {

TEST_F(Panels, TypingInTheTextIsSeenInTheDiagramAndUndone) {
    openLambda();
    const QString original = document().modelText();
    auto* text = panel<TextView>();
    window.findChild<QTabWidget*>("centre")->setCurrentWidget(text);
    QTextCursor cursor = text->textCursor();
    cursor.setPosition(static_cast<int>(original.indexOf("equation")));
    text->setTextCursor(cursor);
    QTest::keyClicks(text, "Analogon.Thermal.HeatCapacitor typed;");
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().diagram().find("typed") != nullptr; }, 5000));
    EXPECT_EQ(text->textCursor().position(), original.indexOf("equation") + 37) << "the cursor stays where one types";
    EXPECT_TRUE(window.isWindowModified());
    QTest::keyClicks(text, " // half a wor");
    QTest::keyClick(text, Qt::Key_Z, Qt::ControlModifier);
    while (document().undoStack().canUndo()) QTest::keyClick(text, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(document().modelText(), original);
    EXPECT_EQ(text->toPlainText(), original);
    EXPECT_FALSE(window.isWindowModified());
}

/// Both at once on one tab; what is done in one is seen in the other, and the choice is remembered.
TEST_F(Panels, ShowsTheTextBesideTheDiagram) {
    openLambda();
    auto* text = panel<TextView>();
    auto* view = panel<DiagramView>();
    auto* tabs = window.findChild<QTabWidget*>("centre");
    auto* beside = window.findChild<QAction*>("text-beside");
    ASSERT_EQ(tabs->count(), 2);
    beside->trigger();
    QTest::qWait(50);
    ASSERT_EQ(tabs->count(), 1);
    ASSERT_TRUE(view->isVisible() && text->isVisible());
    const QRect left(view->mapTo(&window, QPoint()), view->size()), right(text->mapTo(&window, QPoint()), text->size());
    EXPECT_GT(std::min(left.width(), right.width()), 200);
    EXPECT_LT(left.right(), right.left());
    EXPECT_EQ(left.top(), right.top());
    EXPECT_EQ(left.height(), right.height());
    window.compose().composer().addBlock("Analogon.Thermal.HeatCapacitor", {0, 90});
    EXPECT_EQ(text->toPlainText(), document().modelText()) << "a gesture is seen in the text at once";
    EXPECT_TRUE(text->toPlainText().contains("heatCapacitor"));
    QTextCursor cursor = text->textCursor();
    cursor.setPosition(static_cast<int>(text->toPlainText().indexOf("equation")));
    text->setTextCursor(cursor);
    QTest::keyClicks(text, "Analogon.Thermal.HeatCapacitor typed;");
    ASSERT_TRUE(QTest::qWaitFor([&] { return panel<DiagramScene>()->block("typed") != nullptr; }, 2000));
    EXPECT_TRUE(view->isVisible()) << "and what is typed in the diagram";
    document().typeText(document().modelText().replace("connect(heater.i", "connect(heater.nothing"));
    QTest::qWait(300);
    window.findChild<QDockWidget*>("messages")->raise();
    QMetaObject::invokeMethod(view, "staleClicked");
    EXPECT_TRUE(text->isVisible());
    const QByteArray sizes = window.findChild<QSplitter*>("diagram-and-text")->saveState();
    {
        MainWindow next;
        next.resize(1440, 900);
        next.show();
        next.open(lambdaFile("next"));
        ASSERT_TRUE(QTest::qWaitFor([&] { return next.document().isOpen(); }, 20000));
        QTest::qWait(50);
        EXPECT_TRUE(next.findChild<DiagramView*>()->isVisible() && next.findChild<TextView*>()->isVisible());
        EXPECT_TRUE(next.findChild<QAction*>("text-beside")->isChecked());
    }
    beside->trigger();
    ASSERT_EQ(tabs->count(), 2);
    EXPECT_TRUE(view->isVisible());
    EXPECT_FALSE(text->isVisible());
    tabs->setCurrentWidget(text);
    EXPECT_TRUE(text->isVisible());
}

/// After the import: what the file says, and beside it what the model gets.
TEST_F(Panels, ShowsTheValuesOfARecordingAsTheyAreAndAsTheModelGetsThem) {
    openLambda();
    StudySettings settings = document().settings();
    StudyExperiment& experiment = settings.experiments.front();
    const QString name = QString::fromStdString(experiment.name);
    experiment.outputs.at("i_mod").scale = 2;
    experiment.outputs.at("i_mod").offset = 0.5;
    document().applySettings(settings, "scale");
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document().facts().outputs.empty(); }, 10000));
    auto* tree = panel<MeasurementPanel>()->tree();
    QTreeWidgetItem* file = tree->topLevelItem(0)->child(0);
    tree->setCurrentItem(file);
    const QPoint place = tree->visualItemRect(file).center();
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, place);
    QTest::mouseDClick(tree->viewport(), Qt::LeftButton, {}, place);
    auto* page = panel<ValuesPage>();
    ASSERT_TRUE(page->isVisible());
    const auto* model = page->model();
    const Table& table = *document().study().tables.at(experiment.file);
    ASSERT_EQ(model->rowCount(), static_cast<int>(table.rows())) << "every row";
    const auto columnOf = [&](const QString& heading) {
        for (int c = 0; c < model->columnCount(); ++c)
            if (model->headerData(c, Qt::Horizontal, Qt::DisplayRole).toString().section('\n', 0, 0) == heading)
                return c;
        return -1;
    };
    const int raw = columnOf("i_heater"), got = columnOf("→ i_mod");
    ASSERT_GE(raw, 0);
    ASSERT_EQ(got, raw + 1) << "side by side";
    const auto value = [&](int row, int column) { return model->index(row, column).data().toString().toDouble(); };
    const int row = model->rowCount() / 2;
    EXPECT_NEAR(value(row, raw), table.find("i_heater")->values[static_cast<std::size_t>(row)], 1e-7);
    EXPECT_NEAR(value(row, got), 2 * 1e-3 * value(row, raw) + 0.5, 1e-6) << "mA and A";
    EXPECT_EQ(columnOf("T_exhaust") + 1, columnOf("→ T_amb"));
    const double celsius = value(row, columnOf("T_exhaust")), kelvin = value(row, columnOf("→ T_amb"));
    const QString unit = model->headerData(columnOf("T_exhaust"), Qt::Horizontal, Qt::DisplayRole).toString();
    EXPECT_NEAR(kelvin - celsius, unit.contains("degC") ? 273.15 : 0, 1e-3) << unit.toStdString();
    const int all = model->columnCount();
    page->rawBox()->setChecked(false);
    EXPECT_EQ(columnOf("i_heater"), -1);
    EXPECT_GE(columnOf("→ i_mod"), 0);
    page->convertedBox()->setChecked(false);
    EXPECT_TRUE(page->rawBox()->isChecked()) << "one of both is shown";
    EXPECT_EQ(model->columnCount(), static_cast<int>(table.columns.size()));
    page->convertedBox()->setChecked(true);
    EXPECT_EQ(model->columnCount(), all);
    settings.experiments.front().outputs.at("i_mod").scale = 3;
    document().applySettings(settings, "scale");
    EXPECT_NEAR(value(row, columnOf("→ i_mod")), 3 * 1e-3 * value(row, raw) + 0.5, 1e-6) << "it follows the study";
    QTest::mouseClick(page->closeButton(), Qt::LeftButton);
    EXPECT_FALSE(page->isVisible());
    EXPECT_TRUE(panel<DiagramView>()->isVisible());
    Q_EMIT panel<MeasurementPanel>()->valuesWanted(name);
    ASSERT_TRUE(page->isVisible());
    settings.experiments.erase(settings.experiments.begin());
    document().applySettings(settings, "remove");
    EXPECT_FALSE(page->isVisible()) << "it is not part of the study any more";
}

TEST_F(Panels, ABrokenTextLeavesTheRestUsable) {
    openLambda();
    auto* view = panel<DiagramView>();
    const auto blocks = view->scene()->diagram().blocks.size();
    const QImage sound = view->grab().toImage();
    document().typeText(QString(document().modelText()).replace("equation", "equatoin"));
    EXPECT_FALSE(document().messages().empty());
    EXPECT_EQ(view->scene()->diagram().blocks.size(), blocks) << "the diagram of the last sound text stays";
    EXPECT_TRUE(view->isStale());
    EXPECT_NE(view->grab().toImage(), sound) << "and is seen to be of an earlier text";
    EXPECT_TRUE(document().before()) << "so do its traces";
    const QString broken = document().modelText();
    EXPECT_TRUE(window.compose().composer().addBlock("Analogon.Mechanics.Inertia", {0, 0}).empty());
    EXPECT_FALSE(window.compose().composer().fault().isEmpty()) << "a change is refused with a reason";
    EXPECT_EQ(document().modelText(), broken);
    QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, view->viewport()->rect().center());
    EXPECT_EQ(window.findChild<QTabWidget*>("centre")->currentWidget(), panel<TextView>()) << "a click shows the fault";
    const int line = static_cast<int>(broken.left(broken.indexOf("equatoin")).count('\n'));
    EXPECT_NEAR(panel<TextView>()->textCursor().blockNumber(), line, 1);
    document().undoStack().undo();
    EXPECT_TRUE(document().diagram().find("heater"));
    EXPECT_FALSE(view->isStale());
}

TEST_F(Panels, ShowsWhatWasMeasuredWhileTheModelCannotBeSimulated) {
    const QString file = lambdaFile();
    Outcome<OpenedStudy> study = openStudy(file.toStdString());
    ASSERT_TRUE(study);
    std::string& text = study->study.models.at("model.mo");
    text.replace(text.find("equation"), 8, "equatoin");
    ASSERT_TRUE(saveStudy(study->study, file.toStdString()));
    window.open(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().isOpen() && !panel<PlotPanel>()->plots().empty(); }, 20000));
    EXPECT_FALSE(document().before());
    const OutputPlot::Content& shown = panel<PlotPanel>()->plots().front()->content();
    EXPECT_GT(shown.measured.size(), 100u);
    EXPECT_EQ(shown.time->size(), shown.measured.size());
    EXPECT_TRUE(shown.before.empty());
    EXPECT_TRUE(shown.after.empty());
    EXPECT_FALSE(shown.unit.isEmpty());
    document().typeText(document().modelText().replace("equatoin", "equation"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().before() != nullptr; }, 20000)) << "until it can";
    EXPECT_FALSE(panel<PlotPanel>()->plots().front()->content().before.empty());
}

TEST_F(Panels, AnErrorInTheModelHoldsRunsBackAndSaysWhy) {
    auto* fit = window.findChild<QAction*>("fit");
    auto* discover = window.findChild<QAction*>("discover");
    auto* why = window.findChild<QToolButton*>("why-no-run");
    ASSERT_TRUE(fit && discover && why);
    EXPECT_FALSE(fit->isEnabled());
    EXPECT_TRUE(fit->toolTip().contains("Open a study first")) << fit->toolTip().toStdString();
    openLambda();
    EXPECT_TRUE(fit->isEnabled() && discover->isEnabled());
    EXPECT_FALSE(why->isVisible());
    const QString tip = fit->toolTip();
    // found by the analysis of the whole model, a moment after the edit; the text itself parses
    const QString sound = document().modelText();
    document().typeText(QString(sound).replace("equation", "  Real unknown;\nequation"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().modelError() != nullptr; }, 10000));
    for (const QAction* action : {fit, discover}) {
        EXPECT_FALSE(action->isEnabled());
        EXPECT_TRUE(action->toolTip().contains(QString::fromStdString(document().modelError()->message.english())))
            << action->toolTip().toStdString();
    }
    EXPECT_TRUE(why->isVisible());
    // the keys and the button lead to the message
    auto* messages = panel<MessagePanel>();
    auto* dock = window.findChild<QDockWidget*>("messages");
    const auto isShown = [&] {
        return !messages->list()->viewport()->visibleRegion().isEmpty() && messages->list()->currentRow() >= 0;
    };
    const auto leave = [&] {
        window.findChild<QDockWidget*>("traces")->raise();
        messages->list()->setCurrentRow(-1);
        ASSERT_TRUE(QTest::qWaitFor([&] { return messages->list()->viewport()->visibleRegion().isEmpty(); }, 2000));
    };
    ASSERT_TRUE(dock);
    for (const Qt::Key key : {Qt::Key_F5, Qt::Key_F6}) {
        leave();
        window.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
        QTest::keyClick(&window, key);
        EXPECT_TRUE(QTest::qWaitFor(isShown, 2000)) << "and no run that can only fail";
        EXPECT_FALSE(window.controller().isRunning());
        EXPECT_TRUE(window.statusBar()->currentMessage().contains("The model has an error"));
    }
    leave();
    QTest::mouseClick(why, Qt::LeftButton);
    EXPECT_TRUE(QTest::qWaitFor(isShown, 2000));
    // another edit that does not mend it changes nothing in between
    document().typeText(document().modelText() + " ");
    EXPECT_FALSE(fit->isEnabled());
    document().typeText(sound);
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().modelError() == nullptr; }, 10000));
    EXPECT_TRUE(fit->isEnabled() && discover->isEnabled());
    EXPECT_EQ(fit->toolTip(), tip);
    EXPECT_FALSE(why->isVisible());
    // a text that does not parse is told at once
    document().typeText(QString(sound).replace("equation", "equatoin"));
    EXPECT_FALSE(fit->isEnabled());
    EXPECT_TRUE(why->isVisible());
    document().undoStack().undo();
    ASSERT_TRUE(QTest::qWaitFor([&] { return fit->isEnabled(); }, 10000));

    window.startNew();
    EXPECT_FALSE(fit->isEnabled());
    EXPECT_TRUE(fit->toolTip().contains("Import a measurement first")) << fit->toolTip().toStdString();
}

TEST_F(Panels, ShowsTheTracesOfTwoOutputsWhole) {
    window.open(ANALOGON_ROOT "/examples/water-pump");
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().isOpen() && document().before(); }, 20000));
    QTest::qWait(100);
    auto* plots = panel<PlotPanel>();
    ASSERT_EQ(plots->plots().size(), 2u);
    const TimePlot* last = plots->plots().back()->residual();
    EXPECT_EQ(last->visibleRegion().boundingRect(), last->rect()) << "with its time axis";
}

/// What an effect would explain by the screening, and what the finished model misses without it, are two figures.
TEST_F(Panels, NamesTheFiguresOfATrialOtherwiseThanThoseOfTheEvidence) {
    openLambda();
    run(RunKind::Discover);
    auto* results = panel<ResultPanel>();
    ASSERT_TRUE(results->candidates());
    const QTreeWidgetItem* header = results->candidates()->headerItem();
    QStringList captions;
    for (const QLabel* label : results->widget()->findChildren<QLabel*>()) captions << label->text();
    EXPECT_TRUE(captions.contains("Score"));
    EXPECT_EQ(header->text(2), "Screening");
    EXPECT_TRUE(header->toolTip(2).contains("before any refit"));
    EXPECT_TRUE(header->toolTip(3).contains("in that round"));
    EXPECT_FALSE(captions.filter("those above are of the finished model").isEmpty());
}

TEST_F(Panels, KeepsEveryRunForComparison) {
    openLambda();
    run(RunKind::Fit);
    auto* runs = panel<FitPanel>();
    runs->startsBox()->setValue(2);
    EXPECT_EQ(window.controller().options().discover.fit.starts, 2);
    run(RunKind::Discover);
    ASSERT_EQ(document().history().size(), 2u);
    EXPECT_FALSE(runs->curve()->points().empty()) << "the error was followed during the run";
    ASSERT_EQ(runs->history()->topLevelItemCount(), 2);
    for (int i = 0; i < 2; ++i) runs->history()->topLevelItem(i)->setSelected(true);
    EXPECT_FALSE(runs->comparison()->isHidden());
    EXPECT_GE(runs->comparison()->topLevelItemCount(), 6) << "two errors and four parameters";
    QTest::qWait(50);
    const QTreeWidget* table = runs->comparison();
    window.findChild<QDockWidget*>("runs")->raise();
    window.resize(1440, 1400);
    QTest::qWait(50);
    EXPECT_GT(table->height(), runs->history()->height()) << "there is more to read in it than in a list of two";
    EXPECT_TRUE(runs->history()->viewport()->rect().contains(
        runs->history()->visualItemRect(runs->history()->topLevelItem(1))));
    for (int c = 0; c < 3; ++c) {
        EXPECT_GT(table->columnWidth(c), 60) << "a long name of an effect pushes no column away";
        EXPECT_LE(table->columnViewportPosition(c) + table->columnWidth(c), table->viewport()->width());
    }
    runs->history()->topLevelItem(1)->setSelected(false);
    const QString before = document().modelText();
    QTest::mouseClick(runs->restoreButton(), Qt::LeftButton);
    EXPECT_NE(document().modelText(), before) << "the values of the fit are in the model";
    document().undoStack().undo();
    EXPECT_EQ(document().modelText(), before);
}

std::vector<double> valuesOf(const Eigen::VectorXd& values) { return {values.data(), values.data() + values.size()}; }

/// What was measured, run A and run B over each other: as the history has them, whatever the study is by now.
TEST_F(Panels, OverlaysTheTracesOfTwoRunsAsTheyWere) {
    openLambda();
    run(RunKind::Fit);
    run(RunKind::Discover);
    ASSERT_EQ(document().history().size(), 2u);
    document().setParameterValue("heater.R", 5);  // far from both
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().isResultStale() && document().before(); }, 20000));
    QTest::qWait(400);
    auto* plots = panel<PlotPanel>();
    auto* runs = panel<FitPanel>();
    for (int i = 0; i < 2; ++i) runs->history()->topLevelItem(i)->setSelected(true);
    ASSERT_TRUE(document().comparedRuns());
    auto* tabs = plots->findChild<QTabBar*>();
    const auto& first = document().history()[0].result->finding.final.experiments;
    const auto& second = document().history()[1].result->finding.final.experiments;
    ASSERT_EQ(tabs->count(), static_cast<int>(first.size()));
    for (std::size_t e = 0; e < first.size(); ++e) {
        tabs->setCurrentIndex(static_cast<int>(e));
        ASSERT_EQ(plots->plots().size(), first[e].outputs.size());
        for (std::size_t o = 0; o < first[e].outputs.size(); ++o) {
            const OutputPlot& plot = *plots->plots()[o];
            EXPECT_EQ(*plot.content().time, first[e].time);
            EXPECT_EQ(plot.content().measured, valuesOf(first[e].outputs[o].measured));
            EXPECT_EQ(plot.content().before, valuesOf(first[e].outputs[o].simulated));
            EXPECT_EQ(plot.content().after, valuesOf(second[e].outputs[o].simulated));
            ASSERT_EQ(plot.residual()->traces().size(), 2u) << "the residuals of both";
            for (const Trace& t : plot.residual()->traces()) {
                const OutputState& of = (t.role == TraceRole::Before ? first : second)[e].outputs[o];
                EXPECT_EQ(t.values, valuesOf(of.measured - of.simulated));
            }
            EXPECT_TRUE(plot.legendText(TraceRole::Before).startsWith("A " + document().history()[0].when));
            EXPECT_TRUE(plot.legendText(TraceRole::After).startsWith("B " + document().history()[1].when));
            EXPECT_EQ(plot.content().note, QString());
        }
    }
    EXPECT_TRUE(plots->trimButton()->isHidden()) << "it would trim the study";
    QTest::mouseClick(plots->endComparisonButton(), Qt::LeftButton);
    EXPECT_FALSE(document().comparedRuns());
    EXPECT_TRUE(runs->history()->selectedItems().isEmpty());
    EXPECT_EQ(
        plots->plots().front()->content().before,
        valuesOf(
            document().before()->experiments[static_cast<std::size_t>(tabs->currentIndex())].outputs[0].simulated));
    EXPECT_TRUE(plots->plots().front()->content().after.empty());
    for (int i = 0; i < 2; ++i) runs->history()->topLevelItem(i)->setSelected(true);
    window.controller().start(RunKind::Fit);
    EXPECT_FALSE(document().comparedRuns()) << "a run that begins is what one wants to see";
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.controller().isRunning(); }, 60000));
}

/// Runs that saw other parts of a recording, or another recording, each keep their own samples.
TEST_F(Panels, ComparesRunsOfOtherPartsOfARecording) {
    const auto runOf = [](unsigned long number, std::vector<double> time, std::vector<double> measured) {
        auto result = std::make_shared<RunResult>();
        ExperimentState experiment;
        experiment.name = "run";
        const auto size = static_cast<Eigen::Index>(time.size());
        OutputState output;
        output.name = "y";
        output.measured = Eigen::Map<Eigen::VectorXd>(measured.data(), size);
        output.simulated = output.measured.array() + static_cast<double>(number);
        experiment.time = std::move(time);
        experiment.outputs.push_back(std::move(output));
        result->finding.final.experiments.push_back(std::move(experiment));
        return RunRecord{number, RunKind::Fit, "12:00:00", {}, 1, std::make_shared<const Study>(), result};
    };
    const auto same = [](const Series& series, const std::vector<double>& values) {
        return std::equal(series.values().begin(), series.values().end(), values.begin(), values.end(),
                          [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); });
    };
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const RunRecord whole = runOf(1, {0, 1, 2, 3}, {5, 6, 7, 8}), part = runOf(2, {1, 2}, {6, 7}),
                    other = runOf(3, {0, 1, 2, 3}, {5, 6, 9, 8}), fine = runOf(4, {1.5, 2.5}, {6.5, 7.5});
    OutputPlot::Content content = contentsOf({whole, part}, "run").front();
    EXPECT_EQ(content.time->size(), 4u);
    EXPECT_TRUE(same(content.measured, {5, 6, 7, 8}));
    EXPECT_TRUE(same(content.before, {6, 7, 8, 9}));
    EXPECT_TRUE(same(content.after, {none, 8, 9, none}));
    EXPECT_TRUE(content.note.contains("other parts") || content.note.contains("different parts"));
    content = contentsOf({whole, other}, "run").front();
    EXPECT_TRUE(same(content.measured, {5, 6, 9, 8}));
    EXPECT_TRUE(same(content.measuredBefore, {5, 6, 7, 8})) << "what A was held against";
    OutputPlot plot;
    plot.show(content);
    ASSERT_EQ(plot.residual()->traces().size(), 2u);
    EXPECT_TRUE(same(plot.residual()->traces()[0].values, {-1, -1, -1, -1}));
    EXPECT_TRUE(same(plot.residual()->traces()[1].values, {-3, -3, -3, -3}));
    content = contentsOf({whole, fine}, "run").front();
    EXPECT_TRUE(same(content.before, {6, 7, 7.5, 8, 8.5, 9})) << "on the line between its samples, as it is drawn";
    EXPECT_TRUE(same(content.after, {none, none, 10.5, 11, 11.5, none}));
    EXPECT_TRUE(contentsOf({whole, part}, "another").empty());
}

TEST_F(Panels, ListsTheRunsThatAreKeptWhenOldOnesAreDropped) {
    openLambda();
    run(RunKind::Fit);
    const RunResult result = *document().result();
    const Study ranOn = document().study();
    auto* list = panel<FitPanel>()->history();
    for (int i = 0; i < 45; ++i) {
        RunResult next = result;
        next.finding.final.experiments.front().errorPercent = 10 + i;
        document().setResult(RunKind::Fit, std::move(next), ranOn, i);
        ASSERT_EQ(list->topLevelItemCount(), static_cast<int>(document().history().size()));
        const RunRecord& last = document().history().back();
        const QTreeWidgetItem* row = list->topLevelItem(list->topLevelItemCount() - 1);
        EXPECT_EQ(row->toolTip(0), QStringLiteral("took %1 s").arg(last.seconds, 0, 'g', 3)) << i;
    }
    const RunRecord& first = document().history().front();
    EXPECT_EQ(list->topLevelItem(0)->toolTip(0), QStringLiteral("took %1 s").arg(first.seconds, 0, 'g', 3));
}

TEST_F(Panels, KeepsARunAsItWasWhateverIsDoneAfterIt) {
    openLambda();
    run(RunKind::Fit);
    ASSERT_EQ(document().history().size(), 1u);
    const auto print = [](const RunRecord& record) {
        std::string text = studyJson(*record.ranOn) + studyJson(record.result->completed);
        for (const auto& [name, model] : record.ranOn->models) text += model;
        for (const FitEstimate& e : record.result->finding.final.parameters)
            text += fmt::format("{} {}\n", e.name, e.value);
        return text;
    };
    const std::string before = print(document().history().front());
    document().adoptCompleted("take over");
    document().setParameterValue("heater.alpha", 0.0042);
    document().typeText(document().modelText() + "// an edit\n");
    run(RunKind::Fit);
    document().undoStack().setIndex(0);
    ASSERT_EQ(document().history().size(), 2u);
    EXPECT_EQ(print(document().history().front()), before);
}

/// The runs are in the project file: opened again, they are listed, compared and gone back to as before.
TEST_F(Panels, KeepsTheRunsInTheProjectFile) {
    openLambda();
    run(RunKind::Fit);
    EXPECT_TRUE(document().isModified()) << "a run is work that is not saved yet";
    run(RunKind::Discover);
    const auto saved = document().history();
    window.saveTo(directory.filePath("kept.analogon"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document().isModified(); }, 10000));
    window.open(lambdaFile("other"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().title() == "other" && document().before(); }, 20000));
    EXPECT_TRUE(document().history().empty());
    window.open(directory.filePath("kept.analogon"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().title() == "kept" && document().before(); }, 20000));
    EXPECT_FALSE(document().isModified());
    ASSERT_EQ(document().history().size(), 2u);
    auto* runs = panel<FitPanel>();
    ASSERT_EQ(runs->history()->topLevelItemCount(), 2);
    for (int i = 0; i < 2; ++i) {
        const RunRecord &then = saved[static_cast<std::size_t>(i)],
                        &now = document().history()[static_cast<std::size_t>(i)];
        EXPECT_EQ(now.kind, then.kind);
        EXPECT_EQ(now.when, then.when);
        EXPECT_EQ(now.seconds, then.seconds);
        EXPECT_EQ(now.ranOn->models, then.ranOn->models);
        runs->history()->topLevelItem(i)->setSelected(true);
    }
    ASSERT_TRUE(document().comparedRuns());
    const OutputPlot::Content& shown = panel<PlotPanel>()->plots().front()->content();
    EXPECT_EQ(shown.before, valuesOf(saved[0].result->finding.final.experiments[0].outputs[0].simulated));
    EXPECT_EQ(shown.after, valuesOf(saved[1].result->finding.final.experiments[0].outputs[0].simulated));
    runs->history()->topLevelItem(0)->setSelected(false);
    const std::size_t blocks = document().diagram().blocks.size();
    QTest::mouseClick(runs->restoreButton(), Qt::LeftButton);
    EXPECT_EQ(document().diagram().blocks.size(), blocks + 1) << "the effect is in the model again";
    EXPECT_FALSE(document().isResultStale()) << "and the result of then belongs to it";
    ASSERT_TRUE(document().finding());
    EXPECT_EQ(document().finding()->effects.front().kind, saved[1].result->finding.effects.front().kind);
    document().undoStack().undo();
    EXPECT_EQ(document().diagram().blocks.size(), blocks);
}

TEST_F(Panels, KeepsClosedPanelsClosed) {
    const auto dock = [](MainWindow& of, const char* name) { return of.findChild<QDockWidget*>(name); };
    const auto open = [this](MainWindow& in, const QString& name) {
        in.open(lambdaFile(name));
        return QTest::qWaitFor([&] { return in.document().isOpen() && in.document().title() == name; }, 20000);
    };
    {
        MainWindow first;
        first.show();
        ASSERT_TRUE(open(first, "one"));
        dock(first, "library")->close();
        ASSERT_TRUE(open(first, "two"));
        EXPECT_TRUE(dock(first, "library")->isHidden()) << "another study";
        EXPECT_FALSE(dock(first, "messages")->isHidden());
        Q_EMIT first.findChild<StartPage*>()->generateWanted();
        EXPECT_TRUE(dock(first, "messages")->isHidden()) << "a page over the whole window";
        Q_EMIT first.findChild<GeneratePage*>()->cancelled();
        EXPECT_TRUE(dock(first, "library")->isHidden());
        EXPECT_FALSE(dock(first, "messages")->isHidden());
        first.addDockWidget(Qt::LeftDockWidgetArea, dock(first, "traces"));
        first.close();
    }
    MainWindow next;
    next.show();
    ASSERT_TRUE(open(next, "three"));
    EXPECT_TRUE(dock(next, "library")->isHidden()) << "the next start";
    EXPECT_FALSE(dock(next, "messages")->isHidden());
    EXPECT_EQ(next.dockWidgetArea(dock(next, "traces")), Qt::LeftDockWidgetArea);
    for (QAction* action : next.findChildren<QAction*>())
        if (action->text() == "Reset layout") action->trigger();
    EXPECT_FALSE(dock(next, "library")->isHidden());
    EXPECT_EQ(next.dockWidgetArea(dock(next, "traces")), Qt::BottomDockWidgetArea);
    Settings().setValue("window/small-state", QByteArray());  // for the tests after this one
    Settings().setValue("window/geometry", QByteArray());
}

TEST_F(Panels, ShowsTheResidualFromThreeSidesAndExports) {
    openLambda();
    auto* plots = panel<PlotPanel>();
    QTest::mouseClick(plots->residualButton(), Qt::LeftButton);
    ASSERT_FALSE(plots->residuals().empty());
    ResidualPlot* residual = plots->residuals().front();
    EXPECT_TRUE(residual->isVisible());
    ASSERT_TRUE(QTest::qWaitFor([&] { return residual->facts().correlation.size() > 10; }, 10000));
    EXPECT_NEAR(residual->facts().correlation.front(), 1, 1e-9);
    EXPECT_NEAR(std::accumulate(residual->facts().histogram.begin(), residual->facts().histogram.end(), 0.0),
                static_cast<double>(document().before()->experiments.front().time.size()), 0.5);
    EXPECT_GE(residual->variableBox()->findText("p_ambient", Qt::MatchContains), 0) << "unused columns too";
    EXPECT_EQ(residual->axisLabels().distribution, "residual [A]") << "every axis says its unit";
    EXPECT_EQ(residual->axisLabels().againstY, "Residual [A]");
    EXPECT_EQ(residual->axisLabels().againstX, "simulated [A]");
    EXPECT_GE(residual->variableBox()->findText("time [s]"), 0);
    for (const char* name : {"r.png", "r.svg", "r.csv"}) {
        const QString file = directory.filePath(name);
        QString told;
        const auto listening = QObject::connect(plots, &PlotPanel::told, [&](const QString& s) { told = s; });
        plots->exportTo(file);
        ASSERT_TRUE(QTest::qWaitFor([&] { return !told.isEmpty(); }, 10000));
        QObject::disconnect(listening);
        EXPECT_TRUE(told.contains(file)) << told.toStdString();
        EXPECT_GT(QFileInfo(file).size(), 1000) << name;
    }
    EXPECT_FALSE(QImage(directory.filePath("r.png")).isNull());
    const Outcome<Table> numbers = readTextTables(directory.filePath("r.csv").toStdString(), {});
    ASSERT_TRUE(numbers) << format(numbers.diagnostics());
    EXPECT_EQ(numbers->rows(), document().before()->experiments.front().time.size());
    EXPECT_TRUE(numbers->find("i_mod measured"));
}

TEST_F(Panels, ReachesAndReadsThePlotsWithTheKeyboardAlone) {
    openLambda();
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    for (const auto& [key, name] :
         {std::pair{Qt::Key_1, "library"}, {Qt::Key_3, "parameters"}, {Qt::Key_6, "traces"}}) {
        QTest::keyClick(&window, key, Qt::ControlModifier);
        const QWidget* focus = QApplication::focusWidget();
        ASSERT_TRUE(focus);
        EXPECT_TRUE(window.findChild<QWidget*>(name)->isAncestorOf(focus)) << name;
    }
    auto* plots = panel<PlotPanel>();
    TimePlot* values = plots->plots().front()->values();
    values->setFocus();
    std::pair<double, double> range;
    std::vector<double> marks;
    QObject::connect(values, &TimePlot::timeRangeWanted, [&](double from, double to) { range = {from, to}; });
    QObject::connect(values, &TimePlot::markWanted, [&](double time) { marks.push_back(time); });
    QTest::keyClick(values, Qt::Key_Plus);
    EXPECT_NEAR(range.second - range.first, 0.8 * 180, 1e-6);
    QTest::keyClick(values, Qt::Key_Right);
    QTest::keyClick(values, Qt::Key_Return);
    QTest::keyClick(values, Qt::Key_Right);
    QTest::keyClick(values, Qt::Key_Return);
    ASSERT_EQ(marks.size(), 2u);
    EXPECT_NEAR(marks[1] - marks[0], 0.01 * 0.8 * 180, 1e-6);
    QEvent away(QEvent::Leave);
    QCoreApplication::sendEvent(values, &away);
    QStringList told;  // the differences between the two marks
    for (const QLabel* label : plots->plots().front()->findChildren<QLabel*>())
        if (label->text().startsWith(QStringLiteral("Δ "))) told << label->text();
    ASSERT_EQ(told.size(), 1);
    EXPECT_TRUE(told.front().startsWith(QStringLiteral("Δ 1.4")) && told.front().count(QStringLiteral("Δ")) == 3)
        << told.front().toStdString();
    QTest::keyClick(&window, Qt::Key_0, Qt::ControlModifier);
    EXPECT_EQ(QApplication::focusWidget(), window.findChild<DiagramView*>());
}

TEST_F(Panels, ZoomsIntoTheBoxThatIsDrawn) {
    openLambda();
    OutputPlot* plot = panel<PlotPanel>()->plots().front();
    TimePlot* values = plot->values();
    const auto all = values->valueRange();
    std::pair<double, double> times;
    QObject::connect(values, &TimePlot::timeRangeWanted, [&](double from, double to) { times = {from, to}; });
    const auto drag = [&](QPoint from, QPoint to) {
        QTest::mousePress(values, Qt::LeftButton, Qt::ShiftModifier, from);
        QTest::mouseMove(values, (from + to) / 2);
        QTest::mouseMove(values, to);
        QTest::mouseRelease(values, Qt::LeftButton, Qt::ShiftModifier, to);
    };
    const int w = values->width(), h = values->height();
    drag({w / 3, h / 4}, {2 * w / 3, 3 * h / 4});
    const auto part = values->valueRange();
    EXPECT_NEAR((part.second - part.first) / (all.second - all.first), 0.5, 0.1);
    EXPECT_GT(part.first, all.first);
    EXPECT_LT(part.second, all.second);
    EXPECT_LT(times.second - times.first, 100) << "of 180 s";
    const auto residual = plot->residual()->valueRange();
    plot->showAfter(plot->content().before, "another trace");
    EXPECT_EQ(values->valueRange(), part) << "one looks at a place, whatever comes to be drawn there";
    drag({w / 3, h / 2}, {w / 2, h / 2 + 3});
    EXPECT_EQ(values->valueRange(), part) << "a flat box chooses times";
    const QPointF at(w / 2, h / 2);
    QWheelEvent turn(at, values->mapToGlobal(at), {}, QPoint(0, -240), Qt::NoButton, Qt::ControlModifier,
                     Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(values, &turn);
    EXPECT_GT(values->valueRange().second - values->valueRange().first, part.second - part.first);
    EXPECT_EQ(plot->residual()->valueRange(), residual);
    QTest::mouseDClick(values, Qt::LeftButton, {}, {w / 2, h / 2});
    EXPECT_EQ(values->valueRange(), all);
}

TEST_F(Panels, TrimsARecordingByDraggingOverThePlot) {
    openLambda();
    auto* plots = panel<PlotPanel>();
    const std::size_t whole = document().before()->experiments.front().time.size();
    QTest::mouseClick(plots->trimButton(), Qt::LeftButton);
    QWidget* area = plots->plots().front()->values();
    const int y = area->height() / 2;
    QTest::mousePress(area, Qt::LeftButton, {}, QPoint(area->width() / 3, y));
    QTest::mouseMove(area, QPoint(area->width() / 2, y));
    QTest::mouseMove(area, QPoint(2 * area->width() / 3, y));
    QTest::mouseRelease(area, Qt::LeftButton, {}, QPoint(2 * area->width() / 3, y));
    const auto& range = document().study().experiments.front().range;
    ASSERT_TRUE(range);
    EXPECT_GT(range->first, 20);
    EXPECT_LT(range->second, 160);
    EXPECT_FALSE(plots->trimButton()->isChecked());
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return document().before() && document().before()->experiments.front().time.size() < whole; }, 20000));
    document().undoStack().undo();
    EXPECT_FALSE(document().study().experiments.front().range);
}

TEST_F(Panels, GoesBackToARunOfATrimmedRecording) {
    openLambda();
    const auto trimTo = [&](std::optional<std::pair<double, double>> range) {
        StudySettings settings = document().settings();
        settings.experiments.front().range = range;
        document().applySettings(std::move(settings), "trim");
        const auto isSimulated = [&] {
            const auto before = document().before();
            return before && (before->experiments.front().time.size() < 3000) == range.has_value();
        };
        ASSERT_TRUE(QTest::qWaitFor(isSimulated, 20000));
    };
    trimTo(std::pair(20.0, 60.0));
    run(RunKind::Fit);
    trimTo(std::nullopt);
    run(RunKind::Fit);
    ASSERT_EQ(document().history().size(), 2u);
    document().restoreRun(document().history().front());
    const OutputPlot::Content& shown = panel<PlotPanel>()->plots().front()->content();
    EXPECT_LT(shown.measured.size(), 3000u);
    EXPECT_EQ(shown.before.size(), shown.measured.size()) << "what that fit began with, of the same part";
}

TEST_F(Panels, ShowsAParameterInAnotherUnitAndWhereItLiesInItsBounds) {
    openLambda();
    ParameterModel* model = panel<ParameterPanel>()->model();
    ASSERT_TRUE(QTest::qWaitFor([&] { return model->rowOf("heater.R") >= 0; }, 5000));
    const int row = model->rowOf("heater.R");
    const auto at = [&](int column) { return model->index(row, column); };
    EXPECT_TRUE(at(ParameterModel::Unit).data(ParameterModel::UnitsRole).toStringList().contains("mOhm"));
    EXPECT_FALSE(at(ParameterModel::Unit).data(ParameterModel::UnitsRole).toStringList().contains("V"));
    const QString text = document().modelText();
    ASSERT_TRUE(model->setData(at(ParameterModel::Unit), "mOhm", Qt::EditRole));
    EXPECT_EQ(at(ParameterModel::Value).data().toString(), "3000");
    EXPECT_EQ(at(ParameterModel::Max).data().toString(), "20000");
    EXPECT_EQ(document().modelText(), text) << "how a value is shown is no change of the study";
    ASSERT_TRUE(model->setData(at(ParameterModel::Value), "4000", Qt::EditRole));
    EXPECT_TRUE(QTest::qWaitFor([&] { return document().parameterValue("heater.R") == 4.0; }, 5000));
    EXPECT_FALSE(model->setData(at(ParameterModel::Unit), "V", Qt::EditRole));
    const auto bar = [&] { return at(ParameterModel::Bounds).data(ParameterModel::BarRole).toList(); };
    const double expected = std::log(4 / 0.1) / std::log(20 / 0.1);  // a logarithmic scale from 0.1 to 20
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return bar().size() == 3 && std::abs(bar()[0].toDouble() - expected) < 1e-9; }, 5000));
}

TEST_F(Panels, ShowsAllParametersWhereTheSelectedBlockHasNone) {
    openLambda();
    auto* model = panel<ParameterPanel>()->model();
    ASSERT_TRUE(QTest::qWaitFor([&] { return model->rowOf("heater.R") >= 0; }, 5000));
    const int all = model->rowCount();
    panel<DiagramScene>()->select("heater");
    EXPECT_LT(model->rowCount(), all);
    EXPECT_TRUE(model->isOfComponent());
    panel<DiagramScene>()->select("i_mod");
    EXPECT_EQ(model->rowCount(), all);
    EXPECT_FALSE(model->isOfComponent());
}

TEST_F(Panels, LeadsToTheParametersWhenThereIsNothingToFit) {
    openLambda();
    StudySettings settings = document().settings();
    for (auto& [name, parameter] : settings.parameters) parameter.fit = false;
    document().applySettings(std::move(settings), "none");
    panel<DiagramScene>()->select("heater");
    window.findChild<QDockWidget*>("parameters")->hide();
    window.controller().start(RunKind::Fit);
    EXPECT_FALSE(window.controller().isRunning());
    EXPECT_TRUE(window.statusBar()->currentMessage().contains("check parameters"));
    EXPECT_EQ(window.focusWidget(), panel<ParameterPanel>()->table());
    EXPECT_FALSE(panel<ParameterPanel>()->model()->isOfComponent());
}

TEST_F(Panels, KeepsTheLibraryInPlaceWhenTheStudyHasClassesOfItsOwn) {
    openLambda();
    const auto topLevel = [&] {
        QStringList names;
        const LibraryModel* model = panel<LibraryPanel>()->model();
        for (int i = 0; i < model->rowCount(); ++i) names << model->index(i, 0).data().toString();
        return names;
    };
    const QStringList before = topLevel();
    ASSERT_TRUE(before.contains("Thermal"));
    window.compose().composer().group({"heater", "element"}, "Probe");
    EXPECT_EQ(topLevel(), QStringList("Probe") + before);
}

/// The frame of a group reaches its border, where its connectors are.
TEST_F(Panels, ShowsTheConnectorsOfAGroupInItsIcon) {
    openLambda();
    ASSERT_FALSE(window.compose().composer().group({"heater", "element"}, "Probe").empty());
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().library().find("Probe") != nullptr; }, 5000));
    constexpr int size = 24, ratio = 4;
    const QImage icon = classPixmap(document().library(), "Probe", size, ratio).toImage();
    const auto isSignal = [&](int x) {  // [px] from the left
        for (int y = 0; y < icon.height(); ++y) {
            const QColor at = icon.pixelColor(x * ratio + ratio / 2, y);
            if (at.alpha() > 200 && at.blue() > at.red() + 60) return true;
        }
        return false;
    };
    EXPECT_TRUE(isSignal(0)) << "outside";
    EXPECT_TRUE(isSignal(1)) << "and inside";
    document().undoStack().setClean();
}

TEST_F(Panels, SaysFromTheStartOfARunHowLongItMayTake) {
    openLambda();
    window.findChild<QDockWidget*>("runs")->raise();
    window.controller().start(RunKind::Discover);
    QTest::qWait(20);
    for (const QLabel* label : panel<FitPanel>()->findChildren<QLabel*>())
        EXPECT_FALSE(label->isVisible() && label->text().isEmpty());
    window.controller().cancel();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window.controller().isRunning(); }, 60000));
}

TEST(ErrorCurve, KeepsOffTheAxisBelowIt) {
    ErrorCurve curve;
    curve.resize(300, 120);
    curve.add(0, 10);
    curve.add(1, 1);
    const QImage picture = curve.grab().toImage();
    const QColor ink = style::accent(curve.palette());
    int lowest = 0;
    for (int y = 0; y < picture.height(); ++y)
        if (picture.pixelColor(picture.width() - style::margin - 1, y) == ink) lowest = y;
    const int axis = curve.height() - style::unit - curve.fontMetrics().height();
    EXPECT_GT(lowest, axis / 2);
    EXPECT_LT(lowest, axis - 3);
}

TEST_F(Panels, LeadsFromAFaultOfTheDataToItsLine) {
    openLambda();
    Place place;
    place.file = document().study().experiments.front().file;
    place.line = 500;
    Q_EMIT panel<MessagePanel>()->placeChosen(place);
    auto* import = panel<ImportPanel>();
    ASSERT_TRUE(import->isVisible());
    auto* table = import->findChild<QTableView*>("preview");
    ASSERT_TRUE(QTest::qWaitFor([&] { return table->currentIndex().isValid(); }, 10000));
    EXPECT_EQ(table->model()->headerData(table->currentIndex().row(), Qt::Vertical).toInt(), 500);
}

TEST_F(Panels, ShowsTheParametersOfABlockOnItWhereThereIsRoom) {
    openLambda();
    auto* view = panel<DiagramView>();
    const auto pictureAt = [&](double zoom, double value) {
        document().setParameterValue("heater.R", value);
        view->setTransform(QTransform::fromScale(zoom, zoom));
        view->centerOn(view->scene()->block("heater"));
        return view->grab().toImage();
    };
    EXPECT_NE(pictureAt(3, 2.5), pictureAt(3, 7.5));
    EXPECT_EQ(pictureAt(3, 2.5), pictureAt(3, 2.5));
    EXPECT_EQ(pictureAt(1.2, 2.5), pictureAt(1.2, 7.5)) << "the name alone has room there";
}

TEST_F(Panels, AsksWhereToSaveAnExample) {
    window.open(QStringLiteral(ANALOGON_ROOT "/examples/lambda-sensor-heating"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().isOpen(); }, 20000));
    document().typeText(document().modelText() + "// changed\n");
    window.findChild<QAction*>("save")->trigger();
    EXPECT_TRUE(window.findChild<QFileDialog*>("save-dialog")) << "the one that ships stays as it is";
    EXPECT_TRUE(document().isModified());
}

TEST_F(Panels, TriesAnEffectOfTheList) {
    openLambda();
    run(RunKind::Discover);
    auto* results = panel<ResultPanel>();
    ASSERT_TRUE(results->tryButton());
    EXPECT_FALSE(results->tryButton()->isEnabled()) << "no line is marked yet";
    QTreeWidgetItem* line = nullptr;
    for (int i = 0; i < results->candidates()->topLevelItemCount() && !line; ++i)
        if (results->candidates()->topLevelItem(i)->toolTip(0).contains("thermal.resistance"))
            line = results->candidates()->topLevelItem(i);
    ASSERT_TRUE(line);
    results->candidates()->setCurrentItem(line);
    const std::string place = line->data(3, Qt::UserRole).toString().toStdString();
    QTest::mouseClick(results->tryButton(), Qt::LeftButton);
    ASSERT_TRUE(window.controller().isRunning());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.controller().isRunning(); }, 120000));
    ASSERT_EQ(document().history().size(), 2u);
    for (const CandidateResult& c : document().finding()->candidates)
        EXPECT_TRUE((c.kind == "thermal.resistance" && c.at == place) || c.kind.starts_with("proposal."))
            << c.kind << " at " << c.at;
}

TEST_F(Panels, ShowsWhatAnEffectWouldBringWhileThePointerIsOnIt) {
    window.resize(1020, 800);
    openLambda();
    run(RunKind::Discover);
    auto* results = panel<ResultPanel>();
    auto* scene = panel<DiagramScene>();
    QTreeWidget* list = results->candidates();
    ASSERT_TRUE(list);
    ASSERT_GT(list->topLevelItemCount(), 1);
    const auto legend = [&] { return panel<PlotPanel>()->plots().front()->legendText(TraceRole::After); };
    const QString result = legend();
    results->verticalScrollBar()->setValue(list->y());
    const auto enter = [&](int row) {
        const QPoint at = list->visualItemRect(list->topLevelItem(row)).center();
        const QPointF onScreen = list->viewport()->mapToGlobal(at);
        QEnterEvent event(at, at, onScreen);
        QCoreApplication::sendEvent(list->viewport(), &event);
        QMouseEvent move(QEvent::MouseMove, at, onScreen, Qt::NoButton, Qt::NoButton, {});  // also to where it was
        QCoreApplication::sendEvent(list->viewport(), &move);
    };
    const auto leave = [&] {
        QEvent event(QEvent::Leave);
        QCoreApplication::sendEvent(list->viewport(), &event);
    };
    enter(0);
    EXPECT_FALSE(scene->pointedOut().empty());
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().preview() != nullptr; }, 20000));
    EXPECT_TRUE(legend().startsWith("tried")) << legend().toStdString();
    TimePlot* residual = panel<PlotPanel>()->plots().front()->residual();
    EXPECT_EQ(residual->note(), list->topLevelItem(0)->text(0)) << "the name beside the caption, over no curve";
    QTest::qWait(20);
    const QWidget* plot = panel<PlotPanel>()->plots().front();
    EXPECT_LE(plot->width(), plot->parentWidget()->parentWidget()->width()) << "however long the name, nothing is cut";
    // what was found is the first of the list: looking at it shows the figure that the search came to
    EXPECT_NEAR(document().preview()->traces.experiments.front().errorPercent,
                document().finding()->final.experiments.front().errorPercent, 0.02);
    leave();
    EXPECT_EQ(document().preview(), nullptr);
    EXPECT_EQ(legend(), result);
    EXPECT_TRUE(residual->note().isEmpty());
    EXPECT_TRUE(scene->pointedOut().empty());
    enter(0);
    EXPECT_NE(document().preview(), nullptr) << "known by now";
    enter(1);
    leave();  // before anything was worked out
    QTest::qWait(400);
    EXPECT_EQ(document().preview(), nullptr);
    list->setCurrentItem(list->topLevelItem(0));  // as the keyboard does; stays when the pointer comes and goes
    EXPECT_NE(document().preview(), nullptr);
    enter(1);
    leave();
    EXPECT_NE(document().preview(), nullptr);
    EXPECT_EQ(document().history().size(), 1u) << "looking leaves nothing behind";
    EXPECT_TRUE(document().undoStack().isClean());
}

TEST_F(Panels, SaysWhatToMindWhatIsProposedAndWhatToMeasureNext) {
    openLambda();
    RunResult result = sampleFinding(document(), "thermal.radiation", "Analogon.Effects.Thermal.Radiation",
                                     "Radiation to constant surroundings", "heater.heatPort", "port", "k_r");
    Finding& finding = result.finding;
    finding.kind = FindingKind::Partial;
    finding.warnings = {"'drive cycle' runs outside the range of the fitted recordings"};
    finding.nextExperiment = "A step of ctrl_var to 13 V, held for 60 s";
    Remainder remainder;
    remainder.output = "i_mod";
    remainder.proposal.equation = "Q = c*(T - T0)^3";
    remainder.proposal.className = "Analogon.Effects.Proposals.CubicHeat";
    remainder.proposal.block = "model CubicHeat end CubicHeat;";
    remainder.proposal.errors.fit = 0.31;
    remainder.proposal.errors.validate = 0.44;
    finding.unexplained.remainders = {remainder};
    document().setResult(RunKind::Discover, std::move(result), document().study());
    QStringList shown;
    const auto collect = [&] {
        shown.clear();
        for (const QLabel* label : panel<ResultPanel>()->findChildren<QLabel*>()) shown << label->text();
        return !shown.filter("drive cycle' runs outside").isEmpty();
    };
    ASSERT_TRUE(QTest::qWaitFor(collect, 5000));
    for (const QLabel* label : panel<ResultPanel>()->findChildren<QLabel*>())
        EXPECT_TRUE(!label->text().contains("Proposals.CubicHeat") || label->toolTip().contains("end CubicHeat"));
    EXPECT_EQ(shown.filter("held for 60 s").size(), 1);
    EXPECT_EQ(shown.filter("(T - T0)^3").size(), 1);
    const QStringList facts = shown.filter("Proposals.CubicHeat");
    ASSERT_EQ(facts.size(), 1);
    EXPECT_TRUE(facts.front().contains("0.31 %") && facts.front().contains("0.44 %")) << facts.front().toStdString();
}

TEST_F(Panels, AddsWhatIsProposedAsOneStepThatCanBeUndone) {
    openLambda();
    RunResult result = sampleFinding(document(), "thermal.radiation", "Analogon.Effects.Thermal.Radiation",
                                     "Radiation to constant surroundings", "heater.heatPort", "port", "k_r");
    result.finding.kind = FindingKind::Unexplained;
    result.finding.effects.clear();
    result.proposed = result.completed;
    result.proposed->models["proposed.mo"] = "model MissingHeat1\nend MissingHeat1;\n";
    result.completed = document().study();
    Remainder remainder;
    remainder.output = "i_mod";
    remainder.proposal.equation = "Q = a1*(T - T_amb)^3";
    remainder.proposal.className = "MissingHeat1";
    result.finding.unexplained.remainders = {remainder};
    const Study proposed = *result.proposed;
    const auto before = document().study().models;
    document().setResult(RunKind::Discover, std::move(result), document().study());
    const auto button = [&] { return panel<ResultPanel>()->findChild<QPushButton*>("adoptProposed"); };
    ASSERT_TRUE(QTest::qWaitFor([&] { return button() != nullptr; }, 5000));
    button()->click();
    EXPECT_EQ(document().study().models, proposed.models);
    EXPECT_NE(document().library().find("MissingHeat1"), nullptr) << "its block is the study's own";
    EXPECT_TRUE(QTest::qWaitFor([&] { return button() == nullptr; }, 5000)) << "it is offered once";
    document().undoStack().undo();
    EXPECT_EQ(document().study().models, before);
    EXPECT_TRUE(QTest::qWaitFor([&] { return button() != nullptr; }, 5000));
}

/// Colouring the text anew is no typing: what the view holds while it is hidden is not the model.
TEST_F(Panels, KeepTheModelWhenTheThemeChanges) {
    openLambda();
    const auto changeTheme = [&](style::Theme theme) {
        style::apply(*qApp, theme);
        QTest::qWait(400);  // longer than typing takes to be taken over
    };
    auto* tabs = window.findChild<QTabWidget*>("centre");
    auto* text = window.findChild<TextView*>();
    const auto opened = document().study().models;
    changeTheme(style::Theme::Dark);
    EXPECT_EQ(document().study().models, opened) << "the text was never shown";
    tabs->setCurrentWidget(text);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !text->toPlainText().isEmpty(); }, 5000));
    changeTheme(style::Theme::Light);
    EXPECT_EQ(document().study().models, opened) << "it is shown";
    tabs->setCurrentWidget(window.findChild<DiagramView*>());
    document().setParameterValue("heater.alpha", 0.0042);
    const auto edited = document().study().models;
    ASSERT_NE(edited, opened);
    changeTheme(style::Theme::Dark);
    EXPECT_EQ(document().study().models, edited) << "it was shown before an edit of the diagram";
    style::apply(*qApp, style::Theme::Light);
}

TEST_F(Panels, SaysOfWhatWasTriedWhyItIsNotInTheModel) {
    openLambda();
    RunResult result = sampleFinding(document(), "thermal.radiation", "Analogon.Effects.Thermal.Radiation",
                                     "Radiation to constant surroundings", "heater.heatPort", "port", "k_r");
    result.finding.candidates[2].reason = phrase("explains less than {}", "thermal.radiation at heater.heatPort");
    document().setResult(RunKind::Discover, std::move(result), document().study());
    ASSERT_TRUE(QTest::qWaitFor([&] { return panel<ResultPanel>()->candidates() != nullptr; }, 5000));
    const auto tipOf = [&](int row) { return panel<ResultPanel>()->candidates()->topLevelItem(row)->toolTip(4); };
    EXPECT_EQ(tipOf(2), "explains less than thermal.radiation at heater.heatPort");
    EXPECT_EQ(tipOf(5), "the data cannot show it: it only shifts motor.k") << "of a run that kept no reasons";
}

TEST_F(Panels, LeadsFromAProblemOfAFileToItsRow) {
    QFile file(directory.filePath("long.csv"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("t [s],T [degC],n [rpm]\n");
    for (int i = 0; i < 3000; ++i)
        file.write(QStringLiteral("%1,20,%2\n").arg(i).arg(i == 2500 ? "broken" : "60").toUtf8());
    file.close();
    openLambda();
    window.open(file.fileName());
    auto* import = panel<ImportPanel>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return import->problems().contains("2502"); }, 10000))
        << import->problems().toStdString();
    EXPECT_FALSE(import->acceptButton()->isEnabled());
    const int row = import->model()->showLine(2502);
    ASSERT_GE(row, 0) << "the lines around are shown as they stand in the file";
    EXPECT_EQ(import->model()->index(row, 0).data().toString(), "2500,20,broken");
    EXPECT_TRUE(import->model()->index(row, 0).data(Qt::BackgroundRole).isValid());
    for (QLabel* label : import->findChildren<QLabel*>())
        if (label->text().contains("<a href='2502'>")) Q_EMIT label->linkActivated("2502");
    EXPECT_EQ(import->findChild<QTableView*>("preview")->currentIndex().row(), row);

    file.setFileName(directory.filePath("good.csv"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("t [s],T [degC],n [rpm]\n0,20,60\n1,30,120\n");
    file.close();
    window.open(file.fileName());
    ASSERT_TRUE(QTest::qWaitFor([&] { return import->acceptButton()->isEnabled(); }, 10000));
    import->convertedBox()->setChecked(true);
    EXPECT_EQ(import->model()->headerData(1, Qt::Horizontal, Qt::DisplayRole).toString(), "T\n[K]");
    EXPECT_EQ(import->model()->index(0, 1).data().toString(), "293.15");
    EXPECT_NEAR(import->model()->index(0, 2).data().toDouble(), 6.2831853, 1e-6);
}

TEST_F(Panels, WritesTheWholeReportBesideTheWindow) {
    openLambda();
    run(RunKind::Fit);
    window.writeReport(directory.filePath("report"));
    const QDir place(directory.filePath("report"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.statusBar()->currentMessage().contains("report.html"); }, 20000));
    EXPECT_GT(QFileInfo(place.filePath("report.html")).size(), 5000);
    EXPECT_GT(QFileInfo(place.filePath("report.pdf")).size(), 5000);
}

TEST_F(Panels, WritesTheReportOnPaper) {
    openLambda();
    run(RunKind::Fit);
    ASSERT_TRUE(document().result());
    Finding finding = document().result()->finding;
    std::vector<QImage> pictures;
    panel<PlotPanel>()->takePictures([&](std::vector<QImage> taken) { pictures = std::move(taken); });
    ASSERT_TRUE(QTest::qWaitFor([&] { return !pictures.empty(); }, 10000));
    EXPECT_EQ(pictures.size(), document().study().experiments.size()) << "one output of each";
    for (const QImage& picture : pictures) EXPECT_FALSE(picture.isNull());
    const QString file = directory.filePath("report.pdf");
    const QString fault = writeReportPdf(file, "lambda", RunKind::Fit, finding, {pictures});
    EXPECT_TRUE(fault.isEmpty()) << fault.toStdString();
    EXPECT_GT(QFileInfo(file).size(), 5000);

    // all that the panel would say of a search
    finding.kind = FindingKind::Partial;
    finding.warnings = {Text("mind the range")};
    AddedEffect effect;
    effect.kind = "thermal.loss";
    effect.at = "element.solid";
    effect.description = "Heat loss";
    effect.instead.effects = {{"thermal.radiation", "element.solid", -3, true}};
    finding.effects = {effect};
    Remainder remainder;
    remainder.output = "i_mod";
    remainder.from = 3;
    remainder.to = 7;
    remainder.node = "element.solid";
    remainder.proposal.equation = Text("Q_flow = a*v^2");
    finding.unexplained.remainders = {remainder};
    finding.nextExperiment = Text("hold the voltage");
    CandidateResult passedOver;
    passedOver.kind = "thermal.loss";
    passedOver.verdict = Verdict::Weaker;
    passedOver.reason = Text("explains less than another");
    finding.candidates = {passedOver};
    const QString body = reportBody("lambda", RunKind::Discover, finding, {pictures});
    for (const char* wanted :
         {"Heat loss at element.solid", "some structure remains", "warm-up", "drive cycle", "mind the range",
          "cannot tell it from: thermal.radiation at element.solid", "What remains on i_mod", "acting at element.solid",
          "Q_flow = a*v^2", "hold the voltage", "explains less than another", "heater.R", "picture:1"})
        EXPECT_TRUE(body.contains(wanted)) << wanted;
}

TEST_F(Panels, OffersWorkThatAnEndedProgramLeft) {
    abandonedCopy("mine.analogon");
    MainWindow fresh;
    fresh.show();
    QPushButton* open = nullptr;
    for (QPushButton* b : fresh.findChild<StartPage*>()->findChildren<QPushButton*>())
        if (b->text() == "Open") open = b;
    ASSERT_TRUE(open) << "the first page offers it";
    QTest::mouseClick(open, Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return fresh.document().isOpen(); }, 10000));
    EXPECT_TRUE(fresh.document().isModified()) << "it is not saved where it belongs";
    EXPECT_EQ(fresh.document().title(), "mine");
    fresh.saveTo(fresh.document().path());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !fresh.document().isModified(); }, 10000));
    EXPECT_TRUE(QFile::exists(directory.filePath("mine.analogon")));
    EXPECT_TRUE(QTest::qWaitFor([&] { return Recovery::abandoned().empty(); }, 10000)) << "it is not offered again";
}

TEST_F(Panels, OffersLeftWorkOverAStudyThatIsOpenedAtTheStart) {
    const QString copy = abandonedCopy("mine.analogon");
    window.open(lambdaFile());
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().isOpen(); }, 20000));
    auto* line = panel<QToolBar>("recovered")->findChild<RecoveredLine*>();
    ASSERT_TRUE(line && line->isVisible());
    Q_EMIT line->chosen({copy, directory.filePath("mine.analogon"), {}});
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().title() == "mine"; }, 20000));
    EXPECT_FALSE(panel<QToolBar>("recovered")->isVisible()) << "it is open";
    EXPECT_EQ(Recovery::abandoned().size(), 1u) << "until it has a copy of its own";
    ASSERT_TRUE(QTest::qWaitFor([&] { return Recovery::abandoned().empty(); }, 10000));
    EXPECT_FALSE(QFile::exists(copy));
    EXPECT_TRUE(document().isModified());
}

TEST_F(Panels, KeepsACopyOfTheWorkOfWhoNeverPauses) {
    openLambda();
    QElapsedTimer clock;
    clock.start();
    while (keptCopy().isEmpty() && clock.elapsed() < 15000) {
        document().typeText(document().modelText() + "// more\n");
        QTest::qWait(500);
    }
    EXPECT_FALSE(keptCopy().isEmpty());
}

TEST_F(Panels, KeepsACopyOfUnsavedChangesAndTakesItAway) {
    openLambda();
    document().typeText(document().modelText() + "// changed\n");
    ASSERT_TRUE(QTest::qWaitFor([&] { return !keptCopy().isEmpty(); }, 8000));
    EXPECT_TRUE(Recovery::abandoned().empty()) << "this program is still alive";
    Recovery::discard({keptCopy(), {}, {}});
    EXPECT_FALSE(keptCopy().isEmpty()) << "the work of a program that is alive is nobody's to discard";
    window.saveTo(document().path());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document().isModified() && keptCopy().isEmpty(); }, 8000));
    const Outcome<OpenedStudy> saved = openStudy(document().path().toStdString());
    ASSERT_TRUE(saved);
    EXPECT_TRUE(saved->study.models.at("model.mo").ends_with("// changed\n"));
}

/// As by an earlier version, by another program, or by hand.
TEST_F(Panels, LeavesWhatOnlyHasTheNameOfLeftWork) {
    recoveryPlace().mkpath("work-1");
    recoveryPlace().mkpath("work-empty");
    for (const char* name : {"999999.analogon", "work-1/copy.analogon", "work-1/copy.analogon.origin"})
        ASSERT_TRUE(QFile::copy(lambdaFile(), recoveryPlace().filePath(name)));
    EXPECT_TRUE(Recovery::abandoned().empty());
    Recovery::discard({recoveryPlace().filePath("work-1/copy.analogon"), {}, {}});
    for (const char* name : {"999999.analogon", "work-1/copy.analogon", "work-1/copy.analogon.origin", "work-empty"})
        EXPECT_TRUE(QFile::exists(recoveryPlace().filePath(name))) << name;
}

TEST_F(Panels, SaysWhatIsWrongWithAnArchive) {
    const QString file = directory.filePath("cut.analogon");
    QFile whole(lambdaFile());
    ASSERT_TRUE(whole.open(QIODevice::ReadOnly));
    QFile cut(file);
    ASSERT_TRUE(cut.open(QIODevice::WriteOnly));
    cut.write(whole.readAll().chopped(200));
    cut.close();
    window.open(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document().isReading() && !document().messages().empty(); }, 5000));
    EXPECT_FALSE(document().isOpen());
    EXPECT_NE(document().messages().front().diagnostic.message.find("cut off"), std::string::npos);
}

TEST_F(Panels, ComposesAStudyFromDomainsAndARecording) {
    QMetaObject::invokeMethod(panel<StartPage>(), "generateWanted");
    auto* page = panel<GeneratePage>();
    ASSERT_TRUE(page->isVisible());
    EXPECT_FALSE(page->generateButton()->isEnabled());
    for (const char* domain : {"electric-thermal", "thermal-fluid"}) page->addDomain(domain);
    page->addRecording(ANALOGON_ROOT "/examples/lambda-sensor-heating/train.csv");
    ASSERT_TRUE(page->generateButton()->isEnabled()) << page->fault().toStdString();
    QTest::mouseClick(page->generateButton(), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().isOpen(); }, 20000)) << page->fault().toStdString();
    EXPECT_TRUE(document().canRun());
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().before() != nullptr; }, 20000));
    const auto& said = document().messages();
    EXPECT_TRUE(std::any_of(said.begin(), said.end(), [](const Message& m) {
        return m.diagnostic.severity == Severity::Note;
    })) << "what was assumed, still there when the model has been analysed";
}

TEST_F(Panels, TakesADomainAndARecordingOutAgain) {
    QMetaObject::invokeMethod(panel<StartPage>(), "generateWanted");
    auto* page = panel<GeneratePage>();
    page->addDomain("electric-thermal");
    page->addDomain("thermal-fluid");
    page->addRecording(ANALOGON_ROOT "/examples/lambda-sensor-heating/train.csv");
    for (const auto& [list, name] :
         {std::pair{page->chain(), "takeOutDomain"}, std::pair{page->recordings(), "takeOutRecording"}}) {
        auto* button = page->findChild<QPushButton*>(name);
        ASSERT_TRUE(button);
        EXPECT_FALSE(button->isEnabled()) << "nothing is marked";
        const int before = list->count();
        list->setCurrentRow(0);
        QTest::mouseClick(button, Qt::LeftButton);
        EXPECT_EQ(list->count(), before - 1);
    }
    EXPECT_EQ(page->chain()->item(0)->data(Qt::UserRole).toString(), "thermal-fluid");
    EXPECT_FALSE(page->generateButton()->isEnabled()) << "without a recording";
}

TEST_F(Panels, RemembersFromOneStartToTheNext) {
    {
        Settings settings;
        settings.setValue("test/list", QStringList{"a", "b"});
        EXPECT_EQ(settings.value("test/list").toStringList().size(), 2) << "it holds at once";
        for (int i = 0; i <= 20; ++i) settings.setValue("test/number", i);  // faster than a file is written
    }
    const Settings next;
    EXPECT_EQ(next.value("test/number").toInt(), 20);
    EXPECT_EQ(next.value("test/list").toStringList(), (QStringList{"a", "b"}));
    EXPECT_EQ(next.value("test/nothing", 7).toInt(), 7);
}

TEST_F(Panels, TakesDroppedRecordingsAsTheBeginningOfAStudy) {
    ASSERT_TRUE(drop(panel<StartPage>(), {example("train.csv"), example("validation.csv")}));
    auto* page = panel<GeneratePage>();
    ASSERT_TRUE(page->isVisible());
    for (const char* domain : {"electric-thermal", "thermal-fluid"}) page->addDomain(domain);
    QTest::mouseClick(page->generateButton(), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().isOpen(); }, 20000)) << page->fault().toStdString();
    EXPECT_EQ(document().study().experiments.size(), 2u);
}

TEST_F(Panels, TakesFilesDroppedOnAnyPanel) {
    openLambda();
    auto* centre = window.findChild<QTabWidget*>("centre");
    auto* import = panel<ImportPanel>();
    for (QWidget* target :
         std::initializer_list<QWidget*>{panel<DiagramView>(), panel<TextView>(), panel<PlotPanel>()}) {
        if (centre->indexOf(target) >= 0) centre->setCurrentWidget(target);
        const QString text = document().modelText();
        ASSERT_TRUE(drop(target, {example("train.csv")})) << target->metaObject()->className();
        EXPECT_TRUE(import->isVisible()) << target->metaObject()->className();
        EXPECT_EQ(document().modelText(), text);
        EXPECT_FALSE(panel<TextView>()->toPlainText().contains("file:"));
        Q_EMIT import->cancelled();
        EXPECT_FALSE(import->isVisible());
    }
    const std::size_t before = document().study().experiments.size();
    ASSERT_TRUE(drop(panel<DiagramView>(), {example("train.csv"), example("validation.csv")}));
    for (std::size_t count = before + 1; count <= before + 2; ++count) {  // one after the other
        ASSERT_TRUE(QTest::qWaitFor([&] { return import->isVisible() && import->acceptButton()->isEnabled(); }, 10000));
        QTest::mouseClick(import->acceptButton(), Qt::LeftButton);
        EXPECT_EQ(document().study().experiments.size(), count);
    }
    EXPECT_FALSE(import->isVisible());
    document().undoStack().setIndex(0);
    ASSERT_TRUE(drop(panel<DiagramView>(), {example("train.csv"), example("validation.csv")}));
    ASSERT_TRUE(drop(panel<DiagramView>(), {lambdaFile("dropped")}));
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().title() == "dropped"; }, 20000));
    Q_EMIT import->cancelled();
    EXPECT_FALSE(import->isVisible()) << "what waited belonged to the study before";
    ASSERT_TRUE(drop(panel<DiagramView>(), {QStringLiteral(ANALOGON_ROOT "/examples/lambda-sensor-heating")}));
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().title() == "lambda-sensor-heating"; }, 20000));
}

TEST_F(Panels, CountsWhatIsStillBeingTyped) {
    openLambda();
    auto* text = panel<TextView>();
    window.findChild<QTabWidget*>("centre")->setCurrentWidget(text);
    window.activateWindow();
    text->setFocus();
    ASSERT_TRUE(QTest::qWaitFor([&] { return text->hasFocus(); }, 5000));
    text->moveCursor(QTextCursor::End);
    QTest::keyClicks(text, "// a");
    QTest::keyClick(&window, Qt::Key_S, Qt::ControlModifier);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document().isSaving() && !document().isModified(); }, 10000));
    const Outcome<OpenedStudy> saved = openStudy(document().path().toStdString());
    ASSERT_TRUE(saved);
    EXPECT_TRUE(saved->study.models.at("model.mo").ends_with("// a")) << "saved";
    EXPECT_TRUE(text->hasFocus()) << "and one types on";
    QTest::keyClicks(text, "b");
    window.close();
    EXPECT_TRUE(window.isVisible()) << "not closed without a question";
    for (QDialog* question : window.findChildren<QDialog*>()) question->reject();
    EXPECT_TRUE(document().modelText().endsWith("// ab"));
}

TEST_F(Panels, GivesTheGuideTheWholeHeightWhileItIsRead) {
    openLambda();
    auto* traces = window.findChild<QDockWidget*>("traces");
    auto* centre = window.findChild<QTabWidget*>("centre");
    QTest::keyClick(&window, Qt::Key_F1);
    EXPECT_TRUE(traces->isHidden());
    centre->setCurrentIndex(0);
    EXPECT_FALSE(traces->isHidden());
    QTest::keyClick(&window, Qt::Key_F1);
    EXPECT_TRUE(traces->isHidden());
    Q_EMIT panel<GuidePage>()->left();
    EXPECT_FALSE(traces->isHidden());
    EXPECT_FALSE(window.findChild<QDockWidget*>("messages")->isHidden());
}

TEST_F(Panels, FramesTheChooserOnAllSidesBetweenWholeScales) {
    window.startNew();
    QTest::qWait(100);  // until the panels stand around the diagram
    QMetaObject::invokeMethod(panel<DiagramView>(), "typed", Q_ARG(QString, "heat"));
    const auto* chooser = panel<Chooser>();
    ASSERT_TRUE(chooser && chooser->isVisible());
    const QColor frame = style::mix(chooser->palette().color(QPalette::Window), style::accent(chooser->palette()), 0.6);
    for (const auto& [scale, shift] :  // an edge on a pixel, and between two
         {std::pair(1.5, 0), std::pair(1.5, 1), std::pair(2.0, 0), std::pair(2.0, 1)}) {
        window.resize(1440 + 2 * shift, 900 + 2 * shift);
        QTest::qWait(20);
        QImage picture(window.size() * scale, QImage::Format_RGB32);
        picture.setDevicePixelRatio(scale);
        window.render(&picture);
        const QRectF box(chooser->mapTo(&window, QPoint()), chooser->size());
        const auto isFramed = [&, scale = scale](QPointF at) {
            const QRect around(QPoint(static_cast<int>(at.x() * scale) - 2, static_cast<int>(at.y() * scale) - 2),
                               QSize(5, 5));
            for (int y = around.top(); y <= around.bottom(); ++y)
                for (int x = around.left(); x <= around.right(); ++x)
                    if (std::abs(picture.pixelColor(x, y).red() - frame.red()) < 3) return true;
            return false;
        };
        for (const QPointF at : {QPointF(box.left(), box.center().y()), QPointF(box.right(), box.center().y()),
                                 QPointF(box.center().x(), box.top()), QPointF(box.center().x(), box.bottom())})
            EXPECT_TRUE(isFramed(at)) << at.x() << " " << at.y() << " at " << scale;
    }
}

TEST_F(Panels, OpensTheGuideWithItsPictures) {
    ASSERT_FALSE(guideFile().isEmpty());
    QTest::keyClick(&window, Qt::Key_F1);
    ASSERT_TRUE(panel<GuidePage>());
    EXPECT_TRUE(panel<GuidePage>()->isVisible());
    EXPECT_TRUE(panel<GuidePage>()->browser()->toPlainText().contains("Discover what is missing"));
    EXPECT_EQ(panel<GuidePage>()->browser()->horizontalScrollBar()->maximum(), 0) << "no line is wider than the page";
    // pictures come a moment later, where room was left for them
    const auto isRead = [&] {
        const QVariant found = panel<GuidePage>()->browser()->document()->resource(QTextDocument::ImageResource,
                                                                                   QUrl("pictures/01-start-en.png"));
        const auto image = found.value<QImage>();
        return !image.isNull() && image.pixelColor(image.rect().center()).alpha() == 255;
    };
    EXPECT_TRUE(QTest::qWaitFor(isRead, 20000));
    // a dark window shows dark ones
    const auto corner = [&] {
        return panel<GuidePage>()
            ->browser()
            ->document()
            ->resource(QTextDocument::ImageResource, QUrl("pictures/01-start-en.png"))
            .value<QImage>()
            .pixelColor(4, 4);
    };
    EXPECT_GT(corner().lightness(), 200);
    style::apply(*qApp, style::Theme::Dark);
    EXPECT_TRUE(QTest::qWaitFor([&] { return isRead() && corner().lightness() < 100; }, 20000));
    style::apply(*qApp, style::Theme::Light);
    EXPECT_TRUE(QTest::qWaitFor([&] { return isRead() && corner().lightness() > 200; }, 20000));
    QFile guide(guideFile());
    ASSERT_TRUE(guide.open(QIODevice::ReadOnly));
    static const QRegularExpression picture(R"(!\[[^\]]*\]\(([^)]+)\))");
    int count = 0;
    for (auto it = picture.globalMatch(QString::fromUtf8(guide.readAll())); it.hasNext(); ++count) {
        QString file = QFileInfo(guideFile()).dir().filePath(it.next().captured(1));
        EXPECT_FALSE(QImage(file).isNull()) << file.toStdString();
        EXPECT_FALSE(QImage(file.replace(".png", "-dark.png")).isNull()) << file.toStdString();
    }
    EXPECT_GE(count, 6);
}

TEST(TimePlotSpeed, StaysFluidWithAMillionSamples) {
    constexpr int samples = 1000000;
    auto time = std::make_shared<std::vector<double>>();
    std::vector<double> noisy, smooth;
    for (int i = 0; i < samples; ++i) {
        time->push_back(i * 1e-3);
        noisy.push_back(std::sin(i * 1e-4) + 0.1 * std::sin(i * 1.7));
        smooth.push_back(std::sin(i * 1e-4));
    }
    const Trace measured{TraceRole::Measured, std::move(noisy)}, after{TraceRole::After, std::move(smooth)};
    TimePlot plot;
    plot.resize(900, 250);
    plot.show();
    plot.setTraces(time, {measured, after});
    int zoom = 0;
    const double zoomed = test::leastMilliseconds(15, [&] {
        plot.setTimeRange(10.0 * zoom, 1000 - 20.0 * zoom);
        ++zoom;
        plot.repaint();
        QCoreApplication::processEvents();
    });
    const double live = test::leastMilliseconds(3, [&] { plot.setTrace(after); });
    std::cout << "another trace of 1e6 samples while a fit runs: " << live << " ms\n"
              << "zoom and repaint of two traces of 1e6 samples: " << zoomed << " ms\n";
    EXPECT_LT(live, 20) << "[ms]";
    EXPECT_LT(zoomed, 10) << "[ms]";
}

/// What a long recording costs the window when its traces arrive: it must not be felt.
TEST_F(Panels, TakesALongRecordingWithoutAStall) {
    openLambda();
    ModelState state = *document().before();
    constexpr Eigen::Index samples = 1000000;
    for (ExperimentState& e : state.experiments) {
        e.time.resize(samples);
        for (std::size_t i = 0; i < e.time.size(); ++i) e.time[i] = static_cast<double>(i) * 1e-3;
        for (OutputState& o : e.outputs) {
            o.measured = Eigen::VectorXd::LinSpaced(samples, 0, 300).array().sin();
            o.simulated = o.measured.array() + 0.01;
        }
    }
    const auto spent = [] {
        rusage usage{};
        getrusage(RUSAGE_THREAD, &usage);
        return usage;
    };
    const auto work = [](const rusage& from, const rusage& to) {  // [ms]
        const auto each = [](const timeval& t) {
            return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
        };
        return each(to.ru_utime) - each(from.ru_utime) + each(to.ru_stime) - each(from.ru_stime);
    };
    const auto memory = [](const rusage& from, const rusage& to) {  // [MB]
        return static_cast<double>(to.ru_minflt - from.ru_minflt) * static_cast<double>(sysconf(_SC_PAGESIZE)) * 1e-6;
    };
    auto* plots = panel<PlotPanel>();
    const auto measure = [&](const char* what, double limit, const std::function<void()>& act) {
        const rusage begin = spent();
        act();
        QCoreApplication::processEvents();
        const rusage end = spent();
        const double worked = work(begin, end), fresh = memory(begin, end);
        std::cout << what << ": " << worked << " ms, " << fresh << " MB of fresh memory\n";
#ifdef __SANITIZE_ADDRESS__
        limit *= 3;  // every access is checked
#endif
        EXPECT_LT(worked, limit) << "[ms] " << what;
        // the residuals alone are new: what is drawn lies where it was
        EXPECT_LT(fresh, 4.5 * 8e-6 * samples) << "[MB] " << what;
    };
    // about three times what a machine takes that does nothing else
    RunResult found;
    found.finding.baseline = state;
    found.finding.final = state;
    found.completed = document().study();
    const Study ranOn = document().study();
    measure("traces of 1e6 samples arrive", 75, [&] { document().setSimulated(std::move(state)); });
    ASSERT_EQ(plots->plots().front()->content().measured.size(), 1000000u);
    auto* tabs = plots->findChild<QTabBar*>();
    measure("another recording is shown", 75, [&] { tabs->setCurrentIndex(1); });
    measure("what was found arrives", 130, [&] { document().setResult(RunKind::Discover, std::move(found), ranOn); });
    ASSERT_EQ(plots->plots().front()->content().after.size(), 1000000u);
    measure("its report is begun", 130, [&] { window.writeReport(directory.filePath("long")); });
    for (std::size_t picture = 0; picture <= document().study().experiments.size(); ++picture)  // one at a turn
        measure("a turn of its pictures", 130, [] {});
    measure("its numbers are exported", 50, [&] { plots->exportTo(directory.filePath("long.csv")); });
}

/// In German, whose words are the longer ones: no name of a parameter, and no effect among those tried, is cut.
TEST(Texts, AreWholeInTheTables) {
    Translator german;
    ASSERT_TRUE(german.loadLanguage("de"));
    QCoreApplication::installTranslator(&german);
    {
        MainWindow window;
        window.resize(1440, 900);
        window.show();
        window.open(ANALOGON_ROOT "/examples/lambda-sensor-heating");
        ASSERT_TRUE(QTest::qWaitFor([&] { return window.document().isOpen() && window.document().before(); }, 20000));
        window.controller().start(RunKind::Discover);
        ASSERT_TRUE(QTest::qWaitFor([&] { return !window.controller().isRunning(); }, 180000));
        window.document().adoptCompleted("add");
        auto* parameters = window.findChild<ParameterPanel*>();
        ASSERT_TRUE(QTest::qWaitFor([&] { return parameters->model()->rowOf("radiation.T_amb") >= 0; }, 20000));
        for (const int width : {1440, 1100}) {
            window.resize(width, 900);
            QTest::qWait(300);
            QTableView* table = parameters->table();
            for (int c = 0; c < table->model()->columnCount(); ++c)
                for (int r = 0; r < table->model()->rowCount() && !table->isColumnHidden(c); ++r)
                    EXPECT_GE(table->columnWidth(c), table->sizeHintForIndex(table->model()->index(r, c)).width())
                        << width << " " << table->model()->index(r, c).data().toString().toStdString();
            QTreeWidget* tried = window.findChild<ResultPanel*>()->candidates();
            ASSERT_TRUE(tried);
            int inTwoLines = 0;
            for (int r = 0; r < tried->topLevelItemCount(); ++r) {
                const QRect cell = tried->visualItemRect(tried->topLevelItem(r));
                const QRect needed = QFontMetrics(tried->topLevelItem(r)->font(0))
                                         .boundingRect(QRect(0, 0, tried->columnWidth(0) - 8, 500), Qt::TextWordWrap,
                                                       tried->topLevelItem(r)->text(0));
                EXPECT_GE(cell.height(), needed.height()) << tried->topLevelItem(r)->text(0).toStdString();
                inTwoLines += needed.height() > 1.5 * tried->fontMetrics().height() ? 1 : 0;
                if (r + 1 == tried->topLevelItemCount()) {
                    EXPECT_LE(cell.bottom(), tried->viewport()->height()) << "the list is as high as its rows";
                }
            }
            EXPECT_GT(inTwoLines, 0);
        }
    }
    QCoreApplication::removeTranslator(&german);
}

/// A laptop of 1280 x 720 pixels at 150 % leaves 853 x 480, one of 1920 x 1080 at 200 % 960 x 540, less what its
/// desktop keeps for itself; one of 1366 x 768 at 100 % less as much.
TEST(SmallScreen, HasRoomForEveryPanel) {
    for (const char* language : {"en", "de"})
        for (const auto& [room, example] :
             {std::pair(QSize(853, 440), "lambda-sensor-heating"), std::pair(QSize(960, 500), "water-pump"),
              std::pair(QSize(1366, 728), "water-pump")}) {
            Translator translator;
            if (translator.loadLanguage(language)) QCoreApplication::installTranslator(&translator);
            {
                MainWindow window;
                window.resize(room);
                window.show();
                window.open(QStringLiteral(ANALOGON_ROOT "/examples/") + example);
                ASSERT_TRUE(
                    QTest::qWaitFor([&] { return window.document().isOpen() && window.document().before(); }, 20000));
                for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
                    dock->raise();
                    QTest::qWait(50);
                    EXPECT_EQ(window.size(), room) << language << " " << dock->objectName().toStdString();
                    EXPECT_GT(dock->geometry().intersected(window.rect()).height(), 100)
                        << dock->objectName().toStdString();
                    window.grab().save(QStringLiteral(ANALOGON_PICTURES "/small-%1-%2-%3.png")
                                           .arg(language)
                                           .arg(room.width())
                                           .arg(dock->objectName()));
                }
                EXPECT_GT(window.findChild<DiagramView*>()->height(), 120);
                const auto* view = window.findChild<DiagramView*>();
                EXPECT_GE(view->zoom(), BlockItem::leastZoomWithNames) << "blocks have names";
                const std::vector<Block>& blocks = window.document().diagram().blocks;
                for (std::size_t i = 0; i < blocks.size(); ++i)
                    for (std::size_t j = 0; j < i; ++j)
                        EXPECT_FALSE(view->nameRect(blocks[i].name)
                                         .adjusted(-4, 0, 4, 0)  // else the two are read as one
                                         .intersects(view->nameRect(blocks[j].name)))
                            << blocks[i].name << " over or beside " << blocks[j].name;
                window.findChild<QDockWidget*>("traces")->raise();
                QTest::qWait(50);
                const OutputPlot* plot = window.findChild<PlotPanel*>()->plots().front();
                const TimePlot* last = plot->residual()->QWidget::isHidden() ? plot->values() : plot->residual();
                EXPECT_EQ(last->visibleRegion().boundingRect(), last->rect()) << "the time axis of an output is whole";
            }
            QCoreApplication::removeTranslator(&translator);
        }
}

/// Every text of the screen that is marked for translation has a German one.
TEST(Translation, GermanIsComplete) {
    Translator german;
    ASSERT_TRUE(german.loadLanguage("de"));
    static const QRegularExpression call(R"re(\btr\(\s*((?:"(?:\\.|[^"\\])*"\s*)+))re");
    static const QRegularExpression literal(R"re("((?:\\.|[^"\\])*)")re");
    int count = 0;
    for (QDirIterator files(ANALOGON_ROOT "/ui", {"*.cpp", "*.hpp"}, QDir::Files, QDirIterator::Subdirectories);
         files.hasNext();) {
        QFile file(files.next());
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        const QString source = QString::fromUtf8(file.readAll());
        for (auto calls = call.globalMatch(source); calls.hasNext(); ++count) {
            QString text;
            for (auto parts = literal.globalMatch(calls.next().captured(1)); parts.hasNext();)
                text += parts.next().captured(1);
            text.replace("\\n", "\n").replace("\\\"", "\"").replace("\\\\", "\\");
            EXPECT_TRUE(german.knows(text)) << file.fileName().toStdString() << ": " << text.toStdString();
        }
    }
    EXPECT_GT(count, 300);
    const Outcome<Library> library = builtInLibrary();
    ASSERT_TRUE(library);
    for (const LibraryClass* cls : library->classes()) {
        EXPECT_TRUE(cls->definition->description.empty() ||
                    german.knows(QString::fromStdString(cls->definition->description)))
            << cls->qualifiedName;
        const syntax::Modification* info =
            cls->definition->annotation ? cls->definition->annotation->find("Documentation") : nullptr;
        static const QRegularExpression paragraph("<p>(.*?)</p>", QRegularExpression::DotMatchesEverythingOption);
        for (const syntax::Modification& m : info ? info->arguments : std::vector<syntax::Modification>())
            for (auto found = paragraph.globalMatch(QString::fromStdString(m.value ? m.value->text : ""));
                 found.hasNext();) {
                const QString text = found.next().captured(1).simplified();
                EXPECT_TRUE(german.knows(text)) << cls->qualifiedName << ": " << text.toStdString();
            }
        for (const auto& component : cls->definition->components)
            EXPECT_TRUE(component.description.empty() || german.knows(QString::fromStdString(component.description)))
                << cls->qualifiedName << ": " << component.description;
    }
    for (const Example& example : findExamples())
        for (const QString& text : {example.title, example.description})
            EXPECT_TRUE(german.knows(text)) << text.toStdString();
}

/// Random mouse and key events anywhere in the window: nothing crashes, nothing hangs. ANALOGON_EVENTS sets how many.
TEST_F(Panels, SurvivesRandomEvents) {
    openLambda();
    const QString original = lambdaFile("original");
    const char* wanted = std::getenv("ANALOGON_EVENTS");
    const char* seed = std::getenv("ANALOGON_SEED");
    const int events = wanted ? std::atoi(wanted) : 1500;
    std::mt19937 random(seed ? static_cast<unsigned>(std::atoi(seed)) : 1u);
    const Qt::Key keys[] = {Qt::Key_A,    Qt::Key_W,      Qt::Key_H,      Qt::Key_V,    Qt::Key_R,      Qt::Key_D,
                            Qt::Key_Z,    Qt::Key_Y,      Qt::Key_C,      Qt::Key_X,    Qt::Key_Delete, Qt::Key_F2,
                            Qt::Key_Tab,  Qt::Key_Return, Qt::Key_Space,  Qt::Key_Left, Qt::Key_Right,  Qt::Key_Up,
                            Qt::Key_Down, Qt::Key_1,      Qt::Key_Period, Qt::Key_F5,   Qt::Key_Plus,   Qt::Key_Escape,
                            Qt::Key_T,    Qt::Key_Minus,  Qt::Key_F6,     Qt::Key_F1};
    // What can be hit, listed anew now and then: finding all of it costs more than most events.
    QList<QPointer<QWidget>> targets;
    int listed = 0;
    const auto canBeHit = [](const QWidget* w) {
        return w && w->isVisible() && w->isEnabled() && w->width() > 2 && w->height() > 2;
    };
    const auto anyTarget = [&]() -> QWidget* {
        for (int tries = 0; tries < 100; ++tries) {
            if (targets.isEmpty() || ++listed % 8 == 0) {
                targets.clear();
                for (QWidget* w : window.findChildren<QWidget*>())
                    if (canBeHit(w)) targets << w;
            }
            if (targets.isEmpty()) return nullptr;
            QWidget* w = targets[static_cast<qsizetype>(random() % static_cast<unsigned>(targets.size()))];
            if (canBeHit(w)) return w;
        }
        return nullptr;
    };
    double longest = 0;  // [ms]
    int felt = 0, running = 0, runs = 0;
    QString previous;
    for (int i = 0; i < events; ++i) {
        if (i % 1000 == 999) {  // by then nothing may be left of the study
            const QString copy = directory.filePath(QStringLiteral("%1.analogon").arg(i));
            ASSERT_TRUE(QFile::copy(original, copy));  // the window may be writing the one before
            document().open(copy);
            ASSERT_TRUE(QTest::qWaitFor([&] { return !document().isReading() && document().before(); }, 60000));
            if (!previous.isEmpty()) QFile::remove(previous);
            previous = copy;
        }
        // A run is followed for a while; what it does for minutes after that is no business of the screen.
        running = window.controller().isRunning() ? running + 1 : 0;
        if (running == 1) ++runs;
        if (running > 300) window.controller().cancel();
        const QPointer<QWidget> target = anyTarget();
        ASSERT_TRUE(target);
        const auto point = [&] {
            const auto below = [&](int size) {  // a press may have folded the target up
                return static_cast<int>(random() % static_cast<unsigned>(std::max(1, size)));
            };
            return QPoint(below(target->width()), below(target->height()));
        };
        const Qt::KeyboardModifiers modifiers = random() % 5 == 0   ? Qt::ControlModifier
                                                : random() % 7 == 0 ? Qt::ShiftModifier
                                                                    : Qt::NoModifier;
        const QString where = QStringLiteral("%1 %2").arg(target->metaObject()->className(), target->objectName());
        const auto kind = random() % 6;
        const Qt::Key key = kind > 3 ? keys[random() % std::size(keys)] : Qt::Key_unknown;
        const double begin = test::ownMilliseconds(), worked = test::workedMilliseconds();
        switch (kind) {
            case 0:
                QTest::mouseClick(target, Qt::LeftButton, modifiers, point());
                break;
            case 1:
                QTest::mouseDClick(target, Qt::LeftButton, modifiers, point());
                break;
            case 2: {
                QTest::mousePress(target, Qt::LeftButton, modifiers, point());
                if (target) QTest::mouseMove(target, point());
                if (target) QTest::mouseMove(target, point());
                if (target) QTest::mouseRelease(target, Qt::LeftButton, modifiers, point());
                break;
            }
            case 3:
                QTest::mouseMove(target, point());
                break;
            default:
                QTest::keyClick(target, key, modifiers);
        }
        QCoreApplication::processEvents();
        const double reaction = test::ownMilliseconds() - begin;
        longest = std::max(longest, reaction);
        if (reaction > 50) {
            ++felt;
            std::cout << "event " << i << ": " << reaction << " ms, " << test::workedMilliseconds() - worked
                      << " of them at work, kind " << kind << " on " << where.toStdString() << ", key "
                      << QKeySequence(key).toString().toStdString() << " modifiers " << modifiers << ", "
                      << document().diagram().blocks.size() << " blocks\n";
        }
        // Select all and duplicate, again and again: beyond what a diagram is made for.
        while (document().diagram().blocks.size() > 500 && document().undoStack().canUndo())
            document().undoStack().undo();
        for (QWidget* top : QApplication::topLevelWidgets()) {
            if (auto* dialog = qobject_cast<QDialog*>(top); dialog && dialog->isVisible()) dialog->reject();
            if (top->isVisible() && (top->windowFlags() & Qt::Popup) == Qt::Popup) top->hide();
        }
        if (!window.isVisible()) window.show();
    }
    std::cout << events << " events of seed " << (seed ? seed : "1") << ", " << runs
              << " runs begun; longest reaction to an event: " << longest << " ms; over 50 ms: " << felt << "\n";
    window.controller().cancel();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window.controller().isRunning(); }, 20000));
    while (document().undoStack().canUndo()) document().undoStack().undo();
#ifndef __SANITIZE_ADDRESS__  // where every access is checked, all takes several times as long
    EXPECT_LE(felt, events / 300) << "hardly anything is felt: over 50 ms is what a busy machine does now and then";
#endif
    EXPECT_LT(longest, 1000) << "[ms]";
}

}  // namespace
}  // namespace analogon::ui
