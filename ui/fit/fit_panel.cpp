#include "ui/fit/fit_panel.hpp"

#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QSpinBox>
#include <QSplitter>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/number_text.hpp"
#include "core/report/words.hpp"
#include "ui/document/document.hpp"
#include "ui/effect/finding_words.hpp"
#include "ui/effect/result_panel.hpp"
#include "ui/fit/error_curve.hpp"
#include "ui/fit/run_controller.hpp"
#include "ui/fit/stop_field.hpp"
#include "ui/style/find_key.hpp"
#include "ui/style/ink.hpp"
#include "ui/style/number.hpp"
#include "ui/style/sought_words.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

QString percentOf(const ModelState& state, Role role) {
    const double error = errorPercent(state, role);
    return std::isfinite(error) ? style::fixedText(error, 2) + QStringLiteral(" %") : QStringLiteral("–");
}

QTreeWidget* makeTable(const QStringList& headers, QWidget* parent) {
    auto* table = new QTreeWidget(parent);
    table->setHeaderLabels(headers);
    table->setRootIsDecorated(false);
    table->setFrameShape(QFrame::NoFrame);
    table->setUniformRowHeights(true);
    table->setAlternatingRowColors(true);
    table->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->header()->setStretchLastSection(false);
    table->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    for (int c = 1; c < headers.size(); ++c)
        table->headerItem()->setTextAlignment(c, Qt::AlignRight | Qt::AlignVCenter);
    return table;
}

const FitEstimate* estimateOf(const RunRecord& run, const std::string& name) {
    for (const FitEstimate& e : run.result->finding.final.parameters)
        if (e.name == name && e.experiment < 0) return &e;
    return nullptr;
}

QString estimateText(const FitEstimate* e) {
    return e ? style::withDecimalSign(valueText(e->value, e->standardError)) : QStringLiteral("–");
}

}  // namespace

