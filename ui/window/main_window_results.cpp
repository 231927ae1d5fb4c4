#include <QDesktopServices>
#include <QDir>
#include <QStatusBar>
#include <QToolButton>
#include <QUrl>
#include <filesystem>

#include "core/export/export.hpp"
#include "core/study/report_settings.hpp"
#include "core/study/results.hpp"
#include "ui/document/document.hpp"
#include "ui/effect/report_pdf.hpp"
#include "ui/effect/report_top.hpp"
#include "ui/job/job.hpp"
#include "ui/plot/plot_panel.hpp"
#include "ui/style/style.hpp"
#include "ui/window/file_dialog.hpp"
#include "ui/window/main_window.hpp"
#include "ui/window/report_dialog.hpp"
#include "ui/window/report_folder.hpp"

/// What leaves the window: reports and exports.
namespace analogon::ui {

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
    const std::string title = reportHeadOf(document_->study().extraJson).title;  // by which it is known
    const QString name =
        tr("%1 report").arg(title.empty() ? document_->title() : QString::fromStdString(title)).replace(u'/', u'-');
    // The report of another study of that name is not to be replaced by who only confirms; the one before of this is.
    const bool wasWritten = openReport_ && !openReport_->isHidden();
    const QString before = wasWritten ? QFileInfo(openReport_->toolTip()).absolutePath() : QString();
    const auto isAnothers = [&](const QString& folder) {
        const QString path = dialog->directory().absoluteFilePath(folder);
        return path != before && QFileInfo::exists(path);
    };
    QString free = name;
    for (int number = 2; isAnothers(free); ++number) free = QStringLiteral("%1 %2").arg(name).arg(number);
    dialog->setProposal(free);
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

}  // namespace analogon::ui
