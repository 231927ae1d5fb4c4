#pragma once

#include <QAbstractItemModel>
#include <QIcon>
#include <map>
#include <memory>

#include "core/library/library.hpp"

namespace analogon::ui {

/// The packages of a library and the classes in them that can be placed on a diagram.
class LibraryModel : public QAbstractItemModel {
    Q_OBJECT

public:
    enum Role {
        ClassNameRole = Qt::UserRole,
        IsPackageRole,
        AboutRole,  // what a block is, in the window's language
        SearchRole  // all by which it is found: its name and its description, in English and in the window's language
    };

    explicit LibraryModel(QObject* parent = nullptr);
    ~LibraryModel() override;

    /// `hidden`: a class that is not offered, as the model being composed.
    void setLibrary(const Library& library, const std::string& hidden);

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& child) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

    QModelIndex find(const QString& className) const;

private:
    struct Node;
    const Node& nodeOf(const QModelIndex& index) const;

    Library library_;
    std::unique_ptr<Node> root_;
    std::vector<std::string> shown_;              // names of the classes shown, to see whether anything changed
    mutable std::map<std::string, QIcon> icons_;  // drawn when first seen
};

/// The icon of a class at a size in pixels.
QPixmap classPixmap(const Library& library, const std::string& className, int size, double ratio);

/// The same as an icon that keeps its colours when its row is selected.
QIcon classIcon(const Library& library, const std::string& className, int size, double ratio);

/// Whether a class can stand in a diagram: a model, a block or a connector that is not partial.
bool isPlaceable(const LibraryClass& cls);

}  // namespace analogon::ui
