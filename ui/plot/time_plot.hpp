#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

namespace analogon::ui {

enum class TraceRole { Measured, Before, After };

struct Trace {
    TraceRole role{TraceRole::Measured};
    std::vector<double> values;  // one per time stamp; NaN: none
};

QColor traceColour(TraceRole role, const QPalette& palette);

/// One axis area over time. The only place that knows the chart library; every trace is decimated to the width
/// it is shown at. Wheel zooms the time axis about the pointer, dragging moves it, Shift and dragging zooms into what
/// is passed over, a double click shows all, Ctrl and a click sets a mark; range and marks are the owner's, who links
/// several plots.
class TimePlot : public QWidget {
    Q_OBJECT

public:
    explicit TimePlot(QWidget* parent = nullptr);
    ~TimePlot() override;

    void setTraces(std::shared_ptr<const std::vector<double>> time, std::vector<Trace> traces);
    /// One of them anew, or one more; the others stay as they are drawn.
    void setTrace(Trace trace);
    void setVisible(TraceRole role, bool isVisible);
    void setTimeRange(double from, double to);
    void setTimeLabels(bool isShown);
    /// Zero in the middle, as a residual is looked at.
    void setSymmetric(bool isSymmetric);
    /// Name at the upper left corner of the area.
    void setCaption(const QString& caption);
    /// While trimming, a drag chooses the range to keep.
    void setTrimming(bool isTrimming);
    void setCursorTime(std::optional<double> time);
    /// Up to two times that stay marked.
    void setMarks(const std::vector<double>& times);
    /// How many points the chart was given for the range shown.
    int paintedPoints() const;
    std::pair<double, double> valueRange() const;

Q_SIGNALS:
    void timeRangeWanted(double from, double to);
    void allWanted();
    void markWanted(double time);
    void trimWanted(double from, double to);
    void pointedAt(double time);
    void pointerLeft();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void refresh();
    void addSeries();
    void draw(std::size_t trace);
    bool isHidden(TraceRole role) const;
    void recolour();
    void colourTraces();
    void layOut();
    void fitValues();
    double timeAt(double x) const;
    double xAt(double time) const;
    void showMarks();

    struct Chart;
    std::unique_ptr<Chart> chart_;
    std::shared_ptr<const std::vector<double>> time_;
    std::vector<Trace> traces_;
    std::vector<std::pair<double, double>> ranges_;  // of their values
    std::vector<TraceRole> hidden_;
    double from_{0}, to_{1};   // [s] shown
    double low_{0}, high_{1};  // values shown
    bool isSymmetric_{}, hasTimeLabels_{true}, isTrimming_{};
    std::optional<double> dragFrom_, zoomFrom_;  // [px]
    std::vector<double> marks_;                  // [s]
};

}  // namespace analogon::ui
