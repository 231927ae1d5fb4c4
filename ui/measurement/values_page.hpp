#pragma once

#include <QWidget>
#include <memory>

#include "ui/job/job.hpp"

class QCheckBox;
class QLabel;
class QPushButton;
class QTableView;

namespace analogon {
struct StudyExperiment;
struct Table;
}  // namespace analogon
namespace analogon::ui {

class Document;
class ValuesModel;

/// A recording of the study after it was imported: what its file says, and what the model gets of that.
class ValuesPage : public QWidget {
    Q_OBJECT

public:
    explicit ValuesPage(Document& document, QWidget* parent = nullptr);

    void show(const QString& experiment);
    const QString& experiment() const { return experiment_; }
    ValuesModel* model() const { return model_; }
    QTableView* view() const { return view_; }
    QCheckBox* rawBox() const { return raw_; }
    QCheckBox* convertedBox() const { return converted_; }
    QPushButton* closeButton() const { return close_; }

Q_SIGNALS:
    void left();

private:
    void refresh();
    void showTable(const StudyExperiment& experiment, const std::shared_ptr<const Table>& table);
    void leave();
    void choose();

    Document& document_;
    QString experiment_;
    JobRunner joiner_;
    ValuesModel* model_;
    QLabel *title_, *caption_;
    QCheckBox *raw_, *converted_;
    QTableView* view_;
    QPushButton* close_;
};

}  // namespace analogon::ui