FitPanel::FitPanel(Document& document, RunController& controller, QWidget* parent)
    : QWidget(parent),
      document_(document),
      controller_(controller),
      method_(new QComboBox(this)),
      loss_(new QComboBox(this)),
      starts_(new QSpinBox(this)),
      curve_(new ErrorCurve(this)),
      left_(new QLabel(this)),
      hint_(new QLabel(this)),
      history_(makeTable({tr("Run"), tr("Time"), tr("Fit"), tr("Validate")}, this)),
      comparison_(makeTable({tr("Parameter")}, this)),
      restore_(new QPushButton(tr("Go back to this run"), this)),
      pin_(new QToolButton(this)),
      filter_(new QLineEdit(this)),
      name_(new QLineEdit(this)),
      note_(new QLineEdit(this)),
      details_(new QWidget(this)) {
    method_->addItem(tr("Least squares (Levenberg-Marquardt)"), static_cast<int>(FitMethod::LeastSquares));
    method_->addItem(tr("Nelder-Mead simplex"), static_cast<int>(FitMethod::NelderMead));
    method_->addItem(tr("Subspace simplex (SBPLX)"), static_cast<int>(FitMethod::Sbplx));
    method_->addItem(tr("Quadratic model (BOBYQA)"), static_cast<int>(FitMethod::Bobyqa));
    method_->addItem(tr("Controlled random search (CRS2)"), static_cast<int>(FitMethod::Crs2));
    method_->addItem(tr("Stochastic ranking (ISRES)"), static_cast<int>(FitMethod::Isres));
    method_->addItem(tr("Evolutionary search (ESCH)"), static_cast<int>(FitMethod::Esch));
    loss_->addItem(tr("Plain squares"), static_cast<int>(RobustLoss::None));
    loss_->addItem(tr("Huber: outliers count less"), static_cast<int>(RobustLoss::Huber));
    loss_->addItem(tr("Cauchy: outliers hardly count"), static_cast<int>(RobustLoss::Cauchy));
    starts_->setRange(1, 500);
    starts_->setToolTip(tr("Fits from several starts within the bounds and keeps the best one"));
    method_->setAccessibleName(tr("Method"));
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(3 * style::unit);
    form->setVerticalSpacing(2 * style::unit);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    for (QComboBox* box : {method_, loss_}) {
        box->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);  // the list is as wide as its texts
        box->setMinimumContentsLength(12);
    }
    form->addRow(tr("Method"), method_);
    form->addRow(tr("Misfit"), loss_);
    form->addRow(tr("Starts"), starts_);
    form->addRow(tr("Simulate until"), new StopField(document, this));
    auto* options = new QWidget;
    auto* column = new QVBoxLayout(options);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2 * style::unit);
    column->addLayout(form);
    column->addWidget(curve_, 1);
    style::makeCaption(left_);
    left_->hide();
    column->addWidget(left_);
    auto* area = new QScrollArea(this);  // beside the lists, not around them: each turns with its own wheel
    area->setWidget(options);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setMinimumHeight(form->sizeHint().height() / 2);
    options_ = area;
    createParts();

    for (QComboBox* box : {method_, loss_}) connect(box, &QComboBox::activated, this, &FitPanel::applyOptions);
    connect(starts_, &QSpinBox::valueChanged, this, &FitPanel::applyOptions);
    connect(history_, &QTreeWidget::itemSelectionChanged, this, &FitPanel::compare);
    connect(restore_, &QPushButton::clicked, this, &FitPanel::restore);
    connect(&document, &Document::opened, this, [this] {
        curve_->clear();
        refresh();
    });
    connect(&document, &Document::resultChanged, this, &FitPanel::refresh);
    connect(&document, &Document::comparisonChanged, this, [this] {
        if (!document_.comparedRuns() && chosen().size() >= 2) history_->clearSelection();
    });
    connect(&document, &Document::historyChanged, this, &FitPanel::refresh);
    connect(pin_, &QToolButton::clicked, this, &FitPanel::pin);
    for (QLineEdit* field : {name_, note_}) connect(field, &QLineEdit::editingFinished, this, &FitPanel::describe);
    connect(history_, &QTreeWidget::itemDoubleClicked, this, [this] {
        name_->setFocus();
        name_->selectAll();
    });
    connectController();
    refresh();
}

/// The runs, what is said of the chosen one, and their comparison below, with borders that the user moves.
void FitPanel::createParts() {
    style::makeCaption(hint_);
    hint_->setWordWrap(true);
    style::wrapColumn(history_, 0);
    history_->header()->setMinimumSectionSize(15 * style::unit);
    history_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    history_->setAccessibleName(tr("Runs so far"));
    comparison_->setSelectionMode(QAbstractItemView::NoSelection);
    comparison_->setAccessibleName(tr("Comparison of runs"));
    style::onThemeChange(*this, [this] { colourCompared(); });
    for (QTreeWidget* table : {history_, comparison_})
        table->setMinimumHeight(table->header()->sizeHint().height() + 3 * table->fontMetrics().lineSpacing());
    pin_->setIcon(style::icon("pin"));
    pin_->setText(tr("Pin"));
    pin_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    pin_->setCheckable(true);
    pin_->setToolTip(tr("A pinned run stays in the study, however many runs follow"));
    name_->setPlaceholderText(tr("Name"));
    name_->setAccessibleName(tr("Name of the run"));
    name_->setMaxLength(80);
    note_->setPlaceholderText(tr("Note"));
    note_->setAccessibleName(tr("Note on the run"));
    note_->setMaxLength(2000);
    filter_->setPlaceholderText(tr("Find a run"));
    filter_->setAccessibleName(tr("Find a run"));
    filter_->setClearButtonEnabled(true);
    filter_->hide();
    connect(filter_, &QLineEdit::textChanged, this, &FitPanel::filter);
    auto* leave = new QShortcut(Qt::Key_Escape, filter_);
    leave->setContext(Qt::WidgetShortcut);
    connect(leave, &QShortcut::activated, this, &FitPanel::leaveFilter);
    style::findBy(*this, [this]() -> QLineEdit* {
        if (history_->topLevelItemCount() == 0) return nullptr;
        filter_->show();
        return filter_;
    });
    auto* words = new QHBoxLayout(details_);
    words->setContentsMargins(0, 0, 0, 0);
    words->addWidget(name_, 1);
    words->addWidget(note_, 2);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(pin_);
    row->addWidget(restore_);
    auto* runs = new QWidget(this);
    auto* list = new QVBoxLayout(runs);
    list->setContentsMargins(0, 0, 0, 0);
    list->setSpacing(2 * style::unit);
    list->addWidget(filter_);
    list->addWidget(history_, 1);
    list->addWidget(details_);
    list->addWidget(hint_);
    list->addLayout(row);
    auto* parts = new QSplitter(Qt::Vertical, this);
    parts->setObjectName("runs-parts");
    parts->setChildrenCollapsible(false);
    for (QWidget* part : std::initializer_list<QWidget*>{options_, runs, comparison_}) parts->addWidget(part);
    for (const int part : {1, 2}) parts->setStretchFactor(part, part + 1);
    parts->setMinimumHeight(20 * style::unit);  // on a small screen a part makes way before the window grows
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(style::margin, style::margin, style::margin, style::margin);
    layout->addWidget(parts);
}

