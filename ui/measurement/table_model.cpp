#include "ui/measurement/table_model.hpp"

#include <QGuiApplication>
#include <algorithm>
#include <cmath>

#include "core/base/unit.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

constexpr std::size_t firstRows = 1000;  // a preview; the whole file is read nevertheless
constexpr std::size_t around = 3;        // rows on either side of one that was asked for

/// The unit of the SI for the same quantity: an angle in rad, a fraction in 1.
std::string unitOfSi(const std::string& unit) {
    for (const char* named : {"K", "rad", "rad/s", "V", "A", "Ohm", "W", "N", "N.m", "Pa", "J", "Hz"})
        if (const Outcome<UnitConversion> to = convertUnit(unit, named))
            return to->factor == 1 && to->offset == 0 ? unit : named;
    const auto dimension = dimensionOf(unit);
    return dimension ? text(*dimension) : unit;
}

}  // namespace

void TableModel::show(std::shared_ptr<const Table> table, Problems problems) {
    beginResetModel();
    table_ = std::move(table);
    problems_ = std::move(problems);
    lines_.clear();
    rows_.clear();
    converted_.clear();
    if (table_) {
        for (std::size_t i = 0; i < std::min(table_->rows(), firstRows); ++i) rows_.push_back(i);
        for (const Column& column : table_->columns) {
            Shown shown{column.unit.empty() ? std::string() : unitOfSi(column.unit), 1, 0};
            if (const Outcome<UnitConversion> to = convertUnit(column.unit, shown.unit))
                shown = {shown.unit, to->factor, to->offset};
            else
                shown.unit = column.unit;
            converted_.push_back(shown);
        }
    }
    endResetModel();
    for (const auto& [line, problem] : problems_) showLine(line);
}

void TableModel::show(std::vector<FileLine> lines, Problems problems) {
    beginResetModel();
    table_ = nullptr;
    rows_.clear();
    lines_ = std::move(lines);
    problems_ = std::move(problems);
    endResetModel();
}

void TableModel::setConverted(bool isConverted) {
    beginResetModel();
    isConverted_ = isConverted;
    endResetModel();
}

void TableModel::addRowsAround(std::size_t tableRow) {
    beginResetModel();
    const std::size_t first = tableRow - std::min(tableRow, around);
    for (std::size_t i = first; i < std::min(table_->rows(), tableRow + around + 1); ++i) rows_.push_back(i);
    std::sort(rows_.begin(), rows_.end());
    rows_.erase(std::unique(rows_.begin(), rows_.end()), rows_.end());
    endResetModel();
}

int TableModel::showLine(int line) {
    if (table_) {
        const auto at = std::find(table_->lines.begin(), table_->lines.end(), line);
        if (at == table_->lines.end()) return -1;
        const auto row = static_cast<std::size_t>(at - table_->lines.begin());
        if (!std::binary_search(rows_.begin(), rows_.end(), row)) addRowsAround(row);
    }
    for (int row = 0; row < rowCount(); ++row)
        if (lineOf(row) == line) return row;
    return -1;
}

int TableModel::lineOf(int row) const {
    const auto i = static_cast<std::size_t>(row);
    if (!table_) return lines_[i].number;
    return rows_[i] < table_->lines.size() ? table_->lines[rows_[i]] : static_cast<int>(rows_[i]) + 1;
}

int TableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(table_ ? rows_.size() : lines_.size());
}

int TableModel::columnCount(const QModelIndex& parent) const {
    if (parent.isValid()) return 0;
    return table_ ? static_cast<int>(table_->columns.size()) : lines_.empty() ? 0 : 1;
}

QString TableModel::cell(int row, int column) const {
    const auto r = static_cast<std::size_t>(row), c = static_cast<std::size_t>(column);
    if (!table_) return lines_[r].text;
    const double value = table_->columns[c].values[rows_[r]];
    if (!std::isfinite(value)) return {};
    const Shown& to = converted_[c];
    return style::numberText(isConverted_ ? to.factor * value + to.offset : value, 9);
}

QVariant TableModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    switch (role) {
        case Qt::DisplayRole:
            return cell(index.row(), index.column());
        case Qt::TextAlignmentRole:
            return QVariant((table_ ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
        case Qt::BackgroundRole: {
            if (!problems_.contains(lineOf(index.row()))) return {};
            const QPalette palette = QGuiApplication::palette();
            return style::mix(palette.color(QPalette::Base), style::caution(palette), 0.25);
        }
        case Qt::ToolTipRole: {
            const auto problem = problems_.find(lineOf(index.row()));
            return problem == problems_.end() ? QVariant() : problem->second;
        }
        default:
            return {};
    }
}

QVariant TableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole) return {};
    if (orientation == Qt::Vertical) return section < rowCount() ? lineOf(section) : QVariant();
    if (section >= columnCount()) return {};
    if (!table_) return tr("Lines of the file");
    const auto c = static_cast<std::size_t>(section);
    const Column& column = table_->columns[c];
    const std::string& unit = isConverted_ ? converted_[c].unit : column.unit;
    QString text = QString::fromStdString(column.name);
    if (!unit.empty()) text += QStringLiteral("\n[%1]").arg(QString::fromStdString(unit));
    return text;
}

}  // namespace analogon::ui
