#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>

#include "core/export/export.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/document/document.hpp"
#include "ui/fit/run_bar.hpp"
#include "ui/fit/run_controller.hpp"
#include "ui/sensitivity/profile_dialog.hpp"
#include "ui/sensitivity/sweep_dialog.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/window/compose_actions.hpp"
#include "ui/window/main_window.hpp"

/// What the window can be asked to do: its actions with their keys, the menus, the tool bar.
namespace analogon::ui {

void MainWindow::createActions() {
    const auto make = [this](const QString& text, const QString& icon, const QKeySequence& keys, const QString& tip) {
        auto* action = new QAction(text, this);
        if (!icon.isEmpty()) action->setIcon(style::icon(icon));
        action->setShortcut(keys);
        const QString shortcut = action->shortcut().toString(QKeySequence::NativeText);
        action->setToolTip(shortcut.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, shortcut));
        addAction(action);
        return action;
    };
    newAction_ = make(tr("New"), "new", QKeySequence::New, tr("Start an empty study"));
    newAction_->setObjectName("new");
    generateAction_ = make(tr("Generate from measurement …"), {}, Qt::CTRL | Qt::Key_G,
                           tr("Compose a first model from the domains of a component and a recording"));
    openAction_ = make(tr("Open …"), "open", QKeySequence::Open, tr("Open a study file"));
    openAction_->setObjectName("open");
    openFileAction_ = make(tr("Open directory …"), {}, Qt::CTRL | Qt::SHIFT | Qt::Key_O,
                           tr("Open a study that is a directory with study.json"));
    saveAction_ = make(tr("Save"), "save", QKeySequence::Save, tr("Save the study"));
    saveAction_->setObjectName("save");
    saveAsAction_ = make(tr("Save as …"), {}, Qt::CTRL | Qt::SHIFT | Qt::Key_S, tr("Save the study as another file"));
    importAction_ =
        make(tr("Import measurement …"), "recording", Qt::CTRL | Qt::Key_I, tr("Add a recording to the study"));
    importAction_->setObjectName("import");
    reportAction_ = make(tr("Write report …"), "report", Qt::CTRL | Qt::Key_E,
                         tr("Write report, traces and the completed study into a directory"));
    reportAction_->setObjectName("report");
    reportHeadAction_ = make(tr("Head of the report …"), {}, {},
                             tr("Title, test object, author, date, logo and sections of the reports of this study"));
    reportHeadAction_->setObjectName("report-head-action");
    connect(reportHeadAction_, &QAction::triggered, this, &MainWindow::askForReport);
    exportMenu_ = new QMenu(tr("Export"), this);
    exportMenu_->setToolTipsVisible(true);
    const auto addExport = [&](ExportFormat format, const char* name, const QString& text, const QString& tip) {
        QAction* action = make(text, {}, {}, tip);
        action->setObjectName(name);
        connect(action, &QAction::triggered, this, [this, format] { askWhereToExport(format); });
        exportMenu_->addAction(action);
        return action;
    };
    addExport(ExportFormat::Fmu, "export-fmu", tr("FMU …"),
              tr("The model with its values for other simulation tools: FMI 2.0, Co-Simulation and Model Exchange"));
    addExport(ExportFormat::Modelica, "export-modelica", tr("Modelica …"),
              tr("The model with its values and the classes it uses, as one Modelica text"));
    exportTracesAction_ = addExport(ExportFormat::Csv, "export-csv", tr("CSV …"),
                                    tr("What was measured and what the model says as it stands, of every experiment"));
    exportMf4Action_ =
        addExport(ExportFormat::Mf4, "export-mf4", tr("MDF 4 …"),
                  tr("What was measured, what the model says and the difference, as groups of channels (ASAM MDF 4)"));
    addExport(ExportFormat::Parameters, "export-parameters", tr("Parameters …"),
              tr("The parameters for tools of calibration: CSV, JSON, SSV (SSP), DCM or CDFX"));
    quitAction_ = make(tr("Quit"), {}, QKeySequence::Quit, tr("Quit"));
    undoAction_ = document_->undoStack().createUndoAction(this, tr("Undo"));
    undoAction_->setIcon(style::icon("undo"));
    undoAction_->setShortcut(QKeySequence::Undo);
    redoAction_ = document_->undoStack().createRedoAction(this, tr("Redo"));
    redoAction_->setIcon(style::icon("redo"));
    undoAction_->setObjectName("undo");
    redoAction_->setObjectName("redo");
    redoAction_->setShortcuts({Qt::CTRL | Qt::SHIFT | Qt::Key_Z, Qt::CTRL | Qt::Key_Y});
    findAction_ = make(tr("Find in the study …"), {}, Qt::CTRL | Qt::SHIFT | Qt::Key_F,
                       tr("Components, parameters, signals, recordings, effects that were tried, runs and texts"));
    findAction_->setObjectName("find-in-study-action");
    connect(findAction_, &QAction::triggered, this, &MainWindow::findInStudy);
    simulateAction_ = make(tr("Simulate"), "simulate", Qt::Key_F4,
                           tr("Simulate the model: over its recordings, and by itself where sources drive it"));
    simulateAction_->setObjectName("simulate");
    practiceAction_ = make(tr("Record as measurement …"), {}, {},
                           tr("Make a recording to practise on from the simulation, with noise"));
    practiceAction_->setObjectName("practice");
    connect(practiceAction_, &QAction::triggered, this, &MainWindow::askForPractice);
    fitAction_ = make(tr("Fit"), "fit", Qt::Key_F5, tr("Estimate the checked parameters"));
    fitAction_->setObjectName("fit");
    discoverAction_ =
        make(tr("Discover"), "discover", Qt::Key_F6, tr("Fit, find the effect that the model lacks, add it and refit"));
    discoverAction_->setObjectName("discover");
    longerAction_ =
        make(tr("Search ten times as long"), {}, {}, tr("Discover again, with ten times the work that it had"));
    longerAction_->setObjectName("search-longer");
    connect(longerAction_, &QAction::triggered, controller_, &RunController::searchLonger);
    fitTip_ = fitAction_->toolTip();
    discoverTip_ = discoverAction_->toolTip();
    whyNoRunAction_ = new QAction(this);  // the keys of both, while they wait for something
    whyNoRunAction_->setShortcuts({Qt::Key_F5, Qt::Key_F6});
    addAction(whyNoRunAction_);
    connect(whyNoRunAction_, &QAction::triggered, this, &MainWindow::explainNoRun);
    recordingsAction_ = make(tr("Table of recordings"), {}, Qt::CTRL | Qt::SHIFT | Qt::Key_R,
                             tr("All recordings as a table: sort them, edit role and weight, fit some of them alone"));
    recordingsAction_->setObjectName("recordings");
    connect(recordingsAction_, &QAction::triggered, this, &MainWindow::showRecordings);
    sensitivityAction_ =
        make(tr("Sensitivities and correlations"), {}, Qt::CTRL | Qt::SHIFT | Qt::Key_K,
             tr("How far each trace moves with each parameter, and which parameters the recordings tell hardly apart"));
    sensitivityAction_->setObjectName("sensitivity");
    connect(sensitivityAction_, &QAction::triggered, this, &MainWindow::showSensitivity);
    textBesideAction_ = make(tr("Model text beside the diagram"), {}, Qt::CTRL | Qt::Key_T,
                             tr("Diagram and text side by side: what is changed in one is seen in the other"));
    textBesideAction_->setObjectName("text-beside");
    textBesideAction_->setCheckable(true);
    fitViewAction_ = make(tr("Show all"), "fit-view", {}, tr("Show the whole diagram (Space)"));

