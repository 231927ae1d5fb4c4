#include "ui/window/pictures.hpp"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollBar>
#include <QSettings>
#include <QSpinBox>
#include <QStatusBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QToolButton>
#include <QTreeView>
#include <QTreeWidget>
#include <algorithm>
#include <functional>
#include <iostream>

#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/document/composer.hpp"
#include "ui/document/document.hpp"
#include "ui/effect/result_panel.hpp"
#include "ui/fit/fit_panel.hpp"
#include "ui/fit/run_controller.hpp"
#include "ui/inspector/parameter_panel.hpp"
#include "ui/library/library_panel.hpp"
#include "ui/measurement/compare_page.hpp"
#include "ui/measurement/import_panel.hpp"
#include "ui/measurement/measurement_panel.hpp"
#include "ui/measurement/question_card.hpp"
#include "ui/measurement/values_page.hpp"
#include "ui/plot/plot_panel.hpp"
#include "ui/signals/plot_area.hpp"
#include "ui/signals/signal_browser.hpp"
#include "ui/signals/signal_strip.hpp"
#include "ui/style/style.hpp"
#include "ui/style/translator.hpp"
#include "ui/text/find_bar.hpp"
#include "ui/text/text_view.hpp"
#include "ui/window/compose_actions.hpp"
#include "ui/window/generate_page.hpp"
#include "ui/window/main_window.hpp"
#include "ui/window/start_page.hpp"

namespace analogon::ui {

namespace {

bool waitFor(const std::function<bool()>& holds, int milliseconds = 900000) {
    QElapsedTimer clock;
    clock.start();
    while (!holds() && clock.elapsed() < milliseconds)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
    return holds();
}

void settle(int milliseconds = 120) {
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < milliseconds) QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
}

/// One pass through the work, in one look and language.
class Album {
public:
    Album(const QDir& directory, QString suffix) : directory_(directory), suffix_(std::move(suffix)) {}

