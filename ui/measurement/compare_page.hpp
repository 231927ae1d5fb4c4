#pragma once

#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/study/recorded.hpp"
#include "core/study/time_shift.hpp"
#include "ui/job/job.hpp"

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace analogon::ui {

class CoursePlot;
class Document;

/// One quantity as several recordings of the study have it, beside each other: how much later than a reference each
/// stamps is estimated, shown, can be typed, and becomes the clock of its channel on a click.
class ComparePage : public QWidget {
    Q_OBJECT

public:
    explicit ComparePage(Document& document, QWidget* parent = nullptr);

    /// The recordings that have this input or output of the model.
    void show(const QString& signal, const QString& reference = {});
    QTableWidget* table() const { return table_; }
    QComboBox* referenceBox() const { return reference_; }
    CoursePlot* plot() const { return plot_; }
    QPushButton* closeButton() const { return close_; }
    /// Sets the clock of the channel of a row; the reference keeps its own.
    void setClock(int row);

Q_SIGNALS:
    void left();

private:
    enum Column { Recording, Shift, About, Clock, Button, ColumnCount };
    struct Compared {
        std::string experiment;
        std::vector<double> time{}, values{};
        double clock{};
        std::optional<TimeShift> found{};
        Diagnostics faults{};
    };
    struct Comparison {
        std::vector<Compared> recordings{};

        static Comparison failed(const Diagnostic& fault) { return {{Compared{{}, {}, {}, 0, {}, {fault}}}}; }
    };
    static Compared recorded(const Tables& tables, const StudyExperiment& experiment, const ChannelMapping& mapping,
                             const std::string& unit);
    void refresh();
    void showComparison(Comparison comparison);
    void addRow(int row, const Compared& compared, bool isReference);
    void shiftTyped(int row);
    std::optional<double> shiftIn(int row) const;

    Document& document_;
    QString signal_;
    Comparison shown_;
    JobRunner worker_;
    QLabel *title_, *caption_;
    QComboBox* reference_;
    CoursePlot* plot_;
    QTableWidget* table_;
    QPushButton* close_;
};

}  // namespace analogon::ui
