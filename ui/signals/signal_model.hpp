#pragma once

#include <QAbstractItemModel>

#include "ui/signals/signal_list.hpp"

namespace analogon::ui {

/// The signals that match a search, below their recordings and components.
class SignalModel : public QAbstractItemModel {
    Q_OBJECT

public:
    using QAbstractItemModel::QAbstractItemModel;

    void setSignals(std::vector<Signal> all);
    void search(const QString& query);
    const QString& query() const { return query_; }
    /// The recording over which variables of the model are meant.
    void setRecording(const QString& recording) { recording_ = recording; }

    int matches() const { return matches_; }
    int total() const { return static_cast<int>(all_.size()); }
    /// Null: of a group.
    const Signal* signalAt(const QModelIndex& index) const;
    /// As it is meant now; nameless: of a group.
    SignalRef referenceAt(const QModelIndex& index) const;

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& index) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& = {}) const override { return 2; }
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QStringList mimeTypes() const override { return {signalMime}; }
    QMimeData* mimeData(const QModelIndexList& indexes) const override;

private:
    struct Group {
        QString name;
        std::vector<int> members;  // in all_
    };
    std::vector<Signal> all_;
    std::vector<Group> groups_;
    QString query_, recording_;
    int matches_{};
};

}  // namespace analogon::ui
