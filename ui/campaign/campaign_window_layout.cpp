#include <QCheckBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QSpinBox>
#include <QTableView>
#include <QThread>
#include <QVBoxLayout>

#include "ui/campaign/campaign_window.hpp"
#include "ui/campaign/units_model.hpp"
#include "ui/style/find_key.hpp"
#include "ui/style/style.hpp"

/// What the window of a campaign is made of.
namespace analogon::ui {

namespace {

constexpr int betweenLooks = 1000;  // [ms]

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
    setWidths();
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
    timer_.start(betweenLooks);
    connect(&timer_, &QTimer::timeout, this, &CampaignWindow::watch);
    connect(&process_, &CampaignProcess::progressed, this, &CampaignWindow::showCounts);
    connect(&process_, &CampaignProcess::noted, this, &CampaignWindow::showNote);
    connect(&process_, &CampaignProcess::ended, this, &CampaignWindow::end);
    connect(&looker_, &JobRunner::finished, this, [this] {
        if (std::exchange(isLookStale_, false)) look();
    });
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
    connect(out_, &QLineEdit::editingFinished, this, &CampaignWindow::lookAgain);
    return form;
}

QLayout* CampaignWindow::runFields() {
    jobs_->setRange(1, 999);
    jobs_->setValue(std::max(1, QThread::idealThreadCount()));
    jobs_->setAccessibleName(tr("Units at the same time"));
    clusterOptions_->setPlaceholderText(QStringLiteral("--partition=short --time=60"));
    clusterOptions_->setAccessibleName(tr("Options for sbatch"));
    start_->setAutoDefault(false);  // Enter in a field is no order to begin
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

/// Widths by what the columns hold as a rule: to measure ten thousand rows takes long.
void CampaignWindow::setWidths() {
    const int letter = view_->fontMetrics().averageCharWidth();
    for (const auto& [column, letters] : {std::pair(UnitsModel::Unit, 16), std::pair(UnitsModel::State, 15),
                                          std::pair(UnitsModel::Found, 34), std::pair(UnitsModel::ErrorBefore, 12),
                                          std::pair(UnitsModel::ErrorAfter, 12), std::pair(UnitsModel::Seconds, 12)})
        view_->setColumnWidth(column, letters * letter + 2 * style::margin);
}

}  // namespace analogon::ui
