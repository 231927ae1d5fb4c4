#include <QApplication>
#include <QDesktopServices>
#include <QDir>
#include <QDockWidget>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPointer>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTabWidget>
#include <QTableWidget>
#include <QToolButton>
#include <QUrl>
#include <algorithm>

#include "core/campaign/campaign_look.hpp"
#include "core/export/export.hpp"
#include "core/study/report_settings.hpp"
#include "core/study/results.hpp"
#include "ui/campaign/campaign_window.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/document/document.hpp"
#include "ui/document/mention.hpp"
#include "ui/effect/report_pdf.hpp"
#include "ui/effect/report_top.hpp"
#include "ui/fit/run_controller.hpp"
#include "ui/job/job.hpp"
#include "ui/measurement/compare_page.hpp"
#include "ui/measurement/import_panel.hpp"
#include "ui/measurement/locate.hpp"
#include "ui/measurement/measurement_panel.hpp"
#include "ui/measurement/practice_dialog.hpp"
#include "ui/measurement/recordings_page.hpp"
#include "ui/measurement/values_page.hpp"
#include "ui/plot/plot_panel.hpp"
#include "ui/sensitivity/sensitivity_page.hpp"
#include "ui/style/style.hpp"
#include "ui/window/generate_page.hpp"
#include "ui/window/main_window.hpp"
#include "ui/window/report_dialog.hpp"
#include "ui/window/report_folder.hpp"
#include "ui/window/start_page.hpp"

/// The window's dealings with files: opening, saving, importing, reporting.
namespace analogon::ui {

namespace {

QStringList filesOf(const QMimeData* data) {
    QStringList files;
    for (const QUrl& url : data ? data->urls() : QList<QUrl>())
        if (url.isLocalFile()) files << url.toLocalFile();
    return files;
}

bool isStudy(const QString& path) {
    const QFileInfo file(path);
    return file.isDir() || file.suffix() == "json" || isArchive(path.toStdString());
}

constexpr const char* folderKey = "window/folder";

/// A dialog beside the window. It begins where the last one ended, in this start or in an earlier one.
template <class Dialog = QFileDialog>
Dialog* fileDialog(QWidget* window, Settings& settings, const QString& title, const QString& name) {
    auto* dialog = new Dialog(window, title);
    dialog->setObjectName(name);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setModal(false);
    const QString folder = settings.value(folderKey).toString();
    if (!folder.isEmpty() && QFileInfo(folder).isDir()) dialog->setDirectory(folder);
    QObject::connect(dialog, &QFileDialog::fileSelected, dialog, [&settings](const QString& path) {
        settings.setValue(folderKey, QFileInfo(path).absolutePath());
    });
    return dialog;
}

}  // namespace

void MainWindow::open(const QString& path) {
    const QFileInfo file(path);
    const bool isGenerating = pages_->currentWidget() == generate_;
    static const QStringList recordings{"csv", "txt", "tsv", "dat", "mf4", "mdf", "mat", "tdms", "xlsx"};
    if (file.exists() && recordings.contains(file.suffix().toLower()) && (isGenerating || !document_->isOpen())) {
        if (!isGenerating) showGenerate();  // there is no model yet that it could be a recording of
        return generate_->addRecording(path);
    }
    if (campaignFileKind(path.toStdString()) != CampaignFile::None) return showCampaign(path);
    if (document_->isOpen() && !isStudy(path) && file.exists()) return importMeasurement(path);
    leaveThen([this, path] { document_->open(path); });
}

/// What is being typed counts: a field keeps it until the keys go elsewhere.
void MainWindow::settle() {
    const QPointer<QWidget> at = QApplication::focusWidget();
    if (!at || at->window() != this) return;
    at->clearFocus();
    if (at) at->setFocus();
}

void MainWindow::leaveThen(std::function<void()> next) {
    settle();
    if (!document_->isModified()) return next();
    auto* box = new QMessageBox(QMessageBox::Question, tr("Unsaved changes"),
                                tr("%1 has changes that are not saved.").arg(document_->title()),
                                QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    connect(box, &QDialog::finished, this, [this, next](int answer) {
        if (answer == QMessageBox::Discard) return next();
        if (answer != QMessageBox::Save) return;
        afterSave_ = next;
        save();
    });
    box->open();
}

void MainWindow::save() {
    const QFileInfo now(document_->path());
    const bool isWritable = now.exists() ? now.isWritable() : QFileInfo(now.path()).isWritable();
    const bool isPlace = !document_->path().isEmpty() && now.fileName() != "study.json" && isWritable;
    if (!isPlace || isExample(document_->path())) return askWhereToSave();
    saveTo(document_->path());
}

void MainWindow::saveTo(const QString& path) {
    settle();
    document_->save(path);
}

void MainWindow::rememberRecent(const QString& path) {
    if (path.isEmpty()) return;
    QStringList recent = settings_.value("window/recent").toStringList();
    const QString whole = QFileInfo(path).absoluteFilePath();
    recent.removeAll(whole);
    recent.prepend(whole);
    while (recent.size() > 8) recent.removeLast();
    settings_.setValue("window/recent", recent);
}

void MainWindow::showRecent() {
    recentMenu_->clear();
    for (const QString& path : settings_.value("window/recent").toStringList()) {
        QAction* action = recentMenu_->addAction(path, this, [this, path] { open(path); });
        action->setEnabled(QFileInfo::exists(path));
    }
    if (recentMenu_->isEmpty()) recentMenu_->addAction(tr("Nothing was opened yet"))->setEnabled(false);
}

QStringList MainWindow::measurementFilters() {
    return {tr("Measurements (*.csv *.txt *.tsv *.dat *.mf4 *.mdf *.mat *.tdms *.xlsx)"), tr("All files (*)")};
}

void MainWindow::askForMeasurement() {
    QFileDialog* const dialog = fileDialog(this, settings_, tr("Import a measurement"), "import-dialog");
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters(measurementFilters());
    connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::importMeasurement);
    dialog->show();
}

void MainWindow::importMeasurement(const QString& path) {
    measurementDock_->show();
    measurementDock_->raise();
    import_->show(path);
    if (centre_->indexOf(import_) < 0) centre_->addTab(import_, tr("Import"));
    centre_->setCurrentWidget(import_);
}

/// The file of a recording that is not where the study says.
void MainWindow::askWhereItIs(const QString& experiment) {
    QFileDialog* const dialog =
        fileDialog(this, settings_, tr("Locate the file of %1").arg(experiment), "locate-dialog");
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters(measurementFilters());
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, experiment](const QString& path) { locateRecording(*document_, *locator_, experiment, path); });
    dialog->show();
}

