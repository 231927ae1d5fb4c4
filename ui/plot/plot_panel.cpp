#include "ui/plot/plot_panel.hpp"

#include <QBuffer>
#include <QEvent>
#include <QFileDialog>
#include <QLabel>
#include <QPainter>
#include <QSaveFile>
#include <QScrollArea>
#include <QStackedLayout>
#include <QSvgGenerator>
#include <QTabBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/document/document.hpp"
#include "ui/document/unfinished.hpp"
#include "ui/plot/residual_plot.hpp"
#include "ui/plot/run_comparison.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

const ExperimentState* experimentOf(const std::shared_ptr<const ModelState>& state, const std::string& name) {
    if (!state) return nullptr;
    for (const ExperimentState& e : state->experiments)
        if (e.name == name) return &e;
    return nullptr;
}

const OutputState* outputOf(const ExperimentState* experiment, const std::string& name) {
    if (!experiment) return nullptr;
    for (const OutputState& o : experiment->outputs)
        if (o.name == name) return &o;
    return nullptr;
}

/// The traces as columns; `isComparison`: those of two runs.
Table numbersOf(const std::vector<OutputPlot::Content>& contents, bool isComparison) {
    Table table;
    const auto add = [&table](const QString& name, const QString& unit, std::span<const double> values) {
        Column column;
        column.name = name.toStdString();
        column.unit = unit.toStdString();
        column.values.assign(values.begin(), values.end());
        if (!values.empty()) table.columns.push_back(std::move(column));
    };
    add("time", "s", *contents.front().time);
    for (const OutputPlot::Content& c : contents) {
        add(c.name + " measured", c.unit, c.measured);
        add(c.name + " measured A", c.unit, c.measuredBefore);
        add(c.name + (isComparison ? " A" : " before"), c.unit, c.before);
        add(c.name + (isComparison ? " B" : " after"), c.unit, c.after);
    }
    return table;
}

}  // namespace

