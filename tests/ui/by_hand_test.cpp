#include <unistd.h>

#include <QComboBox>
#include <QContextMenuEvent>
#include <QDockWidget>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QStatusBar>
#include <QStyleOptionSlider>
#include <QTabBar>
#include <QTableWidget>
#include <QTextEdit>
#include <QToolButton>
#include <QTreeView>
#include <QTreeWidget>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "core/study/recorded.hpp"
#include "core/study/sensitivity.hpp"
#include "tests/core/measure/mdf/mdf4_writer.hpp"
#include "tests/ui/by_hand_fixture.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/inspector/knob.hpp"
#include "ui/inspector/parameter_model.hpp"
#include "ui/inspector/parameter_panel.hpp"
#include "ui/library/library_panel.hpp"
#include "ui/measurement/compare_page.hpp"
#include "ui/measurement/course_plot.hpp"
#include "ui/measurement/import_panel.hpp"
#include "ui/measurement/measurement_panel.hpp"
#include "ui/measurement/practice_dialog.hpp"
#include "ui/plot/plot_panel.hpp"
#include "ui/plot/time_plot.hpp"
#include "ui/signals/plot_area.hpp"
#include "ui/signals/signal_browser.hpp"
#include "ui/signals/signal_strip.hpp"
#include "ui/text/find_bar.hpp"
#include "ui/text/text_view.hpp"
#include "ui/window/compose_actions.hpp"

namespace analogon::ui {
namespace {

// ---- signals ----

TEST_F(ByHand, SignalsAreFoundByKindComponentAndRecording) {
    openSignals();
    const QStringList all = listed();
    ASSERT_GT(all.size(), 20);
    const auto& [output, mapping] = *document().study().experiments.front().outputs.begin();
    const QString column = QString::fromStdString(mapping.column);
    for (const QString& word : {column, QString("p_ambient"), QString("residuals"), QString("sensitivities")}) {
        seek(word);
        EXPECT_FALSE(listed().isEmpty()) << word.toStdString();
        EXPECT_LT(listed().size(), all.size()) << word.toStdString();
    }
    seek("heater");
    EXPECT_TRUE(listed().contains("heater | i")) << "of a component: " << listed().join('\n').toStdString();
    seek(QString::fromStdString(document().study().experiments[1].name) + " " + column);
    ASSERT_EQ(listed().size(), 1) << "of a recording";
    EXPECT_TRUE(listed().front().startsWith(QString::fromStdString(document().study().experiments[1].name)));
    seek("no such thing");
    EXPECT_TRUE(listed().isEmpty());
}

TEST_F(ByHand, SensitivitiesGoToThePlotsByEnter) {
    openSignals();
    const Outcome<Sensitivity> wanted = sensitivityOf(document().study());
    ASSERT_TRUE(wanted);
    const auto parameter = std::find(wanted->parameters.begin(), wanted->parameters.end(), "heater.R");
    ASSERT_NE(parameter, wanted->parameters.end());
    const auto p = parameter - wanted->parameters.begin();
    send("sensitivities heater.R");
    ASSERT_TRUE(QTest::qWaitFor([&] { return isShown(0); }, 20000)) << plots().strips().size();
    const ChartLine& line = plots().strips()[0]->chart()->lines()[0];
    EXPECT_EQ(line.data->unit.toStdString(), wanted->outputs[0].unit);
    ASSERT_EQ(line.data->values.size(), wanted->outputs[0].time.size());
    const std::size_t some = line.data->values.size() / 2;
    EXPECT_NEAR(line.data->values[some],
                wanted->outputs[0].slopes(static_cast<Eigen::Index>(some), p) * wanted->values[p], 1e-9);
    // a second one needs no further work, a change of the model asks anew
    const double before = line.data->values[some];
    send("sensitivities heater.alpha");
    ASSERT_TRUE(QTest::qWaitFor([&] { return isShown(1); }, 20000));
    document().setParameterValue("heater.R", 1.5 * wanted->values[p]);
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return plots().strips()[0]->chart()->lines()[0].data->values[some] != before; }, 20000));
    document().undoStack().undo();
    run(RunKind::Fit);
    ASSERT_TRUE(document().result());
    const Outcome<Sensitivity> fitted = sensitivityOf(document().result()->completed);
    ASSERT_TRUE(fitted);
    EXPECT_TRUE(QTest::qWaitFor(
        [&] {
            return std::abs(plots().strips()[0]->chart()->lines()[0].data->values[some] -
                            fitted->outputs[0].slopes(static_cast<Eigen::Index>(some), p) * fitted->values[p]) < 1e-9;
        },
        20000))
        << "at the fitted values";
}

