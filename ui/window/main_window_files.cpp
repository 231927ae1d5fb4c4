#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QDropEvent>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPointer>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTabWidget>
#include <QUrl>
#include <algorithm>

#include "core/campaign/campaign_look.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/document/document.hpp"
#include "ui/measurement/import_panel.hpp"
#include "ui/measurement/locate.hpp"
#include "ui/measurement/practice_dialog.hpp"
#include "ui/plot/plot_panel.hpp"
#include "ui/window/compose_actions.hpp"
#include "ui/window/file_dialog.hpp"
#include "ui/window/generate_page.hpp"
#include "ui/window/main_window.hpp"
#include "ui/window/start_page.hpp"

/// The window's dealings with files: opening, saving, importing.
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
    if (isPlace && !isExample(document_->path())) return saveTo(document_->path());
    askWhereToSave();
    if (!document_->path().isEmpty() && !isWritable)
        statusBar()->showMessage(tr("%1 cannot be written: save the study under another name.").arg(now.fileName()));
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
    dialog->setFileMode(QFileDialog::ExistingFiles);
    dialog->setNameFilters(measurementFilters());
    connect(dialog, &QFileDialog::filesSelected, this, &MainWindow::takeFiles);
    dialog->show();
}

void MainWindow::askForRecordings() {
    QFileDialog* const dialog = fileDialog(this, settings_, tr("Add recording"), "recordings-dialog");
    dialog->setFileMode(QFileDialog::ExistingFiles);
    dialog->setNameFilters(measurementFilters());
    connect(dialog, &QFileDialog::filesSelected, this, [this](const QStringList& files) {
        for (const QString& file : files) generate_->addRecording(file);
    });
    dialog->show();
}

void MainWindow::importMeasurement(const QString& path) {
    measurementDock_->show();
    measurementDock_->raise();
    import_->show(path);
    if (centre_->indexOf(import_) < 0) centre_->addTab(import_, tr("Import"));
    centre_->setCurrentWidget(import_);
}

void MainWindow::askForPicture() {
    QFileDialog* const dialog = fileDialog(this, settings_, tr("Add a picture to the diagram"), "picture-dialog");
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters({tr("Pictures (*.png *.jpg *.jpeg *.bmp *.gif *.svg)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) { compose_->addPicture(path); });
    dialog->show();
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
