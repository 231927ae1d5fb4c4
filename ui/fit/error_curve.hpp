#pragma once

#include <QPointF>
#include <QWidget>
#include <vector>

namespace analogon::ui {

/// The best error so far over the time of a run, on a logarithmic scale.
class ErrorCurve : public QWidget {
    Q_OBJECT

public:
    explicit ErrorCurve(QWidget* parent = nullptr);

    void clear();
    void add(double seconds, double errorPercent);
    const std::vector<QPointF>& points() const { return points_; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::vector<QPointF> points_;  // x: [s], y: [%], falling
};

}  // namespace analogon::ui
