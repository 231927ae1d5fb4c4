#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>
#include <QPushButton>
#include <QSettings>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QTreeWidget>
#include <QWheelEvent>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <utility>

#include "core/study/validate.hpp"
#include "core/syntax/parser.hpp"
#include "tests/working_time.hpp"
#include "ui/canvas/block_item.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/document/document.hpp"
#include "ui/effect/result_panel.hpp"
#include "ui/fit/error_curve.hpp"
#include "ui/fit/run_bar.hpp"
#include "ui/fit/run_controller.hpp"
#include "ui/inspector/parameter_model.hpp"
#include "ui/inspector/parameter_panel.hpp"
#include "ui/measurement/measurement_panel.hpp"
#include "ui/messages/message_panel.hpp"
#include "ui/plot/plot_panel.hpp"
#include "ui/style/style.hpp"
#include "ui/text/text_view.hpp"
#include "ui/window/main_window.hpp"
#include "ui/window/start_page.hpp"

namespace analogon::ui {
namespace {

namespace fs = std::filesystem;

// A body that is heated by a known power and loses heat to the ambient through a conductor: G (T - T_amb).
const char* const heatedBody = R"(model HeatedBody "A body that is heated and cools through its mount"
  Analogon.Interfaces.RealInput power(unit="W") annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Analogon.Interfaces.RealOutput T(unit="K") annotation (Placement(transformation(extent={{90,30},{110,50}})));
  Analogon.Sources.PrescribedHeatFlow heater annotation (Placement(transformation(extent={{-70,-10},{-50,10}})));
  Analogon.Thermal.HeatCapacitor body(C=20, T_start=293.15) annotation (Placement(transformation(extent={{-20,0},{0,20}})));
  Analogon.Thermal.ThermalConductor mount(G=0.05) annotation (Placement(transformation(extent={{20,-10},{40,10}})));
  Analogon.Sources.FixedTemperature ambient(T=293.15) annotation (Placement(transformation(extent={{80,-10},{60,10}})));
  Analogon.Sensors.TemperatureSensor sensor annotation (Placement(transformation(extent={{20,30},{40,50}})));
  // the wires
equation
  connect(power, heater.Q_flow) annotation (Line(points={{-90,0},{-70,0}}, color={0,0,127}));
  connect(heater.port, body.port) annotation (Line(points={{-50,0},{-10,0}}, color={191,0,0}));
  connect(body.port, mount.port_a) annotation (Line(points={{-10,0},{20,0}}, color={191,0,0}));
  connect(mount.port_b, ambient.port) annotation (Line(points={{40,0},{60,0}}, color={191,0,0}));
  connect(body.port, sensor.port) annotation (Line(points={{-10,0},{10,0},{10,40},{20,40}}, color={191,0,0}));
  connect(sensor.T, T) annotation (Line(points={{40,40},{90,40}}, color={0,0,127}));
end HeatedBody;
)";

const char* const studyJsonText = R"({
  "format": "analogon-study-1",
  "class": "HeatedBody",
  "experiments": [
    {"name": "heating", "role": "fit", "file": "train.csv", "time": "t",
     "inputs": {"power": "P"}, "outputs": {"T": "T_body"}},
    {"name": "cycle", "role": "validate", "file": "check.csv", "time": "t",
     "inputs": {"power": "P"}, "outputs": {"T": "T_body"}}
  ],
  "parameters": {
    "body.C": {"fit": true, "min": 1, "max": 500},
    "mount.G": {"fit": true, "min": 0.001, "max": 5}
  }
})";

/// Integrates C T' = P - G (T - T_amb) - k (T^4 - T_amb^4) with small Euler steps and adds noise of 0.05 K.
void writeRecording(const fs::path& file, double radiation, double period, unsigned seed) {
    constexpr double capacity = 30, conductance = 0.08, ambient = 293.15, step = 2, end = 1200;
    std::mt19937 generator(seed);
    std::normal_distribution<double> noise(0, 0.05);
    std::ofstream stream(file);
    stream << "t [s],P [W],T_body [degC],unused [V]\n";
    const auto power = [period](double t) { return std::fmod(t, period) < 0.6 * period ? 60.0 : 0.0; };
    double temperature = ambient;
    for (int i = 0; i * step <= end; ++i) {
        const double t = i * step;
        stream << t << ',' << power(t) << ',' << temperature - 273.15 + noise(generator) << ",1\n";
        constexpr int substeps = 50;
        for (int k = 0; k < substeps; ++k) {
            const double between = power(t) + (power(t + step) - power(t)) * (k + 0.5) / substeps;
            const double loss =
                conductance * (temperature - ambient) + radiation * (std::pow(temperature, 4) - std::pow(ambient, 4));
            temperature += step / substeps * (between - loss) / capacity;
        }
    }
}

