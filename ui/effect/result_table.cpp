#include "ui/effect/result_table.hpp"

#include <QHeaderView>
#include <QTreeWidgetItemIterator>
#include <algorithm>
#include <cmath>

#include "ui/style/ink.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

QString evidenceText(double value) {
    if (!std::isfinite(value)) return QStringLiteral("–");
    if (std::abs(value) < 9999.5) return style::fixedText(value, std::abs(value) < 99.5 ? 1 : 0);
    return style::withDecimalSign(QString::number(value, 'e', 1).remove("+0").remove('+').toStdString());
}

QTreeWidget* resultTable(const QStringList& headers, QWidget* parent) {
    auto* table = new QTreeWidget(parent);
    table->setHeaderLabels(headers);
    table->setRootIsDecorated(false);
    table->setFrameShape(QFrame::NoFrame);
    table->setSelectionMode(QAbstractItemView::NoSelection);
    table->setFocusPolicy(Qt::NoFocus);
    table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->setUniformRowHeights(true);
    table->header()->setStretchLastSection(false);
    table->header()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    style::followTheme(*table);
    return table;
}

void fitTableHeight(QTreeWidget* table) {
    table->doItemsLayout();
    int height = table->header()->sizeHint().height() + 4;
    for (QTreeWidgetItemIterator row(table, QTreeWidgetItemIterator::NotHidden); *row; ++row)
        height += std::max(table->visualItemRect(*row).height(), table->fontMetrics().height() + 4);
    table->setFixedHeight(height);
}

void alignRight(QTreeWidgetItem* item, std::initializer_list<int> columns) {
    for (const int c : columns) item->setTextAlignment(c, Qt::AlignRight | Qt::AlignVCenter);
}

}  // namespace analogon::ui