PlotPanel::PlotPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      experiments_(new QTabBar(this)),
      pages_(new QStackedLayout),
      empty_(new QLabel(this)),
      area_(new QScrollArea(this)) {
    connect(&exporter_, &JobRunner::failed, this,
            [this](const Diagnostic& fault) { Q_EMIT told(inWords(fault.message)); });
    experiments_->setDrawBase(false);
    experiments_->setExpanding(false);
    experiments_->setDocumentMode(true);
    experiments_->setAccessibleName(tr("Experiments"));
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setWordWrap(true);
    empty_->setMargin(style::margin);
    style::makeCaption(empty_);
    auto* body = new QWidget;
    body->setBackgroundRole(QPalette::Base);
    body->setAutoFillBackground(true);
    column_ = new QVBoxLayout(body);
    column_->setContentsMargins(0, 0, 0, style::unit);
    column_->setSpacing(2 * style::unit);
    area_->setWidget(body);
    area_->setWidgetResizable(true);
    area_->setFrameShape(QFrame::NoFrame);
    area_->viewport()->installEventFilter(this);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    traceView_ = new QToolButton(this);
    residualView_ = new QToolButton(this);
    trim_ = new QToolButton(this);
    untrim_ = new QToolButton(this);
    export_ = new QToolButton(this);
    traceView_->setText(tr("Traces"));
    traceView_->setObjectName("traces-view");
    residualView_->setText(tr("Residual"));
    residualView_->setToolTip(tr("What the residual looks like: distribution, memory, what it moves with"));
    export_->setText(tr("Export …"));
    export_->setToolTip(tr("What is shown as PNG or SVG, its numbers as CSV"));
    trim_->setText(tr("Trim"));
    trim_->setToolTip(tr("Then drag over the part of the recording that is to be used"));
    untrim_->setText(tr("Use all"));
    untrim_->setToolTip(tr("Use the whole recording again"));
    endComparison_ = new QToolButton(this);
    endComparison_->setText(tr("End comparison"));
    endComparison_->setIcon(style::icon("close"));
    endComparison_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    endComparison_->setToolTip(tr("Show the traces of the study again, instead of two runs over each other"));
    endComparison_->hide();
    connect(endComparison_, &QToolButton::clicked, this, [this] { document_.compareRuns(std::nullopt); });
    for (QToolButton* b : {traceView_, residualView_, trim_}) b->setCheckable(true);
    for (QToolButton* b : {traceView_, residualView_, trim_, untrim_, export_, endComparison_}) b->setAutoRaise(true);
    connect(trim_, &QToolButton::toggled, this, &PlotPanel::setTrimming);
    connect(untrim_, &QToolButton::clicked, this, [this] { trim(std::nullopt); });
    traceView_->setChecked(true);
    connect(traceView_, &QToolButton::clicked, this, [this] { showView(false); });
    connect(residualView_, &QToolButton::clicked, this, [this] { showView(true); });
    connect(export_, &QToolButton::clicked, this, &PlotPanel::askWhereToExport);
    bar_ = new QHBoxLayout;
    bar_->setContentsMargins(0, 0, 2 * style::unit, 0);
    bar_->setSpacing(style::unit);
    bar_->addWidget(experiments_, 1);
    buttons_ = new QHBoxLayout;
    buttons_->setSpacing(style::unit);
    for (QToolButton* b : {endComparison_, traceView_, residualView_, trim_, untrim_, export_}) buttons_->addWidget(b);
    buttons_->addStretch(1);
    bar_->addLayout(buttons_);
    layout->addLayout(bar_);
    layout->addLayout(pages_, 1);
    pages_->addWidget(empty_);
    pages_->addWidget(area_);
    connect(experiments_, &QTabBar::currentChanged, this, &PlotPanel::rebuild);
    connect(&document, &Document::opened, this, [this] { shown_.clear(); });
    connect(&document, &Document::resultChanged, this, &PlotPanel::refresh);
    connect(&document, &Document::comparisonChanged, this, &PlotPanel::refresh);
    connect(&document, &Document::liveTracesChanged, this, &PlotPanel::showLive);
    for (auto signal : {&Document::experimentsChanged, &Document::messagesChanged})
        connect(&document, signal, this, [this] {
            if (names_.empty()) rebuild();  // why there are none may be another reason
        });
    refresh();
}

QSize PlotPanel::minimumSizeHint() const {
    return {widthOfButtons() + 2 * style::unit, QWidget::minimumSizeHint().height()};
}

void PlotPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrangeBar();
}

bool PlotPanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == area_->viewport() && event->type() == QEvent::Resize)
        for (OutputPlot* plot : plots_) plot->fitInto(area_->viewport()->height());
    return QWidget::eventFilter(watched, event);
}

int PlotPanel::widthOfButtons() const { return buttons_->minimumSize().width() - buttons_->contentsMargins().left(); }

