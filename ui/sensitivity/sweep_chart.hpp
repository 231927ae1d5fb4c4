#pragma once

#include <QChartView>
#include <optional>

#include "core/study/parameter_sweep.hpp"

namespace analogon::ui {

/// The error over one parameter as a curve, over two as a map of coloured cells, with its least marked. Values that
/// grow by equal factors are on a logarithmic axis.
class SweepChart : public QChartView {
    Q_OBJECT

public:
    explicit SweepChart(QWidget* parent = nullptr);

    void setSweep(std::optional<ParameterSweep> sweep);
    /// Of the least and of the largest error, as the cells have them.
    QColor colourOf(double errorPercent) const;
    /// Where a point of the grid is drawn; in the widget.
    QPoint placeOf(Eigen::Index row, Eigen::Index column) const;
    QSize sizeHint() const override { return {440, 320}; }

protected:
    void changeEvent(QEvent* event) override;
    void drawForeground(QPainter* painter, const QRectF& rect) override;
    bool viewportEvent(QEvent* event) override;

private:
    void draw();
    void drawCurve();
    void drawMap();
    QAbstractAxis* axisOf(const std::string& title, const std::string& unit, bool isLogarithmic) const;
    QRectF cell(Eigen::Index row, Eigen::Index column) const;  // in the scene
    bool isMap() const { return sweep_ && sweep_->axes.size() > 1; }

    std::optional<ParameterSweep> sweep_;
};

}  // namespace analogon::ui
