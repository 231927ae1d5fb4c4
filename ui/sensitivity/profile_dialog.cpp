#include "ui/sensitivity/profile_dialog.hpp"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/fit/profile.hpp"
#include "core/study/confidence.hpp"
#include "ui/document/document.hpp"
#include "ui/signals/figure_chart.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

Outcome<ConfidenceInterval> profileOf(const RunResult& result, const std::string& parameter, const Progress& progress) {
    const Outcome<EstimationTask> task = estimationTask(result.completed, UnusedColumns::Leave);
    if (!task) return task.diagnostics();
    ModelState state = result.finding.final;
    for (FitEstimate& e : state.parameters) e.interval.reset();
    FitOptions options;
    options.threads = 2;  // one a side
    addConfidence(*task, {parameter}, options, state, progress);
    for (const FitEstimate& e : state.parameters)
        if (e.name == parameter && e.interval) return *e.interval;
    return error(phrase("the profile of {} was not found: the model cannot be fitted again from here", parameter));
}

}  // namespace

ProfileDialog::ProfileDialog(Document& document, QWidget* parent)
    : QDialog(parent),
      document_(document),
      parameter_(new QComboBox(this)),
      outcome_(new QLabel(this)),
      chart_(new FigureChart(this)),
      progress_(new QProgressBar(this)),
      run_(new QPushButton(this)) {
    setWindowTitle(tr("Profile of the likelihood"));
    setAttribute(Qt::WA_DeleteOnClose);
    parameter_->setAccessibleName(tr("Parameter"));
    outcome_->setWordWrap(true);
    style::makeCaption(outcome_);
    style::makeQuiet(progress_);
    progress_->setRange(0, 0);  // how many fits it takes is not known before
    run_->setDefault(true);
    auto* bottom = new QHBoxLayout;
    bottom->addWidget(progress_, 1);
    bottom->addWidget(run_);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(parameter_);
    layout->addWidget(outcome_);
    layout->addWidget(chart_, 1);
    layout->addLayout(bottom);
    resize(140 * style::unit, 110 * style::unit);
    fillParameters();
    connect(parameter_, &QComboBox::currentIndexChanged, this, [this] { showOutcome({}); });
    connect(run_, &QPushButton::clicked, this, &ProfileDialog::start);
    connect(&worker_, &JobRunner::started, this, &ProfileDialog::follow);
    connect(&worker_, &JobRunner::finished, this, [this] {
        if (isStopped_) showOutcome({});  // what was stopped early tells nothing
        follow();
    });
    connect(&document, &Document::resultChanged, this, [this] {
        worker_.drop();  // a profile of the result before
        fillParameters();
        follow();
    });
    connect(&document, &Document::opened, this, &QDialog::close);
    follow();
}

std::span<const FitEstimate> ProfileDialog::estimates() const {
    const RunResult* result = document_.resultKind() == RunKind::Simulate ? nullptr : document_.result();
    return result ? std::span<const FitEstimate>(result->finding.final.parameters) : std::span<const FitEstimate>();
}

const FitEstimate* ProfileDialog::estimate() const {
    const std::span<const FitEstimate> all = estimates();
    const std::string name = parameter_->currentText().toStdString();
    const auto found = std::find_if(all.begin(), all.end(), [&](const FitEstimate& e) { return e.name == name; });
    return found == all.end() ? nullptr : &*found;
}

void ProfileDialog::fillParameters() {
    const QString chosen = parameter_->currentText();
    const QSignalBlocker quiet(parameter_);
    parameter_->clear();
    for (const FitEstimate& e : estimates())
        if (const QString name = QString::fromStdString(e.name); parameter_->findText(name) < 0)
            parameter_->addItem(name);
    parameter_->setCurrentIndex(std::max(0, parameter_->findText(chosen)));
    showOutcome({});
}

void ProfileDialog::start() {
    if (worker_.isBusy()) {
        isStopped_ = true;
        return worker_.cancel();
    }
    isStopped_ = false;
    outcome_->setText(tr("Fitting the others at each value …"));
    worker_.start<Outcome<ConfidenceInterval>>(
        windowTitle(),
        [result = document_.sharedResult(), name = parameter_->currentText().toStdString()](const Progress& progress) {
            return profileOf(*result, name, progress);
        },
        [this](Outcome<ConfidenceInterval> found) {
            if (found)
                showOutcome(std::move(*found));
            else
                showOutcome({}, found.diagnostics());
        });
}

void ProfileDialog::showOutcome(std::optional<ConfidenceInterval> found, const Diagnostics& faults) {
    interval_ = std::move(found);
    QStringList why;
    for (const Diagnostic& said : faults)
        if (said.severity == Severity::Error) why << inWords(said.message);
    if (interval_)
        outcome_->setText(wordsOf(*interval_));
    else if (isStopped_)
        outcome_->setText(tr("Stopped."));
    else if (!why.isEmpty())
        outcome_->setText(why.join('\n'));
    else if (!estimate())
        outcome_->setText(tr("Fit the parameters first (F5)."));
    else
        outcome_->setText(
            tr("How much worse the fit becomes where the parameter is held at other values and all others "
               "are fitted anew."));
    isStopped_ = false;
    draw();
    follow();
}

QString ProfileDialog::wordsOf(const ConfidenceInterval& interval) const {
    const QString text =
        interval.isOpenBelow && interval.isOpenAbove ? tr("The recordings limit %1 on no side between %2 and %3.")
        : interval.isOpenBelow ? tr("95 % interval of %1: up to %3; the recordings set no lower limit down to %2.")
        : interval.isOpenAbove ? tr("95 % interval of %1: from %2; the recordings set no upper limit up to %3.")
                               : tr("95 % interval of %1: from %2 to %3.");
    const FitEstimate* of = estimate();
    const auto end = [&](double value) {
        return style::numberWithUnit(style::numberText(value, 4), of ? QString::fromStdString(of->unit) : QString());
    };
    return text.arg(parameter_->currentText(), end(interval.lower), end(interval.upper));
}

void ProfileDialog::draw() {
    Figure figure;
    const FitEstimate* of = estimate();
    if (!interval_ || !of || interval_->values.empty()) return chart_->show(figure);
    std::vector<std::pair<double, double>> points;
    for (std::size_t i = 0; i < interval_->values.size(); ++i)
        points.emplace_back(interval_->values[i], interval_->rises[i]);
    std::sort(points.begin(), points.end());
    QPolygonF curve;
    for (const auto& [value, rise] : points) curve << QPointF(value, rise);
    const QColor muted = style::mutedText(palette());
    const double left = points.front().first, right = points.back().first;
    figure.xLabel = style::nameWithUnit(QString::fromStdString(of->name), QString::fromStdString(of->unit));
    figure.yLabel = tr("Fall of twice the log-likelihood");
    figure.curves = {{tr("Profile"), style::accent(palette()), curve},
                     {tr("95 %"), muted, QPolygonF{QPointF(left, profileThreshold), QPointF(right, profileThreshold)}},
                     {tr("Estimate"), muted, QPolygonF{QPointF(of->value, 0), QPointF(of->value, profileThreshold)}}};
    chart_->show(std::move(figure));
}

void ProfileDialog::follow() {
    run_->setText(worker_.isBusy() ? tr("Stop") : tr("Work it out"));
    progress_->setVisible(worker_.isBusy());
    run_->setEnabled(worker_.isBusy() ? !worker_.isCancelling() : estimate() != nullptr);
    parameter_->setEnabled(!worker_.isBusy() && parameter_->count() > 0);
}

}  // namespace analogon::ui
