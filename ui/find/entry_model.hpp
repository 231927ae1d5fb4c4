#pragma once

#include <QAbstractTableModel>

#include "ui/find/study_entries.hpp"

namespace analogon::ui {

/// What of a study matches a query: a heading of each kind with its number, and its entries below. One level, so that
/// the arrow keys lead from entry to entry.
class EntryModel : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    void setEntries(std::vector<StudyEntry> entries);
    void search(const QString& query);
    int matches() const { return matches_; }
    /// Null: of a heading.
    const StudyEntry* entryAt(const QModelIndex& index) const;
    /// Invalid: nothing matches.
    QModelIndex firstEntry() const { return matches_ > 0 ? index(1, 0) : QModelIndex(); }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& = {}) const override { return 2; }
    QVariant data(const QModelIndex& index, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

private:
    struct Row {
        int entry{-1};  // -1: the heading of a kind
        StudyEntry::Kind kind{};
        int count{};
    };
    std::vector<StudyEntry> entries_;
    std::vector<Row> rows_;
    int matches_{};
};

}  // namespace analogon::ui
