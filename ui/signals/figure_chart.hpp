#pragma once

#include <QChartView>
#include <QTimer>

#include "ui/job/job.hpp"
#include "ui/signals/figure.hpp"

namespace analogon::ui {

/// Draws what is made of the traces of an axis; it is worked out beside the window, and again when the part of the
/// time that is visible changes.
class FigureChart : public QChartView {
    Q_OBJECT

public:
    explicit FigureChart(QWidget* parent = nullptr);

    void want(PlotView view, std::vector<ChartLine> lines, double from, double to);
    /// One that was made elsewhere.
    void show(Figure figure);
    const Figure& figure() const { return figure_; }
    QSize sizeHint() const override { return {300, 140}; }  // not that of its scene: axes share the room there is

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void drawForeground(QPainter* painter, const QRectF& rect) override;

private:
    void workOut();
    void draw();

    PlotView view_{PlotView::Spectrum};
    std::vector<ChartLine> lines_;
    double from_{}, to_{};
    Figure figure_;
    QTimer pause_;
    JobRunner worker_;
};

}  // namespace analogon::ui
