#pragma once

#include <QAbstractTableModel>
#include <map>
#include <memory>
#include <vector>

#include "core/measure/table.hpp"

namespace analogon::ui {

/// A line of a file as it stands there.
struct FileLine {
    int number{};  // 1-based
    QString text;
};

/// A measurement file as it was read, in its own units or in those of the SI; its first rows, and those that were asked
/// for. A file that could not be read is shown as its lines. The lines of the file number the rows, what is wrong with
/// a line is said in it.
class TableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    using Problems = std::map<int, QString>;  // by line
    void show(std::shared_ptr<const Table> table, Problems problems);
    void show(std::vector<FileLine> lines, Problems problems);
    void setConverted(bool isConverted);
    /// The row that stands in a line of the file, which is shown from then on; -1: there is none.
    int showLine(int line);
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    int lineOf(int row) const;
    void addRowsAround(std::size_t tableRow);
    QString cell(int row, int column) const;

    std::shared_ptr<const Table> table_;
    std::vector<std::size_t> rows_;  // of the table, rising
    std::vector<FileLine> lines_;    // without a table
    struct Shown {
        std::string unit;
        double factor{1}, offset{0};
    };
    std::vector<Shown> converted_;  // by column: its unit of the SI
    Problems problems_;
    bool isConverted_{};
};

}  // namespace analogon::ui
