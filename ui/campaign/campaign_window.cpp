#include "ui/campaign/campaign_window.hpp"

#include <QCheckBox>
#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QSpinBox>
#include <QTableView>
#include <QUrl>
#include <cmath>

#include "ui/campaign/units_model.hpp"
#include "ui/style/ink.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

constexpr int interrupted = 130;  // status of a campaign that was stopped
constexpr int allFailed = 3;

QString timeLeftText(double seconds) {
    if (seconds < 0) return {};
    if (seconds < 90) return CampaignWindow::tr(", about %1 s left").arg(std::round(seconds));
    if (seconds < 5400) return CampaignWindow::tr(", about %1 min left").arg(std::round(seconds / 60));
    return CampaignWindow::tr(", about %1 h left").arg(style::fixedText(seconds / 3600, 1));
}

/// The first fault with its place and its hint.
QString faultText(const Diagnostics& faults) {
    for (const Diagnostic& fault : faults) {
        if (fault.severity != Severity::Error) continue;
        const QString hint = inWords(fault.hint), message = inWords(fault.message);
        return hint.isEmpty() ? message + "." : message + ". " + hint;
    }
    return {};
}

/// What the run of a unit came to is where its study begins.
void beginAt(Study& study, const UnitRecord& record) {
    for (const UnitParameter& found : record.parameters) {
        const auto parameter = study.parameters.find(found.name);
        if (parameter != study.parameters.end() && std::isfinite(found.value)) parameter->second.value = found.value;
    }
}

QDateTime stateWritten(const QString& out) { return QFileInfo(out + "/campaign.json").lastModified(); }

}  // namespace

void CampaignWindow::askForFile() {
    auto* dialog = new QFileDialog(this, tr("Open a campaign"), QFileInfo(file_->text()).absolutePath(),
                                   tr("Campaigns (*.json);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &CampaignWindow::openCampaign);
    dialog->open();
}

void CampaignWindow::askForPlace() {
    auto* dialog = new QFileDialog(this, tr("Directory of the results"), out_->text());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        out_->setText(path);
        lookAgain();
    });
    dialog->open();
}

CampaignWindow::Opened CampaignWindow::read(std::string file) {
    Opened opened;
    if (campaignFileKind(file) == CampaignFile::State) {  // what it was made of is named there
        opened.out = std::filesystem::path(file).parent_path().string();
        const Outcome<std::filesystem::path> written = campaignOf(opened.out);
        if (!written) return {file, {}, nullptr, nullptr, written.diagnostics()};
        file = written->string();
    }
    opened.file = file;
    Outcome<Campaign> campaign = readCampaign(file);
    Outcome<CampaignTemplate> study = campaign ? CampaignTemplate::open(*campaign) : campaign.diagnostics();
    if (!study) {
        opened.faults = study.diagnostics();
        return opened;
    }
    opened.campaign = std::make_shared<const Campaign>(std::move(*campaign));
    opened.study = std::make_shared<const CampaignTemplate>(std::move(*study));
    return opened;
}

void CampaignWindow::openCampaign(const QString& file) {
    if (process_.isRunning() || file.trimmed().isEmpty()) return;
    asked_ = QFileInfo(file.trimmed()).absoluteFilePath();
    file_->setText(asked_);
    look_.reset();
    model_->setCampaign(nullptr);
    opened_ = {};
    tell(tr("Reading …"), false);
    reader_.start<Outcome<Opened>>(
        tr("Reading"), [path = asked_.toStdString()](const Progress&) -> Outcome<Opened> { return read(path); },
        [this](Outcome<Opened> opened) {
            if (opened)
                showOpened(std::move(*opened));
            else
                tell(faultText(opened.diagnostics()), true);
        });
    updateState();
}

