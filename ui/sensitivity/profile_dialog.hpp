#pragma once

#include <QDialog>
#include <optional>
#include <span>

#include "core/fit/fit.hpp"
#include "ui/job/job.hpp"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace analogon::ui {

class Document;
class FigureChart;

/// The profile of the likelihood of one fitted parameter: it is held at values away from its estimate, all others are
/// fitted anew. Shown with the threshold of 95 %, whose crossings are the ends of the interval. Worked out beside the
/// window from the fit or search that is shown.
class ProfileDialog : public QDialog {
    Q_OBJECT

public:
    explicit ProfileDialog(Document& document, QWidget* parent = nullptr);

    QComboBox* parameterBox() const { return parameter_; }
    QPushButton* runButton() const { return run_; }
    QLabel* outcome() const { return outcome_; }
    FigureChart* chart() const { return chart_; }
    const std::optional<ConfidenceInterval>& interval() const { return interval_; }

private:
    void fillParameters();
    void start();
    /// Neither a profile nor faults: nothing was asked for yet.
    void showOutcome(std::optional<ConfidenceInterval> found, const Diagnostics& faults = {});
    void draw();
    QString wordsOf(const ConfidenceInterval& interval) const;
    void follow();
    /// Of the shown result; none of a simulation.
    std::span<const FitEstimate> estimates() const;
    /// That of the chosen parameter; null: it is not fitted there.
    const FitEstimate* estimate() const;

    Document& document_;
    QComboBox* parameter_;
    QLabel* outcome_;
    FigureChart* chart_;
    QProgressBar* progress_;
    QPushButton* run_;
    std::optional<ConfidenceInterval> interval_;
    bool isStopped_{};
    JobRunner worker_;
};

}  // namespace analogon::ui
