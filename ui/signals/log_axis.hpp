#pragma once

#include <QCategoryAxis>
#include <vector>

class QChart;
class QPainter;

namespace analogon::ui {

/// A logarithmic axis of a chart with round values inside a decade as well, which QLogValueAxis of Qt Charts, with its
/// one label a decade, does not have. Its series hold the logarithms: `at` of each value.
class LogAxis : public QCategoryAxis {
    Q_OBJECT

public:
    using QCategoryAxis::QCategoryAxis;

    static double at(double value);
    /// Both positive.
    void setValues(double low, double high);
    /// Labels as they fit into so many pixels.
    void fit(double length);
    const std::vector<double>& minorTicks() const { return minor_; }

private:
    double low_{1}, high_{10};
    std::vector<double> minor_;
};

/// The minor ticks of the logarithmic axes, over the plot area of the chart, in the scene.
void paintMinorTicks(QPainter& painter, const QChart& chart);
/// Gives each logarithmic axis of a chart of this size the labels that there is room for.
void fitLogAxes(const QChart& chart, const QSizeF& size);

}  // namespace analogon::ui
