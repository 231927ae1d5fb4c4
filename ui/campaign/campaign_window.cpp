#include "ui/campaign/campaign_window.hpp"

#include <QCheckBox>
#include <QCloseEvent>
#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QSpinBox>
#include <QTableView>
#include <QThread>
#include <QUrl>
#include <QVBoxLayout>
#include <cmath>

#include "core/base/guard.hpp"
#include "ui/campaign/units_model.hpp"
#include "ui/style/find_key.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

constexpr int betweenLooks = 1000;  // [ms] while a campaign runs
constexpr int interrupted = 130;    // status of a campaign that was stopped
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

void setUp(QTableView* view) {
    view->setSortingEnabled(true);
    view->sortByColumn(UnitsModel::Unit, Qt::AscendingOrder);
    view->setTabKeyNavigation(false);
    view->setShowGrid(false);
    view->setAlternatingRowColors(true);
    view->setWordWrap(false);
    view->setSelectionBehavior(QAbstractItemView::SelectRows);
    view->setSelectionMode(QAbstractItemView::SingleSelection);
    view->setEditTriggers(QAbstractItemView::NoEditTriggers);
    view->setAccessibleName(CampaignWindow::tr("Units of the campaign"));
    view->verticalHeader()->hide();
    view->verticalHeader()->setDefaultSectionSize(view->fontMetrics().height() + 2 * style::unit);
    view->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    view->horizontalHeader()->setHighlightSections(false);
    view->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    view->horizontalHeader()->setStretchLastSection(true);
}

/// Widths by what the columns hold as a rule: to measure ten thousand rows takes long.
void setWidths(QTableView* view) {
    const int letter = view->fontMetrics().averageCharWidth();
    for (const auto& [column, letters] : {std::pair(UnitsModel::Unit, 16), std::pair(UnitsModel::State, 15),
                                          std::pair(UnitsModel::Found, 34), std::pair(UnitsModel::ErrorBefore, 12),
                                          std::pair(UnitsModel::ErrorAfter, 12), std::pair(UnitsModel::Seconds, 12)})
        view->setColumnWidth(column, letters * letter + 2 * style::margin);
}

/// What the run of a unit came to is where its study begins.
void beginAt(Study& study, const UnitRecord& record) {
    for (const UnitParameter& found : record.parameters) {
        const auto parameter = study.parameters.find(found.name);
        if (parameter != study.parameters.end() && std::isfinite(found.value)) parameter->second.value = found.value;
    }
}

}  // namespace

CampaignWindow::CampaignWindow(QWidget* parent)
    : QDialog(parent),
      model_(new UnitsModel(this)),
      sorted_(new QSortFilterProxyModel(this)),
      file_(new QLineEdit(this)),
      out_(new QLineEdit(this)),
      clusterOptions_(new QLineEdit(this)),
      filter_(new QLineEdit(this)),
      jobs_(new QSpinBox(this)),
      cluster_(new QCheckBox(tr("On a Slurm cluster, with the options"), this)),
      retry_(new QCheckBox(tr("Failed units again"), this)),
      start_(new QPushButton(this)),
      openStudy_(new QPushButton(tr("Open its study"), this)),
      openReport_(new QPushButton(tr("Open its report"), this)),
      page_(new QPushButton(tr("Open the summary"), this)),
      table_(new QPushButton(tr("Open the table of results"), this)),
      view_(new QTableView(this)),
      bar_(new QProgressBar(this)),
      told_(new QLabel(this)),
      counts_(new QLabel(this)) {
    setObjectName("campaign");
    setWindowTitle(tr("Campaign"));
    setWindowFlag(Qt::WindowMaximizeButtonHint);
    setAttribute(Qt::WA_DeleteOnClose);
    resize(980, 620);
    sorted_->setSourceModel(model_);
    sorted_->setSortRole(UnitsModel::SortRole);
    sorted_->setFilterKeyColumn(-1);  // whatever a row shows
    sorted_->setFilterCaseSensitivity(Qt::CaseInsensitive);
    view_->setModel(sorted_);
    setUp(view_);
    setWidths(view_);
    style::showWhenEmpty(view_, tr("Open a campaign.json: it names a study, and a table with a row for each unit"));
    told_->setWordWrap(true);
    told_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    told_->hide();
    style::makeCaption(counts_);
    bar_->setTextVisible(false);
    bar_->setFixedHeight(2 * style::unit);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(style::margin, style::margin, style::margin, style::margin);
    layout->setSpacing(2 * style::unit);
    layout->addLayout(placeFields());
    layout->addLayout(runFields());
    layout->addWidget(bar_);
    auto* above = new QHBoxLayout;
    above->addWidget(counts_, 1);
    above->addWidget(filter_);
    layout->addLayout(above);
    layout->addWidget(view_, 1);
    layout->addWidget(told_);
    layout->addLayout(rowButtons());
    style::findBy(*this, [this] { return filter_; });
    watch_.setInterval(betweenLooks);
    connect(&watch_, &QTimer::timeout, this, &CampaignWindow::look);
    connect(&process_, &CampaignProcess::progressed, this, &CampaignWindow::showCounts);
    connect(&process_, &CampaignProcess::ended, this, &CampaignWindow::end);
    connect(&looker_, &JobRunner::failed, this, [this](const Diagnostic& fault) { tell(faultText({fault}), true); });
    updateState();
}

