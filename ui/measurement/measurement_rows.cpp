#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QStackedLayout>
#include <QToolButton>
#include <QTreeWidget>
#include <map>
#include <set>

#include "core/measure/all_channels.hpp"
#include "core/measure/channel_place.hpp"
#include "core/measure/common_raster.hpp"
#include "core/study/recorded.hpp"
#include "ui/document/document.hpp"
#include "ui/measurement/locate.hpp"
#include "ui/measurement/mapping.hpp"
#include "ui/measurement/mapping_text.hpp"
#include "ui/measurement/measurement_panel.hpp"
#include "ui/measurement/recording_extent.hpp"
#include "ui/style/ink.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

/// The rows of the list of recordings: what they show of the study.
namespace analogon::ui {

namespace {

/// Whether a recording is used, and for what.
void showUse(QTreeWidgetItem* top, const StudyExperiment& experiment, const QPalette& palette) {
    const bool isFit = experiment.role == Role::Fit;
    QFont bold = top->font(0);
    bold.setWeight(QFont::DemiBold);
    top->setFont(0, bold);
    top->setCheckState(0, experiment.isUsed ? Qt::Checked : Qt::Unchecked);
    top->setText(1, isFit ? MeasurementPanel::tr("fit") : MeasurementPanel::tr("validate"));
    top->setToolTip(1, isFit ? MeasurementPanel::tr("Used to fit and to choose effects")
                             : MeasurementPanel::tr("Only reported; never used to fit or to choose"));
    style::tint(*top, 1, isFit ? style::accentText : style::mutedText, palette);
}

QString rangeText(const StudyExperiment& experiment) {
    if (!experiment.range) return MeasurementPanel::tr("all");
    const auto [from, to] = *experiment.range;
    return QStringLiteral("%1 … %2 s").arg(style::numberText(from, 6), style::numberText(to, 6));
}

}  // namespace

QTreeWidgetItem* MeasurementPanel::addRow(QTreeWidgetItem* top, Kind kind, const QString& text, const QString& value) {
    auto* item = new QTreeWidgetItem(top, {text, value});
    item->setData(0, kindRole, static_cast<int>(kind));
    return item;
}

void MeasurementPanel::addSpares(QTreeWidgetItem* top, const Table& file, const std::set<QString>& used) {
    const QIcon icon = style::icon("spare");
    const ChannelLabels labels(file);
    QList<QTreeWidgetItem*> items;
    for (const Column* column : channelsOf(file)) {
        const std::string name = labels.of(*column);
        const QString label = QString::fromStdString(name);
        if (used.contains(label)) continue;
        auto* item = new QTreeWidgetItem({tr("not used"), withUnit(name, column->unit)});
        item->setData(0, kindRole, static_cast<int>(Kind::Spare));
        item->setData(1, columnRole, label);
        item->setIcon(0, icon);
        item->setToolTip(0, tr("Kept: the search for effects may use it as a cause"));
        item->setToolTip(1, item->text(1));  // where the list has no room for the whole of it
        for (int c : {0, 1}) style::tint(*item, c, style::mutedText, palette());
        items << item;
    }
    top->addChildren(items);
}

void MeasurementPanel::showExtent(QTreeWidgetItem* info, const RecordingExtent& extent) {
    info->setData(0, extentRole, true);
    const QString text = QStringLiteral(" · ") + extentText(extent);
    info->setText(0, info->text(0) + text);
    info->setToolTip(0, info->toolTip(0).replace('\n', text + '\n'));
}

/// A range is looked for in every row.
bool MeasurementPanel::isExtentAtHand(const StudyExperiment& experiment) const {
    return !experiment.range && isAtHand(document_.study().tables, experiment);
}

void MeasurementPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (isMeasureOwed_) measureExtents();
}