void MainWindow::leaveImport() {
    if (!waitingImports_.isEmpty()) return import_->show(waitingImports_.takeFirst());
    if (const int tab = centre_->indexOf(import_); tab >= 0) centre_->removeTab(tab);
    showDiagram();
    view_->setFocus();
}

void MainWindow::showValues(const QString& experiment) {
    values_->show(experiment);
    if (centre_->indexOf(values_) < 0) centre_->addTab(values_, tr("Values"));
    centre_->setCurrentWidget(values_);
}

void MainWindow::leaveValues() {
    const int tab = centre_->indexOf(values_);
    if (tab < 0) return;
    centre_->removeTab(tab);
    showDiagram();
}

void MainWindow::showComparison(const QString& signal, const QString& experiment) {
    comparison_->show(signal, experiment);
    if (centre_->indexOf(comparison_) < 0) centre_->addTab(comparison_, tr("Compare"));
    centre_->setCurrentWidget(comparison_);
}

void MainWindow::leaveComparison() {
    const int tab = centre_->indexOf(comparison_);
    if (tab < 0) return;
    centre_->removeTab(tab);
    showDiagram();
}

void MainWindow::connectRecordings() {
    connect(measurements_, &MeasurementPanel::tableWanted, this, &MainWindow::showRecordings);
    connect(recordings_, &RecordingsPage::left, this, &MainWindow::leaveRecordings);
    connect(recordings_, &RecordingsPage::valuesWanted, this, &MainWindow::showValues);
    connect(recordings_, &RecordingsPage::locateWanted, this, &MainWindow::askWhereItIs);
    connect(recordings_, &RecordingsPage::experimentChosen, plots_, &PlotPanel::showExperiment);
    const auto start = [this](RunKind kind) {
        return [this, kind](const std::set<std::string>& recordings) {
            settle();
            controller_->startOn(kind, recordings);
        };
    };
    connect(recordings_, &RecordingsPage::fitWanted, this, start(RunKind::Fit));
    connect(recordings_, &RecordingsPage::searchWanted, this, start(RunKind::Discover));
    connect(controller_, &RunController::runningChanged, recordings_,
            [this] { recordings_->setRunning(controller_->isRunning()); });
}

void MainWindow::showRecordings() {
    if (!document_->isOpen()) return;
    if (centre_->indexOf(recordings_) < 0) centre_->addTab(recordings_, tr("Recordings"));
    centre_->setCurrentWidget(recordings_);
    recordings_->focusTable();
}

void MainWindow::leaveRecordings() {
    const int tab = centre_->indexOf(recordings_);
    if (tab < 0) return;
    centre_->removeTab(tab);
    showDiagram();
}

