#pragma once

#include <QAbstractTableModel>
#include <optional>

#include "ui/document/document.hpp"

namespace analogon::ui {

/// The parameters of the model with their fit settings and, after a run, their results. Every edit goes through
/// the document and can be undone.
class ParameterModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, Value, Unit, Min, Max, Result, ColumnCount };
    enum Role { IsFittedRole = Qt::UserRole, AtBoundRole, NameRole };

    explicit ParameterModel(Document& document, QObject* parent = nullptr);

    /// Only the parameters of this component; empty: all.
    void setComponent(const QString& component);
    /// Only names that contain the text.
    void setFilter(const QString& text);
    void setOnlyFitted(bool onlyFitted);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

    int rowOf(const std::string& name) const;

private:
    struct Row {
        std::string name, unit, description;
        std::optional<double> value;
        std::optional<StudyParameter> setting;
        const FitEstimate* estimate{};
    };
    void refresh();
    QVariant display(const Row& row, int column) const;
    QString boundText(const Row& row) const;
    QString tooltip(const Row& row, int column) const;
    StudyParameter settingOf(const Row& row) const;
    bool setNumber(const Row& row, int column, const QString& text);

    Document& document_;
    std::vector<Row> rows_;
    QString component_, filter_;
    bool onlyFitted_{};
};

/// A number as an engineer writes it: 5 significant digits, no trailing zeros.
QString numberText(double value, int digits = 5);

}  // namespace analogon::ui
