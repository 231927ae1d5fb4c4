#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSpinBox>
#include <QTreeWidget>
#include <algorithm>

#include "ui/document/document.hpp"
#include "ui/effect/result_panel.hpp"
#include "ui/find/find_dialog.hpp"
#include "ui/fit/fit_panel.hpp"
#include "ui/fit/run_controller.hpp"
#include "ui/inspector/parameter_panel.hpp"
#include "ui/sensitivity/profile_dialog.hpp"
#include "ui/sensitivity/sweep_chart.hpp"
#include "ui/sensitivity/sweep_dialog.hpp"
#include "ui/signals/plot_area.hpp"
#include "ui/signals/signal_browser.hpp"
#include "ui/signals/signal_strip.hpp"
#include "ui/window/album.hpp"
#include "ui/window/main_window.hpp"
#include "ui/window/report_dialog.hpp"

/// Scenes of runs and what they came to.
namespace analogon::ui {

/// A fit on its way, and a value that it would like beyond its bound.
bool takeRunning(Album& album, const QString& example) {
    MainWindow window;
    if (!openIn(album, window, {1440, 900}, example)) return false;
    Document& document = window.document();
    if (!waitUntil([&] { return !document.facts().parameters.empty(); })) return false;
    StudySettings settings = document.settings();
    std::string bounded;
    for (const ParameterFact& fact : document.facts().parameters) {
        const auto setting = settings.parameters.find(fact.name);
        const auto value = document.parameterValue(fact.name);
        if (setting == settings.parameters.end() || !setting->second.fit || !value) continue;
        setting->second.max = 1.02 * *value;
        setting->second.min = 0.98 * *value;
        bounded = fact.name;
        break;
    }
    document.applySettings(std::move(settings), "picture");
    goOnFor(500);
    auto* runs = window.findChild<FitPanel*>();
    runs->startsBox()->setValue(40);  // long enough to be seen
    window.controller().start(RunKind::Fit);
    waitUntil([&] { return document.liveTraces() || !window.controller().isRunning(); }, 60000);
    goOnFor(500);
    album.expect(window.controller().isRunning());
    album.take(window, "18-running");
    runs->startsBox()->setValue(1);
    window.controller().cancel();
    waitUntil([&] { return !window.controller().isRunning(); });
    window.controller().start(RunKind::Fit);
    waitUntil([&] { return !window.controller().isRunning(); });
    window.findChild<ParameterPanel*>()->pointAt(QString::fromStdString(bounded));
    goOnFor();
    album.take(window, "19-at-its-bound");
    return true;
}

/// Signals of every kind, with two cursors.
bool takeSignals(Album& album, const QString& example) {
    MainWindow window;
    if (!openIn(album, window, {1440, 900}, example)) return false;
    Document& document = window.document();
    if (!waitUntil([&] { return !document.facts().variables.empty(); })) return false;
    auto* plots = window.findChild<PlotArea*>();
    auto* browser = window.findChild<SignalBrowser*>();
    for (const char* dock : {"signals", "plots"}) window.findChild<QDockWidget*>(dock)->raise();
    const StudyExperiment& first = document.study().experiments.front();
    const QString recording = QString::fromStdString(first.name);
    std::vector<SignalRef> shown;
    for (const auto* mappings : {&first.outputs, &first.inputs})
        for (const auto& [signal, mapping] : *mappings)
            shown.push_back({SignalKind::Recorded, recording, QString::fromStdString(mapping.column)});
    plots->show(shown);
    plots->show({{SignalKind::Variable, recording, "element.solid.T"}, {SignalKind::Variable, recording, "heater.i"}});
    browser->formulaField()->setText("heater.v*heater.i");
    QMetaObject::invokeMethod(browser->formulaField(), "returnPressed");
    const auto isThere = [](const SignalStrip* strip) {
        const auto& lines = strip->chart()->lines();
        return std::all_of(lines.begin(), lines.end(), [](const ChartLine& line) { return line.data != nullptr; });
    };
    waitUntil([&] { return std::all_of(plots->strips().begin(), plots->strips().end(), isThere); }, 20000);
    const auto [from, to] = plots->timeRange();
    for (const double part : {0.2, 0.6}) Q_EMIT plots->strips().front()->chart()->markWanted(from + part * (to - from));
    browser->searchField()->setText("heater");
    goOnFor(300);
    album.take(window, "20-signals");
    window.resize(1024, 768);
    goOnFor();
    album.take(window, "20-signals-1024");
    document.undoStack().setClean();
    return true;
}

/// The arrangement for each part of the work, with a parameter that is turned; the result with its runs named.
bool takeArrangements(Album& album, const QString& example) {
    MainWindow window;
    if (!openIn(album, window, {1024, 700}, example)) return false;
    Document& document = window.document();
    if (!waitUntil([&] { return !document.facts().parameters.empty(); })) return false;
    window.controller().start(RunKind::Discover);
    waitUntil([&] { return !window.controller().isRunning(); });
    window.controller().start(RunKind::Fit);
    waitUntil([&] { return !window.controller().isRunning(); });
    if (document.history().size() < 2) return false;
    document.describeRun(document.history().front().number, "A", "1024 x 700");
    document.pinRun(document.history().front().number, true);
    const auto turnTo = [&](Qt::Key key) {
        for (QAction* action : window.findChildren<QAction*>())
            if (action->shortcut() == QKeySequence(key)) action->trigger();
        goOnFor(300);
    };
    turnTo(Qt::Key_F7);
    window.findChild<ParameterPanel*>()->pointAt(QString::fromStdString(document.facts().parameters.front().name));
    goOnFor(300);
    album.take(window, "22-for-the-model");
    turnTo(Qt::Key_F8);
    album.take(window, "22-for-the-data");
    document.restoreRun(document.history().front());
    turnTo(Qt::Key_F9);
    auto* results = window.findChild<ResultPanel*>();
    if (QTreeWidget* list = results->candidates()) {
        results->roundBox()->setChecked(true);
        goOnFor();
        results->verticalScrollBar()->setValue(list->y() - results->viewport()->height() / 3);
    }
    goOnFor();
    album.take(window, "22-for-the-result");
    auto* runs = window.findChild<FitPanel*>();
    window.findChild<QDockWidget*>("runs")->raise();
    runs->history()->setCurrentItem(runs->history()->topLevelItem(0));
    runs->history()->topLevelItem(0)->setSelected(true);
    goOnFor();
    album.take(window, "22-a-run-with-a-name");
    for (const char* page : {"recordings", "sensitivity"}) {
        window.findChild<QAction*>(page)->trigger();
        goOnFor(1500);
        album.take(window, QStringLiteral("22-") + page);
    }
    document.undoStack().setClean();
    return true;
}

/// The profile of the first fitted parameter.
void takeProfile(Album& album, MainWindow& window) {
    window.controller().start(RunKind::Fit);
    waitUntil([&] { return !window.controller().isRunning(); });
    window.findChild<QAction*>("profile")->trigger();
    auto* dialog = window.findChild<ProfileDialog*>();
    dialog->runButton()->click();
    album.expect(waitUntil([&] { return dialog->interval().has_value(); }, 60000));
    goOnFor();
    album.takeDialog(*dialog, "22-profile");
    dialog->reject();
}

/// The error over one parameter, and over two.
bool takeSweep(Album& album, const QString& example) {
    MainWindow window;
    if (!openIn(album, window, {1024, 700}, example)) return false;
    if (!waitUntil([&] { return !window.document().facts().parameters.empty(); })) return false;
    window.findChild<QAction*>("sweep")->trigger();
    auto* dialog = window.findChild<SweepDialog*>();
    if (!dialog) return false;
    goOnFor();
    dialog->runButton()->click();
    album.expect(waitUntil([&] { return dialog->sweep().has_value(); }, 60000));
    goOnFor();
    album.takeDialog(*dialog, "22-sweep");
    QComboBox* const second = dialog->axis(1).parameter;
    second->setCurrentIndex(std::min(2, second->count() - 1));
    goOnFor();
    dialog->runButton()->click();
    album.expect(waitUntil([&] { return dialog->sweep() && dialog->sweep()->axes.size() == 2; }, 60000));
    goOnFor();
    album.takeDialog(*dialog, "22-sweep-of-two");
    dialog->reject();
    takeProfile(album, window);
    return true;
}

/// The head of the report, and what is found in the study.
bool takeDialogs(Album& album, const QString& example) {
    MainWindow window;
    if (!openIn(album, window, {1024, 700}, example)) return false;
    if (!waitUntil([&] { return !window.document().facts().variables.empty(); })) return false;
    window.findChild<QAction*>("report-head-action")->trigger();
    auto* report = window.findChild<ReportDialog*>();
    if (!report) return false;
    report->titleField()->setText("LSU 4.9");
    report->authorField()->setText("E. Noether");
    goOnFor();
    album.takeDialog(*report, "23-head-of-the-report");
    report->reject();
    window.findChild<QAction*>("find-in-study-action")->trigger();
    auto* find = window.findChild<FindDialog*>();
    if (!find) return false;
    find->field()->setText("heater");
    goOnFor();
    album.takeDialog(*find, "23-find-in-the-study");
    find->reject();
    return true;
}

}  // namespace analogon::ui
