#pragma once

#include <QAbstractTableModel>
#include <memory>

#include "core/campaign/campaign_look.hpp"

namespace analogon::ui {

/// The units of a campaign, in the order of their table: how far each is, what was found, its errors and its
/// attributes.
class UnitsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Unit, State, Found, ErrorBefore, ErrorAfter, Seconds, FirstAttribute };  // and the fault, at the end
    enum { SortRole = Qt::UserRole };

    using QAbstractTableModel::QAbstractTableModel;

    void setCampaign(std::shared_ptr<const Campaign> campaign);
    void setLook(std::shared_ptr<const CampaignLook> look);

    int faultColumn() const { return columnCount() - 1; }
    const CampaignUnit* unitAt(int row) const;
    /// What is known of a unit from its run; null: nothing.
    const UnitLook* lookOf(const std::string& unit) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QVariant text(const CampaignUnit& unit, const UnitLook* look, int column) const;
    QVariant sortValue(const CampaignUnit& unit, const UnitLook* look, int row, int column) const;

    std::shared_ptr<const Campaign> campaign_;
    std::shared_ptr<const CampaignLook> look_;
};

}  // namespace analogon::ui
