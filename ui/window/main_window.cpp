#include "ui/window/main_window.hpp"

#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QLocale>
#include <QMenuBar>
#include <QScreen>
#include <QSplitter>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTabWidget>
#include <QTableView>
#include <QTextBrowser>
#include <QToolBar>
#include <QToolButton>

#include "core/export/export.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/document/document.hpp"
#include "ui/document/mention.hpp"
#include "ui/document/recovery.hpp"
#include "ui/document/unfinished.hpp"
#include "ui/effect/finding_words.hpp"
#include "ui/effect/result_panel.hpp"
#include "ui/fit/fit_panel.hpp"
#include "ui/fit/run_bar.hpp"
#include "ui/fit/run_controller.hpp"
#include "ui/inspector/parameter_model.hpp"
#include "ui/inspector/parameter_panel.hpp"
#include "ui/job/job.hpp"
#include "ui/library/library_panel.hpp"
#include "ui/measurement/compare_page.hpp"
#include "ui/measurement/import_panel.hpp"
#include "ui/measurement/measurement_panel.hpp"
#include "ui/measurement/recordings_page.hpp"
#include "ui/measurement/values_page.hpp"
#include "ui/messages/message_panel.hpp"
#include "ui/plot/plot_panel.hpp"
#include "ui/sensitivity/sensitivity_page.hpp"
#include "ui/signals/plot_area.hpp"
#include "ui/signals/signal_browser.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/text/text_view.hpp"
#include "ui/window/block_marks.hpp"
#include "ui/window/breadcrumb.hpp"
#include "ui/window/compose_actions.hpp"
#include "ui/window/generate_page.hpp"
#include "ui/window/guide_page.hpp"
#include "ui/window/recovered_line.hpp"
#include "ui/window/start_page.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

/// Where the user put the borders within panels stays over the next start.
void keepSplitters(const QWidget& window, Settings& settings, const QSplitter* other) {
    for (QSplitter* const splitter : window.findChildren<QSplitter*>()) {
        if (splitter->objectName().isEmpty() || splitter == other) continue;
        const QString key = QStringLiteral("window/splitter/") + splitter->objectName();
        splitter->restoreState(settings.value(key).toByteArray());
        QObject::connect(splitter, &QSplitter::splitterMoved, splitter,
                         [&settings, splitter, key] { settings.setValue(key, splitter->saveState()); });
    }
}

QString whyFailed(const Document& document) {
    for (const Message& message : document.messages())
        if (message.origin == Message::Origin::Run && message.diagnostic.severity == Severity::Error)
            return inWords(message.diagnostic.message);
    return MainWindow::tr("see the messages");
}

}  // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      document_(new Document(this)),
      controller_(new RunController(*document_, this)),
      writer_(new JobRunner(this)),
      exporter_(new JobRunner(this)),
      locator_(new JobRunner(this)),
      recovery_(new Recovery(*document_, this)) {
    setAcceptDrops(true);
    qApp->installEventFilter(this);  // files may be dropped anywhere
    setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setDocumentMode(true);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    createPanels();
    createActions();
    createMenus();
    createToolBar();
    connectPanels();
    resize(QSize(1440, 900).boundedTo(screen()->availableSize()));
    arrangeDocks();
    keepSplitters(*this, settings_, both_);
    restoreLayout();
    showStudy();
}

MainWindow::~MainWindow() = default;

