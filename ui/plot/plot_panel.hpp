#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "ui/plot/time_plot.hpp"

class QLabel;
class QScrollArea;
class QStackedLayout;
class QTabBar;
class QVBoxLayout;

namespace analogon {
struct ModelState;
struct ExperimentState;
}  // namespace analogon

namespace analogon::ui {

class Document;
class OutputPlot;

/// Measured against simulated, before and after, of one experiment at a time: for each output the values and the
/// residual below. All time axes move together.
class PlotPanel : public QWidget {
    Q_OBJECT

public:
    explicit PlotPanel(Document& document, QWidget* parent = nullptr);

    void showExperiment(const QString& name);
    /// One per output of the experiment that is shown.
    const std::vector<OutputPlot*>& plots() const { return plots_; }

private:
    void refresh();
    void rebuild();
    void setTimeRange(double from, double to);
    void showAll();
    void pointAt(double time);
    void leave();

    Document& document_;
    QTabBar* experiments_;
    QStackedLayout* pages_;
    QLabel* empty_;
    QScrollArea* area_;
    QVBoxLayout* column_;
    std::vector<OutputPlot*> plots_;
    std::vector<std::string> names_;
    double from_{0}, to_{0}, first_{0}, last_{0};
    unsigned long version_{};  // of the traces shown
    QString shown_;            // experiment the time range belongs to
};

/// One output: a heading that is also the legend, values, residual.
class OutputPlot : public QWidget {
    Q_OBJECT

public:
    explicit OutputPlot(QWidget* parent = nullptr);

    struct Content {
        QString name, unit;
        std::shared_ptr<const std::vector<double>> time;
        std::vector<double> measured;
        std::vector<double> before, after;  // empty: none
        QString beforeLabel, afterLabel;    // with the error: "before 8.6 %"
    };
    void show(Content content);
    void setTimeRange(double from, double to);
    void pointAt(std::optional<double> time);

    TimePlot* values() const { return values_; }
    TimePlot* residual() const { return residual_; }
    QString legendText(TraceRole role) const;

Q_SIGNALS:
    void timeRangeWanted(double from, double to);
    void allWanted();
    void pointedAt(double time);
    void pointerLeft();

private:
    void setLegend(TraceRole role, const QString& text);
    Content content_;
    QLabel* name_;
    QLabel* readout_;
    class LegendEntry;
    std::vector<LegendEntry*> legend_;
    TimePlot* values_;
    TimePlot* residual_;
};

}  // namespace analogon::ui