TEST_F(ByHand, AxesAreZoomedMovedAndEmptiedByMouseAndStayInTheProject) {
    openSignals();
    const StudyExperiment& experiment = document().study().experiments.front();
    const QString recording = QString::fromStdString(experiment.name);
    const QString output = QString::fromStdString(experiment.outputs.begin()->second.column);
    send(recording + " " + output);
    send(recording + " T_exhaust");
    ASSERT_TRUE(QTest::qWaitFor([&] { return isShown(0) && isShown(1); }, 5000));
    SignalChart* chart = plots().strips()[0]->chart();
    const auto whole = plots().timeRange();
    const auto values = chart->valueRange();
    const QPointF at(chart->width() / 5.0, chart->height() / 2.0);
    for (int i = 0; i < 8; ++i) {
        QWheelEvent turn(at, chart->viewport()->mapToGlobal(at), {}, {0, 240}, Qt::NoButton, {}, Qt::NoScrollPhase,
                         false);
        QCoreApplication::sendEvent(chart->viewport(), &turn);
    }
    EXPECT_LT(plots().timeRange().second - plots().timeRange().first, 0.2 * (whole.second - whole.first));
    EXPECT_NE(chart->valueRange(), values) << "the values follow the part that is seen";
    QTest::mouseDClick(chart->viewport(), Qt::LeftButton, {}, at.toPoint());
    EXPECT_EQ(plots().timeRange(), whole);
    EXPECT_EQ(chart->valueRange(), values);
    for (const int x : {chart->width() / 3, chart->width() / 2})
        QTest::mouseClick(chart->viewport(), Qt::LeftButton, Qt::ControlModifier, {x, chart->height() / 2});
    for (const SignalStrip* strip : plots().strips())
        for (const char* figure : {"Δ", "mean", "rms"})
            EXPECT_TRUE(strip->legendText().contains(QString::fromUtf8(figure))) << strip->legendText().toStdString();

    clickButton(plots().strips()[0], "strip-down");
    EXPECT_EQ(plots().layout().axes[1].traces[0].name, output);
    activate();
    QTest::keyClick(&window, Qt::Key_S, Qt::ControlModifier);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document().isModified(); }, 20000));
    {
        MainWindow later;
        later.open(document().path());
        ASSERT_TRUE(QTest::qWaitFor([&] { return later.document().isOpen(); }, 20000));
        EXPECT_EQ(later.findChild<PlotArea*>()->layout(), plots().layout());
    }
    // × behind a name takes it out: wherever its letters are
    auto legends = plots().strips()[0]->findChildren<QLabel*>();
    const auto legend = std::find_if(legends.begin(), legends.end(), [](QLabel* l) { return l->text().contains("×"); });
    ASSERT_NE(legend, legends.end());
    for (int x = (*legend)->width() - 2; x > 0 && plots().layout().axes.size() > 1; x -= 3)
        for (int y = 5; y < (*legend)->height() && plots().layout().axes.size() > 1; y += 8)
            QTest::mouseClick(*legend, Qt::LeftButton, {}, {x, y});
    ASSERT_EQ(plots().layout().axes.size(), 1u);
    EXPECT_EQ(plots().layout().axes[0].traces[0].name, output);
    clickButton(plots().strips()[0], "strip-close");
    EXPECT_TRUE(plots().layout().axes.empty());
}

