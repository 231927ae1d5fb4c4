#pragma once

#include <QDialog>
#include <array>
#include <optional>

#include "core/study/parameter_sweep.hpp"
#include "ui/job/job.hpp"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace analogon::ui {

class Document;
class SweepChart;
struct SweepPoint;

/// Leads one or two parameters through values and shows the error of the fitted recordings as a curve or a map. It is
/// worked out beside the window; stopped, it shows what it has.
class SweepDialog : public QDialog {
    Q_OBJECT

public:
    explicit SweepDialog(Document& document, QWidget* parent = nullptr);

    struct Axis {
        QComboBox* parameter{};
        QLineEdit *from{}, *to{};
        QSpinBox* count{};
        QCheckBox* byFactors{};
    };
    const Axis& axis(int i) const { return axes_[static_cast<std::size_t>(i)]; }
    QPushButton* runButton() const { return run_; }
    QLabel* outcome() const { return outcome_; }
    SweepChart* chart() const { return chart_; }
    const std::optional<ParameterSweep>& sweep() const { return sweep_; }

private:
    void addAxis(class QGridLayout& grid, int i);
    void fillParameters();
    void proposeRange(int i);
    std::optional<SweepAxis> wanted(int i);
    void start();
    void showOutcome(Outcome<ParameterSweep> found);
    void follow();
    /// The parameters to a point of the sweep, as one step.
    void take(const SweepPoint& point);
    void showPresent();

    Document& document_;
    std::array<Axis, 2> axes_;
    QLabel* outcome_;
    SweepChart* chart_;
    QProgressBar* progress_;
    QPushButton* run_;
    std::optional<ParameterSweep> sweep_;
    JobRunner worker_;
};

}  // namespace analogon::ui
