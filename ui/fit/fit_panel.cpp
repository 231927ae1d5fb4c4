#include "ui/fit/fit_panel.hpp"

#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
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
#include "ui/style/number.hpp"
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
      comparison_(makeTable({tr("Parameter"), tr("First"), tr("Second")}, this)),
      restore_(new QPushButton(tr("Go back to this run"), this)) {
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
    style::makeCaption(left_);
    left_->hide();
    style::makeCaption(hint_);
    hint_->setWordWrap(true);
    style::wrapColumn(history_, 0);
    history_->header()->setMinimumSectionSize(15 * style::unit);
    history_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    history_->setAccessibleName(tr("Runs so far"));
    comparison_->setSelectionMode(QAbstractItemView::NoSelection);
    comparison_->setAccessibleName(tr("Comparison of two runs"));
    comparison_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    for (const int run : {1, 2}) {  // the name of an effect breaks, and pushes no column out of sight
        comparison_->header()->setSectionResizeMode(run, QHeaderView::Stretch);
        style::wrapColumn(comparison_, run);
    }
    auto* row = new QHBoxLayout;
    row->addWidget(hint_, 1);
    row->addWidget(restore_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(style::margin, style::margin, style::margin, style::margin);
    layout->setSpacing(2 * style::unit);
    layout->addLayout(form);
    layout->addWidget(curve_, 2);
    layout->addWidget(left_);
    layout->addWidget(history_, 3);
    layout->addLayout(row);
    layout->addWidget(comparison_, 5);

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
        if (!document_.comparedRuns() && chosen().size() == 2) history_->clearSelection();
    });
    connect(&controller, &RunController::runningChanged, this, [this] {
        if (controller_.isRunning()) {
            history_->clearSelection();  // its traces are what one wants to see now
            curve_->clear();
            clock_.start();
        }
        left_->setVisible(controller_.isRunning());
        left_->setText(tr("How long it takes is not known yet."));
    });
    connect(&controller, &RunController::progressed, this, [this](const Progress::Report& report) {
        const double seconds = static_cast<double>(clock_.elapsed()) / 1000, fraction = report.fraction;
        if (report.error > 0) curve_->add(seconds, report.error);
        if (fraction > 0.05 && seconds > 1)
            left_->setText(tr("about %1 s left").arg(style::fixedText(seconds * (1 - fraction) / fraction, 0)));
    });
    connect(&document, &Document::liveTracesChanged, this, [this] {
        if (const SimulatedTraces* live = document_.liveTraces())
            curve_->add(static_cast<double>(clock_.elapsed()) / 1000, live->errorPercent);
    });
    refresh();
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
            QString name = runName(run.kind);
            if (!run.result->finding.effects.empty()) name += ": " + effectName(run.result->finding.effects.front());
            auto* item = new QTreeWidgetItem(history_, {name, run.when, percentOf(run.result->finding.final, Role::Fit),
                                                        percentOf(run.result->finding.final, Role::Validate)});
            item->setData(0, Qt::UserRole, static_cast<qulonglong>(run.number));
            for (int c = 1; c < 4; ++c) item->setTextAlignment(c, Qt::AlignRight | Qt::AlignVCenter);
            item->setToolTip(0, tr("took %1 s").arg(style::numberText(run.seconds, 3)));
        }
    }
    compare();
}

std::vector<std::size_t> FitPanel::chosen() const {
    std::vector<std::size_t> rows;
    for (const QTreeWidgetItem* item : history_->selectedItems())
        rows.push_back(static_cast<std::size_t>(history_->indexOfTopLevelItem(const_cast<QTreeWidgetItem*>(item))));
    std::sort(rows.begin(), rows.end());
    return rows;
}

/// What the list takes to show all runs, or the first few: beside a comparison it needs no more.
int FitPanel::heightOfRuns() const {
    constexpr int most = 6;
    int height = history_->header()->height() + 2 * history_->frameWidth() + style::unit;
    for (int i = 0; i < std::min(most, history_->topLevelItemCount()); ++i)
        height += history_->visualItemRect(history_->topLevelItem(i)).height();
    return height;
}

void FitPanel::compare() {
    const auto& runs = document_.history();
    std::vector<std::size_t> rows = chosen();
    std::erase_if(rows, [&](std::size_t r) { return r >= runs.size(); });
    restore_->setVisible(rows.size() == 1);
    comparison_->setVisible(rows.size() == 2);
    hint_->setText(runs.empty()       ? tr("Every run of Fit (F5) and Discover (F6) is kept here.")
                   : rows.size() == 2 ? QString()
                                      : tr("Choose two runs to compare them."));
    hint_->setVisible(!hint_->text().isEmpty());
    history_->setMaximumHeight(rows.size() == 2 ? heightOfRuns() : QWIDGETSIZE_MAX);
    comparison_->clear();
    if (rows.size() != 2) return document_.compareRuns(std::nullopt);
    const RunRecord &first = runs[rows[0]], &second = runs[rows[1]];
    comparison_->headerItem()->setText(1, "A " + first.when);  // as their traces are called
    comparison_->headerItem()->setText(2, "B " + second.when);
    comparison_->headerItem()->setForeground(1, style::beforeTrace(palette()));
    comparison_->headerItem()->setForeground(2, style::afterTrace(palette()));
    std::set<std::string> names;
    for (const RunRecord* run : {&first, &second})
        for (const FitEstimate& e : run->result->finding.final.parameters)
            if (e.experiment < 0) names.insert(e.name);
    const auto add = [this](const QString& name, const QString& a, const QString& b) {
        auto* item = new QTreeWidgetItem(comparison_, {name, a, b});
        for (int c = 1; c < 3; ++c) item->setTextAlignment(c, Qt::AlignRight | Qt::AlignVCenter);
    };
    for (const Role role : {Role::Fit, Role::Validate})
        add(role == Role::Fit ? tr("error, fit") : tr("error, validate"), percentOf(first.result->finding.final, role),
            percentOf(second.result->finding.final, role));
    const auto effectsOf = [](const RunRecord& run) {
        QStringList effects;
        for (const AddedEffect& e : run.result->finding.effects) effects << effectTitle(e);
        return effects.isEmpty() ? QStringLiteral("–") : effects.join("; ");
    };
    if (!first.result->finding.effects.empty() || !second.result->finding.effects.empty())
        add(tr("effects"), effectsOf(first), effectsOf(second));
    for (const std::string& name : names)
        add(QString::fromStdString(name), estimateText(estimateOf(first, name)),
            estimateText(estimateOf(second, name)));
    document_.compareRuns(Document::RunPair{first, second});
}

void FitPanel::restore() {
    const std::vector<std::size_t> rows = chosen();
    if (rows.size() != 1 || rows.front() >= document_.history().size()) return;
    const RunRecord run = document_.history()[rows.front()];
    document_.restoreRun(run);
}

}  // namespace analogon::ui