/// A campaign stands beside the study that is open; a second one takes the place of the first unless that runs.
void MainWindow::showCampaign(const QString& file) {
    auto* campaign = findChild<CampaignWindow*>();
    if (!campaign) {
        campaign = new CampaignWindow(this);
        connect(campaign, &CampaignWindow::studyWanted, this, [this](const Study& study, const Diagnostics& remarks) {
            leaveThen([this, study, remarks] { document_->startWith(study, remarks); });
        });
    }
    if (!file.isEmpty()) campaign->openCampaign(file);
    campaign->show();
    campaign->raise();
    campaign->activateWindow();
}

void MainWindow::showSensitivity() {
    if (!document_->isOpen()) return;
    if (!sensitivity_) {
        sensitivity_ = new SensitivityPage(*document_, this);
        connect(sensitivity_, &SensitivityPage::left, this, [this] {
            const int tab = centre_->indexOf(sensitivity_);
            if (tab < 0) return;
            centre_->removeTab(tab);
            showDiagram();
        });
        connect(sensitivity_, &SensitivityPage::parameterChosen, this, [this](const QString& name) {
            showMention({Mention::Kind::Parameter, name});
        });
    }
    if (centre_->indexOf(sensitivity_) < 0) centre_->addTab(sensitivity_, tr("Sensitivities"));
    centre_->setCurrentWidget(sensitivity_);
    sensitivity_->matrix()->setFocus();
}

void MainWindow::askForPractice() {
    auto* dialog = new PracticeDialog(*document_, settings_.value(folderKey).toString(), this);
    connect(dialog, &PracticeDialog::recorded, this, [this](const QString& experiment, const QString& file) {
        settings_.setValue(folderKey, QFileInfo(file).absolutePath());
        statusBar()->showMessage(tr("Recorded to %1.").arg(file), 8000);
        measurementDock_->show();
        measurementDock_->raise();
        plots_->showExperiment(experiment);
    });
    dialog->show();
}

void MainWindow::askForStudy(bool isDirectory) {
    QFileDialog* const dialog = fileDialog(this, settings_, tr("Open a study"), "open-dialog");
    dialog->setFileMode(isDirectory ? QFileDialog::Directory : QFileDialog::ExistingFile);
    if (!isDirectory) dialog->setNameFilter(tr("Studies (*.analogon study.json)"));
    connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::open);
    dialog->show();
}

void MainWindow::askWhereToSave() {
    QFileDialog* const dialog = fileDialog(this, settings_, tr("Save the study"), "save-dialog");
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilter(tr("Studies (*.analogon)"));
    dialog->setDefaultSuffix("analogon");
    const QFileInfo now(document_->path());
    dialog->selectFile((now.suffix() == "analogon" ? now.completeBaseName() : document_->title()) + ".analogon");
    connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::saveTo);
    connect(dialog, &QDialog::rejected, this, [this] { afterSave_ = nullptr; });
    dialog->show();
}

/// The head of the report first: what it says is on every page of it.
void MainWindow::askForReport() {
    if (!document_->isOpen()) return;
    auto* dialog = new ReportDialog(*document_, reportAction_->isEnabled(), this);
    connect(dialog, &ReportDialog::writeWanted, this, &MainWindow::askWhereToReport);
    dialog->show();
}

void MainWindow::askWhereToReport() {
    auto* dialog =
        fileDialog<ReportFolderDialog>(this, settings_, tr("Write the report into a directory"), "report-dialog");
    dialog->setProposal(tr("%1 report").arg(document_->title()).replace(u'/', u'-'));
    connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::writeReport);
    dialog->show();
}