    connect(newAction_, &QAction::triggered, this, [this] { leaveThen([this] { startNew(); }); });
    connect(generateAction_, &QAction::triggered, this, &MainWindow::showGenerate);
    connect(openAction_, &QAction::triggered, this, [this] { askForStudy(false); });
    connect(openFileAction_, &QAction::triggered, this, [this] { askForStudy(true); });
    connect(saveAction_, &QAction::triggered, this, &MainWindow::save);
    connect(saveAsAction_, &QAction::triggered, this, &MainWindow::askWhereToSave);
    connect(importAction_, &QAction::triggered, this, &MainWindow::askForMeasurement);
    connect(reportAction_, &QAction::triggered, this, &MainWindow::askForReport);
    connect(quitAction_, &QAction::triggered, this, &QWidget::close);
    for (const auto& [action, kind] :
         {std::pair(simulateAction_, RunKind::Simulate), std::pair(fitAction_, RunKind::Fit),
          std::pair(discoverAction_, RunKind::Discover)})
        connect(action, &QAction::triggered, this, [this, kind = kind] {
            settle();
            controller_->start(kind);
        });
    connect(fitViewAction_, &QAction::triggered, view_, &DiagramView::fitView);
    connect(textBesideAction_, &QAction::toggled, this, &MainWindow::setTextBeside);
    textBesideAction_->setChecked(settings_.value("window/text-beside").toBool());
}

