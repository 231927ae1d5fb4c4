#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QLineSeries>
#include <QPainter>
#include <QSignalSpy>
#include <QToolButton>
#include <QTreeView>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/study/recorded.hpp"
#include "tests/ui/panels_fixture.hpp"
#include "tests/working_time.hpp"
#include "ui/measurement/course_plot.hpp"
#include "ui/plot/time_plot.hpp"
#include "ui/signals/figure_chart.hpp"
#include "ui/signals/plot_area.hpp"
#include "ui/signals/signal_browser.hpp"
#include "ui/signals/signal_strip.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {
namespace {

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

TEST(SignalModel, SearchesTwentyThousandSignalsInLessThanFiftyMilliseconds) {
    std::vector<Signal> all;
    for (int i = 0; i < 20000; ++i) {
        const QString group = QStringLiteral("drive.stage%1").arg(i / 20),
                      name = group + QStringLiteral(".phi%1").arg(i);
        all.push_back({{SignalKind::Variable, {}, name}, group, "rad", "angle", (name + " rad angle").toLower()});
    }
    SignalModel model;
    QTreeView tree;
    tree.setUniformRowHeights(true);
    tree.setModel(&model);
    tree.show();
    model.setSignals(std::move(all));
    std::vector<double> taken;
    for (const char* query : {"p", "ph", "phi", "phi1", "Stage77 phi", "nothing", "", "rad 199"}) {
        QElapsedTimer clock;
        clock.start();
        model.search(query);
        if (model.matches() < 300) tree.expandAll();  // as the browser does
        QCoreApplication::processEvents();
        taken.push_back(static_cast<double>(clock.nsecsElapsed()) / 1e6);
    }
    EXPECT_LT(median(taken), 50);
    RecordProperty("milliseconds", std::to_string(median(taken)));
    model.search("rad STAGE77.phi1540");
    EXPECT_EQ(model.matches(), 1);
    EXPECT_EQ(model.signalAt(model.index(0, 0, model.index(0, 0)))->reference.name, "drive.stage77.phi1540");
}

std::shared_ptr<const SignalData> signal(std::vector<double> time, std::vector<double> values) {
    return std::make_shared<const SignalData>(
        SignalData{std::make_shared<const std::vector<double>>(std::move(time)), Series(std::move(values)), "V", {}});
}

std::shared_ptr<const SignalData> noise(std::size_t samples, double scale) {
    std::vector<double> time(samples), values(samples);
    unsigned state = 1;
    for (std::size_t i = 0; i < samples; ++i) {
        state = state * 1664525u + 1013904223u;
        time[i] = 1e-3 * static_cast<double>(i);
        values[i] = scale * (std::sin(1e-2 * time[i]) + 0.1 * (state >> 8) / double(1 << 24));
    }
    return signal(std::move(time), std::move(values));
}

TEST(SignalChart, DrawsTwoTracesOfAMillionSamplesAnewInLessThanSixteenMilliseconds) {
    SignalChart chart;
    chart.resize(1200, 300);
    chart.setLines({{{SignalKind::Recorded, "a", "one"}, Qt::blue, noise(1'000'000, 1)},
                    {{SignalKind::Recorded, "a", "two"}, Qt::red, noise(1'000'000, 0.5)}});
    chart.setTimeRange(0, 1000);
    chart.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&chart));
    QImage picture(chart.size(), QImage::Format_ARGB32_Premultiplied);
    int step = 0;
    const double repaint = test::leastMilliseconds(25, [&] {
        chart.setTimeRange(step, 1000 - 10 * step);
        ++step;
        QPainter painter(&picture);
        chart.render(&painter);
    });
    RecordProperty("milliseconds", std::to_string(repaint));
    std::cout << "repaint " << repaint << " ms\n";
    EXPECT_LE(chart.pointsDrawn(), 4 * 1200);
    EXPECT_LT(repaint, 16);
}