void FitPanel::connectController() {
    connect(&controller_, &RunController::runningChanged, this, [this] {
        if (controller_.isRunning()) {
            history_->clearSelection();  // its traces are what one wants to see now
            curve_->clear();
            clock_.start();
        }
        left_->setVisible(controller_.isRunning());
        left_->setText(tr("How long it takes is not known yet."));
    });
    connect(&controller_, &RunController::progressed, this, [this](const Progress::Report& report) {
        const double seconds = static_cast<double>(clock_.elapsed()) / 1000, fraction = report.fraction;
        if (report.error > 0) curve_->add(seconds, report.error);
        if (fraction > 0.05 && seconds > 1)
            left_->setText(tr("about %1 s left").arg(style::fixedText(seconds * (1 - fraction) / fraction, 0)));
    });
    connect(&document_, &Document::liveTracesChanged, this, [this] {
        if (const SimulatedTraces* live = document_.liveTraces())
            curve_->add(static_cast<double>(clock_.elapsed()) / 1000, live->errorPercent);
    });
}

void FitPanel::applyOptions() {
    FitOptions& fit = controller_.options().discover.fit;
    fit.method = static_cast<FitMethod>(method_->currentData().toInt());
    fit.loss = static_cast<RobustLoss>(loss_->currentData().toInt());
    fit.starts = starts_->value();
}

void FitPanel::refresh() {
    const auto& runs = document_.history();
    const auto isShown = [this, row = 0](const RunRecord& run) mutable {
        const QTreeWidgetItem* item = history_->topLevelItem(row++);
        return item && item->data(0, Qt::UserRole).toULongLong() == run.number;
    };
    if (static_cast<std::size_t>(history_->topLevelItemCount()) != runs.size() ||
        !std::all_of(runs.begin(), runs.end(), isShown)) {
        const QSignalBlocker blocker(history_);
        history_->clear();
        for (const RunRecord& run : runs) {
            auto* item =
                new QTreeWidgetItem(history_, {QString(), run.when, percentOf(run.result->finding.final, Role::Fit),
                                               percentOf(run.result->finding.final, Role::Validate)});
            item->setData(0, Qt::UserRole, static_cast<qulonglong>(run.number));
            for (int c = 1; c < 4; ++c) item->setTextAlignment(c, Qt::AlignRight | Qt::AlignVCenter);
        }
    }
    for (int row = 0; row < history_->topLevelItemCount(); ++row)
        showRow(history_->topLevelItem(row), runs[static_cast<std::size_t>(row)]);
    if (runs.empty()) leaveFilter();
    filter();
    compare();
}