void MainWindow::createPanels() {
    scene_ = new DiagramScene(this);
    view_ = new DiagramView(*scene_);
    new Breadcrumb(*document_, *view_);
    text_ = new TextView(*document_);
    centre_ = new QTabWidget;
    centre_->setObjectName("centre");
    centre_->setDocumentMode(true);
    centre_->addTab(view_, tr("Diagram"));
    centre_->addTab(text_, tr("Model text"));
    both_ = new QSplitter(Qt::Horizontal, this);
    both_->setObjectName("diagram-and-text");
    both_->setChildrenCollapsible(false);
    both_->hide();
    connect(both_, &QSplitter::splitterMoved, this,
            [this] { settings_.setValue("window/text-beside-sizes", both_->saveState()); });
    start_ = new StartPage(findExamples());
    pages_ = new QStackedWidget(this);
    pages_->addWidget(start_);
    pages_->addWidget(centre_);
    generate_ = new GeneratePage(this);
    pages_->addWidget(generate_);
    pages_->setMinimumSize(320, 160);  // the user decides how narrow the middle may be
    setCentralWidget(pages_);

    measurements_ = new MeasurementPanel(*document_);
    parameters_ = new ParameterPanel(*document_);
    results_ = new ResultPanel(*document_);
    plots_ = new PlotPanel(*document_);
    messages_ = new MessagePanel(*document_);
    signals_ = new SignalBrowser(*document_);
    signalPlots_ = new PlotArea(*document_);
    import_ = new ImportPanel(*document_, this);
    import_->hide();
    values_ = new ValuesPage(*document_, this);
    values_->hide();
    comparison_ = new ComparePage(*document_, this);
    comparison_->hide();
    recordings_ = new RecordingsPage(*document_, this);
    recordings_->hide();
    library_ = new LibraryPanel(*document_);
    compose_ = new ComposeActions(*document_, *scene_, *view_, *library_, this);
    libraryDock_ = addDock("library", tr("Library"), library_, Qt::LeftDockWidgetArea);
    measurementDock_ = addDock("measurements", tr("Measurements"), measurements_, Qt::LeftDockWidgetArea);
    parameterDock_ = addDock("parameters", tr("Parameters"), parameters_, Qt::RightDockWidgetArea);
    resultDock_ = addDock("result", tr("Result"), results_, Qt::RightDockWidgetArea);
    runs_ = new FitPanel(*document_, *controller_);
    runDock_ = addDock("runs", tr("Runs"), runs_, Qt::RightDockWidgetArea);
    plotDock_ = addDock("traces", tr("Measured and simulated"), plots_, Qt::BottomDockWidgetArea);
    messageDock_ = addDock("messages", tr("Messages"), messages_, Qt::BottomDockWidgetArea);
    signalDock_ = addDock("signals", tr("Signals"), signals_, Qt::LeftDockWidgetArea);
    signalPlotDock_ = addDock("plots", tr("Plots"), signalPlots_, Qt::BottomDockWidgetArea);
    connect(signals_, &SignalBrowser::wanted, this, [this](const std::vector<SignalRef>& references) {
        signalPlots_->show(references);
        signalPlotDock_->show();
        signalPlotDock_->raise();
    });
}