fs::path makeStudy(const std::string& name, double radiation, const std::string& model = heatedBody) {
    static const QTemporaryDir own;  // tests run side by side as processes of their own
    const fs::path directory = fs::path(own.path().toStdString()) / name;
    fs::remove_all(directory);
    fs::create_directories(directory);
    std::ofstream(directory / "study.json") << studyJsonText;
    std::ofstream(directory / "model.mo") << model;
    writeRecording(directory / "train.csv", radiation, 700, 1);
    writeRecording(directory / "check.csv", radiation, 330, 2);
    return directory;
}

/// Processes events until it holds; false after the time is up.
template <class Condition>
bool waitUntil(Condition condition, int milliseconds = 60000) {
    return QTest::qWaitFor(condition, milliseconds);
}

class Window : public testing::Test {
protected:
    void SetUp() override {
        window.resize(1440, 900);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    }
    ~Window() override { QTest::qWait(1); }

    Document& document() { return window.document(); }
    template <class T>
    T* panel() const {
        return window.findChild<T*>();
    }
    void open(const fs::path& study) {
        window.open(QString::fromStdString(study.string()));
        ASSERT_TRUE(waitUntil([&] { return !document().isReading(); }));
        ASSERT_TRUE(document().isOpen()) << (document().messages().empty()
                                                 ? ""
                                                 : document().messages().front().diagnostic.message);
        ASSERT_TRUE(waitUntil([&] { return !document().facts().parameters.empty(); }));
    }
    /// Clicks a button of the toolbar, as a user does.
    void clickTool(const char* action) {
        auto* bar = window.findChild<QToolBar*>("main");
        QWidget* button = bar->widgetForAction(window.findChild<QAction*>(action));
        ASSERT_TRUE(button && button->isEnabled()) << action;
        QTest::mouseClick(button, Qt::LeftButton);
    }
    void run(const char* action) {
        clickTool(action);
        ASSERT_TRUE(window.controller().isRunning());
        ASSERT_TRUE(waitUntil([&] { return !window.controller().isRunning(); }, 180000));
        QTest::qWait(20);  // panels follow in the next turn of the event loop
    }
    /// Presses the button that takes the result over.
    void adopt() {
        auto* button = panel<ResultPanel>()->findChild<QPushButton*>("adopt");
        ASSERT_TRUE(button && button->isEnabled());
        panel<ResultPanel>()->ensureWidgetVisible(button);
        QTest::mouseClick(button, Qt::LeftButton);
        QTest::qWait(20);
    }
    void grab(const std::string& name) {
        QTest::qWait(30);
        const QDir pictures(QStringLiteral(ANALOGON_PICTURES));
        pictures.mkpath(".");
        ASSERT_TRUE(window.grab().save(pictures.filePath(QString::fromStdString(name + ".png"))));
    }

    MainWindow window;
};

TEST(Examples, HaveEachAPictureOfItsOwn) {
    std::set<QString> icons;
    for (const Example& example : findExamples()) {
        EXPECT_TRUE(QFile::exists(":/icons/" + example.icon + ".svg")) << example.icon.toStdString();
        EXPECT_TRUE(icons.insert(example.icon).second) << example.icon.toStdString();
    }
    EXPECT_GE(icons.size(), 2u);
}

TEST_F(Window, OffersExamplesWhileNothingIsOpen) {
    EXPECT_FALSE(document().isOpen());
    auto* start = panel<StartPage>();
    ASSERT_TRUE(start && start->isVisible());
    EXPECT_FALSE(window.findChild<QAction*>("fit")->isEnabled());
    const auto examples = findExamples();
    ASSERT_FALSE(examples.empty());
    QAbstractButton* first = nullptr;
    for (QAbstractButton* b : start->findChildren<QAbstractButton*>())
        if (b->text() == examples.front().title) first = b;
    ASSERT_TRUE(first) << "each example is a button";
    grab("start-page");
    QTest::mouseClick(first, Qt::LeftButton);
    EXPECT_TRUE(waitUntil([&] { return document().isOpen(); }));
    EXPECT_FALSE(start->isVisible());
}

