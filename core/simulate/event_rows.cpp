#include <algorithm>
#include <cmath>

#include "core/simulate/event_runner.hpp"

/// What is told of a run: its rows.
namespace analogon {

/// As asked for, and not so wide that what the rows show between events would be lost.
double EventRun::rowInterval() const {
    constexpr double fewest = 2500;
    const double whole = options_.stop - options_.start;
    if (!(options_.interval > 0)) return whole / fewest;
    return options_.interval / std::max(1.0, std::ceil(fewest * options_.interval / whole));
}

bool EventRun::checkHere() {
    if (model_.checks.empty() && model_.subscripts.empty()) return true;
    if (!read(time_, x_.data(), readings_)) return hasNoValue(system_.failure(workspace_));
    model_.program.update(slots_, readings_, time_, values_, isDue_);
    return check();
}

/// All that is told, with the discrete quantities as they are. False: something has no value.
bool EventRun::rowAt(double t, const std::vector<double>& x, std::vector<double>& row) {
    takeDelayed(t);
    std::vector<double> observed(handles_.size());
    if (!system_.observed(workspace_, t, {x.data(), n_}, u_, handles_, observed)) return false;
    row.resize(source_.size());
    for (std::size_t i = 0; i < row.size(); ++i)
        row[i] = source_[i].first >= 0 ? slots_[static_cast<std::size_t>(source_[i].first)]
                                       : observed[static_cast<std::size_t>(source_[i].second)];
    return true;
}

bool EventRun::record() {
    if (!takeSlots()) return hasNoValue(system_.failure(workspace_));
    takeDelayed(time_);
    if (drive_) return checkHere();
    RowPoint now{time_, x_, {}};
    if (!rowAt(now.time, now.x, now.row)) return hasNoValue(system_.failure(workspace_));
    if (!checkHere()) return false;
    if (!model_.subscripts.empty())
        for (std::size_t i = 0; i < now.row.size(); ++i)
            if (std::isnan(now.row[i])) return hasNoValue(names_[i]);
    tell(now);
    path_.push_back(std::move(now));
    tellJump();
    path_.erase(path_.begin(), path_.end() - 1);
    return true;
}

void EventRun::tell(const RowPoint& point) {
    if (least_.empty()) least_ = greatest_ = point.row;
    for (std::size_t i = 0; i < point.row.size(); ++i) {
        if (point.row[i] < least_[i]) least_[i] = point.row[i];
        if (point.row[i] > greatest_[i]) greatest_[i] = point.row[i];
    }
    result_.time.push_back(point.time);
    result_.rows.push_back(point.row);
}

/// The column that moved most since the row before, by far more than between the two rows before; -1: none.
int EventRun::columnThatJumps() const {
    constexpr double leastPart = 0.1, leastRatio = 8;  // of the range so far; of the change before
    const std::size_t k = result_.rows.size();
    if (k < 2 || result_.time[k - 1] <= result_.time[k - 2]) return -1;
    const std::vector<double>&now = result_.rows[k - 1], &before = result_.rows[k - 2];
    const bool isKnown = k > 2 && result_.time[k - 2] > result_.time[k - 3];
    const std::vector<double>& earlier = isKnown ? result_.rows[k - 3] : before;
    int found = -1;
    double most = leastPart;
    for (std::size_t i = 0; i < now.size(); ++i) {
        const double change = std::fabs(now[i] - before[i]), range = greatest_[i] - least_[i];
        if (!(change > most * range) || !(change > leastRatio * std::fabs(before[i] - earlier[i]))) continue;
        most = change / range;
        found = static_cast<int>(i);
    }
    return found;
}

namespace {

/// The cubic through two points and with the slopes at both.
std::vector<double> cubicBetween(double t, double begin, const std::vector<double>& x, const std::vector<double>& xdot,
                                 double end, const std::vector<double>& y, const std::vector<double>& ydot) {
    const double h = end - begin, s = (t - begin) / h, r = 1 - s;
    std::vector<double> at = x;
    for (std::size_t i = 0; i < xdot.size(); ++i)
        at[i] =
            x[i] * (1 + 2 * s) * r * r + h * xdot[i] * s * r * r + y[i] * s * s * (3 - 2 * s) - h * ydot[i] * s * s * r;
    return at;
}

}  // namespace

/// What jumps between two rows without an event, as an angle does where it begins anew, is told from both sides.
void EventRun::tellJump() {
    const int column = columnThatJumps();
    if (column < 0 || path_.size() < 2 || path_.front().row.empty()) return;
    const auto at = [column](const RowPoint& p) { return p.row[static_cast<std::size_t>(column)]; };
    const double whole = std::fabs(at(path_.back()) - at(path_.front()));
    // the half in which it jumps; false: it does not
    const auto narrow = [&](RowPoint& before, RowPoint& behind, RowPoint middle) {
        if (!rowAt(middle.time, middle.x, middle.row)) return false;
        const double left = std::fabs(at(middle) - at(before)), right = std::fabs(at(behind) - at(middle));
        (left > right ? behind : before) = std::move(middle);
        return std::max(left, right) > 0.6 * whole;
    };
    RowPoint before = path_.front(), behind = path_.back();
    std::size_t first = 0, last = path_.size() - 1;
    while (last - first > 1) {
        const std::size_t middle = (first + last) / 2;
        if (!narrow(before, behind, path_[middle])) return;
        (behind.time == path_[middle].time ? last : first) = middle;
    }
    std::vector<double> slopes(n_), behindSlopes(n_);
    const RowPoint from = before, to = behind;
    const auto ratesAt = [&](const RowPoint& p, std::vector<double>& rates) {
        takeDelayed(p.time);
        return n_ == 0 || system_.derivatives(workspace_, p.time, {p.x.data(), n_}, u_, rates);
    };
    if (!(to.time > from.time) || !ratesAt(from, slopes) || !ratesAt(to, behindSlopes)) return;
    const double close = std::max(1e-9 * (to.time - from.time), 1e-14 * std::fabs(to.time));
    while (behind.time - before.time > close) {
        const double t = before.time + (behind.time - before.time) / 2;
        if (!narrow(before, behind, {t, cubicBetween(t, from.time, from.x, slopes, to.time, to.x, behindSlopes), {}}))
            return;
    }
    const double end = result_.time.back();
    std::vector<double> row = std::move(result_.rows.back());
    result_.time.pop_back();
    result_.rows.pop_back();
    tell(before);
    tell(behind);
    result_.time.push_back(end);
    result_.rows.push_back(std::move(row));
}

}  // namespace analogon