void MainWindow::writeReport(const QString& path) {
    if (!document_->result()) return;
    ReportHead head = reportHeadOf(document_->study().extraJson);  // of the study as it is now, not as it was then
    if (!head.logo.empty()) {
        const std::filesystem::path logo = std::filesystem::absolute(document_->study().directory / head.logo);
        if (std::filesystem::exists(logo)) head.logo = logo.string();
    }
    const auto write = [this, result = document_->sharedResult(), kind = document_->resultKind(),
                        title = document_->title(), path, head](std::vector<QImage> pictures) {
        writer_->start<Outcome<bool>>(  // whether it is there on paper, too
            tr("Writing the report"),
            [result, kind, title, pictures = std::move(pictures), path, head](const Progress&) -> Outcome<bool> {
                Outcome<ResultsPlace> place = ResultsPlace::take(path.toStdString());
                if (!place) return place.diagnostics();
                const Outcome<Done> done = place->write(*result, commandName(kind), Traces::All, {}, head);
                if (!done) return done.diagnostics();
                Diagnostics said = done.diagnostics();
                const ReportPictures paper{pictures, logoPicture(QString::fromStdString(head.logo)),
                                           diagramsOf(*result)};
                const QString fault =
                    writeReportPdf(QDir(path).filePath("report.pdf"), title, kind, result->finding, paper, head);
                if (!fault.isEmpty()) said.push_back(error(fault.toStdString()));
                return {fault.isEmpty(), std::move(said)};
            },
            [this, path](Outcome<bool> isOnPaper) {
                document_->setRunMessages(isOnPaper.diagnostics());
                if (!isOnPaper) return statusBar()->showMessage(tr("No report written: see the messages."));
                offerReport(QDir(path).filePath("report.html"));
                statusBar()->showMessage(
                    (*isOnPaper ? tr("Report written to %1/report.html.")
                                : tr("Report written to %1/report.html, but no report.pdf: see the messages."))
                        .arg(path));
            });
    };
    plots_->takePictures(write);
}

/// The report that was written last, until another study is opened.
void MainWindow::offerReport(const QString& file) {
    if (!openReport_) {
        openReport_ = new QToolButton(this);
        openReport_->setObjectName("open-report");
        openReport_->setText(tr("Open the report"));
        openReport_->setIcon(style::icon("report"));
        openReport_->setAutoRaise(true);
        openReport_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        openReport_->setFixedHeight(fontMetrics().height() + 2);  // the bar keeps its height
        statusBar()->addPermanentWidget(openReport_);
        connect(openReport_, &QToolButton::clicked, this,
                [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(openReport_->toolTip())); });
        connect(document_, &Document::opened, openReport_, &QWidget::hide);
    }
    openReport_->setToolTip(file);
    openReport_->show();
}

void MainWindow::askWhereToExport(ExportFormat format) {
    const auto [filter, ending] = [format]() -> std::pair<QString, QString> {
        switch (format) {
            case ExportFormat::Fmu:
                return {tr("Functional Mock-up Units (*.fmu)"), "fmu"};
            case ExportFormat::Modelica:
                return {tr("Modelica texts (*.mo)"), "mo"};
            case ExportFormat::Mf4:
                return {tr("ASAM MDF (*.mf4)"), "mf4"};
            case ExportFormat::Parameters:
                return {tr("Parameters (*.csv *.json *.ssv *.dcm *.cdfx)"), "csv"};
            case ExportFormat::Csv:
                break;
        }
        return {tr("Tables (*.csv)"), "csv"};
    }();
    QFileDialog* const dialog = fileDialog(this, settings_, tr("Export"), "export-dialog");
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilter(filter);
    dialog->setDefaultSuffix(ending);
    dialog->selectFile(document_->title() + "." + ending);
    connect(dialog, &QFileDialog::fileSelected, this, [this, format](const QString& path) { exportTo(format, path); });
    dialog->show();
}

void MainWindow::exportTo(ExportFormat format, const QString& path) {
    if (!document_->isOpen()) return;
    settle();
    statusBar()->showMessage(tr("Exporting …"));
    exporter_->start<Outcome<Exported>>(
        tr("Exporting"),
        [study = document_->study(), format, path](const Progress& progress) {
            return exportStudy(study, format, path.toStdString(), progress);
        },
        [this, path](Outcome<Exported> exported) {
            document_->setRunMessages(exported.diagnostics());
            statusBar()->showMessage(exported ? tr("Exported to %1.").arg(path)
                                              : tr("Nothing exported: see the messages."));
        });
}

/// A file is meant for the window, whatever panel or field it is dropped on: else a text would take its address.
bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::DragEnter && event->type() != QEvent::DragMove && event->type() != QEvent::Drop)
        return false;
    const auto* widget = qobject_cast<QWidget*>(watched);
    auto* drop = static_cast<QDropEvent*>(event);  // the base of all three
    const QStringList files = filesOf(drop->mimeData());
    if (files.isEmpty() || !widget || (widget->window() != this && !isAncestorOf(widget->window()))) return false;
    drop->acceptProposedAction();
    if (event->type() == QEvent::Drop) takeFiles(files);
    return true;
}

void MainWindow::takeFiles(const QStringList& paths) {
    const auto study = std::find_if(paths.begin(), paths.end(), isStudy);
    if (study != paths.end()) return open(*study);
    for (const QString& path : paths) {
        const bool isImporting = centre_->indexOf(import_) >= 0;
        if (isImporting && document_->isOpen() && pages_->currentWidget() != generate_)
            waitingImports_ << path;
        else
            open(path);
    }
}

}  // namespace analogon::ui