TEST_F(Window, ShowsWhyAStudyCannotBeRead) {
    window.open("/nowhere/at/all");
    ASSERT_TRUE(waitUntil([&] { return !document().isReading() && !document().messages().empty(); }));
    EXPECT_FALSE(document().isOpen());
    bool isTold = false;
    for (QLabel* label : panel<StartPage>()->findChildren<QLabel*>())
        isTold = isTold || (label->isVisible() && label->text().contains("/nowhere/at/all"));
    EXPECT_TRUE(isTold);
}

/// The same words as the command line, once each.
TEST_F(Window, SaysOfAStudyWhatEveryCommandSays) {
    const fs::path directory = makeStudy("remarked", 0);
    std::string json = studyJsonText;
    json.replace(json.find("\"min\": 0.001"), 12, "\"mni\": 3, \"min\": -1");
    std::ofstream(directory / "study.json") << json;
    const Outcome<Study> study = readStudy(directory);
    ASSERT_TRUE(study);
    Diagnostics wanted = study.diagnostics();
    const Outcome<ValidStudy> valid = validated(*study, Purpose::Simulate);
    wanted.insert(wanted.end(), valid.diagnostics().begin(), valid.diagnostics().end());
    ASSERT_EQ(wanted.size(), 2u) << format(wanted);

    ASSERT_NO_FATAL_FAILURE(open(directory));
    ASSERT_TRUE(waitUntil([&] { return document().before() != nullptr; }));
    auto* list = panel<MessagePanel>()->list();
    ASSERT_TRUE(waitUntil([&] { return list->count() == 2; })) << list->count();
    for (const Diagnostic& d : wanted)
        EXPECT_EQ(list->findItems(QString::fromStdString(d.message.english()), Qt::MatchContains).size(), 1)
            << d.message;
    // what is mended is told no more, a value outside the range is an error of the model
    StudyParameter mended = document().study().parameters.at("mount.G");
    mended.min = 0.001;
    document().setStudyParameter("mount.G", mended, "Mend");
    EXPECT_TRUE(waitUntil([&] { return list->count() == 1; }));
    document().typeText(document().modelText().replace("mount(G=", "mount(G=-"));
    EXPECT_TRUE(waitUntil([&] { return document().modelError() != nullptr; }));
    EXPECT_EQ(document().modelError()->message.english().find("the parameter 'mount.G' is -"), 0u);
}

TEST_F(Window, DrawsTheDiagramAndListsParametersAndChannels) {
    ASSERT_NO_FATAL_FAILURE(open(makeStudy("plain", 0)));
    auto* scene = panel<DiagramScene>();
    for (const char* name : {"power", "T", "heater", "body", "mount", "ambient", "sensor"})
        EXPECT_TRUE(scene->block(name)) << name;
    ParameterModel* parameters = panel<ParameterPanel>()->model();
    ASSERT_GE(parameters->rowOf("mount.G"), 0);
    const auto text = [&](const char* name, int column) {
        return parameters->index(parameters->rowOf(name), column).data().toString();
    };
    EXPECT_EQ(text("mount.G", ParameterModel::Value), "0.05");
    EXPECT_EQ(text("mount.G", ParameterModel::Unit), "W/K");
    EXPECT_EQ(text("mount.G", ParameterModel::Max), "5");
    QTreeWidget* tree = panel<MeasurementPanel>()->tree();
    ASSERT_EQ(tree->topLevelItemCount(), 2);
    EXPECT_EQ(tree->topLevelItem(0)->text(0), "heating");
    EXPECT_EQ(tree->topLevelItem(1)->text(1), "validate");
    EXPECT_FALSE(tree->findItems("T_body  [degC]", Qt::MatchExactly | Qt::MatchRecursive, 1).isEmpty());
    EXPECT_FALSE(tree->findItems("not used", Qt::MatchExactly | Qt::MatchRecursive, 0).isEmpty());

    // What was measured is shown at once; the model as it stands is simulated without being asked.
    ASSERT_TRUE(waitUntil([&] { return document().before() != nullptr; }));
    ASSERT_FALSE(panel<PlotPanel>()->plots().empty());
    EXPECT_TRUE(panel<PlotPanel>()->plots().front()->legendText(TraceRole::Before).startsWith("simulated"));
    grab("opened");
}

