#include "ui/signals/signal_strip.hpp"

#include <QComboBox>
#include <QDragEnterEvent>
#include <QLabel>
#include <QMimeData>
#include <QPainter>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QStackedLayout>
#include <QTextDocumentFragment>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/signal/formula.hpp"
#include "core/signal/range_figures.hpp"
#include "ui/signals/figure_chart.hpp"
#include "ui/style/breakable.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

QString withUnitBehind(double value, const QString& unit) {
    const QString number = style::numberText(value);
    return unit.isEmpty() || unit == "1" ? number : number + QChar(0x00a0) + unit;
}

double valueAt(const SignalData& data, double time) {
    const double wanted[]{time};
    return valuesAt(*data.time, data.values, wanted).front();
}

}  // namespace

SignalStrip::SignalStrip(QWidget* parent)
    : QWidget(parent), chart_(new SignalChart), figure_(new FigureChart), views_(new QComboBox), legend_(new QLabel) {
    setAcceptDrops(true);
    legend_->setWordWrap(true);
    legend_->setMinimumWidth(24 * style::unit);  // for the longest part of a name that cannot break
    legend_->setTextFormat(Qt::RichText);
    legend_->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    const auto button = [this](const QString& text, const QString& tip) {
        auto* made = new QToolButton;
        made->setText(text);
        made->setToolTip(tip);
        made->setAutoRaise(true);
        return made;
    };
    up_ = button("▲", tr("Move this axis up (Alt+Up)"));
    down_ = button("▼", tr("Move this axis down (Alt+Down)"));
    close_ = button("✕", tr("Remove this axis (Del)"));
    up_->setObjectName("strip-up");
    down_->setObjectName("strip-down");
    close_->setObjectName("strip-close");
    views_->addItems({tr("Time"), tr("x-y"), tr("Spectrum"), tr("Coherence"), tr("Histogram")});
    views_->setToolTip(
        tr("Over the time, the others against the first signal, power spectral density (Welch), coherence "
           "with the first signal, or how often each value comes; of the part that is visible"));
    views_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    views_->setMinimumContentsLength(5);
    views_->setFocusPolicy(Qt::StrongFocus);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, style::unit, 0, 0);
    column->setSpacing(0);
    auto* head = new QHBoxLayout;
    head->setContentsMargins(style::margin, 0, style::unit, 0);
    head->addWidget(legend_, 1);
    head->addWidget(views_, 0, Qt::AlignTop);
    for (QToolButton* b : {up_, down_, close_}) head->addWidget(b, 0, Qt::AlignTop);
    column->addLayout(head);
    pages_ = new QStackedLayout;
    pages_->addWidget(chart_);
    pages_->addWidget(figure_);
    column->addLayout(pages_, 1);
    connect(views_, &QComboBox::activated, this, [this](int view) { Q_EMIT viewWanted(static_cast<PlotView>(view)); });
    connect(up_, &QToolButton::clicked, this, [this] { Q_EMIT moveWanted(-1); });
    connect(down_, &QToolButton::clicked, this, [this] { Q_EMIT moveWanted(1); });
    connect(close_, &QToolButton::clicked, this, &SignalStrip::closeWanted);
    connect(legend_, &QLabel::linkActivated, this, [this](const QString& link) { Q_EMIT removeWanted(link.toInt()); });
}

void SignalStrip::setLines(std::vector<ChartLine> lines, bool hasRecordings) {
    hasRecordings_ = hasRecordings;
    chart_->setLines(std::move(lines));
    writeLegend();
    showFigure();
}

void SignalStrip::setView(PlotView view) {
    view_ = view;
    const QSignalBlocker blocker(views_);
    views_->setCurrentIndex(static_cast<int>(view));
    pages_->setCurrentWidget(view == PlotView::Time ? static_cast<QWidget*>(chart_) : figure_);
    showFigure();
}

void SignalStrip::setTimeRange(double from, double to) {
    from_ = from;
    to_ = to;
    chart_->setTimeRange(from, to);
    showFigure();
}

