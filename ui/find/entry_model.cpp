#include "ui/find/entry_model.hpp"

#include <QApplication>
#include <QFont>
#include <QPalette>

#include "ui/style/style.hpp"

namespace analogon::ui {

void EntryModel::setEntries(std::vector<StudyEntry> entries) { entries_ = std::move(entries); }

void EntryModel::search(const QString& query) {
    beginResetModel();
    rows_.clear();
    const std::vector<int> found = matchingEntries(entries_, query);
    matches_ = static_cast<int>(found.size());
    std::size_t heading = 0;
    for (const int i : found) {
        const StudyEntry::Kind kind = entries_[static_cast<std::size_t>(i)].kind;
        if (rows_.empty() || rows_.back().kind != kind) {
            heading = rows_.size();
            rows_.push_back({-1, kind, 0});
        }
        ++rows_[heading].count;
        rows_.push_back({i, kind, 0});
    }
    endResetModel();
}

const StudyEntry* EntryModel::entryAt(const QModelIndex& index) const {
    if (!index.isValid() || index.row() >= static_cast<int>(rows_.size())) return nullptr;
    const Row& row = rows_[static_cast<std::size_t>(index.row())];
    return row.entry < 0 ? nullptr : &entries_[static_cast<std::size_t>(row.entry)];
}

int EntryModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant EntryModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const Row& row = rows_[static_cast<std::size_t>(index.row())];
    if (const StudyEntry* entry = entryAt(index)) {
        if (role == Qt::DisplayRole) return index.column() == 0 ? entry->name : entry->detail;
        if (role == Qt::ToolTipRole) return entry->name + (entry->detail.isEmpty() ? "" : "\n" + entry->detail);
        if (role == Qt::ForegroundRole && index.column() == 1) return style::mutedText(QApplication::palette());
        return {};
    }
    if (role == Qt::DisplayRole && index.column() == 0)
        return QStringLiteral("%1 (%2)").arg(titleOf(row.kind)).arg(row.count);
    if (role == Qt::ForegroundRole) return style::accentText(QApplication::palette());
    if (role == Qt::FontRole) {
        QFont font = QApplication::font();
        font.setWeight(QFont::DemiBold);
        return font;
    }
    return {};
}

Qt::ItemFlags EntryModel::flags(const QModelIndex& index) const {
    return entryAt(index) ? Qt::ItemIsEnabled | Qt::ItemIsSelectable : Qt::ItemFlags();
}

}  // namespace analogon::ui