TEST_F(Window, FollowsTheBlockThatIsClicked) {
    ASSERT_NO_FATAL_FAILURE(open(makeStudy("plain", 0)));
    auto* scene = panel<DiagramScene>();
    auto* view = panel<DiagramView>();
    QTest::qWait(50);
    const QPoint at = view->mapFromScene(scene->block("mount")->body().center());
    QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, at);
    EXPECT_EQ(scene->selectedBlock(), "mount");
    ParameterModel* parameters = panel<ParameterPanel>()->model();
    EXPECT_EQ(parameters->rowCount(), 1);
    EXPECT_EQ(parameters->rowOf("mount.G"), 0);
    QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, QPoint(5, 5));
    EXPECT_TRUE(scene->selectedBlock().isEmpty());
    EXPECT_GT(parameters->rowCount(), 1);
}

TEST_F(Window, ZoomsAboutThePointerAndFitsAgainWithSpace) {
    ASSERT_NO_FATAL_FAILURE(open(makeStudy("plain", 0)));
    auto* view = panel<DiagramView>();
    QTest::qWait(50);
    const double fitted = view->zoom();
    const QPoint pointer(200, 120);
    const QPointF under = view->mapToScene(pointer);
    QWheelEvent wheel(pointer, view->viewport()->mapToGlobal(pointer), {}, QPoint(0, 240), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(view->viewport(), &wheel);
    EXPECT_GT(view->zoom(), 1.2 * fitted);
    EXPECT_NEAR(view->mapToScene(pointer).x(), under.x(), 1.5);
    view->setFocus();
    QTest::keyClick(view, Qt::Key_Space);
    EXPECT_NEAR(view->zoom(), fitted, 1e-6);
}

TEST_F(Window, EditsOfParametersAreEditsOfTheTextAndCanBeUndone) {
    ASSERT_NO_FATAL_FAILURE(open(makeStudy("plain", 0)));
    const QString original = document().modelText();
    QTableView* table = panel<ParameterPanel>()->table();
    ParameterModel* parameters = panel<ParameterPanel>()->model();
    const auto edit = [&](const char* name, int column, const char* typed) {
        const QModelIndex index = parameters->index(parameters->rowOf(name), column);
        table->setCurrentIndex(index);
        table->edit(index);
        // the one of this cell: that of the cell before goes in a later turn of the event loop
        QPointer<QLineEdit> editor = qobject_cast<QLineEdit*>(table->indexWidget(index));
        ASSERT_TRUE(editor) << name;
        editor->selectAll();
        QTest::keyClicks(editor, typed);
        QTest::keyClick(editor, Qt::Key_Return);
        ASSERT_TRUE(QTest::qWaitFor([&] { return !editor; }, 20000)) << name;
    };
    edit("mount.G", ParameterModel::Value, "0.125");
    EXPECT_TRUE(document().modelText().contains("mount(G=0.125)"));
    EXPECT_TRUE(document().modelText().contains("// the wires"));
    edit("mount.G", ParameterModel::Value, "nonsense");
    EXPECT_TRUE(document().modelText().contains("mount(G=0.125)")) << "what is no number changes nothing";
    edit("mount.G", ParameterModel::Max, "2");
    EXPECT_EQ(document().study().parameters.at("mount.G").max, 2.0);
    const QModelIndex check = parameters->index(parameters->rowOf("body.C"), ParameterModel::Name);
    EXPECT_TRUE(parameters->setData(check, Qt::Unchecked, Qt::CheckStateRole));
    EXPECT_FALSE(document().study().parameters.at("body.C").fit);
    EXPECT_TRUE(window.isWindowModified());

    for (int i = 0; i < 3; ++i) QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(document().modelText(), original) << "byte for byte";
    EXPECT_EQ(document().study().parameters.at("mount.G").max, 5.0);
    EXPECT_TRUE(document().study().parameters.at("body.C").fit);
    EXPECT_FALSE(window.isWindowModified());
}

TEST_F(Window, AResultThatArrivesDoesNotTakeBackWhatIsBeingTyped) {
    ASSERT_NO_FATAL_FAILURE(open(makeStudy("typed", 0)));
    ASSERT_TRUE(waitUntil([&] { return document().before() != nullptr; }));
    QTableView* table = panel<ParameterPanel>()->table();
    ParameterModel* parameters = panel<ParameterPanel>()->model();
    const QModelIndex index = parameters->index(parameters->rowOf("mount.G"), ParameterModel::Value);
    table->setCurrentIndex(index);
    table->edit(index);
    auto* editor = table->findChild<QLineEdit*>();
    ASSERT_TRUE(editor);
    editor->selectAll();
    QTest::keyClicks(editor, "0.12");
    Q_EMIT parameters->dataChanged(parameters->index(0, 0), parameters->index(parameters->rowCount() - 1, 0));
    Q_EMIT parameters->dataChanged(index, index);
    EXPECT_EQ(editor->text(), "0.12");
    QTest::keyClicks(editor, "5");
    QTest::keyClick(editor, Qt::Key_Return);
    EXPECT_TRUE(waitUntil([&] { return document().modelText().contains("mount(G=0.125)"); }));
}

TEST_F(Window, FitsFromTheToolbarAndShowsErrorsAndStandardErrors) {
    ASSERT_NO_FATAL_FAILURE(open(makeStudy("plain", 0)));
    ASSERT_TRUE(waitUntil([&] { return document().before() != nullptr; }));
    const double errorBefore = document().before()->experiments.front().errorPercent;
    run("fit");
    ASSERT_TRUE(document().after()) << (document().messages().empty()
                                            ? ""
                                            : document().messages().front().diagnostic.message);
    EXPECT_LT(document().after()->experiments.front().errorPercent, 0.3 * errorBefore);
    ParameterModel* parameters = panel<ParameterPanel>()->model();
    const QString result = parameters->index(parameters->rowOf("mount.G"), ParameterModel::Result).data().toString();
    EXPECT_TRUE(result.contains("±")) << result.toStdString();
    EXPECT_NEAR(result.section(' ', 0, 0).toDouble(), 0.08, 0.004);
    const OutputPlot& plot = *panel<PlotPanel>()->plots().front();
    EXPECT_TRUE(plot.legendText(TraceRole::Before).startsWith("before"));
    EXPECT_TRUE(plot.legendText(TraceRole::After).startsWith("after"));
    EXPECT_TRUE(plot.legendText(TraceRole::After).endsWith("%"));
    grab("fitted");
}

TEST_F(Window, FindsTheMissingEffectAndShowsItOnTheDiagram) {
    ASSERT_NO_FATAL_FAILURE(open(makeStudy("radiating", 3e-9)));
    const QString original = document().modelText();
    run("discover");
    ASSERT_TRUE(document().finding()) << (document().messages().empty()
                                              ? ""
                                              : document().messages().front().diagnostic.message);
    ASSERT_FALSE(document().finding()->effects.empty());
    const AddedEffect& effect = document().finding()->effects.front();
    EXPECT_EQ(effect.kind, "thermal.radiation");
    EXPECT_EQ(document().modelText(), original) << "nothing is added before the user says so";
    grab("found");
    adopt();
    BlockItem* item = panel<DiagramScene>()->block(effect.wired.instance);
    ASSERT_TRUE(item) << "the effect is a block of the diagram";
    EXPECT_TRUE(item->isMarked());
    EXPECT_TRUE(document().modelText().contains(QString::fromStdString(effect.className)));
    EXPECT_TRUE(panel<ResultPanel>()->headline().contains(QString::fromStdString(effect.at)));
    ASSERT_TRUE(panel<ResultPanel>()->candidates());
    EXPECT_FALSE(panel<ResultPanel>()->candidates()->findItems("chosen", Qt::MatchExactly, 4).isEmpty());
    ASSERT_TRUE(panel<ResultPanel>()->comparison());
    EXPECT_EQ(panel<ResultPanel>()->comparison()->topLevelItemCount(), 2);
    grab("discovered");

    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(document().modelText(), original) << "taken back byte for byte";
    EXPECT_FALSE(panel<DiagramScene>()->block(effect.wired.instance));
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_TRUE(panel<DiagramScene>()->block(effect.wired.instance));
}

TEST_F(Window, StaysAliveWhileItSearches) {
    ASSERT_NO_FATAL_FAILURE(open(makeStudy("radiating", 3e-9)));
    double longest = 0, last = test::ownMilliseconds();
    QTimer heartbeat;
    QObject::connect(&heartbeat, &QTimer::timeout, [&] {
        const double now = test::ownMilliseconds();
        longest = std::max(longest, now - std::exchange(last, now));
    });
    heartbeat.start(5);
    run("discover");
    heartbeat.stop();
    EXPECT_LT(longest, 400) << "[ms]; 50 on a machine that does nothing else";
    RecordProperty("longest_gap_ms", static_cast<int>(longest));
    std::cout << "longest gap: " << longest << " ms\n";
}

TEST_F(Window, ShowsTheBestTracesSoFarWhileAFitRuns) {
    ASSERT_NO_FATAL_FAILURE(open(makeStudy("watched", 3e-9)));
    FitOptions& options = window.controller().options().discover.fit;
    options.method = FitMethod::NelderMead;
    options.starts = 2000;  // longer than anyone waits
    double longest = 0, last = test::ownMilliseconds();
    QTimer heartbeat;
    QObject::connect(&heartbeat, &QTimer::timeout, [&] {
        const double now = test::ownMilliseconds();
        longest = std::max(longest, now - std::exchange(last, now));
    });
    heartbeat.start(5);
    clickTool("fit");
    auto* plots = panel<PlotPanel>();
    ASSERT_TRUE(waitUntil([&] { return document().liveTraces() != nullptr && !plots->plots().empty(); }, 20000));
    heartbeat.stop();
    const SimulatedTraces* live = document().liveTraces();
    ASSERT_EQ(live->experiments.size(), 1u) << "what validates is not simulated for this";
    const OutputPlot* plot = plots->plots().front();
    EXPECT_EQ(plot->content().after, live->experiments.front().outputs.front().values);
    EXPECT_TRUE(plot->legendText(TraceRole::After).startsWith("best so far"))
        << plot->legendText(TraceRole::After).toStdString();
    EXPECT_FALSE(panel<ErrorCurve>()->points().empty());
    EXPECT_TRUE(window.controller().isRunning());
    grab("live");

    QTest::mouseClick(panel<RunBar>()->cancelButton(), Qt::LeftButton);
    ASSERT_TRUE(waitUntil([&] { return !window.controller().isRunning(); }, 10000));
    QTest::qWait(400);
    EXPECT_EQ(document().liveTraces(), nullptr);
    ASSERT_TRUE(document().finding()) << "the best so far is kept";
    EXPECT_TRUE(plots->plots().front()->legendText(TraceRole::After).startsWith("after"));
    std::cout << "longest gap while a fit is watched: " << longest << " ms\n";
    EXPECT_LT(longest, 400) << "[ms]; 50 on a machine that does nothing else";
}

TEST_F(Window, CancelStopsTheSearchSoonAndKeepsTheStudy) {
    ASSERT_NO_FATAL_FAILURE(open(makeStudy("radiating", 3e-9)));
    const QString original = document().modelText();
    clickTool("discover");
    ASSERT_TRUE(window.controller().isRunning());
    QToolButton* cancel = panel<RunBar>()->cancelButton();
    ASSERT_TRUE(waitUntil([&] { return cancel->isVisible(); }, 2000));
    QTest::qWait(100);
    grab("running");
    QElapsedTimer timer;
    timer.start();
    QTest::mouseClick(cancel, Qt::LeftButton);
    ASSERT_TRUE(waitUntil([&] { return !window.controller().isRunning(); }, 10000));
    EXPECT_LT(timer.elapsed(), 2000);
    EXPECT_EQ(document().modelText(), original) << "what was found so far is shown, not taken over";
    EXPECT_TRUE(window.findChild<QAction*>("discover")->isEnabled());
}

/// A chain that takes its time: many states, a long record.
fs::path makeSlowStudy() {
    const fs::path directory = makeStudy("slow", 0, R"(model HeatedBody
  parameter Real k = 0.001;
  input Real power(unit="W");
  output Real T(unit="K") = 293.15 + x[1];
  Real x[120](each start=0, each fixed=true);
equation
  for i in 1:119 loop
    der(x[i]) = sin(x[i + 1]) - x[i]^3 + k*power;
  end for;
  der(x[120]) = cos(x[1]) - x[120];
end HeatedBody;
)");
    std::ofstream(directory / "study.json") << R"({"format": "analogon-study-1", "class": "HeatedBody",
  "experiments": [{"name": "heating", "role": "fit", "file": "train.csv", "time": "t",
                   "inputs": {"power": "P"}, "outputs": {"T": "T_body"}}]})";
    std::ofstream stream(directory / "train.csv");
    stream << "t [s],P [W],T_body [K]\n";
    for (int k = 0; k < 300000; ++k) stream << 0.01 * k << ',' << 10 + (k / 700) % 3 << ',' << 293 + k % 7 << '\n';
    return directory;
}

