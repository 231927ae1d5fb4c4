#pragma once

#include <QWidget>

#include "core/study/study.hpp"
#include "ui/job/job.hpp"
#include "ui/measurement/table_model.hpp"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;

namespace analogon::ui {

class Document;

/// A measurement file before it becomes part of the study: how it is read, what is in it, what is wrong with it.
class ImportPanel : public QWidget {
    Q_OBJECT

public:
    explicit ImportPanel(Document& document, QWidget* parent = nullptr);

    void show(const QString& path);
    QPushButton* acceptButton() const { return accept_; }
    QComboBox* timeBox() const { return time_; }
    TableModel* model() const { return model_; }
    QCheckBox* convertedBox() const { return converted_; }
    QString problems() const;
    /// Shows a line of the file, once it has been read.
    void pointAt(int line);

Q_SIGNALS:
    void accepted(const QString& experiment);
    void cancelled();

private:
    void read();
    /// What was read: the table, or the lines of a file that is none.
    struct Preview {
        Outcome<std::shared_ptr<const Table>> table;  // on one raster
        std::vector<FileLine> lines;
        std::shared_ptr<const Table> file{};
        ReadOptions options{};

        static Preview failed(const Diagnostic& fault) { return {fault, {}}; }
    };
    void showPreview(Preview preview);
    void tellProblems(const Diagnostics& problems);
    void accept();
    QString freeName() const;

    Document& document_;
    QString path_;
    std::shared_ptr<const Table> table_, file_;  // as it is shown, and whole
    ReadOptions options_;
    QString told_;      // what is wrong, as plain text
    int wantedLine_{};  // to be shown once it is there; 0: none
    JobRunner reader_;
    TableModel* model_;
    QLabel *title_, *problems_;
    QLineEdit* name_;
    QComboBox *separator_, *decimal_, *units_, *time_, *role_;
    QCheckBox* converted_;
    QTableView* view_;
    QPushButton *accept_, *cancel_;
};

}  // namespace analogon::ui
