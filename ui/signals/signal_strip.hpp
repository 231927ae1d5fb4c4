#pragma once

#include <QWidget>

#include "ui/signals/signal_chart.hpp"

class QLabel;
class QToolButton;

namespace analogon::ui {

/// One axis of the plots: above it its legend, which breaks into lines and never loses a word, with the values under
/// the pointer, or the differences, means and rms between two cursors.
class SignalStrip : public QWidget {
    Q_OBJECT

public:
    explicit SignalStrip(QWidget* parent = nullptr);

    void setLines(std::vector<ChartLine> lines, bool hasRecordings);
    void setTimeLabels(bool isFirst, bool isLast);
    void pointAt(std::optional<double> time);
    void setMarks(const std::vector<double>& times);
    SignalChart* chart() const { return chart_; }
    /// As one reads it.
    QString legendText() const;

Q_SIGNALS:
    void dropped(const std::vector<SignalRef>& references);
    void removeWanted(int trace);
    void closeWanted();
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
    QString figuresOf(const ChartLine& line) const;

    SignalChart* chart_;
    QLabel* legend_;
    QToolButton *up_, *down_, *close_;
    std::optional<double> cursor_;
    std::vector<double> marks_;
    bool hasRecordings_{}, isTarget_{};
};

}  // namespace analogon::ui
