#pragma once

#include <QWidget>

#include "ui/signals/signal_chart.hpp"

class QComboBox;
class QLabel;
class QStackedLayout;
class QToolButton;

namespace analogon::ui {

class FigureChart;

/// One axis of the plots: above it its legend, which breaks into lines and never loses a word, with the values under
/// the pointer, or the differences, means and rms between two cursors.
class SignalStrip : public QWidget {
    Q_OBJECT

public:
    explicit SignalStrip(QWidget* parent = nullptr);

    void setLines(std::vector<ChartLine> lines, bool hasRecordings);
    void setView(PlotView view);
    void setTimeRange(double from, double to);
    void setTimeLabels(bool isFirst, bool isLast);
    void pointAt(std::optional<double> time);
    void setMarks(const std::vector<double>& times);
    SignalChart* chart() const { return chart_; }
    FigureChart* figure() const { return figure_; }
    QComboBox* viewBox() const { return views_; }
    /// As one reads it.
    QString legendText() const;

Q_SIGNALS:
    void dropped(const std::vector<SignalRef>& references);
    void removeWanted(int trace);
    void closeWanted();
    void viewWanted(PlotView view);
    void moveWanted(int by);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void writeLegend();
    void showFigure();
    QString figuresOf(const ChartLine& line) const;

    SignalChart* chart_;
    FigureChart* figure_;
    QStackedLayout* pages_;
    QComboBox* views_;
    PlotView view_{PlotView::Time};
    double from_{}, to_{1};  // [s]
    QLabel* legend_;
    QToolButton *up_, *down_, *close_;
    std::optional<double> cursor_;
    std::vector<double> marks_;
    bool hasRecordings_{}, isTarget_{};
};

}  // namespace analogon::ui