TEST_F(ByHand, WhatIsShownIsExportedUnderTheNameThatIsTyped) {
    openLambda();
    QToolButton* button = nullptr;
    for (QToolButton* b : panel<PlotPanel>()->findChildren<QToolButton*>())
        if (b->text() == "Export …") button = b;
    ASSERT_TRUE(button && button->isVisible());
    QTest::mouseClick(button, Qt::LeftButton);
    auto* dialog = window.findChild<QFileDialog*>("export-dialog");
    ASSERT_TRUE(dialog);
    const QString file = directory.filePath("shown.csv");
    name(dialog, file);
    EXPECT_TRUE(QTest::qWaitFor([&] { return QFileInfo(file).size() > 1000; }, 10000));
}

/// The same channel of two recordings whose clocks differ.
TEST_F(ByHand, RecordingsAreLaidOverEachOtherWithAShiftThatIsTyped) {
    openLambda();
    QTreeWidgetItem* row =
        panel<MeasurementPanel>()->signalItem(QString::fromStdString(document().study().experiments[0].name), "i_mod");
    ASSERT_TRUE(row);
    chooseOf(row, "Compare with other recordings");
    auto* page = panel<ComparePage>();
    ASSERT_TRUE(page && page->isVisible());
    ASSERT_TRUE(QTest::qWaitFor([&] { return page->plot()->lines().size() == 2; }, 20000));
    typeInCell(page->table(), 1, 1, "0,25");
    EXPECT_NEAR(page->plot()->lines().at(1).shift, 0.25, 1e-12);
    auto* set = qobject_cast<QPushButton*>(page->table()->cellWidget(1, 4));
    ASSERT_TRUE(set && set->isVisible() && set->isEnabled());
    QTest::mouseClick(set, Qt::LeftButton);
    EXPECT_EQ(document().study().experiments[1].outputs.at("i_mod").clock, 0.25);
}

// ---- files ----

/// What the dialog lists is read: an .mf4 was listed and refused.
TEST_F(ByHand, AFileOfMdfIsTakenFromTheDialogThatListsIt) {
    openLambda();
    const QString file = directory.filePath("p.mf4");
    test::Mdf4Writer writer;
    test::Bytes data;
    for (int i = 0; i < 5; ++i) data.put(0.5 * i).put(10.0 + i);
    const std::uint64_t group =
        writer.simple("", {{"time", "s", 2}, {"p", "Pa", 0, 4, 64, 8}}, 5, 16, writer.block("DT", {}, data.text));
    writer.finish(group, file.toStdString());
    activate();
    QTest::keyClick(&window, Qt::Key_I, Qt::ControlModifier);
    auto* dialog = window.findChild<QFileDialog*>("import-dialog");
    ASSERT_TRUE(dialog);
    EXPECT_TRUE(dialog->nameFilters().front().contains("*.mf4"));
    name(dialog, file);
    auto* accept = panel<ImportPanel>()->acceptButton();
    ASSERT_TRUE(QTest::qWaitFor([&] { return accept->isEnabled() && accept->isVisible(); }, 20000));
    QTest::mouseClick(accept, Qt::LeftButton);
    EXPECT_EQ(document().study().experiments.back().name, "p");
}