/// Channels of several rasters are joined beside the window: that may take a while, and is not done for nobody.
void MeasurementPanel::measureExtents() {
    isMeasureOwed_ = !isVisible();
    if (isMeasureOwed_) return measurer_.drop();
    using Extents = std::vector<std::pair<QString, RecordingExtent>>;
    std::vector<StudyExperiment> experiments;
    for (std::size_t i = 0; i < shown_.size(); ++i)
        if (!tree_->topLevelItem(static_cast<int>(i))->child(0)->data(0, extentRole).toBool())
            experiments.push_back(shown_[i].recording);
    if (experiments.empty()) return measurer_.drop();
    measurer_.start<Extents>(
        tr("Reading"),
        [experiments, tables = document_.study().tables](const Progress& progress) {
            Extents extents;
            for (const StudyExperiment& e : experiments) {
                if (progress.stopRequested()) break;
                if (const auto table = shownTable(tables, e))
                    extents.emplace_back(QString::fromStdString(e.name), extentOf(*table, e));
            }
            return extents;
        },
        [this](const Extents& extents) {
            // no width depends on it: the columns need not be measured with each of them
            const QSignalBlocker blocker(tree_), quiet(tree_->model());
            tree_->viewport()->update();
            for (int i = 0; i < tree_->topLevelItemCount(); ++i)
                for (const auto& [name, extent] : extents)
                    if (QTreeWidgetItem* const top = tree_->topLevelItem(i);
                        top->data(0, experimentRole).toString() == name)
                        showExtent(top->child(0), extent);
        });
}

void MeasurementPanel::markLeftOut() {
    const QSignalBlocker blocker(tree_);
    for (int i = 0; i < tree_->topLevelItemCount(); ++i)
        if (const StudyExperiment* const experiment = experimentOf(tree_->topLevelItem(i)))
            mark(tree_->topLevelItem(i), *experiment);
}

/// A recording that is not used, or has a fault, is told from the others, and why is said where one points.
void MeasurementPanel::mark(QTreeWidgetItem* top, const StudyExperiment& experiment) const {
    const bool isMissing = isUnread(document_.study(), experiment);
    const FaultyRecording* const faulty = experiment.isUsed ? document_.leftOut(experiment.name) : nullptr;
    QStringList why;
    for (const Diagnostic& said : faulty ? faulty->why : Diagnostics())
        if (said.severity == Severity::Error) why << inWords(said.message);
    const QString tip = faulty              ? tr("Left out until this is mended:") + "\n" + why.join('\n')
                        : experiment.isUsed ? tr("Clear the check box to leave the recording out of all work")
                                            : tr("Left out of all work; set the check box to take it in");
    if (top->toolTip(0) == tip) return;  // it says all that the row shows of it
    top->setIcon(0, style::icon(isMissing ? "error" : faulty ? "warning" : "recording"));
    style::tint(*top, 0,
                !experiment.isUsed    ? style::mutedText
                : faulty || isMissing ? style::caution
                                      : nullptr,
                palette());
    top->setToolTip(0, tip);
}

/// Why there is nothing of the file, and what to do.
void MeasurementPanel::addUnread(QTreeWidgetItem* top, const QStringList& faults) {
    if (faults.isEmpty()) return;
    auto* item = addRow(top, Kind::Unread, faults.front(), {});
    item->setIcon(0, style::icon("error"));
    style::tint(*item, 0, style::fault, palette());
    item->setToolTip(0, faults.join('\n') + '\n' + tr("Double-click or Enter looks for the file"));
}

/// Where two columns fit alike, which they are.
QString MeasurementPanel::unmappedText(const StudyExperiment& experiment, const SignalFact& fact, bool isInput,
                                       const Table* table) {
    constexpr std::size_t mostNamed = 3;
    const auto rivals = table ? rivalColumns(experiment, fact, isInput, *table) : std::vector<std::string>();
    if (rivals.empty() || rivals.size() > mostNamed) return tr("not mapped");
    QStringList names;
    for (const std::string& name : rivals) names << QString::fromStdString(name);
    return tr("%1?").arg(names.join(tr(" or ")));
}

