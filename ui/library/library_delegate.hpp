#pragma once

#include <QStyledItemDelegate>

namespace analogon::ui {

/// A block of the library: its name, which is the one in the model's text, and behind it, as far as there is room, what
/// it is in the language of the window.
class LibraryDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace analogon::ui