    bool make() {
        QSettings().clear();  // what an earlier album opened is no part of this one
        MainWindow window;
        window.resize(1440, 900);
        window.show();
        settle();
        take(window, "01-start");
        const auto examples = findExamples();
        if (examples.empty()) return false;
        QMetaObject::invokeMethod(window.findChild<StartPage*>(), "generateWanted");
        auto* generate = window.findChild<GeneratePage*>();
        if (generate->knownDomains()->count() > 0)
            generate->addDomain(generate->knownDomains()->item(0)->data(Qt::UserRole).toString());
        settle();
        take(window, "02-generate");
        window.startNew();
        settle();
        take(window, "03-empty-study");
        for (const char* dock : {"runs", "messages"}) window.findChild<QDockWidget*>(dock)->raise();
        settle();
        take(window, "03-empty-study-runs");
        for (const char* dock : {"result", "traces"}) window.findChild<QDockWidget*>(dock)->raise();
        QMetaObject::invokeMethod(window.findChild<DiagramView*>(), "typed", Q_ARG(QString, "heat"));
        settle();
        take(window, "04-insert-block");
        window.open(examples.front().path);
        Document& document = window.document();
        if (!waitFor([&] { return !document.path().isEmpty() && document.before(); })) return false;
        settle(300);
        take(window, "05-opened");
        if (const auto table = document.study().experiments.front().file; !table.empty())
            window.open(QString::fromStdString((document.study().directory / table).string()));
        waitFor([&] { return window.findChild<ImportPanel*>()->acceptButton()->isEnabled(); }, 10000);
        settle();
        take(window, "06-import");
        QMetaObject::invokeMethod(window.findChild<ImportPanel*>(), "cancelled");
        takeQuestion(window);
        takeComparison(window);
        auto* tabs = window.findChild<QTabWidget*>("centre");
        tabs->setCurrentWidget(window.findChild<TextView*>());
        settle();
        take(window, "07-model-text");
        tabs->setCurrentWidget(window.findChild<DiagramView*>());
        auto* beside = window.findChild<QAction*>("text-beside");
        beside->trigger();
        settle();
        take(window, "07-text-beside");
        beside->trigger();
        Q_EMIT window.findChild<MeasurementPanel*>()->valuesWanted(
            QString::fromStdString(document.study().experiments.front().name));
        settle();
        take(window, "07-values");
        Q_EMIT window.findChild<ValuesPage*>()->left();
        window.controller().start(RunKind::Fit);
        waitFor([&] { return !window.controller().isRunning(); });
        settle();
        take(window, "08-fitted");
        window.controller().start(RunKind::Discover);
        waitFor([&] { return !window.controller().isRunning(); });
        settle();
        take(window, "09-found");
        if (!document.finding()) return false;
        takePreview(window);
        document.adoptCompleted("picture");
        const std::string added =
            document.finding()->effects.empty() ? "" : document.finding()->effects.front().instance;
        waitFor(
            [&] {  // the lists follow once the model has been analysed
                const auto& known = document.facts().parameters;
                return std::any_of(known.begin(), known.end(),
                                   [&](const ParameterFact& p) { return p.name.rfind(added + ".", 0) == 0; });
            },
            60000);
        settle(300);
        take(window, "10-added");
        window.findChild<PlotPanel*>()->residualButton()->click();
        settle();
        take(window, "11-residual");
        window.findChild<QToolButton*>("traces-view")->click();
        window.findChild<QDockWidget*>("runs")->raise();
        window.findChild<FitPanel*>()->history()->selectAll();
        settle();
        take(window, "12-runs");
        window.findChild<PlotPanel*>()->endComparisonButton()->click();
        const QString whole = document.modelText();
        QString broken = whole;
        document.typeText(broken.replace("connect(heater.i", "connect(heater.current"));
        settle(400);
        window.findChild<QDockWidget*>("messages")->raise();
        settle();
        take(window, "13-messages");
        document.typeText(whole);
        settle(400);
        for (QAction* action : window.findChildren<QAction*>())
            if (action->shortcut() == QKeySequence(QKeySequence::HelpContents)) action->trigger();
        settle(2500);  // its pictures come a moment later
        take(window, "14-guide");
        return takeGroup(examples.front().path) && takeSmall(examples.front().path) &&
               takeComposing(examples.front().path) && takeRunning(examples.back().path) &&
               takeSignals(examples.front().path) && takeFinding(examples.front().path) &&
               takeArrangements(examples.front().path) && isWhole_;
    }

private:
    /// The second of the effects that were tried, as one looks at it.
    void takePreview(MainWindow& window) {
        auto* results = window.findChild<ResultPanel*>();
        QTreeWidget* list = results->candidates();
        if (!list || list->topLevelItemCount() < 2) return;
        list->setCurrentItem(list->topLevelItem(1));
        waitFor([&] { return window.document().preview() != nullptr; }, 20000);
        results->verticalScrollBar()->setValue(list->y() - results->viewport()->height() / 3);
        settle();
        take(window, "09-preview");
        list->setCurrentItem(nullptr);
        results->verticalScrollBar()->setValue(0);
        settle();
    }
    /// False: the study did not come up, or its start values gave no trace.
    bool openIn(MainWindow& window, QSize size, const QString& example) {
        window.resize(size);
        window.show();
        window.open(example);
        return waitFor([&] { return window.document().isOpen() && window.document().before(); });
    }
    bool takeGroup(const QString& example) {
        MainWindow window;
        if (!openIn(window, {1440, 900}, example)) return false;
        Document& document = window.document();
        document.enter(window.compose().composer().group({"heater", "element"}, "Probe"));
        settle(1000);
        take(window, "15-inside-a-group");
        return !document.levels().empty();
    }
    bool takeSmall(const QString& example) {
        MainWindow window;
        if (!openIn(window, {853, 480}, example)) return false;
        settle(300);
        take(window, "16-small-screen");
        return true;
    }
    /// A block of the library with what it is for, and a wire on its way to a connector that does not fit.
    bool takeComposing(const QString& example) {
        MainWindow window;
        if (!openIn(window, {1440, 900}, example)) return false;
        Document& document = window.document();
        auto* library = window.findChild<LibraryPanel*>();
        const QRect row = library->showClass("Analogon.ThermalFluid.BasicThermalFluid");
        library->tree()->setCurrentIndex(library->tree()->indexAt(row.center()));
        window.compose().composer().addBlock("Analogon.Mechanics.Inertia", {40, -40});
        settle(300);
        auto* view = window.findChild<DiagramView*>();
        view->fitView();
        const auto from = document.diagram().anchor("element.fluid"),
                   to = document.diagram().anchor("inertia.flange_a");
        if (!from || !to) return false;
        const auto send = [&](QEvent::Type type, Point at, Qt::MouseButtons buttons) {
            const QPointF pixel = view->mapFromScene(QPointF(at.x, -at.y));
            QMouseEvent event(type, pixel, view->viewport()->mapToGlobal(pixel), Qt::LeftButton, buttons, {});
            QCoreApplication::sendEvent(view->viewport(), &event);
        };
        send(QEvent::MouseButtonPress, *from, Qt::LeftButton);
        send(QEvent::MouseMove, {(from->x + to->x) / 2, (from->y + to->y) / 2}, Qt::LeftButton);
        send(QEvent::MouseMove, *to, Qt::LeftButton);
        settle();
        take(window, "17-a-wire-is-refused");
        send(QEvent::MouseButtonRelease, {-140, -100}, Qt::NoButton);
        document.undoStack().setClean();
        return true;
    }
    /// A fit on its way, and a value that it would like beyond its bound.
    bool takeRunning(const QString& example) {
        MainWindow window;
        if (!openIn(window, {1440, 900}, example)) return false;
        Document& document = window.document();
        if (!waitFor([&] { return !document.facts().parameters.empty(); })) return false;
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
        settle(500);
        auto* runs = window.findChild<FitPanel*>();
        runs->startsBox()->setValue(40);  // long enough to be seen
        window.controller().start(RunKind::Fit);
        waitFor([&] { return document.liveTraces() || !window.controller().isRunning(); }, 60000);
        settle(500);
        isWhole_ = isWhole_ && window.controller().isRunning();
        take(window, "18-running");
        runs->startsBox()->setValue(1);
        window.controller().cancel();
        waitFor([&] { return !window.controller().isRunning(); });
        window.controller().start(RunKind::Fit);
        waitFor([&] { return !window.controller().isRunning(); });
        window.findChild<ParameterPanel*>()->pointAt(QString::fromStdString(bounded));
        settle();
        take(window, "19-at-its-bound");
        return true;
    }
    /// Signals of every kind, with two cursors.
    bool takeSignals(const QString& example) {
        MainWindow window;
        if (!openIn(window, {1440, 900}, example)) return false;
        Document& document = window.document();
        if (!waitFor([&] { return !document.facts().variables.empty(); })) return false;
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
        plots->show(
            {{SignalKind::Variable, recording, "element.solid.T"}, {SignalKind::Variable, recording, "heater.i"}});
        browser->formulaField()->setText("heater.v*heater.i");
        QMetaObject::invokeMethod(browser->formulaField(), "returnPressed");
        const auto isThere = [](const SignalStrip* strip) {
            const auto& lines = strip->chart()->lines();
            return std::all_of(lines.begin(), lines.end(), [](const ChartLine& line) { return line.data != nullptr; });
        };
        waitFor([&] { return std::all_of(plots->strips().begin(), plots->strips().end(), isThere); }, 20000);
        const auto [from, to] = plots->timeRange();
        for (const double part : {0.2, 0.6})
            Q_EMIT plots->strips().front()->chart()->markWanted(from + part * (to - from));
        browser->searchField()->setText("heater");
        settle(300);
        take(window, "20-signals");
        window.resize(1024, 768);
        settle();
        take(window, "20-signals-1024");
        document.undoStack().setClean();
        return true;
    }
    /// A block by another word for it, a search without result, and a word of the text.
    bool takeFinding(const QString& example) {
        MainWindow window;
        if (!openIn(window, {1024, 700}, example)) return false;
        auto* library = window.findChild<LibraryPanel*>();
        window.findChild<QDockWidget*>("library")->raise();
        library->search()->setText("Heizung");
        window.findChild<QTabWidget*>("centre")->setCurrentWidget(window.findChild<TextView*>());
        FindBar* find = window.findChild<TextView*>()->findBar();
        find->open();
        find->field()->setText("heater");
        settle();
        take(window, "21-find");
        library->search()->setText("xyz");
        find->field()->setText("xyz");
        settle();
        take(window, "21-nothing-found");
        return true;
    }
    /// The arrangement for each part of the work, with a parameter that is turned; the result with its runs named.
    bool takeArrangements(const QString& example) {
        MainWindow window;
        if (!openIn(window, {1024, 700}, example)) return false;
        Document& document = window.document();
        if (!waitFor([&] { return !document.facts().parameters.empty(); })) return false;
        window.controller().start(RunKind::Discover);
        waitFor([&] { return !window.controller().isRunning(); });
        window.controller().start(RunKind::Fit);
        waitFor([&] { return !window.controller().isRunning(); });
        if (document.history().size() < 2) return false;
        document.describeRun(document.history().front().number, "A", "1024 x 700");
        document.pinRun(document.history().front().number, true);
        const auto turnTo = [&](Qt::Key key) {
            for (QAction* action : window.findChildren<QAction*>())
                if (action->shortcut() == QKeySequence(key)) action->trigger();
            settle(300);
        };
        turnTo(Qt::Key_F7);
        window.findChild<ParameterPanel*>()->pointAt(QString::fromStdString(document.facts().parameters.front().name));
        settle(300);
        take(window, "22-for-the-model");
        turnTo(Qt::Key_F8);
        take(window, "22-for-the-data");
        document.restoreRun(document.history().front());
        turnTo(Qt::Key_F9);
        auto* results = window.findChild<ResultPanel*>();
        if (QTreeWidget* list = results->candidates()) {
            results->roundBox()->setChecked(true);
            settle();
            results->verticalScrollBar()->setValue(list->y() - results->viewport()->height() / 3);
        }
        settle();
        take(window, "22-for-the-result");
        auto* runs = window.findChild<FitPanel*>();
        window.findChild<QDockWidget*>("runs")->raise();
        runs->history()->setCurrentItem(runs->history()->topLevelItem(0));
        runs->history()->topLevelItem(0)->setSelected(true);
        settle();
        take(window, "22-a-run-with-a-name");
        for (const char* page : {"recordings", "sensitivity"}) {
            window.findChild<QAction*>(page)->trigger();
            settle(1500);
            take(window, QStringLiteral("22-") + page);
        }
        document.undoStack().setClean();
        return true;
    }
    /// A text that can be read in two ways.
    void takeQuestion(MainWindow& window) {
        const QTemporaryDir place;
        const QString path = place.filePath("bench.csv");
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly)) return;
        file.write("Zeit [s];T_Wasser [degC];p [mbar]\n");
        for (int i = 0; i < 40; ++i)
            file.write(
                QStringLiteral("%1;%2,%3;1.%4\n").arg(i).arg(60 + i / 10).arg(100 + 7 * i).arg(110 + 3 * i).toUtf8());
        file.close();
        window.open(path);
        auto* import = window.findChild<ImportPanel*>();
        waitFor([&] { return import->question()->isVisible(); }, 3000);
        settle();
        take(window, "06-import-question");
        QMetaObject::invokeMethod(import, "cancelled");
    }
    /// The measured channel of the fit beside those of the other recordings.
    void takeComparison(MainWindow& window) {
        const StudyExperiment& first = window.document().study().experiments.front();
        if (first.outputs.empty()) return;
        Q_EMIT window.findChild<MeasurementPanel*>()->comparisonWanted(
            QString::fromStdString(first.outputs.begin()->first), QString::fromStdString(first.name));
        settle(800);
        take(window, "06-compare");
        Q_EMIT window.findChild<ComparePage*>()->left();
    }

    void take(MainWindow& window, const QString& name) {
        window.statusBar()->clearMessage();  // it tells how fast this machine is: no part of the picture
        const QString file = directory_.filePath(name + suffix_ + ".png");
        isWhole_ = window.grab().save(file) && isWhole_;
        std::cout << file.toStdString() << std::endl;
    }

    QDir directory_;
    QString suffix_;
    bool isWhole_{true};
};

}  // namespace

bool writePictures(const QString& directory, const QString& onlyLanguage) {
    const QTemporaryDir settings;  // neither read nor change the user's own
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    qputenv("XDG_DATA_HOME", settings.path().toUtf8());  // nor show what a crash of theirs has left
    const QDir target(directory);
    if (!target.mkpath(".")) return false;
    bool isWhole = true;
    for (const QString& language : onlyLanguage.isEmpty() ? languages() : QStringList{onlyLanguage})
        for (const style::Theme theme : {style::Theme::Light, style::Theme::Dark}) {
            style::apply(*qApp, theme);
            Translator translator;
            if (translator.loadLanguage(language)) QCoreApplication::installTranslator(&translator);
            const int percent = qRound(qApp->devicePixelRatio() * 100);
            const QString suffix = "-" + language + (theme == style::Theme::Dark ? "-dark" : "") +
                                   (percent == 100 ? QString() : QStringLiteral("-%1").arg(percent));
            isWhole = Album(target, suffix).make() && isWhole;
            QCoreApplication::removeTranslator(&translator);
        }
    return isWhole;
}

}  // namespace analogon::ui
