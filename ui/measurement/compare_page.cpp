#include "ui/measurement/compare_page.hpp"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "core/measure/channel.hpp"
#include "core/study/recorded.hpp"
#include "ui/document/document.hpp"
#include "ui/measurement/course_plot.hpp"
#include "ui/measurement/mapping.hpp"
#include "ui/style/ink.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

const ChannelMapping* mappingOf(const StudyExperiment& experiment, const std::string& signal) {
    for (const auto* channels : {&experiment.inputs, &experiment.outputs})
        if (const auto found = channels->find(signal); found != channels->end()) return &found->second;
    return nullptr;
}

std::string unitIn(const ModelFacts& facts, const std::string& signal) {
    const std::string ofInput = unitOf(facts.inputs, signal);
    return ofInput.empty() ? unitOf(facts.outputs, signal) : ofInput;
}

}  // namespace

ComparePage::ComparePage(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      title_(new QLabel(this)),
      caption_(new QLabel(this)),
      reference_(new QComboBox(this)),
      plot_(new CoursePlot(this)),
      table_(new QTableWidget(this)),
      close_(new QPushButton(tr("Close"), this)) {
    style::makeHeading(title_, 1.2);
    style::makeCaption(caption_);
    caption_->setWordWrap(true);
    auto* label = new QLabel(tr("Reference"), this);
    label->setBuddy(reference_);
    reference_->setToolTip(tr("The recording whose stamps are taken for right"));
    table_->setColumnCount(ColumnCount);
    table_->setHorizontalHeaderLabels({tr("Recording"), tr("Shift in s"), tr("How sure"), tr("Clock now"), {}});
    table_->horizontalHeaderItem(Shift)->setToolTip(tr("How much later than the reference it stamps; it can be typed"));
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setSectionResizeMode(About, QHeaderView::Stretch);
    table_->verticalHeader()->hide();
    table_->setFrameShape(QFrame::NoFrame);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setWordWrap(false);  // a long reason is told whole below, of the recording that is chosen
    table_->setAccessibleName(tr("Recordings"));
    auto* heading = new QHBoxLayout;
    heading->setSpacing(2 * style::unit);
    heading->addWidget(title_, 1);
    heading->addWidget(label);
    heading->addWidget(reference_);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(caption_, 1);
    buttons->addWidget(close_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(style::margin, style::margin, style::margin, style::margin);
    layout->setSpacing(2 * style::unit);
    layout->addLayout(heading);
    layout->addWidget(plot_, 3);
    layout->addWidget(table_, 2);
    layout->addLayout(buttons);
    connect(close_, &QPushButton::clicked, this, &ComparePage::left);
    connect(reference_, &QComboBox::activated, this, &ComparePage::refresh);
    connect(table_, &QTableWidget::cellChanged, this, [this](int row, int column) {
        if (column == Shift) shiftTyped(row);
    });
    connect(table_, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (row < 0) return;
        plot_->setMarked(static_cast<std::size_t>(row));
        if (const QTableWidgetItem* about = table_->item(row, About)) caption_->setText(about->text());
    });
    style::onThemeChange(*this, [this] {
        const QSignalBlocker quiet(table_);
        for (int row = 0; row < table_->rowCount(); ++row)
            table_->item(row, Recording)->setForeground(plot_->colourOf(static_cast<std::size_t>(row)));
    });
    connect(&document, &Document::experimentsChanged, this, &ComparePage::refresh);
    connect(&document, &Document::opened, this, &ComparePage::left);
}

/// The channel in the unit of the model, on the raster of its experiment.
ComparePage::Compared ComparePage::recorded(const Tables& tables, const StudyExperiment& experiment,
                                            const ChannelMapping& mapping, const std::string& unit) {
    Compared compared{experiment.name};
    compared.clock = mapping.clock;
    const Outcome<std::shared_ptr<const Table>> table = recordedTable(tables, experiment);
    if (!table) {
        compared.faults = table.diagnostics();
        return compared;
    }
    Outcome<std::vector<double>> time = readTime(**table, experiment.timeColumn),
                                 values = readChannel(**table, mapping, unit, EmptyCells::NotMeasured);
    if (!time || !values) {
        compared.faults = time ? values.diagnostics() : time.diagnostics();
        return compared;
    }
    compared.time = std::move(*time);
    compared.values = std::move(*values);
    return compared;
}

void ComparePage::show(const QString& signal, const QString& reference) {
    signal_ = signal;
    reference_->clear();
    reference_->addItem(reference, reference);
    refresh();
}

/// Reads the recordings and estimates their shifts beside the window.
void ComparePage::refresh() {
    worker_.drop();
    if (signal_.isEmpty() || !document_.isOpen()) return;
    const std::string signal = signal_.toStdString();
    std::vector<StudyExperiment> experiments;
    for (const StudyExperiment& e : document_.study().experiments)
        if (mappingOf(e, signal)) experiments.push_back(e);
    const std::string reference = reference_->currentData().toString().toStdString();
    reference_->clear();
    for (const StudyExperiment& e : experiments)
        reference_->addItem(QString::fromStdString(e.name), QString::fromStdString(e.name));
    reference_->setCurrentIndex(std::max(0, reference_->findData(QString::fromStdString(reference))));
    if (experiments.empty()) return left();
    const auto inFront = experiments.begin() + reference_->currentIndex();
    std::rotate(experiments.begin(), inFront, inFront + 1);
    title_->setText(tr("%1 in several recordings").arg(signal_));
    caption_->setText(tr("Reading …"));
    worker_.start<Comparison>(
        tr("Reading"),
        [experiments, signal, unit = unitIn(document_.facts(), signal),
         tables = document_.study().tables](const Progress& progress) {
            Comparison comparison;
            for (const StudyExperiment& e : experiments) {
                if (progress.stopRequested()) break;
                comparison.recordings.push_back(recorded(tables, e, *mappingOf(e, signal), unit));
                Compared& last = comparison.recordings.back();
                const Compared& front = comparison.recordings.front();
                if (comparison.recordings.size() < 2 || front.time.empty() || last.time.empty()) continue;
                const Outcome<TimeShift> found = timeShift({front.time, front.values}, {last.time, last.values});
                if (found)
                    last.found = *found;
                else
                    last.faults = found.diagnostics();
            }
            return comparison;
        },
        [this](Comparison comparison) { showComparison(std::move(comparison)); });
}

void ComparePage::showComparison(Comparison comparison) {
    shown_ = std::move(comparison);
    std::vector<CoursePlot::Line> lines;
    for (const Compared& compared : shown_.recordings)
        lines.push_back({compared.time, compared.values, compared.found ? compared.found->shift : 0.0});
    plot_->show(std::move(lines), QString::fromStdString(unitIn(document_.facts(), signal_.toStdString())));
    {
        const QSignalBlocker blocker(table_);
        table_->setRowCount(static_cast<int>(shown_.recordings.size()));
        for (int row = 0; row < table_->rowCount(); ++row)
            addRow(row, shown_.recordings[static_cast<std::size_t>(row)], row == 0);
        table_->resizeRowsToContents();
        table_->setCurrentCell(-1, -1);
    }
    caption_->setText(shown_.recordings.size() < 2
                          ? tr("Only one recording has %1: import another one and map it.").arg(signal_)
                          : tr("Each is drawn earlier by its shift: where it is right they lie on each other."));
    // what cannot be told says why at once
    const auto fault = std::find_if(shown_.recordings.begin(), shown_.recordings.end(),
                                    [](const Compared& c) { return !c.faults.empty(); });
    if (fault != shown_.recordings.end())
        table_->setCurrentCell(static_cast<int>(fault - shown_.recordings.begin()), About);
}

void ComparePage::addRow(int row, const Compared& compared, bool isReference) {
    const auto put = [&](Column column, const QString& text, bool isEditable = false) {
        auto* item = new QTableWidgetItem(text);
        item->setFlags(isEditable ? item->flags() : item->flags() & ~Qt::ItemIsEditable);
        table_->setItem(row, column, item);
        return item;
    };
    put(Recording, QString::fromStdString(compared.experiment))
        ->setForeground(plot_->colourOf(static_cast<std::size_t>(row)));
    QString about;
    if (isReference && compared.faults.empty()) about = tr("the reference");
    if (compared.found)
        about = tr("± %1 s, correlation %2")
                    .arg(style::numberText(compared.found->deviation, 2),
                         style::numberText(compared.found->correlation, 3));
    for (const Diagnostic& fault : compared.faults) about += inWords(fault.message);
    put(About, about)->setToolTip(about);
    const bool isShown = !compared.time.empty();
    put(Shift, compared.found ? style::numberText(compared.found->shift, 6) : QString(isReference ? "0" : ""),
        !isReference && isShown);
    put(Clock, style::numberText(compared.clock, 6) + QStringLiteral(" s"));
    table_->removeCellWidget(row, Button);
    put(Button, {});
    if (isReference || !isShown) return;
    auto* set = new QPushButton(tr("Set as its clock"), table_);
    set->setEnabled(compared.found.has_value());
    connect(set, &QPushButton::clicked, this, [this, row] { setClock(row); });
    table_->setCellWidget(row, Button, set);
}

std::optional<double> ComparePage::shiftIn(int row) const {
    const QTableWidgetItem* item = table_->item(row, Shift);
    return item ? style::readNumber(item->text().trimmed()) : std::nullopt;
}

void ComparePage::shiftTyped(int row) {
    const std::optional<double> shift = shiftIn(row);
    if (auto* button = table_->cellWidget(row, Button)) button->setEnabled(shift.has_value());
    if (shift) plot_->setShift(static_cast<std::size_t>(row), *shift);
}

/// A channel is as far ahead as the reference and its shift together.
void ComparePage::setClock(int row) {
    const std::optional<double> shift = shiftIn(row);
    if (!shift || row <= 0 || row >= table_->rowCount()) return;
    const std::string signal = signal_.toStdString(),
                      name = shown_.recordings[static_cast<std::size_t>(row)].experiment;
    const double clock = shown_.recordings.front().clock + *shift;
    StudySettings settings = document_.settings();
    for (StudyExperiment& e : settings.experiments)
        for (auto* channels : {&e.inputs, &e.outputs})
            if (const auto found = channels->find(signal); e.name == name && found != channels->end()) {
                found->second.clock = clock;
                found->second.fitsClock = false;
            }
    dropUnaskedClocks(settings.parameters, settings.experiments);
    document_.applySettings(std::move(settings), tr("Set the clock of %1").arg(signal_));
}

}  // namespace analogon::ui