void MainWindow::connectPanels() {
    connect(document_, &Document::opened, this, [this] {
        waitingImports_.clear();  // they were dropped on another study
        showStudy();
    });
    connect(document_, &Document::modelChanged, this, &MainWindow::showModel);
    connect(document_, &Document::levelsChanged, this, [this] {
        scene_->clearSelection();
        showModel();
        view_->fitView();
        view_->setFocus();
    });
    connect(document_, &Document::resultChanged, this, [this] {
        showEffects();
        view_->refitIfHidden();
        updateActions();
        if (document_->finding() && document_->resultKind() != RunKind::Simulate) resultDock_->raise();
        const bool hasError = std::any_of(document_->messages().begin(), document_->messages().end(),
                                          [](const Message& m) { return m.diagnostic.severity == Severity::Error; });
        if (!hasError && (document_->before() || document_->after())) plotDock_->raise();
    });
    connect(document_, &Document::comparisonChanged, this, [this] {
        if (document_->comparedRuns()) plotDock_->raise();
    });
    connect(document_, &Document::readingChanged, this, [this] {
        if (document_->isReading())
            statusBar()->showMessage(tr("Reading the study …"));
        else
            statusBar()->clearMessage();
        updateActions();
    });
    connect(document_, &Document::messagesChanged, this, [this] {
        if (document_->isOpen() || document_->messages().empty()) return;
        const Diagnostic& fault = document_->messages().front().diagnostic;
        QString text = QString::fromStdString(fault.place.file);
        if (fault.place.line > 0) text += QStringLiteral(":%1").arg(fault.place.line);
        if (!text.isEmpty()) text += QStringLiteral(": ");
        text += inWords(fault.message);
        if (!fault.hint.empty()) text += "\n" + inWords(fault.hint);
        start_->showFault(text);
    });
    connect(document_, &Document::messagesChanged, this, &MainWindow::updateActions);
    connect(document_, &Document::parametersChanged, this, &MainWindow::updateActions);  // a result may be stale
    for (const auto changed : {&Document::parametersChanged, &Document::factsChanged, &Document::experimentsChanged})
        connect(document_, changed, this, &MainWindow::showEffects);
    connect(document_, &Document::resultChanged, this, &MainWindow::updateActions);
    connect(document_, &Document::modifiedChanged, this, &MainWindow::updateTitle);
    connect(document_, &Document::experimentsChanged, this, &MainWindow::updateActions);
    connect(document_, &Document::saved, this, [this](bool isDone) {
        statusBar()->showMessage(isDone ? tr("Saved to %1.").arg(document_->path())
                                        : tr("Not saved: %1").arg(whyFailed(*document_)));
        if (isDone) rememberRecent(document_->path());
        const auto next = std::exchange(afterSave_, nullptr);
        if (isDone && next) next();
    });
    connect(recovery_, &Recovery::notKept, this, [this](const Diagnostic& fault) {
        statusBar()->showMessage(tr("No copy of the unsaved work can be kept: %1").arg(inWords(fault.message)));
    });
    connect(plots_, &PlotPanel::told, this, [this](const QString& s) { statusBar()->showMessage(s, 8000); });
    connect(compose_, &ComposeActions::told, this, [this](const QString& s) { statusBar()->showMessage(s, 8000); });
    connect(compose_, &ComposeActions::pictureWanted, this, &MainWindow::askForPicture);
    connect(compose_, &ComposeActions::inspectWanted, this, &MainWindow::inspect);
    connect(controller_, &RunController::runningChanged, this, [this] {
        if (controller_->isRunning()) {
            statusBar()->clearMessage();
            runDock_->raise();
        }
        updateActions();
    });
    connect(controller_, &RunController::concluded, statusBar(),
            [this](const QString& s) { statusBar()->showMessage(s); });
    connect(controller_, &RunController::parametersWanted, this, [this] {
        scene_->clearSelection();  // those of every block
        parameterDock_->show();
        parameterDock_->raise();
        parameters_->table()->setFocus();
    });
    // The guide is read over the whole height, and so are the sensitivities.
    connect(centre_, &QTabWidget::currentChanged, this, [this] {
        const QWidget* const page = centre_->currentWidget();
        const bool isReading = page && (page == guide_ || page == sensitivity_);
        if (isReading == isReadingGuide_) return;
        isReadingGuide_ = isReading;
        if (isReading) besideGuide_.clear();
        for (QDockWidget* dock : {plotDock_, messageDock_, signalPlotDock_})
            if (isReading && !dock->isHidden() && !dock->isFloating()) besideGuide_ << dock;
        for (QDockWidget* dock : besideGuide_) dock->setVisible(!isReading);
        if (!isReading && besideGuide_.contains(plotDock_)) plotDock_->raise();
    });
    connect(measurements_, &MeasurementPanel::experimentChosen, plots_, &PlotPanel::showExperiment);
    connect(view_, &DiagramView::staleClicked, this, &MainWindow::showFault);
    connect(scene_, &DiagramScene::blockSelected, this,
            [this](const QString& block) { parameters_->showComponent(wholeName(block)); });
    connect(parameters_, &ParameterPanel::componentCleared, scene_, &QGraphicsScene::clearSelection);
    connect(results_, &ResultPanel::effectChosen, this, [this](const QString& instance) {
        showMention({Mention::Kind::Block, instance});
    });
    connect(results_, &ResultPanel::mentionChosen, this, &MainWindow::showMention);
    connect(parameters_, &ParameterPanel::mentionChosen, this, &MainWindow::showMention);
    connect(results_, &ResultPanel::trialWanted, this, [this](const EffectChoice& choice) {
        if (document_->canRun()) controller_->tryEffect(choice);
    });
    connect(results_, &ResultPanel::longerSearchWanted, controller_, &RunController::searchLonger);
    connect(results_, &ResultPanel::placePointedAt, this,
            [this](const QString& place) { scene_->pointOut(place.toStdString()); });
    connect(results_, &ResultPanel::effectLookedAt, controller_, &RunController::lookAtEffect);
    connect(results_, &ResultPanel::effectLeft, controller_, &RunController::leaveEffect);
    connect(messages_, &MessagePanel::placeChosen, this, &MainWindow::showPlace);
    connect(messages_, &MessagePanel::mentionChosen, this, &MainWindow::showMention);
    connect(messages_, &MessagePanel::countChanged, this, [this](int errors, int others) {
        const int count = errors + others;
        const QString title = count > 0 ? tr("Messages (%1)").arg(count) : tr("Messages");
        messageDock_->setWindowTitle(title);
        if (auto* label = qobject_cast<QLabel*>(messageDock_->titleBarWidget())) label->setText(title);
        if (errors > 0) messageDock_->raise();
    });
    connect(measurements_, &MeasurementPanel::importWanted, this, &MainWindow::importMeasurement);
    connect(measurements_, &MeasurementPanel::browseWanted, this, &MainWindow::askForMeasurement);
    connect(measurements_, &MeasurementPanel::valuesWanted, this, &MainWindow::showValues);
    connect(measurements_, &MeasurementPanel::locateWanted, this, &MainWindow::askWhereItIs);
    connect(values_, &ValuesPage::left, this, &MainWindow::leaveValues);
    connect(measurements_, &MeasurementPanel::comparisonWanted, this, &MainWindow::showComparison);
    connect(comparison_, &ComparePage::left, this, &MainWindow::leaveComparison);
    connectRecordings();
    connect(import_, &ImportPanel::cancelled, this, &MainWindow::leaveImport);
    connect(import_, &ImportPanel::accepted, this, [this](const QString& experiment) {
        plots_->showExperiment(experiment);
        leaveImport();
    });
    connect(start_, &StartPage::openWanted, openAction_, &QAction::trigger);
    connect(start_, &StartPage::exampleChosen, this, &MainWindow::open);
    connect(start_, &StartPage::generateWanted, this, &MainWindow::showGenerate);
    connect(generate_, &GeneratePage::cancelled, this, &MainWindow::showStudy);
    connect(generate_, &GeneratePage::recordingsWanted, this, &MainWindow::askForRecordings);
    connect(generate_, &GeneratePage::generated, this, [this](const GeneratedStudy& made) {
        leaveThen([this, made] {
            Diagnostics assumed;
            for (const Text& text : made.assumptions) {
                Diagnostic note = warning(text);
                note.severity = Severity::Note;
                assumed.push_back(std::move(note));
            }
            document_->startWith(made.study, std::move(assumed));
        });
    });
    connect(start_, &StartPage::newWanted, this, &MainWindow::startNew);
    connect(start_, &StartPage::recoveryChosen, this, &MainWindow::openRecovered);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    settle();
    if (document_->isOpen() && areDocksShown_) {  // the start page hides the docks: nothing worth remembering
        settings_.setValue("window/geometry", saveGeometry());
        settings_.setValue(layoutKey(), saveState(layoutVersion));
        settings_.setValue("window/arrangement", arrangement_);
    }
    if (document_->isModified() && !mayClose_) {
        event->ignore();
        return leaveThen([this] {
            mayClose_ = true;
            close();
        });
    }
    controller_->cancel();
    recovery_->clear();
    QMainWindow::closeEvent(event);
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && scene_) scene_->update();
}