/// The row of a recording with those below it. They come into the tree together: it lays itself out once.
QTreeWidgetItem* MeasurementPanel::itemOf(const RowContent& content) {
    const StudyExperiment& experiment = content.recording;
    const Table* const table = content.table.get();
    const QString file = QString::fromStdString(std::filesystem::path(experiment.file).filename().string());
    const QString name = QString::fromStdString(experiment.name);
    auto* top = new QTreeWidgetItem({name});
    top->setFlags(top->flags() | Qt::ItemIsEditable);
    top->setData(0, experimentRole, name);
    top->setData(0, kindRole, static_cast<int>(Kind::Experiment));
    showUse(top, experiment, palette());
    auto* info = addRow(top, Kind::Info, file, {});
    style::tint(*info, 0, style::mutedText, palette());
    info->setToolTip(0, QString::fromStdString(experiment.file) + "\n" + tr("Double-click or Enter shows the values"));
    addUnread(top, content.faults);
    mark(top, experiment);
    if (table && isExtentAtHand(experiment)) showExtent(info, extentOf(*table, experiment));

    std::set<QString> used{labelText(table, {experiment.timeColumn, experiment.timeGroup})};
    const auto add = [&](const std::map<std::string, ChannelMapping>& channels,
                         const std::vector<SignalFact>& signalFacts, Kind kind) {
        const bool isInput = kind == Kind::Input;
        const auto addSignal = [&](const std::string& signal, const ChannelMapping* mapping,
                                   const QString& unmapped = {}) {
            auto* item =
                addRow(top, kind, QString::fromStdString(signal), mapping ? columnText(table, *mapping) : unmapped);
            item->setFlags(item->flags() | Qt::ItemIsEditable);
            item->setData(0, signalRole, QString::fromStdString(signal));
            item->setIcon(0, style::icon(isInput ? "input" : "output"));
            item->setToolTip(0, isInput ? tr("Input of the model") : tr("Output of the model"));
            if (!mapping) {
                style::tint(*item, 1, style::caution, palette());
                item->setToolTip(1, tr("Drag a column here, or double-click and choose one"));
                item->setData(1, columnRole, QString());
                return;
            }
            const QString label = labelText(table, mapping->channel());
            item->setData(1, columnRole, label);
            item->setToolTip(1, mappingTip(*mapping, file));
            item->setText(Clock, clockText(*mapping));
            style::tint(*item, Clock,
                        mapping->fitsClock      ? style::accentText
                        : hasOwnClock(*mapping) ? nullptr
                                                : style::mutedText,
                        palette());
            item->setToolTip(Clock, clockTip(!isInput));
            const Column* const column = columnOf(table, mapping->channel());
            item->setText(Unit, QString::fromStdString(mapping->unit.empty() && column ? column->unit : mapping->unit));
            style::tint(*item, Unit, mapping->unit.empty() ? style::mutedText : nullptr, palette());
            item->setToolTip(Unit, mapping->unit.empty() ? tr("As the file says") : tr("Told here, not by the file"));
            used.insert(label);
        };
        for (const auto& [signal, mapping] : channels) addSignal(signal, &mapping);
        for (const SignalFact& fact : signalFacts)
            if (!channels.contains(fact.name))
                addSignal(fact.name, nullptr, unmappedText(experiment, fact, isInput, table));
    };
    add(experiment.inputs, document_.facts().inputs, Kind::Input);
    add(experiment.outputs, document_.facts().outputs, Kind::Output);
    if (table) addSpares(top, *table, used);
    auto* rangeItem = addRow(top, Kind::Range, tr("range"), rangeText(experiment));
    rangeItem->setFlags(rangeItem->flags() | Qt::ItemIsEditable);
    rangeItem->setIcon(0, style::icon("time"));
    style::tint(*rangeItem, 1, style::mutedText, palette());
    rangeItem->setToolTip(1, tr("Double-click and type from and to, in seconds"));
    return top;
}

std::vector<MeasurementPanel::RowContent> MeasurementPanel::contents() const {
    const Study& study = document_.study();
    std::vector<RowContent> contents;
    for (const StudyExperiment& experiment : study.experiments) {
        RowContent& content = contents.emplace_back(experiment, fileTable(study.tables, experiment));
        if (!isUnread(study, experiment)) continue;
        for (const Diagnostic& d : study.unread.at(tableKey(experiment))) content.faults << inWords(d.message);
    }
    return contents;
}

void MeasurementPanel::unfold(QTreeWidgetItem* top, bool isUnfolded) {
    for (int i = 0; i < top->childCount(); ++i)
        if (const auto kind = static_cast<Kind>(top->child(i)->data(0, kindRole).toInt());
            kind == Kind::Info || kind == Kind::Unread)
            top->child(i)->setFirstColumnSpanned(true);
    top->setExpanded(isUnfolded);
}

