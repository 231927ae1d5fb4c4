#pragma once

#include <QDialog>

#include "ui/find/entry_model.hpp"

class QLabel;
class QLineEdit;
class QTreeView;

namespace analogon::ui {

class Document;

/// Finds in the whole study while one types. The arrow keys choose, Enter goes there, Escape leaves.
class FindDialog : public QDialog {
    Q_OBJECT

public:
    explicit FindDialog(Document& document, QWidget* parent = nullptr);

    QLineEdit* field() const { return field_; }
    QTreeView* list() const { return list_; }
    QLabel* count() const { return count_; }
    const EntryModel& model() const { return *model_; }

Q_SIGNALS:
    void chosen(const analogon::ui::StudyEntry& entry);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void search();
    void go();

    QLineEdit* field_;
    QTreeView* list_;
    QLabel* count_;
    EntryModel* model_;
};

}  // namespace analogon::ui
