#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/unit.hpp"
#include "core/study/study.hpp"
#include "ui/document/model_facts.hpp"

namespace analogon::ui {

/// The values of a recording, every row of it: each column as the file has it, and beside one that is mapped what the
/// model gets of it. Nothing is copied: a cell is worked out when it is drawn.
class ValuesModel : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    /// null: nothing.
    void show(std::shared_ptr<const Table> table, const StudyExperiment& experiment, const ModelFacts& facts);
    void setShown(bool isRaw, bool isConverted);
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    /// A column of the file, or what the model gets of it.
    struct Shown {
        std::size_t column{};
        QString heading, unit, tip;
        std::optional<UnitConversion> conversion;  // none: as the file has it
    };
    void arrange();
    bool isUsed(std::size_t row) const;

    std::shared_ptr<const Table> table_;
    std::vector<Shown> all_, shown_;
    bool isRaw_{true}, isConverted_{true};
    const Column* time_{};  // null: there is no range
    UnitConversion toSeconds_;
    std::optional<std::pair<double, double>> range_;  // [s] that is used
};

}  // namespace analogon::ui
