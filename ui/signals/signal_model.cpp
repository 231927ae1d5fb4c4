#include "ui/signals/signal_model.hpp"

#include <QFont>
#include <QMimeData>

namespace analogon::ui {

namespace {

constexpr quintptr ofGroups = 0;  // internal id of a group; of a signal that of its group, plus 1

}  // namespace

void SignalModel::setSignals(std::vector<Signal> all) {
    all_ = std::move(all);
    search(query_);
}

void SignalModel::search(const QString& query) {
    beginResetModel();
    query_ = query;
    groups_.clear();
    const std::vector<int> found = matching(all_, query);
    matches_ = static_cast<int>(found.size());
    for (const int i : found) {
        const QString& group = all_[static_cast<std::size_t>(i)].group;
        if (groups_.empty() || groups_.back().name != group) groups_.push_back({group, {}});
        groups_.back().members.push_back(i);
    }
    endResetModel();
}

const Signal* SignalModel::signalAt(const QModelIndex& index) const {
    if (!index.isValid() || index.internalId() == ofGroups) return nullptr;
    const Group& group = groups_[index.internalId() - 1];
    return &all_[static_cast<std::size_t>(group.members[static_cast<std::size_t>(index.row())])];
}

SignalRef SignalModel::referenceAt(const QModelIndex& index) const {
    const Signal* signal = signalAt(index);
    if (!signal) return {};
    SignalRef reference = signal->reference;
    if (reference.recording.isEmpty()) reference.recording = recording_;
    return reference;
}

QModelIndex SignalModel::index(int row, int column, const QModelIndex& parent) const {
    if (!hasIndex(row, column, parent)) return {};
    return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) + 1 : ofGroups);
}

QModelIndex SignalModel::parent(const QModelIndex& index) const {
    if (!index.isValid() || index.internalId() == ofGroups) return {};
    return createIndex(static_cast<int>(index.internalId() - 1), 0, ofGroups);
}

int SignalModel::rowCount(const QModelIndex& parent) const {
    if (!parent.isValid()) return static_cast<int>(groups_.size());
    if (parent.internalId() != ofGroups || parent.column() > 0) return 0;
    return static_cast<int>(groups_[static_cast<std::size_t>(parent.row())].members.size());
}

QVariant SignalModel::data(const QModelIndex& index, int role) const {
    const Signal* signal = signalAt(index);
    if (!signal) {
        if (!index.isValid() || index.column() > 0) return {};
        if (role == Qt::DisplayRole) return groups_[static_cast<std::size_t>(index.row())].name;
        if (role != Qt::FontRole) return {};
        QFont bold;
        bold.setWeight(QFont::DemiBold);
        return bold;
    }
    const SignalRef& reference = signal->reference;
    if (role == Qt::ToolTipRole)
        return signal->description.isEmpty() ? reference.name : reference.name + "\n" + signal->description;
    if (role != Qt::DisplayRole) return {};
    if (index.column() == 1) return signal->unit;
    const bool isInComponent = reference.kind == SignalKind::Variable && reference.name.startsWith(signal->group + '.');
    if (isInComponent) return reference.name.mid(signal->group.size() + 1);
    const bool isOfRecording = reference.kind == SignalKind::Residual || reference.kind == SignalKind::Sensitivity;
    return isOfRecording ? reference.name + " · " + reference.recording : reference.name;
}

QVariant SignalModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    return section == 0 ? tr("Signal") : tr("Unit");
}

Qt::ItemFlags SignalModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) return Qt::NoItemFlags;
    return Qt::ItemIsEnabled | (signalAt(index) ? Qt::ItemIsSelectable | Qt::ItemIsDragEnabled : Qt::NoItemFlags);
}

QMimeData* SignalModel::mimeData(const QModelIndexList& indexes) const {
    std::vector<SignalRef> references;
    for (const QModelIndex& index : indexes)
        if (index.column() == 0 && signalAt(index)) references.push_back(referenceAt(index));
    auto* data = new QMimeData;
    data->setData(signalMime, mimeOf(references));
    return data;
}

}  // namespace analogon::ui