void SignalStrip::showFigure() {
    if (view_ != PlotView::Time) figure_->want(view_, chart_->lines(), from_, to_);
}

void SignalStrip::setTimeLabels(bool isFirst, bool isLast) {
    up_->setEnabled(!isFirst);
    down_->setEnabled(!isLast);
}

void SignalStrip::pointAt(std::optional<double> time) {
    cursor_ = time;
    chart_->setCursorTime(time);
    writeLegend();
}

void SignalStrip::setMarks(const std::vector<double>& times) {
    marks_ = times;
    chart_->setMarks(times);
    writeLegend();
}

QString SignalStrip::figuresOf(const ChartLine& line) const {
    if (!line.data) return tr("on its way …");
    const SignalData& shown = *line.data;
    if (!shown.time) return shown.fault;
    if (marks_.size() == 2) {
        const double from = std::min(marks_[0], marks_[1]), to = std::max(marks_[0], marks_[1]);
        const RangeFigures figures = figuresWithin(*shown.time, shown.values, from, to);
        return tr("Δ %1, mean %2, rms %3")
            .arg(withUnitBehind(valueAt(shown, to) - valueAt(shown, from), shown.unit),
                 withUnitBehind(figures.mean, shown.unit), withUnitBehind(figures.rms, shown.unit));
    }
    if (cursor_) return withUnitBehind(valueAt(shown, *cursor_), shown.unit);
    return shown.unit;
}

void SignalStrip::writeLegend() {
    QString text;
    const QColor muted = style::mutedText(palette());
    for (std::size_t i = 0; i < chart_->lines().size(); ++i) {
        const ChartLine& line = chart_->lines()[i];
        QString name = breakable(line.reference.name);
        if (line.reference.kind == SignalKind::Residual) name = tr("residual of %1").arg(name);
        if (hasRecordings_)
            name += QStringLiteral(" <span style='color:%1'>· %2</span>")
                        .arg(muted.name(), breakable(line.reference.recording));
        const bool isFault = line.data && !line.data->time;
        QString figures = figuresOf(line).toHtmlEscaped();
        static const QRegularExpression unitBehind("(\\d) ");  // a number stays with its unit
        if (!isFault) figures.replace(unitBehind, "\\1&nbsp;");
        text += QStringLiteral(
                    "<span style='color:%1'>▬</span>&nbsp;%2 <span style='color:%3'>%4</span>&nbsp;"
                    "<a href='%5' style='color:%6;text-decoration:none'>×</a>&#8195;")
                    .arg(line.colour.name(), name, (isFault ? style::fault(palette()) : muted).name(), figures,
                         QString::number(i), muted.name());
    }
    legend_->setText(text);
}

QString SignalStrip::legendText() const {
    return QTextDocumentFragment::fromHtml(legend_->text()).toPlainText().remove(QChar(0x200B));
}

void SignalStrip::dragEnterEvent(QDragEnterEvent* event) {
    if (!event->mimeData()->hasFormat(signalMime)) return;
    event->acceptProposedAction();
    isTarget_ = true;
    update();
}

void SignalStrip::dragLeaveEvent(QDragLeaveEvent*) {
    isTarget_ = false;
    update();
}

void SignalStrip::dropEvent(QDropEvent* event) {
    isTarget_ = false;
    update();
    event->acceptProposedAction();
    Q_EMIT dropped(signalsOf(event->mimeData()->data(signalMime)));
}

void SignalStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    if (!isTarget_) return;
    painter.setPen(QPen(style::accent(palette()), 2));
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

void SignalStrip::keyPressEvent(QKeyEvent* event) {
    const bool isMove = event->modifiers() & Qt::AltModifier;
    if (isMove && (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down))
        return Q_EMIT moveWanted(event->key() == Qt::Key_Up ? -1 : 1);
    if (event->key() == Qt::Key_Delete) return Q_EMIT closeWanted();
    QWidget::keyPressEvent(event);
}

void SignalStrip::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && legend_) writeLegend();
}

}  // namespace analogon::ui
