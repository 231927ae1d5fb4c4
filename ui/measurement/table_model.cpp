#include "ui/measurement/table_model.hpp"

#include <cmath>

namespace analogon::ui {

void TableModel::show(std::shared_ptr<const Table> table) {
    beginResetModel();
    table_ = std::move(table);
    endResetModel();
}

int TableModel::rowOfLine(int line) const {
    for (int row = 0; row < rowCount(); ++row)
        if (headerData(row, Qt::Vertical, Qt::DisplayRole).toInt() == line) return row;
    return -1;
}

int TableModel::rowCount(const QModelIndex& parent) const {
    constexpr std::size_t shown = 1000;  // a preview; the whole file is read nevertheless
    return parent.isValid() || !table_ ? 0 : static_cast<int>(std::min(table_->rows(), shown));
}

int TableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() || !table_ ? 0 : static_cast<int>(table_->columns.size());
}

QVariant TableModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || !table_) return {};
    if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole) return {};
    const auto& values = table_->columns[static_cast<std::size_t>(index.column())].values;
    const double value = values[static_cast<std::size_t>(index.row())];
    return std::isfinite(value) ? QString::number(value, 'g', 9) : QString();
}

QVariant TableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole || !table_) return {};
    if (orientation == Qt::Vertical) {
        const auto row = static_cast<std::size_t>(section);
        return row < table_->lines.size() ? table_->lines[row] : section + 1;
    }
    if (section >= columnCount()) return {};
    const Column& column = table_->columns[static_cast<std::size_t>(section)];
    QString text = QString::fromStdString(column.name);
    if (!column.unit.empty()) text += QStringLiteral("\n[%1]").arg(QString::fromStdString(column.unit));
    return text;
}

}  // namespace analogon::ui
