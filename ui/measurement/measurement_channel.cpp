#include <QActionGroup>
#include <QMenu>
#include <QToolTip>
#include <QTreeWidget>

#include "core/base/unit.hpp"
#include "core/measure/all_channels.hpp"
#include "core/measure/channel_place.hpp"
#include "core/study/recorded.hpp"
#include "ui/document/document.hpp"
#include "ui/measurement/mapping_text.hpp"
#include "ui/measurement/measurement_panel.hpp"
#include "ui/words/common_units.hpp"

/// What is said of a channel that is mapped: its clock, its unit, and how an input runs between its samples.
namespace analogon::ui {

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
