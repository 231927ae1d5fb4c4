#pragma once

#include <QPixmap>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "ui/plot/decimate.hpp"
#include "ui/plot/series.hpp"

namespace analogon::ui {

enum class TraceRole { Measured, Before, After };

struct Trace {
    TraceRole role{TraceRole::Measured};
    Series values;  // one per time stamp; NaN: none
};

QColor traceColour(TraceRole role, const QPalette& palette);

/// One axis area over time. A trace is drawn from what it covers in each column of pixels, so that a million samples
/// cost no more than a thousand; grid and traces are kept as a picture while only the pointer moves.
/// Wheel zooms the time axis about the pointer, with Ctrl the axis of the values; dragging moves the time axis, Shift
/// and dragging zooms into the box that is drawn (into its time alone where it is flat), a double click shows all, Ctrl
/// and a click sets a mark. With the keys: arrows move the pointer, with Ctrl the axis, + and - zoom, Enter sets a
/// mark, Home shows all. Times and marks are the owner's, who links several plots; the values shown are the plot's own.
class TimePlot : public QWidget {
    Q_OBJECT

public:
    explicit TimePlot(QWidget* parent = nullptr);

    void setTraces(std::shared_ptr<const std::vector<double>> time, std::vector<Trace> traces);
    /// One of them anew, or one more.
    void setTrace(Trace trace);
    const std::vector<Trace>& traces() const { return traces_; }
    void setVisible(TraceRole role, bool isVisible);
    void setTimeRange(double from, double to);
    /// The values shown; as all traces need it until the user has zoomed into a part.
    std::pair<double, double> valueRange() const { return {low_, high_}; }
    void showAllValues();
    void setTimeLabels(bool isShown);
    /// Zero in the middle, as a residual is looked at.
    void setSymmetric(bool isSymmetric);
    /// Name at the upper left corner of the area.
    void setCaption(const QString& caption);
    /// A name that is too long for a legend, at the right of the caption.
    void setNote(const QString& note);
    const QString& note() const { return note_; }
    /// While trimming, a drag chooses the range to keep.
    void setTrimming(bool isTrimming);
    void setCursorTime(std::optional<double> time);
    /// Up to two times that stay marked.
    void setMarks(const std::vector<double>& times);

Q_SIGNALS:
    void timeRangeWanted(double from, double to);
    void allWanted();
    void markWanted(double time);
    void trimWanted(double from, double to);
    void pointedAt(double time);
    void pointerLeft();

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
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
    void zoom(double about, double factor);
    bool isHidden(TraceRole role) const;
    void fitValues();
    void redraw();
    void paintGround(QPainter& painter) const;
    void paintGrid(QPainter& painter) const;
    void paintNote(QPainter& painter) const;
    void paintTrace(QPainter& painter, std::size_t trace) const;
    QPolygonF lineThroughSamples(std::span<const double> values) const;
    void paintColumns(QPainter& painter, const std::vector<ValueRange>& columns, double width, const QPen& pen) const;
    QFont labelFont() const;
    QRectF area() const;
    double timeAt(double x) const;
    double xAt(double time) const;
    double yAt(double value) const;
    double valueAt(double y) const;
    void setValueRange(double low, double high);
    bool isBox() const;

    std::shared_ptr<const std::vector<double>> time_;
    std::vector<Trace> traces_;
    std::vector<ValueExtent> extents_;  // of their values
    std::vector<TraceRole> hidden_;
    QString caption_, note_;
    double from_{0}, to_{1};   // [s] shown
    double low_{0}, high_{1};  // values shown
    bool isCloseUp_{};         // they were chosen, and stay when traces change
    bool isSymmetric_{}, hasTimeLabels_{true}, isTrimming_{};
    QPixmap ground_;                              // grid and traces; null: to be drawn anew
    std::optional<double> cursor_;                // [s]
    std::optional<double> dragFrom_, bandFrom_;   // [px]
    double bandTo_{}, bandTop_{}, bandBottom_{};  // [px] top: where it was begun
    std::vector<double> marks_;                   // [s]
};

}  // namespace analogon::ui