/// Fields tell that they are left when they go, after what they would change.
CampaignWindow::~CampaignWindow() {
    for (QObject* field : std::initializer_list<QObject*>{file_, out_, view_->selectionModel()})
        disconnect(field, nullptr, this, nullptr);
}

QWidget* CampaignWindow::withButton(QLineEdit* field, const QString& text, const char* name,
                                    void (CampaignWindow::*ask)()) {
    auto* both = new QWidget(this);
    auto* row = new QHBoxLayout(both);
    row->setContentsMargins(0, 0, 0, 0);
    auto* button = new QPushButton(text, this);
    button->setObjectName(name);
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, ask);
    row->addWidget(field, 1);
    row->addWidget(button);
    return both;
}

QLayout* CampaignWindow::placeFields() {
    auto* form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    file_->setPlaceholderText(QStringLiteral("campaign.json"));
    form->addRow(tr("Campaign"), withButton(file_, tr("Open …"), "open-campaign", &CampaignWindow::askForFile));
    form->addRow(tr("Results in"), withButton(out_, tr("Choose …"), "choose-place", &CampaignWindow::askForPlace));
    connect(file_, &QLineEdit::editingFinished, this, [this] {
        if (file_->text() != asked_) openCampaign(file_->text());
    });
    connect(out_, &QLineEdit::textChanged, this, &CampaignWindow::updateState);
    connect(out_, &QLineEdit::editingFinished, this, &CampaignWindow::look);
    return form;
}

QLayout* CampaignWindow::runFields() {
    jobs_->setRange(1, 999);
    jobs_->setValue(std::max(1, QThread::idealThreadCount()));
    jobs_->setAccessibleName(tr("Units at the same time"));
    clusterOptions_->setPlaceholderText(QStringLiteral("--partition=short --time=60"));
    clusterOptions_->setAccessibleName(tr("Options for sbatch"));
    start_->setDefault(true);
    auto* row = new QHBoxLayout;
    auto* label = new QLabel(tr("&Units at the same time"), this);
    label->setBuddy(jobs_);
    row->addWidget(label);
    row->addWidget(jobs_);
    row->addSpacing(style::margin);
    row->addWidget(cluster_);
    row->addWidget(clusterOptions_, 1);
    row->addSpacing(style::margin);
    row->addWidget(retry_);
    row->addWidget(start_);
    connect(cluster_, &QCheckBox::toggled, this, &CampaignWindow::updateState);
    connect(start_, &QPushButton::clicked, this, &CampaignWindow::startOrStop);
    return row;
}