/// Leaves the runs that hold each word in their name, note, effect or time.
void FitPanel::filter() {
    const style::SoughtWords sought(filter_->text());
    for (int row = 0; row < history_->topLevelItemCount(); ++row) {
        QTreeWidgetItem* const item = history_->topLevelItem(row);
        const QString said = (item->text(0) + '\n' + item->toolTip(0) + '\n' + item->text(1)).toLower();
        const bool isFound = sought.areIn(said);
        item->setHidden(!isFound);
        if (!isFound) item->setSelected(false);
    }
}

void FitPanel::leaveFilter() {
    if (filter_->isHidden()) return;
    filter_->clear();
    filter_->hide();
    history_->setFocus(Qt::ShortcutFocusReason);
}

void FitPanel::showRow(QTreeWidgetItem* item, const RunRecord& run) const {
    QString found = runName(run.kind);
    if (!run.result->finding.effects.empty()) found += ": " + effectName(run.result->finding.effects.front());
    const QString name = run.name.isEmpty() ? found : run.name;
    item->setText(0, run.note.isEmpty() ? name : name + QStringLiteral(" – ") + run.note);
    item->setIcon(0, run.isPinned ? style::icon("pin") : QIcon());
    QFont font = history_->font();
    if (run.number == document_.shownRun()) font.setWeight(QFont::DemiBold);
    item->setFont(0, font);
    QStringList tip{tr("took %1 s").arg(style::numberText(run.seconds, 3))};
    if (!run.name.isEmpty()) tip.prepend(found);
    if (!run.note.isEmpty()) tip << run.note;
    item->setToolTip(0, tip.join('\n'));
}

const RunRecord* FitPanel::chosenRun() const {
    const std::vector<std::size_t> rows = chosen();
    return rows.size() == 1 && rows.front() < document_.history().size() ? &document_.history()[rows.front()] : nullptr;
}

/// Of the one run that is chosen.
void FitPanel::showDetails() {
    const RunRecord* run = chosenRun();
    for (QWidget* w : std::initializer_list<QWidget*>{details_, pin_, restore_}) w->setVisible(run);
    if (!run) return;
    pin_->setChecked(run->isPinned);
    if (name_->text() != run->name) name_->setText(run->name);
    if (note_->text() != run->note) note_->setText(run->note);
}

void FitPanel::describe() {
    if (const RunRecord* run = chosenRun())
        document_.describeRun(run->number, name_->text().simplified(), note_->text().simplified());
}

void FitPanel::pin(bool isPinned) {
    const RunRecord* run = chosenRun();
    if (!run || document_.pinRun(run->number, isPinned)) return;
    pin_->setChecked(false);
    hint_->setText(tr("As many runs are pinned as a study keeps: loosen another first."));
    hint_->show();
}

std::vector<std::size_t> FitPanel::chosen() const {
    std::vector<std::size_t> rows;
    for (const QTreeWidgetItem* item : history_->selectedItems())
        rows.push_back(static_cast<std::size_t>(history_->indexOfTopLevelItem(const_cast<QTreeWidgetItem*>(item))));
    std::sort(rows.begin(), rows.end());
    return rows;
}