TEST(SignalChart, LosesNoPeakAndFollowsWhatIsVisible) {
    std::vector<double> time(100'000), values(100'000);
    for (std::size_t i = 0; i < time.size(); ++i) time[i] = static_cast<double>(i);
    values[54'321] = 7;
    SignalChart chart;
    chart.resize(800, 300);
    chart.setLines({{{}, Qt::blue, signal(std::move(time), std::move(values))}});
    chart.setTimeRange(0, 99'999);
    EXPECT_GT(chart.valueRange().second, 7);
    chart.setTimeRange(0, 50'000);
    EXPECT_LT(chart.valueRange().second, 2);
    EXPECT_FALSE(chart.hasRightAxis());
}

/// Samples that are drawn by columns: a slope stays one line, without teeth.
TEST(SignalChart, GoesDownASlopeWithoutGoingUpAgain) {
    std::vector<double> time(100'000), values(100'000);
    for (std::size_t i = 0; i < time.size(); ++i) {
        time[i] = static_cast<double>(i);
        values[i] = -time[i];
    }
    SignalChart chart;
    chart.resize(800, 300);
    chart.setLines({{{}, Qt::blue, signal(std::move(time), std::move(values))}});
    chart.setTimeRange(0, 99'999);
    const auto* series = qobject_cast<QLineSeries*>(chart.chart()->series().front());
    ASSERT_TRUE(series && series->count() > 600 && series->count() < 2000);
    int turns = 0;
    for (int i = 2; i < series->count(); ++i) turns += series->at(i).y() > series->at(i - 1).y() + 1e-6 ? 1 : 0;
    EXPECT_EQ(turns, 0) << "of " << series->count() << " points";
}

/// Signals of the shipped study, in the window.
class Signals : public Panels {
protected:
    SignalBrowser& browser() const { return *window.findChild<SignalBrowser*>(); }
    PlotArea& plots() const { return *window.findChild<PlotArea*>(); }
    void toFront() {
        for (const char* dock : {"signals", "plots"}) panel<QDockWidget>(dock)->raise();
        QTest::qWait(20);
    }
    void openAndWait() {
        openLambda();
        ASSERT_TRUE(QTest::qWaitFor([&] { return !document().facts().variables.empty(); }, 20000));
        toFront();
    }
    /// Types a search and sends the first match by Enter.
    void send(const QString& search) {
        browser().searchField()->setFocus();
        browser().searchField()->clear();
        QTest::keyClicks(browser().searchField(), search);
        QTest::keyClick(browser().searchField(), Qt::Key_Return);
        QTest::keyClick(browser().tree(), Qt::Key_Return);
    }
    bool drop(QWidget* target, const std::vector<SignalRef>& references) {
        QMimeData data;
        data.setData(signalMime, mimeOf(references));
        const QPoint at = target->rect().center();
        QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(target, &enter);
        if (!enter.isAccepted()) return false;
        QDropEvent event(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(target, &event);
        return event.isAccepted();
    }
    bool isShown(int axis, std::size_t trace = 0) {
        const auto& strips = plots().strips();
        if (axis >= static_cast<int>(strips.size())) return false;
        const auto& lines = strips[static_cast<std::size_t>(axis)]->chart()->lines();
        return trace < lines.size() && lines[trace].data && lines[trace].data->time;
    }
    const StudyExperiment& experiment() { return document().study().experiments.front(); }
    QString recording() { return QString::fromStdString(experiment().name); }
};

TEST_F(Signals, OfEveryKindAreListed) {
    openAndWait();
    std::set<SignalKind> kinds;
    std::size_t channels = 0;
    for (const Signal& signal : allSignals(document(), {"i_mod^2"})) {
        kinds.insert(signal.reference.kind);
        channels += signal.reference.kind == SignalKind::Recorded;
    }
    EXPECT_EQ(kinds.size(), 5u) << "recorded, variable, residual, sensitivity, formula";
    std::size_t columns = 0;
    for (const StudyExperiment& e : document().study().experiments)
        columns += fileTable(document().study().tables, e)->columns.size() - 1;
    EXPECT_EQ(channels, columns) << "mapped or not, all but the time";
    const auto all = allSignals(document(), {});
    for (const char* query : {"heater", "element.solid.T", "residual"})
        EXPECT_FALSE(matching(all, query).empty()) << query;
    EXPECT_TRUE(matching(all, "no such thing").empty());
}

TEST_F(Signals, AreListedOnceForAllThatAStepChangesAndNotForNobody) {
    openAndWait();
    QTest::qWait(100);
    const SignalModel& model = browser().model();
    QSignalSpy listed(&model, &QAbstractItemModel::modelReset);
    const int before = model.total();
    const auto addRecording = [&](const char* name) {
        StudySettings settings = document().settings();
        settings.experiments.push_back(settings.experiments.front());
        settings.experiments.back().name = name;
        document().applySettings(std::move(settings), "add");
    };
    addRecording("second");
    addRecording("third");
    EXPECT_TRUE(listed.isEmpty()) << "the step goes on";
    QCoreApplication::processEvents();
    const auto lists = listed.size();
    EXPECT_GT(lists, 0);
    EXPECT_LE(lists, 2) << "the signals, and the search in them";
    EXPECT_GT(model.total(), before);

    window.findChild<QDockWidget*>("signals")->hide();
    addRecording("fourth");
    QTest::qWait(50);
    EXPECT_EQ(listed.size(), lists);
    window.findChild<QDockWidget*>("signals")->show();
    window.findChild<QDockWidget*>("signals")->raise();
    ASSERT_TRUE(browser().isVisible());
    EXPECT_GT(listed.size(), lists);
}

TEST_F(Signals, GoToThePlotsByEnterAndMeasuredOnesNeedNoSimulation) {
    openAndWait();
    const auto& [output, mapping] = *experiment().outputs.begin();
    send(recording() + " " + QString::fromStdString(mapping.column));
    ASSERT_TRUE(QTest::qWaitFor([&] { return isShown(0); }, 5000));
    EXPECT_EQ(plots().values().simulations(), 0);
    const ChartLine& line = plots().strips()[0]->chart()->lines()[0];
    EXPECT_EQ(line.reference.name.toStdString(), mapping.column);
    EXPECT_EQ(line.colour, style::measuredTrace(plots().palette())) << "its colour in every plot";
    EXPECT_EQ(line.data->values.size(), line.data->time->size());
    EXPECT_TRUE(plots().strips()[0]->legendText().contains(line.reference.name));
}

TEST_F(Signals, OfTheModelAreSimulatedWhenTheyAreAskedFor) {
    openAndWait();
    send("element.solid.T");
    ASSERT_TRUE(QTest::qWaitFor([&] { return isShown(0); }, 20000)) << plots().strips()[0]->legendText().toStdString();
    EXPECT_EQ(plots().values().simulations(), 1);
    const ChartLine& line = plots().strips()[0]->chart()->lines()[0];
    EXPECT_EQ(line.reference.kind, SignalKind::Variable);
    EXPECT_GT(line.data->values.size(), 100u);
    const double before = line.data->values[line.data->values.size() - 1];
    const ParameterFact fact = document().facts().parameters.front();
    ASSERT_TRUE(fact.value);
    std::string resistance;
    for (const ParameterFact& p : document().facts().parameters)
        if (p.name == "heater.R") resistance = p.name;
    ASSERT_FALSE(resistance.empty());
    document().setParameterValue(resistance, 2 * *document().parameterValue(resistance));
    EXPECT_TRUE(QTest::qWaitFor(
        [&] {
            const auto& data = plots().strips()[0]->chart()->lines()[0].data;
            return data->values[data->values.size() - 1] != before;
        },
        20000))
        << "the trace follows the model";
}

TEST_F(Signals, ShareAnAxisWhereTheyAreDroppedAndOtherUnitsStandAtTheRight) {
    openAndWait();
    const auto input = experiment().inputs.begin();
    const auto output = experiment().outputs.begin();
    const SignalRef first{SignalKind::Recorded, recording(), QString::fromStdString(output->second.column)},
        second{SignalKind::Recorded, recording(), QString::fromStdString(input->second.column)};
    ASSERT_TRUE(drop(&plots(), {first}));
    ASSERT_TRUE(QTest::qWaitFor([&] { return isShown(0); }, 5000));
    ASSERT_TRUE(drop(plots().strips()[0], {second}));
    ASSERT_TRUE(QTest::qWaitFor([&] { return isShown(0, 1); }, 5000));
    ASSERT_EQ(plots().strips().size(), 1u);
    const auto& lines = plots().strips()[0]->chart()->lines();
    EXPECT_EQ(plots().strips()[0]->chart()->hasRightAxis(), lines[0].data->unit != lines[1].data->unit);
    EXPECT_NE(lines[0].colour, lines[1].colour);
    ASSERT_TRUE(drop(&plots(), {second}));
    ASSERT_EQ(plots().strips().size(), 2u);
    EXPECT_EQ(plots().strips()[1]->chart()->lines()[0].colour, lines[1].colour) << "one meaning, one colour";
}

TEST_F(Signals, OfOneMeaningHaveOneColourInEveryPlotBeforeAndAfterAFitAndInBothThemes) {
    openAndWait();
    const auto& [output, mapping] = *experiment().outputs.begin();
    const QString name = QString::fromStdString(output);
    const std::vector<SignalRef> shown{{SignalKind::Recorded, recording(), QString::fromStdString(mapping.column)},
                                       {SignalKind::Variable, recording(), name},
                                       {SignalKind::Residual, recording(), name}};
    for (const SignalRef& one : shown) plots().show({one});
    ASSERT_TRUE(QTest::qWaitFor([&] { return isShown(0) && isShown(1) && isShown(2); }, 20000));
    const auto expectAlike = [&](TraceRole model) {
        QTest::qWait(50);
        const TraceRole roles[] = {TraceRole::Measured, model, model};
        for (std::size_t i = 0; i < shown.size(); ++i)
            EXPECT_EQ(plots().strips()[i]->chart()->lines()[0].colour, traceColour(roles[i], plots().palette()))
                << "as among what was measured and simulated, " << i;
    };
    expectAlike(TraceRole::Before);
    run(RunKind::Fit);
    ASSERT_TRUE(QTest::qWaitFor([&] { return isShown(0) && isShown(1) && isShown(2); }, 20000));
    expectAlike(TraceRole::After);
    style::apply(*qApp, style::Theme::Dark);
    expectAlike(TraceRole::After);
    style::apply(*qApp, style::Theme::Light);
    plots().strips()[0]->findChild<QToolButton*>("strip-close")->click();
    plots().show({shown[0]});
    ASSERT_TRUE(QTest::qWaitFor([&] { return isShown(2); }, 5000));
    EXPECT_EQ(plots().strips()[2]->chart()->lines()[0].colour, style::measuredTrace(plots().palette()))
        << "wherever it comes again";
    // recordings that are compared with each other are none of the three
    CoursePlot compared;
    for (std::size_t line = 0; line < 6; ++line)
        for (const TraceRole role : {TraceRole::Measured, TraceRole::Before, TraceRole::After})
            EXPECT_NE(compared.colourOf(line), traceColour(role, compared.palette())) << line;
    document().undoStack().setClean();
}

TEST_F(Signals, OfAResidualIsSeenAgainstAVariableOfTheModel) {
    openAndWait();
    const QString name = QString::fromStdString(experiment().outputs.begin()->first);
    plots().show({{SignalKind::Variable, recording(), "element.solid.T"}, {SignalKind::Residual, recording(), name}});
    ASSERT_TRUE(QTest::qWaitFor([&] { return isShown(0) && isShown(0, 1); }, 20000));
    SignalStrip& strip = *plots().strips()[0];
    strip.viewBox()->setFocus();
    QTest::keyClick(strip.viewBox(), Qt::Key_Down);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return !strip.figure()->figure().curves.empty() && strip.figure()->figure().fault.isEmpty(); }, 5000));
    EXPECT_TRUE(strip.figure()->figure().xLabel.contains("element.solid.T"))
        << strip.figure()->figure().xLabel.toStdString();
    EXPECT_GT(strip.figure()->figure().curves[0].points.size(), 100);
    document().undoStack().setClean();
}

TEST_F(Signals, HaveFiguresBetweenTwoCursorsAndLinkedTimes) {
    openAndWait();
    const SignalRef channel{SignalKind::Recorded, recording(),
                            QString::fromStdString(experiment().outputs.begin()->second.column)};
    plots().show({channel});
    plots().show({channel});
    ASSERT_TRUE(QTest::qWaitFor([&] { return isShown(1); }, 5000));
    SignalChart* chart = plots().strips()[0]->chart();
    chart->setFocus();
    const auto whole = plots().timeRange();
    QTest::keyClick(chart, Qt::Key_Plus);
    const auto part = plots().timeRange();
    EXPECT_LT(part.second - part.first, whole.second - whole.first);
    QTest::keyClick(chart, Qt::Key_Home);
    EXPECT_EQ(plots().timeRange(), whole);
    for (const int x : {200, 500})
        QTest::mouseClick(chart->viewport(), Qt::LeftButton, Qt::ControlModifier, {x, chart->height() / 2});
    for (const SignalStrip* strip : plots().strips()) {
        EXPECT_TRUE(strip->legendText().contains("mean")) << strip->legendText().toStdString();
        EXPECT_TRUE(strip->legendText().contains("rms"));
    }
    QTest::mouseMove(chart->viewport(), {300, chart->height() / 2});
    QTest::mouseDClick(chart->viewport(), Qt::LeftButton, Qt::NoModifier, {300, 50});
    EXPECT_EQ(plots().timeRange(), whole);
}

TEST_F(Signals, AreTakenOutMovedAndBroughtBackByUndo) {
    openAndWait();
    const SignalRef one{SignalKind::Recorded, recording(),
                        QString::fromStdString(experiment().outputs.begin()->second.column)},
        two{SignalKind::Recorded, recording(), QString::fromStdString(experiment().inputs.begin()->second.column)};
    plots().show({one});
    plots().show({two});
    ASSERT_EQ(plots().layout().axes.size(), 2u);
    const unsigned long revision = document().revision();
    plots().strips()[0]->findChild<QToolButton*>("strip-down")->click();
    EXPECT_EQ(plots().layout().axes[1].traces[0], one);
    plots().strips()[0]->findChild<QToolButton*>("strip-close")->click();
    EXPECT_EQ(plots().layout().axes.size(), 1u);
    document().undoStack().undo();
    document().undoStack().undo();
    EXPECT_EQ(plots().layout().axes[0].traces[0], one);
    EXPECT_EQ(document().revision(), revision) << "what is looked at changes no result";
    Q_EMIT plots().strips()[0]->removeWanted(0);
    EXPECT_EQ(plots().layout().axes.size(), 1u);
}

TEST_F(Signals, OfTheOtherAxesStayAsTheyAreDrawnWhereOneIsClosed) {
    openAndWait();
    for (const char* name : {"u_heater", "T_exhaust", "i_heater", "p_ambient"})
        plots().show({{SignalKind::Recorded, recording(), name}});
    const std::vector<SignalStrip*> before = plots().strips();
    ASSERT_EQ(before.size(), 4u);
    before[1]->chart()->setFocus();
    QTest::keyClick(before[1]->chart(), Qt::Key_Delete);
    EXPECT_EQ(plots().strips(), (std::vector<SignalStrip*>{before[0], before[2], before[3]})) << "none is made anew";
    EXPECT_TRUE(before[2]->chart()->hasFocus()) << "the next Del closes the next one";
    QTest::mouseClick(before[0]->findChild<QToolButton*>("strip-close"), Qt::LeftButton);
    EXPECT_EQ(plots().strips(), (std::vector<SignalStrip*>{before[2], before[3]}));
    EXPECT_TRUE(plots().strips()[0]->legendText().contains("i_heater"));
    EXPECT_FALSE(plots().strips()[0]->findChild<QToolButton*>("strip-up")->isEnabled()) << "the first now";
    document().undoStack().undo();
    document().undoStack().undo();
    ASSERT_EQ(plots().strips().size(), 4u);
    EXPECT_TRUE(plots().strips()[1]->legendText().contains("T_exhaust"));
    EXPECT_TRUE(plots().strips()[2]->legendText().contains("i_heater"));
}

TEST_F(Signals, AreWorkedOutByFormulasWithTheirUnits) {
    openAndWait();
    browser().formulaField()->setFocus();
    QTest::keyClicks(browser().formulaField(), "heater.v*heater.i +");
    QTest::keyClick(browser().formulaField(), Qt::Key_Return);
    EXPECT_EQ(plots().layout().axes.size(), 0u) << "no formula";
    browser().formulaField()->clear();
    QTest::keyClicks(browser().formulaField(), "heater.v*heater.i");
    QTest::keyClick(browser().formulaField(), Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return isShown(0); }, 20000));
    EXPECT_EQ(plots().strips()[0]->chart()->lines()[0].data->unit, "W");
    EXPECT_EQ(plots().values().simulations(), 1) << "what it uses is simulated together, once";
}

