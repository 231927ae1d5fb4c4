#pragma once

#include <QChartView>
#include <optional>

#include "core/study/parameter_sweep.hpp"

namespace analogon::ui {

/// A point of the grid.
struct SweepPoint {
    Eigen::Index row{}, column{};
};

/// The error over one parameter as a curve, over two as a map of coloured cells, with its least and the present values
/// marked. Values that grow by equal factors are on a logarithmic axis. A click chooses a point; arrows move among
/// them, Enter chooses.
class SweepChart : public QChartView {
    Q_OBJECT

public:
    explicit SweepChart(QWidget* parent = nullptr);

    void setSweep(std::optional<ParameterSweep> sweep);
    /// Of the least and of the largest error, as the cells have them.
    QColor colourOf(double errorPercent) const;
    /// Where a point of the grid is drawn; in the widget.
    QPoint placeOf(Eigen::Index row, Eigen::Index column) const;
    /// The values of the parameters there, one an axis.
    std::vector<double> valuesAt(const SweepPoint& point) const;
    /// "heater.R = 3 Ohm", one an axis, and the error there.
    QStringList wordsOf(const SweepPoint& point) const;
    QString errorWordsOf(const SweepPoint& point) const;
    /// Those of the study.
    void setPresent(std::vector<double> values);
    QSize sizeHint() const override { return {440, 320}; }

Q_SIGNALS:
    void chosen(const analogon::ui::SweepPoint& point);
    void pointedAt(const analogon::ui::SweepPoint& point);

protected:
    void changeEvent(QEvent* event) override;
    void drawForeground(QPainter* painter, const QRectF& rect) override;
    bool viewportEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void draw();
    void drawCurve();
    void drawMap();
    QAbstractAxis* axisOf(const std::string& title, const std::string& unit, bool isLogarithmic) const;
    void drawCells(QPainter& painter) const;
    void drawPresent(QPainter& painter) const;
    /// Along an axis of the chart, in its coordinates.
    double coordinateOf(int axis, double value) const;
    std::vector<double> edgesOf(int axis) const;               // one more than there are values
    QRectF cell(Eigen::Index row, Eigen::Index column) const;  // likewise
    std::optional<SweepPoint> pointAt(const QPoint& place) const;
    bool isMap() const { return sweep_ && sweep_->axes.size() > 1; }

    std::optional<ParameterSweep> sweep_;
    std::pair<double, double> errors_{};  // [%] least and largest
    std::vector<double> present_;
    std::optional<SweepPoint> cursor_;  // of the keys
};

}  // namespace analogon::ui
