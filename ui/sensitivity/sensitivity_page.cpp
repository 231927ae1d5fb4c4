#include "ui/sensitivity/sensitivity_page.hpp"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <cmath>

#include "ui/document/document.hpp"
#include "ui/plot/series.hpp"
#include "ui/signals/signal_chart.hpp"
#include "ui/style/breakable.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

constexpr double strong = 0.95;  // from which on two estimates go so much together that it is worth a look

constexpr int mostWhole = 24;  // letters of a name that the narrowest page has room for beside its figure

/// The more two go together, the stronger the colour: one for either sign.
QColor ground(double correlation, const QPalette& palette) {
    const QColor base = palette.color(QPalette::Base);
    if (!std::isfinite(correlation)) return base;
    const QColor ink = correlation > 0 ? style::beforeTrace(palette) : style::afterTrace(palette);
    return style::mix(base, ink, 0.6 * std::abs(correlation));
}

}  // namespace

SensitivityPage::SensitivityPage(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      caption_(new QLabel(this)),
      legend_(new QLabel(this)),
      matrix_(new QTableWidget(this)),
      trace_(new QComboBox(this)),
      measure_(new QComboBox(this)),
      chart_(new SignalChart(this)),
      close_(new QPushButton(tr("Close"), this)) {
    caption_->setWordWrap(true);
    style::makeCaption(caption_);
    legend_->setWordWrap(true);
    legend_->setTextFormat(Qt::RichText);
    matrix_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    matrix_->setAccessibleName(tr("Correlation of the parameters"));
    matrix_->setTabKeyNavigation(false);
    matrix_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    matrix_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 2 * style::unit);
    trace_->setAccessibleName(tr("Trace"));
    measure_->addItems({tr("per relative change of a parameter"), tr("per standard error of a parameter")});
    measure_->setAccessibleName(tr("Sensitivity"));
    measure_->setToolTip(tr("The slope of the trace times the value of each parameter, or times its standard error"));
    layOut();
    connect(trace_, &QComboBox::currentIndexChanged, this, &SensitivityPage::draw);
    connect(measure_, &QComboBox::currentIndexChanged, this, &SensitivityPage::draw);
    connect(close_, &QPushButton::clicked, this, &SensitivityPage::left);
    connect(&document, &Document::opened, this, &SensitivityPage::left);
    connect(matrix_, &QTableWidget::cellActivated, this, [this](int row, int) {
        if (const QTableWidgetItem* head = matrix_->verticalHeaderItem(row)) Q_EMIT parameterChosen(head->text());
    });
    for (const auto changed : {&Document::opened, &Document::modelChanged, &Document::parametersChanged,
                               &Document::experimentsChanged, &Document::resultChanged})
        connect(&document, changed, this, [this] {
            isOwed_ = true;
            if (isVisible()) workOut();
        });
    connect(chart_, &SignalChart::timeRangeWanted, chart_, &SignalChart::setTimeRange);
    connect(chart_, &SignalChart::allWanted, this, &SensitivityPage::draw);
}

void SensitivityPage::layOut() {
    auto* heading = new QHBoxLayout;
    heading->addWidget(caption_, 1);
    heading->addWidget(close_, 0, Qt::AlignTop);
    auto* choice = new QHBoxLayout;
    choice->setSpacing(2 * style::unit);
    for (QComboBox* box : {trace_, measure_}) {
        box->setMinimumContentsLength(8);
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        choice->addWidget(box, 1);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(style::margin, 2 * style::unit, style::margin, style::margin);
    layout->setSpacing(2 * style::unit);
    layout->addLayout(heading);
    layout->addWidget(matrix_, 2);
    layout->addLayout(choice);
    layout->addWidget(legend_);
    layout->addWidget(chart_, 3);
}

void SensitivityPage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (isOwed_) workOut();
}

void SensitivityPage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() != QEvent::PaletteChange || !shown_) return;
    fillMatrix();
    draw();
}

void SensitivityPage::workOut() {
    isOwed_ = false;
    worker_.drop();
    if (!document_.isOpen()) return;
    const RunResult* result = document_.resultKind() == RunKind::Simulate ? nullptr : document_.result();
    const bool isOfFit = result && document_.after();
    caption_->setText(tr("Working out the sensitivities …"));
    worker_.start<Outcome<Sensitivity>>(
        tr("Sensitivities"),
        [study = isOfFit ? result->completed : document_.study()](const Progress& progress) {
            return sensitivityOf(study, progress);
        },
        [this, isOfFit](Outcome<Sensitivity> found) { show(std::move(found), isOfFit); });
}

