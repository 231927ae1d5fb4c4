#pragma once

#include <QAbstractTableModel>
#include <map>
#include <optional>

#include "core/base/unit.hpp"
#include "ui/document/document.hpp"

namespace analogon::ui {

/// The parameters of the model, and the clocks of loggers that are to be fitted, with their fit settings and, after a
/// run, their results. Every edit goes through the document and can be undone.
class ParameterModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, Value, Unit, Result, Bounds, Min, Max, Prior, ColumnCount };
    /// BarRole: where the value lies in its bounds and the ends of its standard error, each 0 … 1, as a list of
    /// doubles. UnitsRole: the units the value can be shown in.
    enum Role { IsFittedRole = Qt::UserRole, AtBoundRole, NameRole, BarRole, UnitsRole };

    explicit ParameterModel(Document& document, QObject* parent = nullptr);

    /// Only the parameters of this component; empty, or where it has none: all.
    void setComponent(const QString& component);
    bool isOfComponent() const { return isOfComponent_; }
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
    /// What a row means and what the fit says about it, as HTML with links to what is named.
    QString noteOn(int row) const;
    /// Whether something is known beforehand of any parameter of the study.
    bool hasPriors() const;

private:
    struct Row {
        std::string name, unit, description;
        std::optional<double> value;
        std::optional<StudyParameter> setting;
        const FitEstimate* estimate{};
    };
    void refresh();
    static bool showsSame(const Row& a, const Row& b);
    std::vector<Row> fittedClocks() const;
    QVariant display(const Row& row, int column) const;
    QString edited(const Row& row, int column) const;
    QString boundText(const Row& row) const;
    QString tooltip(const Row& row, int column) const;
    StudyParameter settingOf(const Row& row) const;
    bool setNumber(const Row& row, int column, const QString& text);
    bool setPrior(const Row& row, const QString& text);
    bool setUnit(const Row& row, const QString& unit);
    /// From the model's unit to the one it is shown in.
    UnitConversion shownAs(const Row& row) const;
    /// What is known beforehand, in that unit.
    std::optional<NormalPrior> shownPrior(const Row& row) const;
    QString unitText(const Row& row) const;
    QVariantList bar(const Row& row) const;
    QString boundHint(const Row& row) const;
    const Text* remarkOn(const Row& row) const;

    Document& document_;
    std::vector<Row> rows_;
    std::map<std::string, std::string> units_;  // parameter: the unit the user chose to see it in
    QString component_, filter_;
    bool onlyFitted_{}, isOfComponent_{};
    bool isResultNew_{};  // since the rows were read
};

}  // namespace analogon::ui
