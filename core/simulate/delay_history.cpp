#include "core/simulate/delay_history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace analogon {
namespace {

constexpr double rounding = 4e-13;  // of a time

}  // namespace

void DelayHistory::add(double time, double value) {
    if (pieces_.empty()) pieces_.emplace_back();
    std::vector<Point>& piece = pieces_.back();
    if (piece.empty() || time > piece.back().time) piece.push_back({time, value});
}

void DelayHistory::addBehindEvent(double time, double value) {
    const bool isFirst = pieces_.empty();
    const double before = isFirst ? value : pieces_.back().back().value;
    if (isFirst || std::fabs(value - before) > 1e-12 * (std::fabs(value) + std::fabs(before)))
        pieces_.push_back({{time, value}});
}

void DelayHistory::arriveUpTo(double time) {
    while (nextArrival() <= time + rounding * std::max(1.0, std::fabs(time))) ++arrived_;
}

double DelayHistory::nextArrival() const {
    return arrived_ + 1 < pieces_.size() ? pieces_[arrived_ + 1].front().time + delay_
                                         : std::numeric_limits<double>::infinity();
}

std::size_t DelayHistory::lineOf(double time) const {
    const std::vector<Point>& piece = pieces_[arrived_];
    const auto behind =
        std::upper_bound(piece.begin(), piece.end(), time, [](double t, const Point& point) { return t < point.time; });
    const auto at = static_cast<std::size_t>(behind - piece.begin());
    return std::clamp<std::size_t>(at, 1, std::max<std::size_t>(1, piece.size() - 1));
}

double DelayHistory::at(double time) const {
    const std::vector<Point>& piece = pieces_[arrived_];
    const double past = time - delay_;
    if (past <= piece.front().time) return piece.front().value;
    if (past >= piece.back().time) return piece.back().value;
    const Point &left = piece[lineOf(past) - 1], &right = piece[lineOf(past)];
    return left.value + (right.value - left.value) * (past - left.time) / (right.time - left.time);
}

double DelayHistory::slopeAt(double time) const {
    const std::vector<Point>& piece = pieces_[arrived_];
    const double past = time - delay_;
    if (piece.size() < 2 || past < piece.front().time) return 0;
    const Point &left = piece[lineOf(past) - 1], &right = piece[lineOf(past)];
    return (right.value - left.value) / (right.time - left.time);
}

}  // namespace analogon
