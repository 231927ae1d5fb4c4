#pragma once

#include <QPointF>
#include <QVector>
#include <span>

namespace analogon::ui {

/// A trace as it looks `pixels` wide: per pixel column first, smallest, largest and last value, so that no peak is
/// lost and no more than 4 points a pixel are painted. Only [from, to] and one sample on either side count; NaN
/// samples are left out. `time` rises.
QVector<QPointF> decimate(std::span<const double> time, std::span<const double> values, double from, double to,
                          int pixels);

/// Distance of grid lines: 1, 2 or 5 times a power of ten, about `count` in the range.
double niceStep(double range, int count);

}  // namespace analogon::ui