TEST_F(ByHand, AStudyThatCannotBeWrittenSaysSoAndAsksForAnotherPlaceInTheLastFolder) {
    openLambda();
    QDir(directory.path()).mkpath("last");
    activate();
    QTest::keyClick(&window, Qt::Key_I, Qt::ControlModifier);
    auto* import = window.findChild<QFileDialog*>("import-dialog");
    ASSERT_TRUE(import);
    ASSERT_TRUE(QFile::copy(example("train.csv"), directory.filePath("last/run.csv")));
    name(import, directory.filePath("last/run.csv"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return panel<ImportPanel>()->acceptButton()->isEnabled(); }, 20000));
    document().setParameterValue("heater.R", 2.75);
    ASSERT_TRUE(document().isModified());
    QFile::setPermissions(document().path(), QFile::ReadOwner);
    const bool isRoot = getuid() == 0;  // who may write everything: whether one may is asked of the real user
    if (isRoot) {
        ASSERT_EQ(setreuid(65534, 0), 0);
    }
    activate();
    QTest::keyClick(&window, Qt::Key_S, Qt::ControlModifier);
    if (isRoot) {
        ASSERT_EQ(setreuid(0, 0), 0);
    }
    auto* dialog = window.findChild<QFileDialog*>("save-dialog");
    ASSERT_TRUE(dialog && dialog->isVisible());
    if (!isRoot) {  // the other user may not look into the folder
        EXPECT_EQ(dialog->directory().absolutePath(), directory.filePath("last"));
    }
    EXPECT_TRUE(window.statusBar()->currentMessage().startsWith("lambda.analogon cannot be written"))
        << qPrintable(window.statusBar()->currentMessage());
    dialog->close();
    document().undoStack().setClean();
}

// ---- knobs ----

TEST_F(ByHand, AKnobIsDraggedAndTheTracesFollow) {
    openLambda();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document().facts().parameters.empty(); }, 20000));
    auto* parameters = panel<ParameterPanel>();
    raise({"parameters"});
    QTableView* table = parameters->table();
    const QModelIndex row = table->model()->index(parameters->model()->rowOf("heater.R"), 0);
    table->scrollTo(row);
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(row).center() + QPoint(20, 0));
    QSlider* slider = parameters->knob()->slider();
    ASSERT_TRUE(QTest::qWaitFor([&] { return slider->isVisible(); }, 2000));
    const int steps = document().undoStack().count();
    const double before = *document().parameterValue("heater.R");
    QStyleOptionSlider option;
    option.initFrom(slider);
    option.minimum = slider->minimum();
    option.maximum = slider->maximum();
    option.sliderPosition = option.sliderValue = slider->value();
    option.orientation = Qt::Horizontal;
    option.subControls = QStyle::SC_All;
    const QPoint handle =
        slider->style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, slider).center();
    QTest::mousePress(slider, Qt::LeftButton, {}, handle);
    ASSERT_TRUE(slider->isSliderDown()) << "the handle is where the style says";
    QTest::mouseMove(slider, handle + QPoint(20, 0));
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().preview() != nullptr; }, 5000));
    const double first = document().preview()->traces.errorPercent;
    QTest::mouseMove(slider, handle + QPoint(45, 0));
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().preview()->traces.errorPercent != first; }, 5000));
    EXPECT_TRUE(panel<PlotPanel>()->plots()[0]->legendText(TraceRole::After).contains("%")) << "the error is told";
    EXPECT_EQ(*document().parameterValue("heater.R"), before) << "while it is held";
    QTest::mouseRelease(slider, Qt::LeftButton, {}, handle + QPoint(45, 0));
    EXPECT_EQ(document().undoStack().count(), steps + 1) << "one step of undo";
    EXPECT_TRUE(QTest::qWaitFor([&] { return *document().parameterValue("heater.R") > before; }, 5000));
    activate();
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(QTest::qWaitFor([&] { return *document().parameterValue("heater.R") == before; }, 5000));
}

// ---- simulation without data ----

