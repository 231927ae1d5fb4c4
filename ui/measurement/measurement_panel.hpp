#pragma once

#include <QWidget>

class QLabel;
class QStackedLayout;
class QTreeWidget;
class QTreeWidgetItem;

namespace analogon::ui {

class Document;

/// The experiments with their files, and which column each model input and output is taken from.
class MeasurementPanel : public QWidget {
    Q_OBJECT

public:
    explicit MeasurementPanel(Document& document, QWidget* parent = nullptr);

    QTreeWidget* tree() const { return tree_; }

Q_SIGNALS:
    void experimentChosen(const QString& name);

private:
    void refresh();

    Document& document_;
    QTreeWidget* tree_;
    QStackedLayout* pages_;
    QLabel* empty_;
};

}  // namespace analogon::ui
