#include "ui/measurement/channel_sketch.hpp"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/measurement/course_frame.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

constexpr std::size_t strips = 400;

std::pair<double, double> rangeOf(const CourseSketch& course) {
    double least = INFINITY, largest = -INFINITY;
    for (std::size_t i = 0; i < course.least.size(); ++i) {
        if (std::isnan(course.least[i])) continue;
        least = std::min(least, course.least[i]);
        largest = std::max(largest, course.largest[i]);
    }
    return {least, largest};
}

}  // namespace

CourseSketch sketchOf(const MeasurementFile& file, std::size_t group, std::size_t channel, const Progress& progress) {
    const RecordedGroup& from = file.groups.at(group);
    CourseSketch course;
    if (from.channels.at(channel).kind == ChannelKind::Text || from.samples == 0) return course;
    std::vector<std::size_t> wanted{channel};
    if (from.masterChannel && *from.masterChannel != channel) wanted.push_back(*from.masterChannel);
    const Outcome<std::vector<ChannelValues>> read = file.reader->read(group, wanted, progress);
    if (!read) return CourseSketch::failed(read.diagnostics().front());
    const std::vector<double>& values = read->front().numbers;
    if (values.empty()) return course;
    const std::vector<double>* const master = wanted.size() > 1 ? &(*read)[1].numbers : nullptr;
    const auto at = [&](std::size_t i) { return master ? (*master)[i] : static_cast<double>(i); };
    course.from = at(0);
    course.to = at(values.size() - 1);
    if (master) course.unit = QString::fromStdString(from.channels[*from.masterChannel].unit);
    course.least.assign(strips, std::numeric_limits<double>::quiet_NaN());
    course.largest = course.least;
    const double width = course.to - course.from;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i])) continue;
        const double part = width > 0 ? std::clamp((at(i) - course.from) / width, 0.0, 1.0) : 0;
        if (std::isnan(part)) continue;
        const auto strip = std::min(strips - 1, static_cast<std::size_t>(part * strips));
        double &least = course.least[strip], &largest = course.largest[strip];
        if (!(least <= values[i])) least = values[i];
        if (!(largest >= values[i])) largest = values[i];
    }
    return course;
}

ChannelSketch::ChannelSketch(QWidget* parent) : QWidget(parent) { setMinimumSize(140, 100); }

void ChannelSketch::show(CourseSketch course) {
    course_ = std::move(course);
    update();
}

void ChannelSketch::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = paintCourseFrame(painter, *this);
    const auto [least, largest] = rangeOf(course_);
    if (!(least <= largest)) return;
    paintCourseLabels(painter, frame, *this, style::numberText(largest, 5), style::numberText(least, 5),
                      QStringLiteral("%1 … %2 %3")
                          .arg(style::numberText(course_.from, 5), style::numberText(course_.to, 5), course_.unit));
    const double reach = largest > least ? largest - least : 1, middle = (least + largest) / 2;
    const auto y = [&](double value) {
        return frame.center().y() - (value - middle) / reach * (frame.height() - 2 * style::unit);
    };
    QPolygonF upper;
    painter.setPen(QPen(style::measuredTrace(palette()), 1.4));
    for (std::size_t i = 0; i < course_.least.size(); ++i) {
        if (std::isnan(course_.least[i])) continue;
        const double x = frame.left() + (static_cast<double>(i) + 0.5) / static_cast<double>(strips) * frame.width();
        painter.drawLine(QPointF(x, y(course_.least[i])), QPointF(x, y(course_.largest[i])));
        upper << QPointF(x, y((course_.least[i] + course_.largest[i]) / 2));
    }
    painter.drawPolyline(upper);
}

}  // namespace analogon::ui
