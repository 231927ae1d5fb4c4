#pragma once

#include <QAbstractTableModel>
#include <memory>

#include "core/measure/table.hpp"

namespace analogon::ui {

/// A measurement file as it was read, in its own units; the lines of the file number the rows.
class TableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    void show(std::shared_ptr<const Table> table);
    /// The row that stands in a line of the file; -1: none that is shown.
    int rowOfLine(int line) const;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::shared_ptr<const Table> table_;
};

}  // namespace analogon::ui
