#pragma once

#include <QWidget>
#include <vector>

#include "core/base/diagnostic.hpp"
#include "core/base/progress.hpp"
#include "core/measure/recording.hpp"

namespace analogon::ui {

/// The course of a channel in so few numbers that it is drawn at once: the least and the largest value of each strip.
struct CourseSketch {
    std::vector<double> least, largest;  // NaN: nothing was measured in the strip
    double from{}, to{};                 // of the master; of the samples' numbers where there is none
    QString unit{};                      // of the master
    bool isFailed{};

    static CourseSketch failed(const Diagnostic&) { return {{}, {}, 0, 0, {}, true}; }
};

/// Reads a channel and its master. Of words there is none.
CourseSketch sketchOf(const MeasurementFile& file, std::size_t group, std::size_t channel, const Progress& progress);

class ChannelSketch : public QWidget {
    Q_OBJECT

public:
    explicit ChannelSketch(QWidget* parent = nullptr);
    void show(CourseSketch course);
    const CourseSketch& course() const { return course_; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    CourseSketch course_;
};

}  // namespace analogon::ui
