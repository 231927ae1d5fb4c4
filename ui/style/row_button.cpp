#include "ui/style/row_button.hpp"

#include <QAbstractItemView>
#include <QStyleOptionToolButton>
#include <QStylePainter>

namespace analogon::ui::style {

void RowButton::paintEvent(QPaintEvent*) {
    QStyleOptionToolButton option;
    initStyleOption(&option);
    const QModelIndex row = view_.indexAt(geometry().center());
    const bool isSelected = row.isValid() && view_.selectionModel()->isSelected(row);
    const bool hasGround = option.state & (QStyle::State_MouseOver | QStyle::State_Sunken);  // of its own
    if (isEnabled() && isSelected && !hasGround)
        option.icon = QIcon(icon().pixmap(iconSize(), devicePixelRatioF(), QIcon::Selected));
    QStylePainter(this).drawComplexControl(QStyle::CC_ToolButton, option);
}

}  // namespace analogon::ui::style
