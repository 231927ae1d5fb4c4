#include "ui/campaign/units_model.hpp"

#include <QApplication>
#include <QPalette>
#include <cmath>

#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

QString stateText(UnitState state) {
    switch (state) {
        case UnitState::Waiting:
            return UnitsModel::tr("waiting");
        case UnitState::Running:
            return UnitsModel::tr("running");
        case UnitState::Done:
            return UnitsModel::tr("done");
        case UnitState::Failed:
            break;
    }
    return UnitsModel::tr("failed");
}

/// Of a search without effects; as reports name it otherwise.
QString findingText(const std::string& finding) {
    if (finding == "adequate") return UnitsModel::tr("nothing is missing");
    if (finding == "unexplained") return UnitsModel::tr("unexplained");
    if (finding == "partial") return UnitsModel::tr("in part");
    return QString::fromStdString(finding);
}

QString foundText(const UnitRecord& record) {
    QStringList effects;
    for (const UnitEffect& e : record.effects)
        effects << QString::fromStdString(e.kind) + UnitsModel::tr(" at ") + QString::fromStdString(e.at);
    return effects.isEmpty() ? findingText(record.finding) : effects.join("; ");
}

/// Without the folder of the campaign, which is that of all rows.
QString faultOf(const Campaign& campaign, const CampaignUnit& unit, const UnitLook* look) {
    const bool isOfRun = look && look->state == UnitState::Failed;
    if (!isOfRun && unit.faults.empty()) return {};
    QString fault = QString::fromStdString(isOfRun ? look->fault : faultLine(unit.faults));
    return fault.remove(QString::fromStdString((campaign.file.parent_path() / "").string()));
}

/// Negative: not known.
double figure(const UnitRecord& record, int column) {
    switch (column) {
        case UnitsModel::ErrorBefore:
            return record.errorBefore;
        case UnitsModel::ErrorAfter:
            return record.errorAfter;
        case UnitsModel::Seconds:
            return record.seconds;
        default:
            break;
    }
    return -1;
}

bool isFigure(int column) {
    return column == UnitsModel::ErrorBefore || column == UnitsModel::ErrorAfter || column == UnitsModel::Seconds;
}

}  // namespace

void UnitsModel::setCampaign(std::shared_ptr<const Campaign> campaign) {
    beginResetModel();
    campaign_ = std::move(campaign);
    look_.reset();
    endResetModel();
}

void UnitsModel::setLook(std::shared_ptr<const CampaignLook> look) {
    look_ = std::move(look);
    if (rowCount() > 0) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

const CampaignUnit* UnitsModel::unitAt(int row) const {
    return campaign_ && row >= 0 && row < rowCount() ? &campaign_->units[static_cast<std::size_t>(row)] : nullptr;
}

const UnitLook* UnitsModel::lookOf(const std::string& unit) const {
    if (!look_) return nullptr;
    const auto found = look_->units.find(unit);
    return found == look_->units.end() ? nullptr : &found->second;
}

int UnitsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !campaign_ ? 0 : static_cast<int>(campaign_->units.size());
}

int UnitsModel::columnCount(const QModelIndex& parent) const {
    if (parent.isValid()) return 0;
    return FirstAttribute + (campaign_ ? static_cast<int>(campaign_->attributes.size()) : 0) + 1;
}

QVariant UnitsModel::text(const CampaignUnit& unit, const UnitLook* look, int column) const {
    if (column == faultColumn()) return faultOf(*campaign_, unit, look);
    if (column >= FirstAttribute) {
        const auto label = unit.labels.find(campaign_->attributes[static_cast<std::size_t>(column - FirstAttribute)]);
        return label == unit.labels.end() ? QString() : QString::fromStdString(label->second);
    }
    if (column == Unit) return QString::fromStdString(unit.name);
    if (column == State) return stateText(look ? look->state : UnitState::Waiting);
    if (!look || !look->record) return {};
    if (column == Found) return foundText(*look->record);
    const double value = figure(*look->record, column);
    return value >= 0 ? style::fixedText(value, column == Seconds ? 1 : 2) : QString();
}

/// Figures by their size, those that are not known last; units as in their table.
QVariant UnitsModel::sortValue(const CampaignUnit& unit, const UnitLook* look, int row, int column) const {
    if (column == State) return static_cast<int>(look ? look->state : UnitState::Waiting);
    if (column == Unit) return row;
    if (isFigure(column)) {
        const double value = look && look->record ? figure(*look->record, column) : -1;
        return value >= 0 ? value : HUGE_VAL;
    }
    const QString shown = text(unit, look, column).toString();
    bool isNumber = false;
    const double number = shown.toDouble(&isNumber);
    return column >= FirstAttribute && isNumber ? QVariant(number) : QVariant(shown);
}

QVariant UnitsModel::data(const QModelIndex& index, int role) const {
    const CampaignUnit* const unit = index.isValid() ? unitAt(index.row()) : nullptr;
    if (!unit) return {};
    const int column = index.column();
    const UnitLook* const look = lookOf(unit->name);
    switch (role) {
        case Qt::DisplayRole:
            return text(*unit, look, column);
        case SortRole:
            return sortValue(*unit, look, index.row(), column);
        case Qt::ToolTipRole:  // what may be longer than its column
            return column == faultColumn() || column == Found ? text(*unit, look, column) : QVariant();
        case Qt::TextAlignmentRole:
            return isFigure(column) ? QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
        case Qt::ForegroundRole:
            if (column == faultColumn() || (column == State && look && look->state == UnitState::Failed))
                return style::fault(QApplication::palette());
            if (column == State && look && look->state == UnitState::Done) return style::good(QApplication::palette());
            break;
        default:
            break;
    }
    return {};
}

QVariant UnitsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return QAbstractTableModel::headerData(section, orientation, role);
    if (role == Qt::TextAlignmentRole && isFigure(section))
        return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole) return {};
    switch (section) {
        case Unit:
            return tr("Unit");
        case State:
            return tr("State");
        case Found:
            return tr("Found");
        case ErrorBefore:
            return tr("Before [%]");
        case ErrorAfter:
            return tr("After [%]");
        case Seconds:
            return tr("Time [s]");
        default:
            break;
    }
    if (section == faultColumn()) return tr("Fault");
    const auto attribute = static_cast<std::size_t>(section - FirstAttribute);
    return campaign_ && attribute < campaign_->attributes.size()
               ? QString::fromStdString(campaign_->attributes[attribute])
               : QVariant();
}

}  // namespace analogon::ui
