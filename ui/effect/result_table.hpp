#pragma once

#include <QTreeWidget>
#include <initializer_list>

namespace analogon::ui {

/// Three digits at most: evidence spans many powers of ten, and nobody reads its fourth digit.
QString evidenceText(double value);

/// A table that is as high as its rows and scrolls with the page.
QTreeWidget* resultTable(const QStringList& headers, QWidget* parent);
/// As high as the rows that are shown.
void fitTableHeight(QTreeWidget* table);
void alignRight(QTreeWidgetItem* item, std::initializer_list<int> columns);

}  // namespace analogon::ui
