#pragma once

#include <QWidget>
#include <vector>

namespace analogon::ui {

/// Some courses over one axis of time, each drawn earlier by its shift. No more than a few points a pixel are drawn.
class CoursePlot : public QWidget {
    Q_OBJECT

public:
    struct Line {
        std::vector<double> time, values;  // [s]; NaN: a gap
        double shift{};                    // [s]
    };

    explicit CoursePlot(QWidget* parent = nullptr);
    void show(std::vector<Line> lines, const QString& unit);
    void setShift(std::size_t line, double shift);
    /// The line in front; the first one is the reference.
    void setMarked(std::size_t line);
    QColor colourOf(std::size_t line) const;
    const std::vector<Line>& lines() const { return lines_; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintLine(QPainter& painter, const Line& line, const QRectF& frame) const;

    std::vector<Line> lines_;
    QString unit_;
    std::size_t marked_{};
    double from_{}, to_{1}, low_{}, high_{1};
};

}  // namespace analogon::ui