namespace {

QString effectsOf(const RunRecord& run) {
    QStringList effects;
    for (const AddedEffect& e : run.result->finding.effects) effects << effectTitle(e);
    return effects.isEmpty() ? QStringLiteral("–") : effects.join("; ");
}

QString errorOf(const RunRecord& run, const std::string& experiment) {
    for (const ExperimentState& e : run.result->finding.final.experiments)
        if (e.name == experiment) return style::fixedText(e.errorPercent, 2) + QStringLiteral(" %");
    return QStringLiteral("–");
}

/// What can be said of the runs side by side, row by row: errors, effects, values.
void fillComparison(QTreeWidget* table, const std::vector<const RunRecord*>& runs) {
    const auto add = [&](const QString& name, const auto& textOf) {
        auto* item = new QTreeWidgetItem(table, {name});
        for (std::size_t r = 0; r < runs.size(); ++r) {
            item->setText(static_cast<int>(r) + 1, textOf(*runs[r]));
            item->setTextAlignment(static_cast<int>(r) + 1, Qt::AlignRight | Qt::AlignVCenter);
        }
    };
    std::vector<std::string> experiments;
    std::set<std::string> names;
    bool hasEffects = false;
    for (const RunRecord* run : runs) {
        hasEffects = hasEffects || !run->result->finding.effects.empty();
        for (const ExperimentState& e : run->result->finding.final.experiments)
            if (std::find(experiments.begin(), experiments.end(), e.name) == experiments.end())
                experiments.push_back(e.name);
        for (const FitEstimate& e : run->result->finding.final.parameters)
            if (e.experiment < 0) names.insert(e.name);
    }
    for (const Role role : {Role::Fit, Role::Validate})
        add(role == Role::Fit ? FitPanel::tr("error, fit") : FitPanel::tr("error, validate"),
            [role](const RunRecord& run) { return percentOf(run.result->finding.final, role); });
    if (experiments.size() > 2)
        for (const std::string& e : experiments)
            add(FitPanel::tr("error, %1").arg(QString::fromStdString(e)),
                [&](const RunRecord& run) { return errorOf(run, e); });
    if (hasEffects) add(FitPanel::tr("effects"), effectsOf);
    for (const std::string& name : names)
        add(QString::fromStdString(name), [&](const RunRecord& run) { return estimateText(estimateOf(run, name)); });
}

}  // namespace

void FitPanel::compare() {
    const auto& runs = document_.history();
    std::vector<std::size_t> rows = chosen();
    std::erase_if(rows, [&](std::size_t r) { return r >= runs.size(); });
    const bool isComparison = rows.size() >= 2;
    comparison_->setVisible(isComparison);
    options_->setVisible(!isComparison);
    hint_->setText(runs.empty()      ? tr("Every run of Simulate (F4), Fit (F5) and Discover (F6) is kept here.")
                   : rows.size() > 2 ? tr("The traces are those of the first and of the last.")
                   : isComparison    ? QString()
                                     : tr("Choose several runs to compare them."));
    hint_->setVisible(!hint_->text().isEmpty());
    showDetails();
    comparison_->clear();
    if (!isComparison) return document_.compareRuns(std::nullopt);
    std::vector<const RunRecord*> compared;
    for (const std::size_t row : rows) compared.push_back(&runs[row]);
    const int columns = static_cast<int>(compared.size()) + 1;
    comparison_->setColumnCount(columns);
    for (int c = 1; c < columns; ++c) {  // as their traces are called
        QTreeWidgetItem* header = comparison_->headerItem();
        const bool isFirst = c == 1, isLast = c + 1 == columns;
        const QString letter = isFirst ? QStringLiteral("A ") : isLast ? QStringLiteral("B ") : QString();
        header->setText(c, letter + compared[static_cast<std::size_t>(c) - 1]->label());
        header->setTextAlignment(c, Qt::AlignRight | Qt::AlignVCenter);
        // The name of an effect breaks, and pushes no column out of sight.
        comparison_->header()->setSectionResizeMode(c,
                                                    columns < 5 ? QHeaderView::Stretch : QHeaderView::ResizeToContents);
        if (!comparison_->itemDelegateForColumn(c)) style::wrapColumn(comparison_, c);
    }
    colourCompared();
    comparison_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    fillComparison(comparison_, compared);
    document_.compareRuns(Document::RunPair{*compared.front(), *compared.back()});
}

/// The heads of the first and the last as their traces.
void FitPanel::colourCompared() {
    const int last = comparison_->columnCount() - 1;
    for (int c = 1; c <= last; ++c)
        comparison_->headerItem()->setForeground(c, c == 1      ? style::beforeTrace(palette())
                                                    : c == last ? style::afterTrace(palette())
                                                                : palette().color(QPalette::WindowText));
}

void FitPanel::restore() {
    const std::vector<std::size_t> rows = chosen();
    if (rows.size() != 1 || rows.front() >= document_.history().size()) return;
    const RunRecord run = document_.history()[rows.front()];
    document_.restoreRun(run);
}

}  // namespace analogon::ui