void CampaignWindow::showOpened(Opened opened) {
    opened_ = std::move(opened);
    asked_ = QString::fromStdString(opened_.file);
    file_->setText(asked_);
    out_->setText(opened_.out.empty() ? QFileInfo(asked_).dir().filePath("results")
                                      : QString::fromStdString(opened_.out));
    model_->setCampaign(opened_.campaign);
    setWidths();
    const bool isFit = opened_.campaign && opened_.campaign->command == CampaignCommand::Fit;
    view_->setColumnHidden(UnitsModel::Found, isFit);
    tell(faultText(opened_.faults), true);
    if (opened_.campaign)
        setWindowTitle(tr("Campaign: %1").arg(QString::fromStdString(opened_.campaign->study.filename().string())));
    updateState();
    lookAgain();
}

/// Once more where a look is under way: what it shows may be of before.
void CampaignWindow::lookAgain() {
    isLookStale_ = looker_.isBusy();
    look();
}

/// How far it is; from the directory, so that also what another program does there is seen.
void CampaignWindow::look() {
    if (!opened_.campaign || looker_.isBusy()) return;
    if (lookedAt_ != out_->text()) look_.reset();
    lookedAt_ = out_->text();
    written_ = stateWritten(lookedAt_);
    looker_.start<Outcome<CampaignLook>>(
        tr("Looking"),
        [out = lookedAt_.toStdString(), before = look_](const Progress&) {
            return lookAt(out, before ? *before : CampaignLook{});
        },
        [this](Outcome<CampaignLook> found) {
            if (found)
                showLook(*found);
            else
                tell(faultText(found.diagnostics()), true);
        });
}

/// What another program does there changes the state; nobody sees it while the window is closed.
void CampaignWindow::watch() {
    if (process_.isRunning() || (isVisible() && lookedAt_ == out_->text() && written_ != stateWritten(lookedAt_)))
        look();
}

void CampaignWindow::showLook(const CampaignLook& found) {
    look_ = std::make_shared<const CampaignLook>(found);
    model_->setLook(look_);
    if (!process_.isRunning()) {
        CampaignProgress still{found.counts};
        const std::size_t all = opened_.campaign ? opened_.campaign->units.size() : 0;
        still.counts.units = all;
        still.counts.waiting = all - std::min(all, found.counts.done + found.counts.failed);
        showCounts(still);
    }
    updateState();
}

void CampaignWindow::showCounts(const CampaignProgress& progress) {
    const CampaignCounts& c = progress.counts;
    bar_->setRange(0, std::max(1, static_cast<int>(c.units)));
    bar_->setValue(static_cast<int>(c.done + c.failed));
    QString text = tr("%1 units: %2 done, %3 failed, %4 waiting")
                       .arg(style::countText(c.units), style::countText(c.done), style::countText(c.failed),
                            style::countText(c.waiting));
    if (process_.isRunning()) text += tr(", %1 running").arg(c.running) + timeLeftText(progress.secondsLeft);
    counts_->setText(text);
}

void CampaignWindow::startOrStop() {
    if (process_.isRunning()) {
        process_.stop();
        return updateState();
    }
    tell({}, false);
    note_.clear();
    process_.start({file_->text(), out_->text(), jobs_->value(), retry_->isChecked(), cluster_->isChecked(),
                    clusterOptions_->text().trimmed()});
    updateState();
}

void CampaignWindow::end(int status, const QString& said) {
    const bool isFault = status != 0 && status != interrupted;
    if (status == interrupted && cluster_->isChecked() && !note_.isEmpty())  // the job works on, or was cancelled
        tell(tr("%1. Start goes on where it was.").arg(note_), false);
    else if (status == interrupted)
        tell(tr("The campaign was stopped. Start goes on where it was."), false);
    else if (status == allFailed)
        tell(tr("All units failed; their rows say why."), true);
    else
        tell(!isFault         ? QString()
             : said.isEmpty() ? tr("The program that works on the campaign has ended unexpectedly. Start goes on where "
                                   "it was.")
                              : said,
             isFault);
    updateState();
    lookAgain();
}