/// The rows from `first` on, without the last `last`, anew. A recording stays folded or unfolded, and the current row
/// stays where it was; of many, new ones are folded.
void MeasurementPanel::replaceRows(std::size_t first, std::size_t last, const std::vector<RowContent>& now) {
    constexpr std::size_t mostUnfolded = 12;
    const int row = static_cast<int>(first), count = static_cast<int>(shown_.size() - last) - row;
    std::map<QString, bool> wasUnfolded;
    for (int i = row; i < row + count; ++i)
        wasUnfolded[tree_->topLevelItem(i)->data(0, experimentRole).toString()] = tree_->topLevelItem(i)->isExpanded();
    const QTreeWidgetItem* current = tree_->currentItem();
    const QString currentSignal = current ? current->data(0, signalRole).toString() : QString();
    while (current && current->parent()) current = current->parent();
    const QString currentName = current ? current->data(0, experimentRole).toString() : QString();
    QList<QTreeWidgetItem*> items;
    for (std::size_t i = first; i < now.size() - last; ++i) items << itemOf(now[i]);
    tree_->model()->removeRows(row, count);
    tree_->insertTopLevelItems(row, items);
    for (QTreeWidgetItem* const top : items) {
        const QString name = top->data(0, experimentRole).toString();
        const auto known = wasUnfolded.find(name);
        unfold(top, known == wasUnfolded.end() ? now.size() <= mostUnfolded : known->second);
        if (name != currentName) continue;
        const bool isSeen = top->isExpanded() && !currentSignal.isEmpty();  // else it would unfold them
        QTreeWidgetItem* const signal = isSeen ? signalItem(currentName, currentSignal) : nullptr;
        tree_->setCurrentItem(signal ? signal : top);
    }
}

/// Only what has changed is built anew: a study may have hundreds of recordings, and most edits are of one of them.
void MeasurementPanel::fillTree() {
    std::vector<RowContent> now = contents();
    const ModelFacts& facts = document_.facts();
    const bool isSameModel = facts.inputs == shownInputs_ && facts.outputs == shownOutputs_;
    std::size_t first = 0, last = 0;
    const std::size_t most = isSameModel ? std::min(now.size(), shown_.size()) : 0;
    while (first < most && now[first] == shown_[first]) ++first;
    while (last < most - first && now[now.size() - 1 - last] == shown_[shown_.size() - 1 - last]) ++last;
    if (first + last < std::max(now.size(), shown_.size())) replaceRows(first, last, now);
    shown_ = std::move(now);
    shownInputs_ = facts.inputs;
    shownOutputs_ = facts.outputs;
}

void MeasurementPanel::refresh() {
    const QSignalBlocker blocker(tree_);
    const auto isSaid = [](const StudyExperiment& experiment, bool (*says)(const ChannelMapping&)) {
        const auto isOwn = [says](const auto& channel) { return says(channel.second); };
        return std::any_of(experiment.inputs.begin(), experiment.inputs.end(), isOwn) ||
               std::any_of(experiment.outputs.begin(), experiment.outputs.end(), isOwn);
    };
    const int scrolled = tree_->verticalScrollBar()->value();
    const bool isOpen = document_.isOpen();
    import_->setEnabled(isOpen);
    table_->setEnabled(isOpen && !document_.study().experiments.empty());
    propose_->setEnabled(isOpen && !document_.study().experiments.empty());
    if (isOpen) fillTree();
    measureExtents();
    // few channels have a clock or a unit of their own: the names of columns need the room
    const auto& experiments = document_.study().experiments;
    const auto isSaidAnywhere = [&](bool (*says)(const ChannelMapping&)) {
        return isOpen && std::any_of(experiments.begin(), experiments.end(),
                                     [&](const StudyExperiment& e) { return isSaid(e, says); });
    };
    tree_->setColumnHidden(Clock, !isSaidAnywhere(hasOwnClock));
    tree_->setColumnHidden(Unit, !isSaidAnywhere([](const ChannelMapping& m) { return !m.unit.empty(); }));
    tree_->verticalScrollBar()->setValue(scrolled);
    empty_->setText(isOpen
                        ? tr("Drop a measurement file on the window, or press Import.\nIts columns are then mapped to "
                             "the inputs and outputs of the model.")
                        : tr("The measurements of the open study appear here."));
    pages_->setCurrentWidget(tree_->topLevelItemCount() > 0 ? static_cast<QWidget*>(tree_) : empty_);
}

}  // namespace analogon::ui
