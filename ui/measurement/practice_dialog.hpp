#pragma once

#include <QDialog>
#include <memory>
#include <optional>

#include "core/study/practice_recording.hpp"
#include "ui/job/job.hpp"

class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace analogon {
struct ModelState;
}  // namespace analogon

namespace analogon::ui {

class Document;

/// Makes a recording to practise on from the simulation of the model by itself that is shown: a CSV file with noise,
/// and an experiment of the study whose columns are mapped to the outputs, as one undoable edit.
class PracticeDialog : public QDialog {
    Q_OBJECT

public:
    /// `folder`: where the file goes unless the user says otherwise; empty: beside the study.
    PracticeDialog(Document& document, const QString& folder, QWidget* parent = nullptr);

    QLineEdit* sampleTimeField() const { return sampleTime_; }
    QSpinBox* seedBox() const { return seed_; }
    QLineEdit* fileField() const { return file_; }
    QTableWidget* noiseTable() const { return noise_; }
    QPushButton* recordButton() const { return record_; }
    QLabel* faultLabel() const { return fault_; }

Q_SIGNALS:
    void recorded(const QString& experiment, const QString& file);

private:
    void fill(const QString& folder);
    QLayout* fields();
    void askForFile();
    void check();
    /// What is asked for; empty: something is no number, `why` says what.
    std::optional<PracticeOptions> options(QString& why) const;
    void record();
    void add(const std::shared_ptr<const Table>& table, const QString& path);

    Document& document_;
    std::shared_ptr<const ModelState> run_;
    const ExperimentState* experiment_{};
    QLineEdit *sampleTime_, *file_;
    QSpinBox* seed_;
    QTableWidget* noise_;
    QLabel* fault_;
    QPushButton* record_;
    JobRunner writer_;
};

}  // namespace analogon::ui