void SensitivityPage::show(Outcome<Sensitivity> found, bool isOfFit) {
    shown_ = found ? std::make_shared<const Sensitivity>(std::move(*found)) : nullptr;
    const QString shownTrace = trace_->currentText();
    QSignalBlocker quiet(trace_);
    trace_->clear();
    if (shown_) {
        for (const OutputSensitivity& output : shown_->outputs)
            trace_->addItem(QStringLiteral("%1 · %2").arg(QString::fromStdString(output.experiment),
                                                          QString::fromStdString(output.output)));
        trace_->setCurrentIndex(std::max(0, trace_->findText(shownTrace)));
        caption_->setText((isOfFit ? tr("At the fitted values.") : tr("At the present values.")) + " " +
                          tr("Correlation of the estimates: near 1 or −1, the recordings tell the two hardly apart."));
    } else {
        QStringList why;
        for (const Diagnostic& said : found.diagnostics())
            if (said.severity == Severity::Error) why << inWords(said.message);
        caption_->setText(why.join('\n'));
    }
    fillMatrix();
    draw();
}

/// Rows and columns are the parameters; the standard error is the first column, as a share of the value.
void SensitivityPage::fillMatrix() {
    matrix_->clear();
    const int count = shown_ ? static_cast<int>(shown_->parameters.size()) : 0;
    matrix_->setRowCount(count);
    matrix_->setColumnCount(count > 0 ? count + 1 : 0);
    QStringList names;
    for (int i = 0; i < count; ++i) names << QString::fromStdString(shown_->parameters[static_cast<std::size_t>(i)]);
    matrix_->setVerticalHeaderLabels(names);
    matrix_->setHorizontalHeaderLabels(QStringList(tr("Standard error")) + names);
    const auto put = [this](int row, int column, const QString& text) {
        auto* item = new QTableWidgetItem(text);
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        matrix_->setItem(row, column, item);
        return item;
    };
    for (int row = 0; row < count; ++row) {
        put(row, 0, style::percentText(100 * std::abs(shown_->standardErrors[row] / shown_->values[row])));
        for (int column = 0; column < count; ++column) {
            const double r = shown_->correlation(row, column);
            QTableWidgetItem* item = put(
                row, column + 1, std::isfinite(r) ? style::fixedText(std::abs(r) < 0.005 ? 0.0 : r, 2) : QString("–"));
            if (row == column) {
                item->setForeground(style::mutedText(palette()));
                continue;
            }
            item->setBackground(ground(r, palette()));
            QFont font = matrix_->font();
            font.setBold(std::abs(r) >= strong);
            item->setFont(font);
            item->setToolTip(QStringLiteral("%1 – %2: %3").arg(names[row], names[column], style::numberText(r, 4)));
        }
    }
}

/// The slope of the chosen trace times the value of each parameter, or times its standard error: in the unit of the
/// trace either way.
void SensitivityPage::draw() {
    std::vector<ChartLine> lines;
    QStringList legend;
    const int chosen = trace_->currentIndex();
    if (shown_ && chosen >= 0) {
        const OutputSensitivity& output = shown_->outputs[static_cast<std::size_t>(chosen)];
        const auto time = std::make_shared<const std::vector<double>>(output.time);
        const Eigen::VectorXd& factors = measure_->currentIndex() == 0 ? shown_->values : shown_->standardErrors;
        for (Eigen::Index p = 0; p < output.slopes.cols(); ++p) {
            const auto values = std::make_shared<Eigen::VectorXd>(output.slopes.col(p) * factors[p]);
            const QString name = QString::fromStdString(shown_->parameters[static_cast<std::size_t>(p)]);
            const QColor colour = style::signalTrace(static_cast<int>(p), palette());
            const std::span<const double> seen(values->data(), static_cast<std::size_t>(values->size()));
            auto drawn = std::make_shared<SignalData>();
            drawn->time = time;
            drawn->values = Series(values, seen);
            drawn->unit = QString::fromStdString(output.unit);
            lines.push_back({{SignalKind::Variable, QString::fromStdString(output.experiment), name}, colour, drawn});
            const double rms =
                std::sqrt(values->squaredNorm() / std::max<double>(1, static_cast<double>(values->size())));
            legend << QStringLiteral("<span style='color:%1'>▬</span>&nbsp;%2&nbsp;<span style='color:%3'>%4</span>")
                          .arg(colour.name(), breakable(name, mostWhole), style::mutedText(palette()).name(),
                               tr("rms %1").arg(style::numberText(rms, 3)).replace(u' ', QChar::Nbsp));
        }
        if (!output.time.empty()) chart_->setTimeRange(output.time.front(), output.time.back());
    }
    legend_->setText(legend.join(QStringLiteral(" &nbsp; ")));
    chart_->setLines(std::move(lines));
}

}  // namespace analogon::ui