void CampaignWindow::showNote(const Text& note) {
    note_ = inWords(note);
    if (!note_.isEmpty()) note_[0] = note_[0].toUpper();
    tell(note_, false);
}

void CampaignWindow::tell(const QString& text, bool isFault) {
    style::tint(*told_, isFault ? style::fault : nullptr);
    told_->setText(text);
    told_->setVisible(!text.isEmpty());
}

void CampaignWindow::updateState() {
    const bool isRunning = process_.isRunning();
    start_->setText(process_.isStopping() && isRunning ? tr("Stopping …") : isRunning ? tr("Stop") : tr("Start"));
    start_->setEnabled(isRunning ? !process_.isStopping() : opened_.campaign && !out_->text().trimmed().isEmpty());
    for (QWidget* field : std::initializer_list<QWidget*>{file_, out_, cluster_, retry_}) field->setEnabled(!isRunning);
    for (const char* name : {"open-campaign", "choose-place"}) findChild<QPushButton*>(name)->setEnabled(!isRunning);
    jobs_->setEnabled(!isRunning && !cluster_->isChecked());
    clusterOptions_->setEnabled(!isRunning && cluster_->isChecked());
    openStudy_->setEnabled(chosen() != nullptr);
    openReport_->setEnabled(chosen() && QFileInfo::exists(folderOfChosen() + "/report.html"));
    page_->setEnabled(QFileInfo::exists(out_->text() + "/campaign.html"));
    table_->setEnabled(QFileInfo::exists(out_->text() + "/results.csv"));
}

const CampaignUnit* CampaignWindow::chosen() const {
    const QModelIndexList rows = view_->selectionModel() ? view_->selectionModel()->selectedRows() : QModelIndexList();
    return rows.isEmpty() ? nullptr : model_->unitAt(sorted_->mapToSource(rows.front()).row());
}

void CampaignWindow::chooseUnit(const QString& name) {
    for (int row = 0; row < sorted_->rowCount(); ++row)
        if (sorted_->index(row, UnitsModel::Unit).data().toString() == name) return view_->selectRow(row);
}

QString CampaignWindow::folderOfChosen() const {
    const CampaignUnit* const unit = chosen();
    return unit ? QString::fromStdString(folderOf(out_->text().toStdString(), unit->name).string()) : QString();
}

void CampaignWindow::openFile(const QString& path) { QDesktopServices::openUrl(QUrl::fromLocalFile(path)); }

void CampaignWindow::openStudyOfChosen() {
    const CampaignUnit* const unit = chosen();
    if (!unit || opener_.isBusy()) return;
    const UnitLook* const look = model_->lookOf(unit->name);
    const std::optional<UnitRecord> record = look ? look->record : std::nullopt;
    opener_.start<Outcome<Study>>(
        tr("Reading"),
        [opened = opened_, unit = *unit, record](const Progress&) {
            Outcome<Study> study = opened.study->studyOf(*opened.campaign, unit);
            if (study && record) beginAt(*study, *record);
            return study;
        },
        [this](const Outcome<Study>& study) {
            if (!study) return tell(faultText(study.diagnostics()), true);
            tell({}, false);
            Q_EMIT studyWanted(*study, study.diagnostics());
        });
}

/// A campaign at work ends with its window, after a question.
void CampaignWindow::reject() {
    if (!process_.isRunning()) return QDialog::reject();
    auto* box = new QMessageBox(QMessageBox::Question, tr("Campaign"),
                                cluster_->isChecked()
                                    ? tr("The job stays on the cluster when this window is closed; starting the "
                                         "campaign again follows it. Close it?")
                                    : tr("The campaign stops when this window is closed; what is done is kept, and "
                                         "starting it again goes on. Close it?"),
                                QMessageBox::Close | QMessageBox::Cancel, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    connect(box, &QDialog::finished, this, [this](int answer) {
        if (answer == QMessageBox::Close) QDialog::reject();
    });
    box->open();
}

}  // namespace analogon::ui