void MainWindow::createMenus() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    file->addActions({newAction_, generateAction_, openAction_, openFileAction_});
    recentMenu_ = file->addMenu(tr("Open recent"));
    connect(recentMenu_, &QMenu::aboutToShow, this, &MainWindow::showRecent);
    file->addSeparator();
    file->addActions({saveAction_, saveAsAction_});
    file->addSeparator();
    file->addActions({importAction_, reportAction_, reportHeadAction_});
    file->addMenu(exportMenu_);
    file->addSeparator();
    file->addAction(quitAction_);
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    edit->addActions({undoAction_, redoAction_});
    edit->addSeparator();
    edit->addAction(findAction_);
    edit->addSeparator();
    compose_->fill(*edit);
    QMenu* run = menuBar()->addMenu(tr("&Run"));
    run->addActions({simulateAction_, fitAction_, discoverAction_, longerAction_});
    run->addSeparator();
    run->addAction(practiceAction_);
    run->addAction(sensitivityAction_);
    QAction* sweep = run->addAction(tr("Sweep of parameters …"), Qt::CTRL | Qt::SHIFT | Qt::Key_W, this, [this] {
        if (document_->isOpen()) (new SweepDialog(*document_, this))->show();
    });
    sweep->setObjectName("sweep");
    sweep->setToolTip(tr("The error over one parameter as a curve, over two as a map"));
    QAction* profile =
        run->addAction(tr("Profile of the likelihood …"), Qt::CTRL | Qt::SHIFT | Qt::Key_L, this, [this] {
            if (document_->isOpen()) (new ProfileDialog(*document_, this))->show();
        });
    profile->setObjectName("profile");
    profile->setToolTip(tr("How far a fitted parameter may be from its estimate, all others fitted anew"));
    QAction* campaign =
        run->addAction(tr("Campaign …"), Qt::CTRL | Qt::SHIFT | Qt::Key_B, this, [this] { showCampaign({}); });
    campaign->setObjectName("campaign-action");
    campaign->setToolTip(tr("One study for a whole series of units: started, watched, and each unit's study opened"));
    run->setToolTipsVisible(true);  // they say what a run waits for
    QMenu* view = menuBar()->addMenu(tr("&View"));
    view->addActions({fitViewAction_, textBesideAction_, recordingsAction_});
    view->addSeparator();
    for (QDockWidget* dock : docks()) view->addAction(dock->toggleViewAction());
    addArrangements(view);
    view->addAction(tr("Reset layout"), this, &MainWindow::resetLayout);
    addPanelKeys(view->addMenu(tr("Go to")));
    view->addSeparator();
    addLanguages(view);
    QMenu* theme = view->addMenu(tr("Theme"));
    auto* group = new QActionGroup(this);
    QMenu* help = menuBar()->addMenu(tr("&Help"));
    QAction* guide = help->addAction(tr("User guide"), this, &MainWindow::showGuide);
    guide->setShortcut(QKeySequence::HelpContents);
    const QStringList names{tr("As the desktop"), tr("Light"), tr("Dark")};
    for (int i = 0; i < names.size(); ++i) {
        QAction* action = theme->addAction(names[i], this, [this, i] { setTheme(i); });
        action->setCheckable(true);
        action->setChecked(i == static_cast<int>(style::current()));
        group->addAction(action);
    }
}

