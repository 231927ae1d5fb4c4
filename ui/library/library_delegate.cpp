#include "ui/library/library_delegate.hpp"

#include <QApplication>
#include <QPainter>

#include "ui/library/library_model.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

void LibraryDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    QStyledItemDelegate::paint(painter, option, index);
    const QString about = index.data(LibraryModel::AboutRole).toString();
    if (about.isEmpty()) return;
    QStyleOptionViewItem shown = option;
    initStyleOption(&shown, index);
    const QStyle* style = shown.widget ? shown.widget->style() : QApplication::style();
    const QRect words = style->subElementRect(QStyle::SE_ItemViewItemText, &shown, shown.widget);
    const int gap = 3 * style::unit, least = 12 * style::unit;
    const int left = words.left() + style::unit + shown.fontMetrics.horizontalAdvance(shown.text) + gap;
    const QRect room(left, shown.rect.top(), shown.rect.right() - style::unit - left, shown.rect.height());
    if (room.width() < least) return;  // less says nothing
    const bool isSelected = shown.state & QStyle::State_Selected;
    painter->save();
    painter->setFont(shown.font);
    painter->setPen(isSelected ? shown.palette.color(QPalette::HighlightedText) : style::mutedText(shown.palette));
    painter->drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                      shown.fontMetrics.elidedText(about, Qt::ElideRight, room.width()));
    painter->restore();
}

}  // namespace analogon::ui