/// Where tabs and buttons have no room side by side, the buttons stand below.
void PlotPanel::arrangeBar() {
    const bool fits = experiments_->sizeHint().width() + widthOfButtons() + 20 <= width();
    bar_->setDirection(fits ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    // below, off the edge of the panel
    bar_->setContentsMargins(0, 0, fits ? 2 * style::unit : 0, 0);
    buttons_->setContentsMargins(fits ? 0 : 2 * style::unit, 0, 0, 0);
}

void PlotPanel::showExperiment(const QString& name) {
    for (std::size_t i = 0; i < names_.size(); ++i)
        if (QString::fromStdString(names_[i]) == name) experiments_->setCurrentIndex(static_cast<int>(i));
}

void PlotPanel::refresh() {
    const unsigned long version = document_.isOpen() ? document_.tracesVersion() : 0;
    if (version == version_ && version != 0) return;
    version_ = version;
    const auto shown = experimentsShown();
    std::vector<std::string> names;
    for (const auto& [name, role] : shown) names.push_back(name);
    if (names != names_) {
        const QSignalBlocker blocker(experiments_);
        const QString before = std::exchange(shown_, {});
        if (!experiments_->hasFocus()) experiments_->hide();  // else it lays itself out with every tab
        while (experiments_->count() > 0) experiments_->removeTab(0);
        for (const auto& [name, role] : shown) {
            const int tab = experiments_->addTab(QString::fromStdString(name));
            experiments_->setTabToolTip(tab, role == Role::Fit ? tr("Used to fit and to choose effects")
                                                               : tr("Only reported; never used to fit or to choose"));
            if (QString::fromStdString(name) == before) {  // what one looks at stays in sight
                experiments_->setCurrentIndex(tab);
                shown_ = before;
            }
        }
        names_ = names;
    }
    const bool isComparison = document_.comparedRuns();
    for (QWidget* w : std::initializer_list<QWidget*>{experiments_, traceView_, residualView_, export_})
        w->setVisible(!names_.empty());
    trim_->setVisible(!names_.empty() && !isComparison);  // it trims the study's recordings, not those of then
    if (isComparison) trim_->setChecked(false);
    endComparison_->setVisible(isComparison);
    rebuild();
    arrangeBar();
}

std::vector<std::pair<std::string, Role>> PlotPanel::experimentsShown() const {
    if (const Document::RunPair* runs = document_.comparedRuns()) return experimentsOf(*runs);
    std::vector<std::pair<std::string, Role>> shown;
    if (const auto state = shownState())
        for (const ExperimentState& e : state->experiments) shown.emplace_back(e.name, e.role);
    return shown;
}

std::vector<OutputPlot::Content> PlotPanel::contentsShown(const std::string& experiment) const {
    if (const Document::RunPair* runs = document_.comparedRuns()) return ui::contentsOf(*runs, experiment);
    return contentsOf(experiment);
}

std::shared_ptr<const ModelState> PlotPanel::shownState() const {
    if (auto after = document_.after()) return after;
    if (auto before = document_.before()) return before;
    return document_.measured();
}

std::vector<OutputPlot::Content> PlotPanel::contentsOf(const std::string& experiment) const {
    const std::shared_ptr<const ModelState> shown = shownState(), stateBefore = document_.before(),
                                            stateAfter = document_.after();
    const ExperimentState* any = experimentOf(shown, experiment);
    if (!any) return {};
    const ExperimentState* before = experimentOf(stateBefore, experiment);
    const ExperimentState* after = experimentOf(stateAfter, experiment);
    // A run one has gone back to may be one of the recording as it was trimmed then.
    if (before && before->time != any->time) before = nullptr;
    // A long recording is drawn from where it is: a copy would be felt.
    const auto part = [](const std::shared_ptr<const ModelState>& of, const Eigen::VectorXd& values) {
        return Series(of, {values.data(), static_cast<std::size_t>(values.size())});
    };
    const bool isSimulation = document_.resultKind() == RunKind::Simulate;
    const QString beforeWord = stateAfter && !isSimulation ? tr("before") : tr("simulated");
    std::vector<OutputPlot::Content> contents;
    for (const OutputState& output : any->outputs) {
        OutputPlot::Content content;
        content.name = QString::fromStdString(output.name);
        content.unit = QString::fromStdString(output.unit);
        content.time = std::shared_ptr<const std::vector<double>>(shown, &any->time);
        content.measured = part(shown, output.measured);
        const bool isMeasured = hasValues(content.measured);
        const auto label = [&](const QString& word, const OutputState& of) {
            return isMeasured ? word + " " + style::percentText(of.figures.errorPercent) : word;
        };
        if (const OutputState* o = outputOf(before, output.name)) {
            content.before = part(stateBefore, o->simulated);
            content.beforeLabel = label(beforeWord, *o);
        }
        if (const OutputState* o = outputOf(after, output.name)) {
            content.after = part(stateAfter, o->simulated);
            content.afterLabel = label(isSimulation ? tr("simulated") : tr("after"), *o);
        }
        contents.push_back(std::move(content));
    }
    return contents;
}

namespace {

QImage pictureOf(OutputPlot::Content content) {
    OutputPlot plot;
    plot.resize(900, 340);
    const auto time = content.time;
    plot.show(std::move(content));
    plot.fitInto(plot.height());
    if (!time->empty()) plot.setTimeRange(time->front(), time->back());
    return plot.grab().toImage();
}

}  // namespace

void PlotPanel::takePictures(std::function<void(std::vector<QImage>)> done) {
    struct Album {
        std::vector<OutputPlot::Content> contents;  // as they are now, whatever becomes of the study
        std::vector<QImage> pictures{};
    };
    auto album = std::make_shared<Album>();
    if (const std::shared_ptr<const ModelState> shown = shownState())  // of the study, though runs may be compared
        for (const ExperimentState& experiment : shown->experiments)
            for (OutputPlot::Content& content : contentsOf(experiment.name)) {
                if (shown->experiments.size() > 1)
                    content.name = QString::fromStdString(experiment.name) + ": " + content.name;
                album->contents.push_back(std::move(content));
            }
    auto* turns = new QTimer(this);
    connect(turns, &QTimer::timeout, this, [turns, album, done = std::move(done)] {
        if (album->pictures.size() < album->contents.size())
            return album->pictures.push_back(pictureOf(std::move(album->contents[album->pictures.size()])));
        turns->stop();
        turns->deleteLater();
        done(std::move(album->pictures));
    });
    turns->start(0);
}

/// Why there are no traces, and what leads to some.
QString PlotPanel::textOfNone() const {
    if (!document_.isOpen()) return tr("Open a study to see its measurements here.");
    const Study& study = document_.study();
    const bool isAnyRead = study.experiments.size() > study.unread.size();
    if (const Diagnostic* const error = document_.modelError(); error && !study.experiments.empty()) {
        if (!isAnyRead) return tr("The model has an error, and no measurement can be read.");
        return isUnfinished(*error) ? tr("The model is not finished: once its parts are connected and its inputs and "
                                         "outputs have columns, measured and simulated traces appear here. Signals "
                                         "shows what was recorded at once.")
                                    : tr("The model has an error (see the messages): measured and simulated traces "
                                         "appear here once it has none. Signals shows what was recorded at once.");
    }
    if (document_.canRun()) return tr("Simulating the model as it stands …");
    if (!study.experiments.empty())
        return tr(
            "Map a column of the recording to an output of the model, among the measurements: measured "
            "and simulated traces then appear here. Signals shows what was recorded at once.");
    return tr(
        "Import a measurement and map its columns: measured and simulated "
        "traces then appear here. Simulate (F4) shows the model by itself.");
}

void PlotPanel::rebuild() {
    const int index = experiments_->currentIndex();
    if (names_.empty() || index < 0) {
        untrim_->hide();
        empty_->setText(textOfNone());
        pages_->setCurrentWidget(empty_);
        return;
    }
    const std::string& name = names_[static_cast<std::size_t>(index)];
    std::vector<OutputPlot::Content> contents = contentsShown(name);
    while (residuals_.size() > contents.size()) {
        delete residuals_.back();
        residuals_.pop_back();
    }
    while (residuals_.size() < contents.size()) {
        residuals_.push_back(new ResidualPlot);
        residuals_.back()->setVisible(isResidualView_);
        column_->addWidget(residuals_.back(), 1);
    }
    while (plots_.size() > contents.size()) {
        delete plots_.back();
        plots_.pop_back();
    }
    while (plots_.size() < contents.size()) {
        auto* plot = new OutputPlot;
        connect(plot, &OutputPlot::timeRangeWanted, this, &PlotPanel::setTimeRange);
        connect(plot, &OutputPlot::allWanted, this, &PlotPanel::showAll);
        connect(plot, &OutputPlot::markWanted, this, &PlotPanel::mark);
        connect(plot, &OutputPlot::trimWanted, this, [this](double from, double to) { trim(std::pair(from, to)); });
        connect(plot, &OutputPlot::pointedAt, this, &PlotPanel::pointAt);
        connect(plot, &OutputPlot::pointerLeft, this, &PlotPanel::leave);
        column_->addWidget(plot, 1);
        plot->fitInto(area_->viewport()->height());
        plot->setVisible(!isResidualView_);
        plots_.push_back(plot);
    }
    const bool isWhole = from_ <= first_ && to_ >= last_;
    const auto time = contents.empty() ? nullptr : contents.front().time;
    first_ = !time || time->empty() ? 0 : time->front();
    last_ = !time || time->empty() ? 1 : time->back();
    const Document::RunPair* runs = document_.comparedRuns();
    const Study& ranOn = runs ? *runs->second.ranOn : document_.study();
    for (std::size_t i = 0; i < contents.size(); ++i) {
        OutputPlot::Content& content = contents[i];
        const Series best = content.after.empty() ? content.before : content.after;
        if (!best.empty() && hasValues(content.measured))
            residuals_[i]->show(withUnit(content.name + " ", content.unit), content.unit,
                                [study = ranOn, name, time = content.time, measured = content.measured, best,
                                 simulated = withUnit(tr("simulated"), content.unit)] {
                                    std::vector<NamedSeries> against = variablesOf(study, name, *time);
                                    against.insert(against.begin(), {simulated, best.copy()});
                                    return residualFacts(residualOf(measured, best).copy(), against);
                                });
        plots_[i]->show(std::move(content));
        plots_[i]->fitInto(area_->viewport()->height());
    }
    const QString key = QString::fromStdString(name);
    const bool isNew = shown_ != key;
    if (isNew) {
        shown_ = key;
        marks_.clear();
        for (OutputPlot* plot : plots_) {
            plot->setMarks(marks_);
            plot->showAllValues();
        }
    }
    if (isNew || isWhole) {
        from_ = first_;
        to_ = last_;
    }
    setTimeRange(from_, to_);
    if ((document_.liveTraces() || document_.preview()) && !runs) showLive();
    const StudyExperiment* shown = shownExperiment();
    const bool isMeasured = std::any_of(plots_.begin(), plots_.end(),
                                        [](const OutputPlot* plot) { return hasValues(plot->content().measured); });
    for (QToolButton* b : {traceView_, residualView_}) b->setVisible(isMeasured);
    trim_->setVisible(isMeasured && !runs);
    if (!isMeasured && isResidualView_) showView(false);
    untrim_->setVisible(shown && shown->range && !runs);
    pages_->setCurrentWidget(area_);
}

void PlotPanel::showLive() {
    const SimulatedTraces* live = document_.liveTraces();
    const Document::Preview* preview = live ? nullptr : document_.preview();
    if ((!live && !preview) || document_.comparedRuns()) return rebuild();
    // A search goes on from the fit with other models, whose errors are smaller: these traces are not its best.
    const QString word = !live                                       ? tr("tried")
                         : document_.liveKind() == RunKind::Discover ? tr("fitted as given")
                                                                     : tr("best so far");
    for (const SimulatedExperiment& experiment : (live ? *live : preview->traces).experiments) {
        if (QString::fromStdString(experiment.name) != shown_) continue;
        for (const SimulatedTrace& trace : experiment.outputs)
            for (OutputPlot* plot : plots_)
                if (plot->content().name == QString::fromStdString(trace.output))
                    plot->showAfter(trace.values, word + " " + style::percentText(trace.errorPercent),
                                    preview ? preview->name : QString());
    }
}

void PlotPanel::setTimeRange(double from, double to) {
    const double whole = last_ - first_;
    double span = std::clamp(to - from, whole * 1e-5, whole);
    from = std::clamp(from, first_, last_ - span);
    from_ = from;
    to_ = from + span;
    for (OutputPlot* plot : plots_) plot->setTimeRange(from_, to_);
}

void PlotPanel::showAll() {
    for (OutputPlot* plot : plots_) plot->showAllValues();
    setTimeRange(first_, last_);
}

void PlotPanel::pointAt(double time) {
    for (OutputPlot* plot : plots_) plot->pointAt(time);
}

void PlotPanel::mark(double time) {
    if (marks_.size() == 2) marks_.clear();
    marks_.push_back(time);
    for (OutputPlot* plot : plots_) plot->setMarks(marks_);
}

const StudyExperiment* PlotPanel::shownExperiment() const {
    if (!document_.isOpen()) return nullptr;
    for (const StudyExperiment& e : document_.study().experiments)
        if (QString::fromStdString(e.name) == shown_) return &e;
    return nullptr;
}

void PlotPanel::setTrimming(bool isTrimming) {
    for (OutputPlot* plot : plots_)
        for (TimePlot* part : {plot->values(), plot->residual()}) part->setTrimming(isTrimming);
    if (isTrimming) {
        showView(false);
        Q_EMIT told(tr("Drag over the part of the recording that is to be used."));
    }
}

void PlotPanel::trim(std::optional<std::pair<double, double>> range) {
    trim_->setChecked(false);
    if (!shownExperiment()) return;
    StudySettings settings = document_.settings();
    for (StudyExperiment& e : settings.experiments)
        if (QString::fromStdString(e.name) == shown_) e.range = range;
    const QString name = std::exchange(shown_, {});  // the whole of what is kept is shown
    document_.applySettings(std::move(settings), range ? tr("Trim %1").arg(name) : tr("Use all of %1").arg(name));
}

void PlotPanel::showView(bool isResidual) {
    isResidualView_ = isResidual;
    traceView_->setChecked(!isResidual);
    residualView_->setChecked(isResidual);
    for (OutputPlot* plot : plots_) plot->setVisible(!isResidual);
    for (ResidualPlot* plot : residuals_) plot->setVisible(isResidual);
}

void PlotPanel::askWhereToExport() {
    auto* dialog = new QFileDialog(window(), tr("Export what is shown"));
    dialog->setObjectName("export-dialog");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setModal(false);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters({tr("Picture (*.png)"), tr("Drawing (*.svg)"), tr("Numbers (*.csv)")});
    dialog->setDefaultSuffix("png");
    connect(dialog, &QFileDialog::filterSelected, dialog,
            [dialog](const QString& filter) { dialog->setDefaultSuffix(filter.section("*.", 1).chopped(1)); });
    connect(dialog, &QFileDialog::fileSelected, this, &PlotPanel::exportTo);
    dialog->show();
}

std::vector<OutputPlot::Content> PlotPanel::shownContents() const {
    std::vector<OutputPlot::Content> contents;
    for (const OutputPlot* plot : plots_) contents.push_back(plot->content());
    return contents;
}

void PlotPanel::exportTo(const QString& file) {
    if (names_.empty()) return Q_EMIT told(tr("There is nothing to export yet."));
    const auto write = [this, &file](std::function<bool()> work) {
        exporter_.start<bool>(
            QString(), [work = std::move(work)](const Progress&) { return work(); },
            [this, file](bool isWritten) {
                Q_EMIT told(isWritten ? tr("Exported to %1.").arg(file) : tr("%1 cannot be written.").arg(file));
            });
    };
    QWidget* body = area_->widget();
    if (file.endsWith(".csv", Qt::CaseInsensitive))
        return write([contents = shownContents(), isComparison = document_.comparedRuns() != nullptr, file] {
            QSaveFile out(file);
            return out.open(QIODevice::WriteOnly) &&
                   out.write(QByteArray::fromStdString(writeCsv(numbersOf(contents, isComparison)))) > 0 &&
                   out.commit();
        });
    if (!file.endsWith(".svg", Qt::CaseInsensitive))
        return write([picture = body->grab().toImage(), file] { return picture.save(file); });
    QByteArray drawing;
    {
        QBuffer buffer(&drawing);
        QSvgGenerator svg;
        svg.setOutputDevice(&buffer);
        svg.setSize(body->size());
        svg.setViewBox(body->rect());
        svg.setTitle(shown_);
        QPainter painter(&svg);
        body->render(&painter);
    }
    write([drawing, file] {
        QSaveFile out(file);
        return out.open(QIODevice::WriteOnly) && out.write(drawing) > 0 && out.commit();
    });
}

void PlotPanel::leave() {
    for (OutputPlot* plot : plots_) plot->pointAt(std::nullopt);
}

}  // namespace analogon::ui