TEST_F(ByHand, EverySourceDrivesAModelThatIsDrawn) {
    for (const char* source : {"Step", "Ramp", "Sine", "Pulse", "Trapezoid", "Chirp", "TimeTable"}) {
        document().undoStack().setClean();
        window.startNew();
        QTest::qWait(100);
        place(("Analogon.Sources." + std::string(source)).c_str(), {-50, 10});
        place("Analogon.Interfaces.RealOutput", {50, 10});
        ASSERT_EQ(document().diagram().blocks.size(), 2u) << source;
        wire((document().diagram().blocks[0].name + ".y").c_str(), "y");
        ASSERT_TRUE(QTest::qWaitFor([&] { return document().facts().outputs.size() == 1; }, 10000)) << source;
        activate();
        QTest::keyClick(&window, Qt::Key_5, Qt::ControlModifier);  // the runs
        auto* const stop = window.findChild<QLineEdit*>("stop-time");
        ASSERT_TRUE(stop && stop->isVisible());
        type(stop, "5");
        QTest::keyClick(stop, Qt::Key_Return);
        simulate();
        ASSERT_TRUE(document().after()) << source;
        const Eigen::VectorXd& y = document().after()->experiments.front().outputs.front().simulated;
        EXPECT_GT(y.cwiseAbs().maxCoeff(), 0) << source;
    }
    document().undoStack().setClean();
}

TEST_F(ByHand, ARecordedChannelBecomesASource) {
    openLambda();
    QTreeWidgetItem* row =
        panel<MeasurementPanel>()->signalItem(QString::fromStdString(document().study().experiments[0].name), "T_amb");
    ASSERT_TRUE(row);
    const std::size_t blocks = document().diagram().blocks.size();
    const int steps = document().undoStack().count();
    chooseOf(row, "Put into the model as a source");
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().diagram().blocks.size() == blocks + 1; }, 10000));
    EXPECT_EQ(document().undoStack().count(), steps + 1) << "one step";
    const Block* made = nullptr;
    for (const Block& block : document().diagram().blocks)
        if (block.className == "Analogon.Sources.TimeTable") made = &block;
    ASSERT_TRUE(made);
    EXPECT_EQ(panel<DiagramScene>()->selectedBlock().toStdString(), made->name);
    // what it says is what was recorded, in the unit of the model
    const std::string name = made->name;
    const auto isKnown = [&] {
        return !unitOf(document().facts().variables, name + ".t[1]").empty() ||
               std::any_of(document().facts().variables.begin(), document().facts().variables.end(),
                           [&](const SignalFact& fact) { return fact.name == name + ".y"; });
    };
    ASSERT_TRUE(QTest::qWaitFor(isKnown, 10000))
        << (document().messages().empty() ? "" : format(document().messages().front().diagnostic));
    raise({"signals", "plots"});
    send(QString::fromStdString(name + ".y"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return isShown(0); }, 20000))
        << (plots().strips().empty() ? "no axis" : plots().strips()[0]->legendText().toStdString());
    const SignalData& repeated = *plots().strips()[0]->chart()->lines()[0].data;
    const StudyExperiment& experiment = document().study().experiments[0];
    const auto table = fileTable(document().study().tables, experiment);
    const Column* column = table->find(experiment.inputs.at("T_amb").column);
    ASSERT_TRUE(column);
    const auto [low, high] = std::minmax_element(column->values.begin(), column->values.end());
    const std::size_t some = repeated.values.size() / 3;
    const double shift = column->unit == "degC" ? 273.15 : 0;
    EXPECT_NEAR(repeated.values[some] - shift, column->values[some], 0.011 * (*high - *low));
    document().undoStack().setClean();
}