TEST_F(Window, ShowsWhatWasMeasuredAtOnceAndALongSimulationWithProgressAndCancel) {
    std::vector<double> fractions;
    QObject::connect(&window.controller(), &RunController::progressed, [&](const Progress::Report& report) {
        if (report.stage == "simulate") fractions.push_back(report.fraction);
    });
    ASSERT_NO_FATAL_FAILURE(open(makeSlowStudy()));
    ASSERT_TRUE(waitUntil([&] { return document().measured() || document().before(); }));
    ASSERT_TRUE(document().measured()) << "before anything is simulated";
    QTest::qWait(20);
    auto* plots = panel<PlotPanel>();
    ASSERT_EQ(plots->plots().size(), 1u);
    EXPECT_EQ(plots->plots().front()->content().measured.size(), 300000u);
    EXPECT_TRUE(plots->plots().front()->content().before.empty());

    QToolButton* cancel = panel<RunBar>()->cancelButton();
    ASSERT_TRUE(waitUntil([&] { return cancel->isVisible(); }, 20000));
    EXPECT_FALSE(window.controller().isRunning()) << "nobody has started a run";
    ASSERT_TRUE(waitUntil([&] { return !fractions.empty() && fractions.back() > 0; }, 20000));
    QElapsedTimer timer;
    timer.start();
    QTest::mouseClick(cancel, Qt::LeftButton);
    ASSERT_TRUE(waitUntil([&] { return window.controller().shownJob() == nullptr; }, 10000));
    EXPECT_LT(timer.elapsed(), 2000);
    EXPECT_TRUE(document().measured());
    EXPECT_FALSE(document().before()) << "half a simulation is none";
    EXPECT_FALSE(cancel->isVisible());
}