QLayout* CampaignWindow::rowButtons() {
    filter_->setPlaceholderText(tr("Filter"));
    filter_->setAccessibleName(tr("Filter the units"));
    filter_->setClearButtonEnabled(true);
    filter_->setMinimumWidth(50 * style::unit);
    connect(filter_, &QLineEdit::textChanged, sorted_, &QSortFilterProxyModel::setFilterFixedString);
    auto* row = new QHBoxLayout;
    for (QPushButton* button : {openStudy_, openReport_}) row->addWidget(button);
    row->addStretch(1);
    for (QPushButton* button : {table_, page_}) row->addWidget(button);
    for (QPushButton* button : {openStudy_, openReport_, table_, page_}) button->setAutoDefault(false);
    connect(openStudy_, &QPushButton::clicked, this, &CampaignWindow::openStudyOfChosen);
    connect(view_, &QTableView::activated, this, &CampaignWindow::openStudyOfChosen);
    connect(openReport_, &QPushButton::clicked, this, [this] { openFile(folderOfChosen() + "/report.html"); });
    connect(page_, &QPushButton::clicked, this, [this] { openFile(out_->text() + "/campaign.html"); });
    connect(table_, &QPushButton::clicked, this, [this] { openFile(out_->text() + "/results.csv"); });
    connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &CampaignWindow::updateState);
    return row;
}

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
        look();
    });
    dialog->open();
}

CampaignWindow::Opened CampaignWindow::read(const std::string& file) {
    Outcome<Campaign> campaign = readCampaign(file);
    if (!campaign) return {nullptr, nullptr, campaign.diagnostics()};
    Outcome<CampaignTemplate> study = CampaignTemplate::open(*campaign);
    if (!study) return {nullptr, nullptr, study.diagnostics()};
    return {std::make_shared<const Campaign>(std::move(*campaign)),
            std::make_shared<const CampaignTemplate>(std::move(*study)),
            {}};
}

void CampaignWindow::openCampaign(const QString& file) {
    if (process_.isRunning() || file.trimmed().isEmpty()) return;
    QString whole = QFileInfo(file.trimmed()).absoluteFilePath();
    QString out = QFileInfo(whole).dir().filePath("results");
    if (campaignFileKind(whole.toStdString()) == CampaignFile::State) {  // what it was made of is named there
        out = QFileInfo(whole).absolutePath();
        const Outcome<CampaignLook> state = lookAt(out.toStdString());
        if (!state) return tell(faultText(state.diagnostics()), true);
        whole = QString::fromStdString(state->campaign.string());
    }
    asked_ = whole;
    file_->setText(whole);
    out_->setText(out);
    look_.reset();
    model_->setCampaign(nullptr);
    opened_ = {};
    tell(tr("Reading …"), false);
    reader_.start<Outcome<Opened>>(
        tr("Reading"), [path = whole.toStdString()](const Progress&) -> Outcome<Opened> { return read(path); },
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
    model_->setCampaign(opened_.campaign);
    setWidths(view_);
    const bool isFit = opened_.campaign && opened_.campaign->command == CampaignCommand::Fit;
    view_->setColumnHidden(UnitsModel::Found, isFit);
    tell(faultText(opened_.faults), true);
    if (opened_.campaign)
        setWindowTitle(tr("Campaign: %1").arg(QString::fromStdString(opened_.campaign->study.filename().string())));
    updateState();
    look();
}

/// How far it is; from the directory, so that also what another program does there is seen.
void CampaignWindow::look() {
    if (!opened_.campaign || looker_.isBusy()) return;
    looker_.start<Outcome<CampaignLook>>(
        tr("Looking"),
        [out = out_->text().toStdString(), before = look_](const Progress&) {
            return lookAt(out, before ? *before : CampaignLook{});
        },
        [this](Outcome<CampaignLook> found) {
            if (found)
                showLook(*found);
            else
                tell(faultText(found.diagnostics()), true);
        });
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
    watch_.start();
    process_.start({file_->text(), out_->text(), jobs_->value(), retry_->isChecked(), cluster_->isChecked(),
                    clusterOptions_->text().trimmed()});
    updateState();
}

void CampaignWindow::end(int status, const QString& said) {
    watch_.stop();
    const bool isFault = status != 0 && status != interrupted;
    if (status == interrupted)
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
    look();
}

void CampaignWindow::tell(const QString& text, bool isFault) {
    QPalette palette = this->palette();
    if (isFault) palette.setColor(QPalette::WindowText, style::fault(palette));
    told_->setPalette(palette);
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