void MainWindow::setTheme(int theme) {
    style::apply(*qApp, static_cast<style::Theme>(theme));
    settings_.setValue("window/theme", theme);
}

void MainWindow::showGenerate() {
    generate_->clear();
    setDocksShown(false);
    pages_->setCurrentWidget(generate_);
}

/// The same key again leads back to the work, and to where the keys went.
void MainWindow::showGuide() {
    if (!guide_) {
        guide_ = new GuidePage(this);
        connect(guide_, &GuidePage::left, this, [this] {
            if (!document_->isOpen() || centre_->indexOf(guide_) < 0) return showStudy();
            const GuidePage::Before before = guide_->before();
            centre_->removeTab(centre_->indexOf(guide_));
            if (before.page && centre_->indexOf(before.page) >= 0) centre_->setCurrentWidget(before.page);
            QWidget* const keys = before.focus && before.focus->isVisible() ? before.focus.data() : view_;
            keys->setFocus(Qt::OtherFocusReason);
        });
    }
    if (guide_->isVisible()) return Q_EMIT guide_->left();
    if (document_->isOpen()) {
        if (centre_->indexOf(guide_) < 0) {
            guide_->comeFrom({centre_->currentWidget(), QApplication::focusWidget()});
            centre_->addTab(guide_, tr("Guide"));
        }
        centre_->setCurrentWidget(guide_);
    } else {
        pages_->addWidget(guide_);
        pages_->setCurrentWidget(guide_);
    }
    guide_->browser()->setFocus(Qt::OtherFocusReason);
}

void MainWindow::startNew() { document_->startNew(tr("Untitled")); }