TEST_F(Window, DropsTheResultOfAStudyThatWasChangedDuringTheRun) {
    ASSERT_NO_FATAL_FAILURE(open(makeStudy("radiating", 3e-9)));
    clickTool("discover");
    StudyParameter changed = document().study().parameters.at("mount.G");
    changed.max = 3;
    document().setStudyParameter("mount.G", changed, "Set the bound");
    ASSERT_TRUE(waitUntil([&] { return !window.controller().isRunning(); }, 180000));
    EXPECT_EQ(document().finding(), nullptr);
}

TEST_F(Window, LeadsFromAMessageToItsPlaceInTheText) {
    std::string broken = heatedBody;
    broken.replace(broken.find("mount(G="), 8, "mount(Gg=");
    window.open(QString::fromStdString(makeStudy("broken", 0, broken).string()));
    QListWidget* list = panel<MessagePanel>()->list();
    ASSERT_TRUE(waitUntil([&] { return document().isOpen() && list->count() > 0; }));
    EXPECT_TRUE(list->item(0)->text().contains("Gg")) << list->item(0)->text().toStdString();
    grab("broken-model");
    const QRect item = list->visualItemRect(list->item(0));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, item.center());
    auto* text = panel<TextView>();
    EXPECT_TRUE(text->isVisible());
    EXPECT_EQ(text->textCursor().blockNumber() + 1, document().messages().front().diagnostic.place.line);
}

TEST_F(Window, ShowsEverythingInTheDarkThemeToo) {
    style::apply(*qApp, style::Theme::Dark);
    ASSERT_NO_FATAL_FAILURE(open(makeStudy("radiating", 3e-9)));
    run("discover");
    adopt();
    grab("discovered-dark");
    const QImage picture = window.grab().toImage();
    // Neither the diagram nor the traces keep a white sheet.
    const auto at = [&](QWidget* w) { return picture.pixelColor(w->mapTo(&window, QPoint(4, w->height() - 4))); };
    EXPECT_LT(at(panel<DiagramView>()->viewport()).lightness(), 60);
    EXPECT_LT(at(panel<PlotPanel>()->plots().front()->values()).lightness(), 60);
    style::apply(*qApp, style::Theme::Light);
}

}  // namespace
}  // namespace analogon::ui