TEST_F(ByHand, ASimulationBecomesAMeasurementWithNoise) {
    newStudy();
    place("Analogon.Sources.Ramp", {-50, 10});
    place("Analogon.Interfaces.RealOutput", {50, 10});
    wire("ramp.y", "y");
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().facts().outputs.size() == 1; }, 10000));
    simulate();
    chooseInMenu("Run", "Record as measurement …");
    auto* dialog = window.findChild<PracticeDialog*>();
    ASSERT_TRUE(dialog && dialog->isVisible());
    type(dialog->sampleTimeField(), "0,002");
    type(dialog->fileField(), directory.filePath("made.csv"));
    typeInCell(dialog->noiseTable(), 0, 1, "0.05");
    ASSERT_TRUE(dialog->recordButton()->isEnabled()) << dialog->faultLabel()->text().toStdString();
    QTest::mouseClick(dialog->recordButton(), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().study().experiments.size() == 1; }, 20000));
    EXPECT_TRUE(document().study().experiments.front().outputs.contains("y"));
    EXPECT_GT(QFileInfo(directory.filePath("made.csv")).size(), 1000);
    document().undoStack().setClean();
}

// ---- text and diagram ----

TEST_F(ByHand, AFaultThatIsTypedIsUnderlinedAndGoesWithUndo) {
    openLambda();
    activate();
    showText();
    auto* text = panel<TextView>();
    const auto underlined = [&] {
        QStringList words;
        for (const QTextEdit::ExtraSelection& s : text->extraSelections())
            if (s.format.underlineStyle() == QTextCharFormat::WaveUnderline) words << s.cursor.selectedText();
        return words.join(' ');
    };
    QTest::mouseClick(text->viewport(), Qt::LeftButton);
    QTest::keyClick(text, Qt::Key_F, Qt::ControlModifier);
    QTest::keyClicks(text->findBar()->field(), "equation");
    QTest::keyClick(text->findBar()->field(), Qt::Key_Escape);
    QTest::keyClick(text, Qt::Key_End);
    QTest::keyClicks(text, " nosuchname = 1;");
    QTest::keyClick(text, Qt::Key_Escape);
    ASSERT_TRUE(QTest::qWaitFor([&] { return underlined().contains("nosuchname"); }, 10000));
    while (document().undoStack().canUndo()) {
        QTest::keyClick(text, Qt::Key_Z, Qt::ControlModifier);
        QTest::qWait(20);
    }
    EXPECT_TRUE(QTest::qWaitFor([&] { return underlined().isEmpty(); }, 10000));
}

TEST_F(ByHand, BlocksAreAlignedAndSpreadFromTheMenu) {
    newStudy();
    for (const Point at : {Point{-60, 20}, Point{-30, 0}, Point{60, -40}}) place("Analogon.Thermal.HeatCapacitor", at);
    ASSERT_EQ(document().diagram().blocks.size(), 3u);
    const auto lefts = [&] {
        std::vector<double> xs;
        for (const Block& block : document().diagram().blocks) xs.push_back(boxOf(block.placement).first.x);
        return xs;
    };
    dragOnDiagram(pixel({-95, 80}), pixel({95, -90}));  // rubber band over all
    const auto chooseInEdit = [&](const QString& text) {
        for (QAction* entry : window.menuBar()->actions()) {
            if (entry->text().remove('&') != "Edit") continue;
            for (QAction* inner : entry->menu()->actions()) {
                if (!inner->menu()) continue;
                const QList<QAction*> actions = inner->menu()->actions();
                if (std::none_of(actions.begin(), actions.end(), [&](QAction* a) { return a->text() == text; }))
                    continue;
                QTest::mouseClick(window.menuBar(), Qt::LeftButton, {},
                                  window.menuBar()->actionGeometry(entry).center());
                QTest::mouseClick(entry->menu(), Qt::LeftButton, {}, entry->menu()->actionGeometry(inner).center());
                return chooseIn(inner->menu(), text);
            }
        }
        chooseInMenu("Edit", text);
    };
    chooseInEdit("Equal gaps in a row");
    const std::vector<double> spread = lefts();
    EXPECT_NEAR(spread[1] - spread[0], spread[2] - spread[1], 1);
    chooseInEdit("Align left");
    EXPECT_EQ(lefts(), std::vector<double>(3, lefts().front()));
    document().undoStack().setClean();
}

}  // namespace
}  // namespace analogon::ui