void MainWindow::showStudy() {
    const bool isOpen = document_->isOpen();
    pages_->setCurrentWidget(isOpen ? static_cast<QWidget*>(centre_) : start_);
    if (isOpen && isLayoutFresh_ && isSmall() != isCompact_) arrangeDocks();
    setDocksShown(isOpen);
    if (isOpen) {
        if (!document_->definition()) scene_->show({});  // nothing of the study before
        if (isLayoutFresh_) {
            sizeDocks();
            plotDock_->raise();
        }
        start_->showFault({});
        rememberRecent(document_->path());
        statusBar()->clearMessage();
        scene_->clearSelection();
        parameters_->showComponent({});
    }
    updateTitle();
    updateActions();
    offerRecovered();
    if (!isOpen) start_->showWork(settings_.value("window/recent").toStringList(), Recovery::abandoned());
    if (isOpen) {
        view_->setFocus();                                    // its keys work at once
        QTimer::singleShot(0, view_, &DiagramView::fitView);  // once the docks have their sizes
    }
}

/// Over a study that is open; the start page offers what there is by itself.
void MainWindow::offerRecovered() {
    recoveredBar_->clear();
    const std::vector<Recovered> left = document_->isOpen() ? Recovery::abandoned() : std::vector<Recovered>();
    for (const Recovered& recovered : left) {
        if (recovered.file == document_->recoveredFrom()) continue;
        auto* line = new RecoveredLine(recovered, recoveredBar_);
        connect(line, &RecoveredLine::chosen, this, &MainWindow::openRecovered);
        connect(line, &RecoveredLine::discarded, this, &MainWindow::offerRecovered, Qt::QueuedConnection);
        recoveredBar_->addWidget(line);
        break;  // the latest; the next one once this is settled
    }
    recoveredBar_->setVisible(!recoveredBar_->actions().isEmpty());
}

void MainWindow::openRecovered(const Recovered& recovered) {
    leaveThen([this, recovered] { document_->openRecovered(recovered.file, recovered.path); });
}

void MainWindow::showDiagram() {
    centre_->setCurrentWidget(view_->parentWidget() == both_ ? both_ : static_cast<QWidget*>(view_));
}

void MainWindow::showText() {
    centre_->setCurrentWidget(text_->parentWidget() == both_ ? both_ : static_cast<QWidget*>(text_));
}

/// Each on a tab of its own, or both on one, with the border between them where it was last.
void MainWindow::setTextBeside(bool isBeside) {
    settings_.setValue("window/text-beside", isBeside);
    const QWidget* const shown = centre_->currentWidget();
    const bool wasModel = shown == view_ || shown == text_ || shown == both_;
    for (QWidget* page : std::initializer_list<QWidget*>{view_, text_, both_})
        if (const int tab = centre_->indexOf(page); tab >= 0) centre_->removeTab(tab);
    if (isBeside) {
        both_->addWidget(view_);
        both_->addWidget(text_);
        for (QWidget* part : std::initializer_list<QWidget*>{view_, text_}) part->show();
        centre_->insertTab(0, both_, tr("Diagram and text"));
        if (!both_->restoreState(settings_.value("window/text-beside-sizes").toByteArray())) both_->setSizes({3, 2});
    } else {
        both_->hide();
        centre_->insertTab(0, view_, tr("Diagram"));
        centre_->insertTab(1, text_, tr("Model text"));
    }
    if (wasModel) showDiagram();
    QTimer::singleShot(0, view_, &DiagramView::fitView);  // once it has its size
}

/// While the text has a fault, the diagram of the last sound one stays in sight.
void MainWindow::showModel() {
    const bool isSound = document_->definition();
    view_->setStale(isSound || !document_->isOpen()
                        ? QString()
                        : tr("The text has a fault: this is the model as it was before. A click shows the fault."));
    if (!isSound) return;
    scene_->show(document_->diagram(), ownGraphics(*document_->definition()));
    showEffects();
}

/// The name a block of the diagram shown has in the whole model; within a component, that component while none is
/// named.
QString MainWindow::wholeName(const QString& block) const {
    QStringList parts;
    for (const std::string& level : document_->levels()) parts << QString::fromStdString(level);
    if (!block.isEmpty()) parts << block;
    return parts.join('.');
}

void MainWindow::showEffects() {
    std::vector<EffectMark> marks;
    if (const Finding* finding = document_->finding(); finding && document_->levels().empty())
        for (const AddedEffect& effect : finding->effects) {
            const Block* block = document_->diagram().find(effect.wired.instance);
            // Taken back by undo, a component may still be there, but with its old class.
            if (block && (block->className == effect.className || block->isEffect))
                marks.push_back({effect.wired.instance, effectName(effect)});
        }
    scene_->mark(marks, blockMarks(*document_));
}

