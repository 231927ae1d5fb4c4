#include "ui/window/pictures.hpp"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QListWidget>
#include <QPushButton>
#include <QScrollBar>
#include <QSettings>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QToolButton>
#include <QTreeWidget>
#include <algorithm>

#include "ui/canvas/diagram_view.hpp"
#include "ui/document/document.hpp"
#include "ui/effect/result_panel.hpp"
#include "ui/fit/fit_panel.hpp"
#include "ui/fit/run_controller.hpp"
#include "ui/measurement/compare_page.hpp"
#include "ui/measurement/import_panel.hpp"
#include "ui/measurement/measurement_panel.hpp"
#include "ui/measurement/question_card.hpp"
#include "ui/measurement/values_page.hpp"
#include "ui/plot/plot_panel.hpp"
#include "ui/style/style.hpp"
#include "ui/style/translator.hpp"
#include "ui/text/text_view.hpp"
#include "ui/window/album.hpp"
#include "ui/window/generate_page.hpp"
#include "ui/window/main_window.hpp"
#include "ui/window/start_page.hpp"

namespace analogon::ui {

namespace {

/// The second of the effects that were tried, as one looks at it.
void takePreview(Album& album, MainWindow& window) {
    auto* results = window.findChild<ResultPanel*>();
    QTreeWidget* list = results->candidates();
    if (!list || list->topLevelItemCount() < 2) return;
    list->setCurrentItem(list->topLevelItem(1));
    waitUntil([&] { return window.document().preview() != nullptr; }, 20000);
    results->verticalScrollBar()->setValue(list->y() - results->viewport()->height() / 3);
    goOnFor();
    album.take(window, "09-preview");
    list->setCurrentItem(nullptr);
    results->verticalScrollBar()->setValue(0);
    goOnFor();
}

/// A text that can be read in two ways.
void takeQuestion(Album& album, MainWindow& window) {
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
    waitUntil([&] { return import->question()->isVisible(); }, 3000);
    goOnFor();
    album.take(window, "06-import-question");
    QMetaObject::invokeMethod(import, "cancelled");
}

/// The measured channel of the fit beside those of the other recordings.
void takeComparison(Album& album, MainWindow& window) {
    const StudyExperiment& first = window.document().study().experiments.front();
    if (first.outputs.empty()) return;
    Q_EMIT window.findChild<MeasurementPanel*>()->comparisonWanted(QString::fromStdString(first.outputs.begin()->first),
                                                                   QString::fromStdString(first.name));
    waitUntil([&] { return window.findChild<ComparePage*>()->table()->rowCount() > 0; }, 20000);
    goOnFor(800);
    album.take(window, "06-compare");
    Q_EMIT window.findChild<ComparePage*>()->left();
}

/// The start page, the page that generates, an empty study.
void takeBeginning(Album& album, MainWindow& window) {
    goOnFor();
    album.take(window, "01-start");
    QMetaObject::invokeMethod(window.findChild<StartPage*>(), "generateWanted");
    auto* generate = window.findChild<GeneratePage*>();
    if (generate->knownDomains()->count() > 0)
        generate->addDomain(generate->knownDomains()->item(0)->data(Qt::UserRole).toString());
    goOnFor();
    album.take(window, "02-generate");
    window.startNew();
    goOnFor();
    album.take(window, "03-empty-study");
    for (const char* dock : {"runs", "messages"}) window.findChild<QDockWidget*>(dock)->raise();
    goOnFor();
    album.take(window, "03-empty-study-runs");
    for (const char* dock : {"result", "traces"}) window.findChild<QDockWidget*>(dock)->raise();
    QMetaObject::invokeMethod(window.findChild<DiagramView*>(), "typed", Q_ARG(QString, "heat"));
    goOnFor();
    album.take(window, "04-insert-block");
}

/// A study with its recordings and its text. False: it did not come up.
bool takeOpened(Album& album, MainWindow& window, const QString& example) {
    window.open(example);
    Document& document = window.document();
    if (!waitUntil([&] { return !document.path().isEmpty() && document.before(); })) return false;
    goOnFor(300);
    album.take(window, "05-opened");
    if (const auto table = document.study().experiments.front().file; !table.empty())
        window.open(QString::fromStdString((document.study().directory / table).string()));
    waitUntil([&] { return window.findChild<ImportPanel*>()->acceptButton()->isEnabled(); }, 10000);
    goOnFor();
    album.take(window, "06-import");
    QMetaObject::invokeMethod(window.findChild<ImportPanel*>(), "cancelled");
    takeQuestion(album, window);
    takeComparison(album, window);
    auto* tabs = window.findChild<QTabWidget*>("centre");
    tabs->setCurrentWidget(window.findChild<TextView*>());
    goOnFor();
    album.take(window, "07-model-text");
    tabs->setCurrentWidget(window.findChild<DiagramView*>());
    auto* beside = window.findChild<QAction*>("text-beside");
    beside->trigger();
    goOnFor();
    album.take(window, "07-text-beside");
    beside->trigger();
    Q_EMIT window.findChild<MeasurementPanel*>()->valuesWanted(
        QString::fromStdString(document.study().experiments.front().name));
    goOnFor();
    album.take(window, "07-values");
    Q_EMIT window.findChild<ValuesPage*>()->left();
    return true;
}

/// A fit and a search. False: it found nothing to show.
bool takeFound(Album& album, MainWindow& window) {
    Document& document = window.document();
    window.controller().start(RunKind::Fit);
    waitUntil([&] { return !window.controller().isRunning(); });
    goOnFor();
    album.take(window, "08-fitted");
    window.controller().start(RunKind::Discover);
    waitUntil([&] { return !window.controller().isRunning(); });
    goOnFor();
    album.take(window, "09-found");
    if (!document.finding()) return false;
    takePreview(album, window);
    return true;
}

/// What was found as a part of the study, the runs, a fault, the guide.
void takeAdopted(Album& album, MainWindow& window) {
    Document& document = window.document();
    document.adoptCompleted("picture");
    const std::string added =
        document.finding()->effects.empty() ? "" : document.finding()->effects.front().wired.instance;
    waitUntil(
        [&] {  // the lists follow once the model has been analysed
            const auto& known = document.facts().parameters;
            return std::any_of(known.begin(), known.end(),
                               [&](const ParameterFact& p) { return p.name.rfind(added + ".", 0) == 0; });
        },
        60000);
    goOnFor(300);
    album.take(window, "10-added");
    window.findChild<PlotPanel*>()->residualButton()->click();
    goOnFor();
    album.take(window, "11-residual");
    window.findChild<QToolButton*>("traces-view")->click();
    window.findChild<QDockWidget*>("runs")->raise();
    window.findChild<FitPanel*>()->history()->selectAll();
    goOnFor();
    album.take(window, "12-runs");
    window.findChild<PlotPanel*>()->endComparisonButton()->click();
    const QString whole = document.modelText();
    QString broken = whole;
    document.typeText(broken.replace("connect(heater.i", "connect(heater.current"));
    goOnFor(400);
    window.findChild<QDockWidget*>("messages")->raise();
    goOnFor();
    album.take(window, "13-messages");
    document.typeText(whole);
    goOnFor(400);
    for (QAction* action : window.findChildren<QAction*>())
        if (action->shortcut() == QKeySequence(QKeySequence::HelpContents)) action->trigger();
    goOnFor(2500);  // its pictures come a moment later
    album.take(window, "14-guide");
}

/// All of it.
bool takeWork(Album& album) {
    const auto examples = findExamples();
    if (examples.empty()) return false;
    const QString example = examples.front().path;
    {
        QSettings().clear();  // what an earlier album opened is no part of this one
        album.beginAnew();
        MainWindow window;
        window.resize(1440, 900);
        window.show();
        takeBeginning(album, window);
        if (!takeOpened(album, window, example) || !takeFound(album, window)) return false;
        takeAdopted(album, window);
    }
    return takeGroup(album, example) && takeSmall(album, example) && takeComposing(album, example) &&
           takeRunning(album, examples.back().path) && takeSignals(album, example) && takeFinding(album, example) &&
           takeArrangements(album, example) && takeSweep(album, example) && takeDialogs(album, example) &&
           album.isWhole();
}

}  // namespace

bool writePictures(const QString& directory, const QString& onlyLanguage) {
    const QTemporaryDir settings, data;  // neither read nor change the user's own, nor show what a crash has left
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
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
            Album album(target, suffix, QDir(data.path()));
            isWhole = takeWork(album) && isWhole;
            QCoreApplication::removeTranslator(&translator);
        }
    return isWhole;
}

}  // namespace analogon::ui