/// Ctrl and a digit lead to each panel, so that the mouse is not needed to get there.
void MainWindow::addPanelKeys(QMenu* menu) {
    const auto add = [&](int digit, const QString& name, std::function<void()> show, QWidget* panel) {
        QAction* action = menu->addAction(name, this, [show = std::move(show), panel] {
            show();
            QWidget* first = panel;  // the first place in it that takes keys
            while (first->focusPolicy() == Qt::NoFocus || !first->isVisibleTo(panel)) {
                first = first->nextInFocusChain();
                if (first == panel || !panel->isAncestorOf(first)) return panel->setFocus(Qt::ShortcutFocusReason);
            }
            first->setFocus(Qt::ShortcutFocusReason);
        });
        action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_0 + digit)));
    };
    add(
        0, tr("Diagram"),
        [this] {
            if (document_->isOpen()) showDiagram();
        },
        view_);
    int digit = 1;
    for (QDockWidget* dock : docks())
        add(
            digit++, dock->windowTitle(),
            [this, dock] {
                if (!document_->isOpen()) return;
                dock->show();
                dock->raise();
            },
            dock->widget());
}

/// Takes effect at the next start: every text of the window is made once.
void MainWindow::addLanguages(QMenu* view) {
    QMenu* menu = view->addMenu(tr("Language"));
    auto* group = new QActionGroup(this);
    const QString now = style::windowLocale().name().left(2);  // as it is shown, whoever asked for it
    const std::pair<QString, QString> names[] = {{"en", QStringLiteral("English")}, {"de", QStringLiteral("Deutsch")}};
    for (const auto& [code, name] : names) {
        QAction* action = menu->addAction(name, this, [this, code = code] {
            settings_.setValue("window/language", code);
            statusBar()->showMessage(tr("The language changes at the next start."), 8000);
        });
        action->setCheckable(true);
        action->setChecked(code == now);
        group->addAction(action);
    }
}

void MainWindow::createToolBar() {
    QToolBar* bar = addToolBar(tr("Main"));
    bar->setObjectName("main");
    bar->setMovable(false);
    bar->setIconSize({20, 20});
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar->setContentsMargins(style::unit, 0, style::unit, 0);
    bar->addAction(newAction_);
    bar->addAction(openAction_);
    bar->addAction(saveAction_);
    for (QAction* a : {newAction_, saveAction_})
        if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(a)))
            button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    bar->addSeparator();
    bar->addAction(importAction_);
    if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(importAction_)))
        button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    bar->addSeparator();
    bar->addAction(undoAction_);
    bar->addAction(redoAction_);
    for (QAction* a : {undoAction_, redoAction_})
        if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(a)))
            button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    bar->addSeparator();
    bar->addAction(simulateAction_);
    if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(simulateAction_)))
        button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    bar->addAction(fitAction_);
    bar->addAction(discoverAction_);
    bar->addSeparator();
    bar->addAction(fitViewAction_);
    runBar_ = new RunBar(*controller_, bar);
    bar->addWidget(runBar_);
    addToolBarBreak();
    recoveredBar_ = addToolBar(tr("Recovered work"));
    recoveredBar_->setObjectName("recovered");
    recoveredBar_->setMovable(false);
    recoveredBar_->toggleViewAction()->setVisible(false);
    statusBar()->setSizeGripEnabled(false);
    whyNoRun_ = new QToolButton(this);
    whyNoRun_->setObjectName("why-no-run");
    whyNoRun_->setAutoRaise(true);
    whyNoRun_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    whyNoRun_->setFixedHeight(fontMetrics().height() + 2);  // the bar keeps its height
    whyNoRun_->hide();
    connect(whyNoRun_, &QToolButton::clicked, this, &MainWindow::explainNoRun);
    statusBar()->addPermanentWidget(whyNoRun_);
}

}  // namespace analogon::ui