void MainWindow::showPlace(const Place& place) {
    if (place.line <= 0 || !document_->isOpen()) return;
    const QString file = QFileInfo(QString::fromStdString(place.file)).fileName();
    for (const StudyExperiment& e : document_->study().experiments) {
        const std::filesystem::path table = document_->study().directory / e.file;
        if (QString::fromStdString(table.filename().string()) != file || !std::filesystem::exists(table)) continue;
        importMeasurement(QString::fromStdString(table.string()));
        return import_->pointAt(place.line);
    }
    if (file != QString::fromStdString(document_->study().modelFile))
        return statusBar()->showMessage(tr("%1 is a file of its own: open it in an editor.").arg(file), 8000);
    showText();
    text_->showPlace(place.line, place.column, place.length);
}

void MainWindow::showMention(const Mention& mention) {
    const auto raise = [](QDockWidget* dock) {
        dock->show();
        dock->raise();
    };
    switch (mention.kind) {
        case Mention::Kind::Experiment:
            raise(plotDock_);
            return plots_->showExperiment(mention.name);
        case Mention::Kind::Parameter:
            scene_->clearSelection();  // those of every block
            raise(parameterDock_);
            return parameters_->pointAt(mention.name);
        case Mention::Kind::Block:
            break;
    }
    const std::string name = mention.name.toStdString();
    showDiagram();
    document_->leaveTo(0);
    scene_->select(name);
    scene_->pointOut(scene_->block(name) ? std::string() : name);
}

/// The place in the text where it stops being a model.
void MainWindow::showFault() {
    for (const Message& message : document_->messages())
        if (message.origin == Message::Origin::Model && message.diagnostic.severity == Severity::Error)
            return showPlace(message.diagnostic.place);
}

/// What a run waits for; empty: for nothing.
QString MainWindow::whyNoRun() const {
    if (!document_->isOpen()) return tr("Open a study first.");
    if (const Diagnostic* error = document_->modelError())
        return (isUnfinished(*error) ? tr("The model is not finished: %1") : tr("The model has an error: %1"))
            .arg(inWords(error->message));
    if (!document_->canRun()) return tr("Import a measurement first, and map a column of it to an output.");
    return {};
}

/// Where the reason is an error, to its message.
void MainWindow::explainNoRun() {
    statusBar()->showMessage(whyNoRun(), 8000);
    if (!document_->modelError()) return;
    messageDock_->show();
    messageDock_->raise();
    messages_->pointAtError();
}

void MainWindow::updateActions() {
    const bool isReady = document_->canRun() && !controller_->isRunning() && !document_->isReading();
    const bool isBusy = controller_->isRunning() || document_->isReading();
    const QString why = isBusy ? QString() : whyNoRun();
    for (const auto& [action, tip] : {std::pair(fitAction_, &fitTip_), std::pair(discoverAction_, &discoverTip_)}) {
        action->setEnabled(!isBusy && why.isEmpty());
        action->setToolTip(why.isEmpty() ? *tip : *tip + "\n" + why);
    }
    longerAction_->setVisible(controller_->canSearchLonger());
    longerAction_->setEnabled(!isBusy);
    simulateAction_->setEnabled(document_->isOpen() && !isBusy);
    practiceAction_->setEnabled(document_->isOpen() && document_->isSimulated() && !isBusy);
    whyNoRunAction_->setEnabled(!why.isEmpty());
    whyNoRun_->setVisible(document_->isOpen() && document_->modelError());
    const bool isOpenYet = document_->modelError() && isUnfinished(*document_->modelError());
    whyNoRun_->setIcon(style::icon(isOpenYet ? "note" : "error"));
    whyNoRun_->setText(isOpenYet ? tr("Not connected yet: no run") : tr("Error in the model: no run"));
    whyNoRun_->setToolTip(why);
    for (QAction* a : {saveAction_, saveAsAction_, importAction_, recordingsAction_, sensitivityAction_,
                       reportHeadAction_, findAction_})
        a->setEnabled(document_->isOpen());
    reportAction_->setEnabled(isReady && document_->result());
    const bool isShown = document_->isOpen() && !document_->isReading();
    exportMenu_->menuAction()->setEnabled(isShown);
    for (QAction* action : exportMenu_->actions()) action->setEnabled(isShown);
    for (QAction* const traces : {exportTracesAction_, exportMf4Action_})
        traces->setEnabled(isShown && document_->canRun());
    fitViewAction_->setEnabled(document_->isOpen());
}

void MainWindow::updateTitle() {
    setWindowTitle(document_->isOpen() ? document_->title() + "[*] – Analogon" : QStringLiteral("Analogon"));
    setWindowModified(document_->isModified());
}

}  // namespace analogon::ui
