#include <fmt/format.h>
#include <fmt/ranges.h>

#include <QActionGroup>
#include <QMenu>
#include <QToolTip>
#include <QTreeWidget>
#include <cctype>
#include <limits>

#include "core/base/unit.hpp"
#include "core/measure/all_channels.hpp"
#include "core/measure/channel.hpp"
#include "core/measure/channel_place.hpp"
#include "core/signal/few_points.hpp"
#include "core/study/recorded.hpp"
#include "ui/document/composer.hpp"
#include "ui/document/document.hpp"
#include "ui/measurement/mapping_text.hpp"
#include "ui/measurement/measurement_panel.hpp"
#include "ui/words/common_units.hpp"
#include "ui/words/words.hpp"

/// What is said of a channel that is mapped: its clock, its unit, and how an input runs between its samples; and a
/// channel as a source of the model.
namespace analogon::ui {

namespace {

/// Of a mapped channel in the unit of the model; of another in the coherent one of the SI.
std::string unitOfSource(const Column& column, const std::string& wanted) {
    if (!wanted.empty()) return wanted;
    const std::optional<Dimension> dimension = dimensionOf(column.unit);
    return dimension ? analogon::text(*dimension) : column.unit;
}

std::string sourceName(const std::string& column) {
    std::string name = column;
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return isModelicaName(name) ? name : "recorded";
}

/// The channel as a line through few of its points, from the first of them on.
Outcome<std::string> sourceOf(const Tables& tables, StudyExperiment experiment, const ChannelMapping& mapping,
                              const std::string& unit) {
    constexpr std::size_t most = 200;  // what one still reads past in a text
    constexpr double share = 1e-3;     // of its range, by which the line may be off
    findTime(tables, experiment);
    const std::shared_ptr<const Table> table = shownTable(tables, experiment);
    const Column* column = table ? table->find(mapping.column) : nullptr;
    if (!column || column->values.empty())
        return error(phrase("{} was not read from its file", mapping.column), {},
                     phrase("Map it to an input or an output of the model."));
    const Outcome<std::vector<double>> time = readTime(*table, experiment.timeColumn);
    if (!time) return time.diagnostics();
    Outcome<std::vector<double>> values =
        readChannel(*table, mapping, unitOfSource(*column, unit), EmptyCells::NotMeasured);
    if (!values) return values.diagnostics();
    for (std::size_t i = 0; experiment.range && i < values->size(); ++i)
        if ((*time)[i] < experiment.range->first || (*time)[i] > experiment.range->second)
            (*values)[i] = std::numeric_limits<double>::quiet_NaN();
    std::vector<std::string> t, v;
    const std::vector<std::size_t> points = fewPoints(*time, *values, most, share);
    for (const std::size_t i : points) {
        t.push_back(fmt::format("{:.9g}", (*time)[i] - (*time)[points.front()]));
        v.push_back(fmt::format("{:.6g}", (*values)[i]));
    }
    return fmt::format("Analogon.Sources.TimeTable {}(t={{{}}}, value={{{}}})", sourceName(mapping.column),
                       fmt::join(t, ", "), fmt::join(v, ", "));
}

}  // namespace

void MeasurementPanel::setClock(const QTreeWidgetItem* item, const QString& typed) {
    const ChannelMapping* mapping = mappingOf(item);
    if (!mapping || typed == clockText(*mapping)) return;
    const bool isInput = static_cast<Kind>(item->data(0, kindRole).toInt()) == Kind::Input;
    const std::string signal = item->data(0, signalRole).toString().toStdString();
    const bool isFitted = !isInput && typed.trimmed() == tr("fit");
    const std::optional<double> seconds = isFitted ? std::optional(0.0) : readSeconds(typed);
    if (!seconds || (mapping->fitsClock == isFitted && mapping->clock == *seconds)) return;
    change(item, tr("Set the clock of %1").arg(QString::fromStdString(signal)), [&](StudyExperiment& e) {
        ChannelMapping& changed = (isInput ? e.inputs : e.outputs)[signal];
        changed.fitsClock = isFitted;
        changed.clock = *seconds;
    });
}

void MeasurementPanel::holdInput(const QTreeWidgetItem* item, bool isHeld) {
    const ChannelMapping* mapping = mappingOf(item);
    const bool isInput = mapping && static_cast<Kind>(item->data(0, kindRole).toInt()) == Kind::Input;
    if (!isInput || (mapping->interpolation == Interpolation::Hold) == isHeld) return;
    const std::string signal = item->data(0, signalRole).toString().toStdString();
    const QString what = isHeld ? tr("Hold %1 between its samples") : tr("Join the samples of %1");
    change(item, what.arg(QString::fromStdString(signal)), [&](StudyExperiment& e) {
        e.inputs[signal].interpolation = isHeld ? Interpolation::Hold : Interpolation::Linear;
    });
}

/// How an input runs between its samples.
void MeasurementPanel::addInterpolation(QMenu& menu, const QTreeWidgetItem* item) {
    const ChannelMapping* mapping = mappingOf(item);
    if (!mapping || static_cast<Kind>(item->data(0, kindRole).toInt()) != Kind::Input) return;
    auto* group = new QActionGroup(&menu);
    for (const bool isHeld : {false, true}) {
        QAction* action = menu.addAction(isHeld ? tr("Held between its samples") : tr("Straight between its samples"),
                                         this, [this, item, isHeld] { holdInput(item, isHeld); });
        action->setCheckable(true);
        action->setChecked((mapping->interpolation == Interpolation::Hold) == isHeld);
        group->addAction(action);
    }
    menu.addSeparator();
}

void MeasurementPanel::addSource(QMenu& menu, const QTreeWidgetItem* item) {
    const StudyExperiment* experiment = experimentOf(item);
    const QString label = item->data(1, columnRole).toString();
    const auto file = experiment ? fileTable(document_.study().tables, *experiment) : nullptr;
    if (label.isEmpty() || !file) return;
    ChannelMapping mapping;
    std::string unit;
    if (const ChannelMapping* known = mappingOf(item)) {
        mapping = *known;
        unit = unitInModel(item);
    } else {
        const ChannelName name = channelOf(*file, label.toStdString());
        mapping.column = name.column;
        mapping.group = name.group;
    }
    menu.addAction(tr("Put into the model as a source"), this,
                   [this, recording = *experiment, mapping, unit] { makeSource(recording, mapping, unit); });
}

void MeasurementPanel::makeSource(const StudyExperiment& experiment, const ChannelMapping& mapping,
                                  const std::string& unit) {
    sourceMaker_.start<Outcome<std::string>>(
        tr("Reading"),
        [tables = document_.study().tables, experiment, mapping, unit](const Progress&) {
            return sourceOf(tables, experiment, mapping, unit);
        },
        [this](const Outcome<std::string>& made) {
            if (made) return Q_EMIT sourceMade(QString::fromStdString(*made));
            const Diagnostic& why = made.diagnostics().front();
            Q_EMIT told(why.hint.empty() ? inWords(why.message) : inWords(why.message) + ". " + inWords(why.hint));
        });
}

/// In which the file says the column is written; empty: it says nothing.
std::string MeasurementPanel::unitInFile(const QTreeWidgetItem* item) const {
    const ChannelMapping* mapping = mappingOf(item);
    const auto file = mapping ? fileTable(document_.study().tables, *experimentOf(item)) : nullptr;
    const Column* column = file ? columnOf(file.get(), mapping->channel()) : nullptr;
    return column ? column->unit : std::string();
}

std::string MeasurementPanel::unitInModel(const QTreeWidgetItem* item) const {
    const bool isInput = static_cast<Kind>(item->data(0, kindRole).toInt()) == Kind::Input;
    const ModelFacts& facts = document_.facts();
    return unitOf(isInput ? facts.inputs : facts.outputs, item->data(0, signalRole).toString().toStdString());
}

QStringList MeasurementPanel::unitsFor(const QTreeWidgetItem* item) const {
    const std::string own = unitInFile(item);
    QStringList units = unitsLike(unitInModel(item));
    const QString ofFile = QString::fromStdString(own);
    units.removeAll(ofFile);
    if (!ofFile.isEmpty()) units.prepend(ofFile);
    return units;
}

/// "unit" of the mapping; that of the file needs none.
void MeasurementPanel::setUnit(const QTreeWidgetItem* item, const QString& typed) {
    const ChannelMapping* mapping = mappingOf(item);
    const std::string unit = typed.trimmed().toStdString(), inModel = unitInModel(item);
    if (!mapping) return;
    QString why = whyNoUnit(unit);
    if (why.isEmpty() && !unit.empty() && !inModel.empty() && !areConvertible(unit, inModel))
        why = tr("%1 cannot be converted to %2, the unit of the model.")
                  .arg(QString::fromStdString(unit), QString::fromStdString(inModel));
    if (!why.isEmpty()) {
        const QRect cell = tree_->visualItemRect(item);
        return QToolTip::showText(tree_->viewport()->mapToGlobal(cell.bottomLeft()), why, tree_);
    }
    const std::string told = unit == unitInFile(item) ? std::string() : unit;
    if (told == mapping->unit) return;
    const bool isInput = static_cast<Kind>(item->data(0, kindRole).toInt()) == Kind::Input;
    const std::string signal = item->data(0, signalRole).toString().toStdString();
    change(item, tr("Set the unit of %1").arg(QString::fromStdString(signal)),
           [&](StudyExperiment& e) { (isInput ? e.inputs : e.outputs)[signal].unit = told; });
}

}  // namespace analogon::ui
