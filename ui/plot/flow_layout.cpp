#include "ui/plot/flow_layout.hpp"

#include <algorithm>

namespace analogon::ui {

FlowLayout::~FlowLayout() { qDeleteAll(items_); }

QSize FlowLayout::minimumSize() const {
    QSize least;
    for (const QLayoutItem* item : items_)
        if (!item->isEmpty()) least = least.expandedTo(item->minimumSize());
    const QMargins margins = contentsMargins();
    return least + QSize(margins.left() + margins.right(), margins.top() + margins.bottom());
}

void FlowLayout::setGeometry(const QRect& rect) {
    QLayout::setGeometry(rect);
    arrange(rect, true);
    firstRowEnd_ = rect.left();
    int top = rect.bottom();
    for (const QLayoutItem* item : items_)
        if (!item->isEmpty()) top = std::min(top, item->geometry().bottom());
    for (const QLayoutItem* item : items_)
        if (!item->isEmpty() && item->geometry().top() < top)
            firstRowEnd_ = std::max(firstRowEnd_, item->geometry().right() + 1);
}

int FlowLayout::arrange(const QRect& rect, bool moves) const {
    const QRect room = rect.marginsRemoved(contentsMargins());
    struct Placed {
        QLayoutItem* item;
        QRect place;
    };
    QList<Placed> row;
    int x = room.left(), y = room.top(), height = 0;
    const auto endRow = [&] {
        for (const Placed& each : row)
            if (moves) each.item->setGeometry(each.place.translated(0, (height - each.place.height()) / 2));
        row.clear();
    };
    for (QLayoutItem* item : items_) {
        if (item->isEmpty()) continue;
        const QSize whole = item->sizeHint();
        const int width = std::min(whole.width(), room.width());
        if (!row.isEmpty() && x + width > room.right() + 1) {
            endRow();
            y += height + spacing() / 2;
            x = room.left();
            height = 0;
        }
        const bool isNarrow = width < whole.width() && item->hasHeightForWidth();
        const QSize size(width, isNarrow ? item->heightForWidth(width) : whole.height());
        row.push_back({item, QRect(QPoint(x, y), size)});
        height = std::max(height, size.height());
        x += width + spacing();
    }
    endRow();
    const QMargins margins = contentsMargins();
    return y + height - room.top() + margins.top() + margins.bottom();
}

}  // namespace analogon::ui
