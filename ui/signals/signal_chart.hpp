#pragma once

#include <QChartView>
#include <memory>
#include <optional>
#include <vector>

#include "ui/plot/decimate.hpp"
#include "ui/signals/plot_layout.hpp"
#include "ui/signals/signal_values.hpp"

class QLineSeries;
class QValueAxis;

namespace analogon::ui {

/// A trace as it is drawn.
struct ChartLine {
    SignalRef reference;
    QColor colour;
    std::shared_ptr<const SignalData> data;  // null, or without times: nothing is drawn

    friend bool operator==(const ChartLine&, const ChartLine&) = default;  // the same numbers, not equal ones
};

/// One axis area of signals over time, by Qt Charts: its axes, grid and series. A series gets what its trace covers in
/// each column of pixels, so that a million samples cost no more than a thousand. Units that differ from that of the
/// first trace are on the axis at the right. The values follow the part that is visible.
///
/// Wheel zooms the time about the pointer, dragging moves it, Shift and dragging zooms into what is marked, a double
/// click shows all, Ctrl and a click sets one of two cursors; arrows move the pointer, with Ctrl the time; + and -
/// zoom, Enter sets a cursor, Home shows all.
class SignalChart : public QChartView {
    Q_OBJECT

public:
    explicit SignalChart(QWidget* parent = nullptr);
    QSize sizeHint() const override { return {300, 140}; }  // not that of its scene: axes share the room there is

    void setLines(std::vector<ChartLine> lines);
    const std::vector<ChartLine>& lines() const { return lines_; }
    void setTimeRange(double from, double to);
    void setCursorTime(std::optional<double> time);
    void setMarks(const std::vector<double>& times);
    /// Of the left axis, or of the one at the right.
    std::pair<double, double> valueRange(bool isRight = false) const;
    bool hasRightAxis() const;
    /// How many points all series hold.
    int pointsDrawn() const;

Q_SIGNALS:
    void timeRangeWanted(double from, double to);
    void allWanted();
    void markWanted(double time);
    void pointedAt(double time);
    void pointerLeft();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void drawForeground(QPainter* painter, const QRectF& rect) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void style();
    void feed();
    QList<QPointF> pointsOf(std::size_t line, ValueRange& range) const;
    void scale(QValueAxis& axis, const ValueRange& range);
    QRectF area() const;
    double timeAt(double x) const;
    double xAt(double time) const;
    void zoom(double about, double factor);

    std::vector<ChartLine> lines_;
    std::vector<ValueExtent> extents_;   // of their values
    std::vector<QLineSeries*> series_;   // owned by the chart
    QValueAxis *time_, *left_, *right_;  // likewise
    double from_{0}, to_{1};             // [s] shown
    std::optional<double> cursor_;       // [s]
    std::vector<double> marks_;          // [s]
    std::optional<double> dragFrom_, bandFrom_;
    double bandTo_{};  // [px]
};

/// What is written at an axis: the units of the traces that are on it.
QString axisUnits(const std::vector<ChartLine>& lines, bool isRight);

}  // namespace analogon::ui
