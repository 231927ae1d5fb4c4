#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

#include "core/measure/table.hpp"
#include "ui/job/job.hpp"
#include "ui/plot/time_plot.hpp"

class QHBoxLayout;
class QLabel;
class QToolButton;
class QScrollArea;
class QStackedLayout;
class QTabBar;
class QVBoxLayout;

namespace analogon {
struct ModelState;
struct ExperimentState;
struct StudyExperiment;
enum class Role;
}  // namespace analogon

namespace analogon::ui {

class Document;
class FlowLayout;
class ResidualPlot;

/// One output: a heading that is also the legend, values, residual.
class OutputPlot : public QWidget {
    Q_OBJECT

public:
    explicit OutputPlot(QWidget* parent = nullptr);

    struct Content {
        QString name, unit;
        std::shared_ptr<const std::vector<double>> time;
        Series measured;
        Series before, after;             // empty: none
        QString beforeLabel, afterLabel;  // with the error: "before 8.6 %"
        Series measuredBefore{};          // what `before` is held against; empty: what was measured
        QString note{};                   // beside the caption of the residual
    };
    void show(Content content);
    /// Another simulated trace in place of the one after.
    void showAfter(const Series& values, const QString& label, const QString& note = {});
    void setTimeRange(double from, double to);
    void showAllValues();
    void pointAt(std::optional<double> time);
    void setMarks(const std::vector<double>& times);
    const Content& content() const { return content_; }
    /// Where there is no room for all of it, or nothing was measured, the residual gives way, and the values carry the
    /// time axis; no word of the legend does.
    void fitInto(int height);

    TimePlot* values() const { return values_; }
    TimePlot* residual() const { return residual_; }
    QString legendText(TraceRole role) const;

Q_SIGNALS:
    void timeRangeWanted(double from, double to);
    void allWanted();
    void markWanted(double time);
    void trimWanted(double from, double to);
    void pointedAt(double time);
    void pointerLeft();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void readOut(std::optional<double> time);
    QString readoutText(std::optional<double> time) const;
    void showReadout(const QString& text);
    void fitLegend();
    void setLegend(TraceRole role, const QString& text);
    Content content_;
    QLabel* name_;
    QLabel* readout_;
    std::vector<double> marks_;
    QWidget* head_{};
    FlowLayout* heading_{};
    int room_{1 << 20};  // [px] of what it is shown in
    class LegendEntry;
    std::vector<LegendEntry*> legend_;
    TimePlot* values_;
    TimePlot* residual_;
};

/// Measured against simulated, before and after, of one experiment at a time: for each output the values and the
/// residual below. All time axes move together.
class PlotPanel : public QWidget {
    Q_OBJECT

public:
    explicit PlotPanel(Document& document, QWidget* parent = nullptr);

    void showExperiment(const QString& name);
    /// Every output of every experiment, whole, for paper: one after the other, between which the window does what else
    /// it has to do.
    void takePictures(std::function<void(std::vector<QImage>)> done);
    /// One per output of the experiment that is shown.
    const std::vector<OutputPlot*>& plots() const { return plots_; }
    const std::vector<ResidualPlot*>& residuals() const { return residuals_; }
    QToolButton* residualButton() const { return residualView_; }
    QToolButton* trimButton() const { return trim_; }
    QToolButton* endComparisonButton() const { return endComparison_; }
    /// What is shown as a picture (png, svg) or as numbers (csv), by the ending of the file; tells how it went.
    void exportTo(const QString& file);
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void told(const QString& sentence);

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void refresh();
    QString textOfNone() const;
    void rebuild();
    void arrangeBar();
    int widthOfButtons() const;
    /// The best so far of a fit that runs, a few times a second: only the trace that moves is drawn anew.
    void showLive();
    void setTimeRange(double from, double to);
    void showAll();
    void pointAt(double time);
    void leave();
    void mark(double time);
    /// Keeps a part of the recording; the whole again when it is kept as a whole.
    void trim(std::optional<std::pair<double, double>> range);
    void setTrimming(bool isTrimming);
    const StudyExperiment* shownExperiment() const;
    /// The model with the effect, else without, else what was measured alone; null: nothing.
    std::shared_ptr<const ModelState> shownState() const;
    std::vector<OutputPlot::Content> contentsOf(const std::string& experiment) const;
    /// The same of what is shown: the study, or two runs of its history.
    std::vector<OutputPlot::Content> contentsShown(const std::string& experiment) const;
    std::vector<std::pair<std::string, Role>> experimentsShown() const;
    void showView(bool isResidual);
    void askWhereToExport();
    /// What the plots show now: of a fit that runs, the best so far.
    std::vector<OutputPlot::Content> shownContents() const;

    Document& document_;
    QTabBar* experiments_;
    QHBoxLayout *bar_, *buttons_;
    QStackedLayout* pages_;
    QLabel* empty_;
    QScrollArea* area_;
    QVBoxLayout* column_;
    std::vector<OutputPlot*> plots_;
    std::vector<std::string> names_;
    double from_{0}, to_{0}, first_{0}, last_{0};
    unsigned long version_{};    // of the traces shown
    std::vector<double> marks_;  // [s] at most two
    std::vector<ResidualPlot*> residuals_;
    QToolButton *traceView_, *residualView_, *trim_, *untrim_, *export_, *endComparison_;
    bool isResidualView_{};
    QString shown_;  // experiment the time range belongs to
    JobRunner exporter_;
};

}  // namespace analogon::ui