TEST_F(Signals, AreSeenAgainstEachOtherAndByTheirFrequenciesAndValues) {
    openAndWait();
    plots().show(
        {{SignalKind::Recorded, recording(), QString::fromStdString(experiment().outputs.begin()->second.column)},
         {SignalKind::Recorded, recording(), QString::fromStdString(experiment().inputs.begin()->second.column)}});
    ASSERT_TRUE(QTest::qWaitFor([&] { return isShown(0) && isShown(0, 1); }, 5000));
    SignalStrip& strip = *plots().strips()[0];
    const auto& lines = strip.chart()->lines();
    const std::array<std::size_t, 5> curves{0, 1, 2, 1, 2};
    QString before;
    for (int view = 1; view < 5; ++view) {
        strip.viewBox()->setFocus();
        QTest::keyClick(strip.viewBox(), Qt::Key_Down);
        ASSERT_EQ(static_cast<int>(plots().layout().axes[0].view), view);
        ASSERT_TRUE(QTest::qWaitFor(
            [&] { return !strip.figure()->figure().yLabel.isEmpty() && strip.figure()->figure().yLabel != before; },
            5000));
        before = strip.figure()->figure().yLabel;
        EXPECT_EQ(strip.figure()->figure().curves.size(), curves[static_cast<std::size_t>(view)]) << view;
        EXPECT_GT(strip.figure()->figure().curves[0].points.size(), 5);
    }
    EXPECT_EQ(strip.figure()->figure().curves[1].colour, lines[1].colour);
    document().undoStack().undo();
    EXPECT_EQ(plots().layout().axes[0].view, PlotView::Coherence);
    Q_EMIT strip.removeWanted(1);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !strip.figure()->figure().fault.isEmpty(); }, 5000)) << "it needs two";
}

TEST_F(Signals, AreShownAgainWhenTheStudyIsOpenedAgain) {
    openAndWait();
    const SignalRef channel{SignalKind::Recorded, recording(),
                            QString::fromStdString(experiment().outputs.begin()->second.column)};
    plots().show({channel});
    const QString file = directory.filePath("kept.analogon");
    bool isSaved = false;
    QObject::connect(&document(), &Document::saved, &document(), [&](bool done) { isSaved = done; });
    window.saveTo(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return isSaved; }, 20000));
    MainWindow other;
    other.open(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return other.document().isOpen(); }, 20000));
    EXPECT_TRUE(other.document().messages().empty() ||
                std::none_of(other.document().messages().begin(), other.document().messages().end(),
                             [](const Message& m) { return m.diagnostic.message.find("plots") != std::string::npos; }));
    ASSERT_EQ(other.findChild<PlotArea*>()->layout().axes.size(), 1u);
    EXPECT_EQ(other.findChild<PlotArea*>()->layout().axes[0].traces[0], channel);
}

}  // namespace
}  // namespace analogon::ui
