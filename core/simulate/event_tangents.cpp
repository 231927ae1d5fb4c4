#include "core/simulate/event_tangents.hpp"

#include <algorithm>
#include <cmath>

namespace analogon {

EventTangents::EventTangents(const HybridModel& model, const System& system, const Eigen::MatrixXd& directions,
                             std::vector<int> slotAt, std::vector<int> readingAt)
    : model_(model),
      system_(system),
      K_(static_cast<int>(directions.cols())),
      n_(system.stateCount()),
      slotAt_(std::move(slotAt)),
      readingAt_(std::move(readingAt)),
      workspace_(system.workspace(K_)) {
    directions_.resize(static_cast<std::size_t>(directions.size()));
    for (Eigen::Index i = 0; i < directions.rows(); ++i)
        for (Eigen::Index k = 0; k < K_; ++k) directions_[static_cast<std::size_t>(i * K_ + k)] = directions(i, k);
    S_ = block(n_);
    slots_ = block(static_cast<int>(slotAt_.size()));
    readings_ = block(static_cast<int>(readingAt_.size()));
    dt_ = block(1);
    f_.resize(static_cast<std::size_t>(n_));
    df_ = block(n_);
    y_.resize(static_cast<std::size_t>(system.outputCount()));
    dy_ = block(system.outputCount());
}

bool EventTangents::takeParameters(const std::vector<double>& parameters) {
    for (std::size_t s = 0; s < slotAt_.size(); ++s)
        if (slotAt_[s] >= 0)
            std::copy_n(slots_.begin() + static_cast<std::ptrdiff_t>(s) * K_, K_,
                        directions_.begin() + static_cast<std::ptrdiff_t>(slotAt_[s]) * K_);
    return system_.setParameters(workspace_, parameters, directions_);
}

bool EventTangents::rates(double t, std::span<const double> x, const double* dx, std::span<const double> u,
                          std::span<double> xdot, double* dxdot) {
    const auto size = static_cast<std::size_t>(n_ * K_);
    return system_.derivatives(workspace_, t, x, {dx, size}, u, {}, xdot, {dxdot, size});
}

bool EventTangents::outputs(const EventPoint& point, std::span<double> y, double* dy) {
    return system_.outputs(workspace_, point.time, point.x, S_, point.u, {}, y, {dy, dy_.size()});
}

bool EventTangents::readings(const EventPoint& point, const std::vector<double>& dx, const std::vector<double>& dt,
                             std::vector<double>& result) {
    std::vector<double> du(point.u.size() * static_cast<std::size_t>(K_));
    bool isMoved = false;
    for (int k = 0; k < K_; ++k) isMoved = isMoved || dt[static_cast<std::size_t>(k)] != 0;
    for (std::size_t i = 0; i < point.u.size() && isMoved; ++i)
        for (int k = 0; k < K_; ++k)
            du[i * static_cast<std::size_t>(K_) + static_cast<std::size_t>(k)] =
                point.inputRates[i] * dt[static_cast<std::size_t>(k)];
    if (!system_.outputs(workspace_, point.time, point.x, dx, point.u, du, y_, dy_)) return false;
    std::vector<double> byTime(y_.size());
    if (isMoved) {  // what speaks of the time itself
        const double h = 1e-7 * std::max(1.0, std::fabs(point.time));
        std::vector<double> later(y_.size()), before(y_.size());
        if (!system_.outputs(workspace_, point.time + h, point.x, dx, point.u, du, later, dy_) ||
            !system_.outputs(workspace_, point.time - h, point.x, dx, point.u, du, before, dy_) ||
            !system_.outputs(workspace_, point.time, point.x, dx, point.u, du, y_, dy_))
            return false;
        for (std::size_t i = 0; i < y_.size(); ++i) byTime[i] = (later[i] - before[i]) / (2 * h);
    }
    for (std::size_t r = 0; r < readingAt_.size(); ++r) {
        const auto at = static_cast<std::size_t>(readingAt_[r]);
        for (int k = 0; k < K_; ++k) {
            const auto j = static_cast<std::size_t>(k);
            result[r * static_cast<std::size_t>(K_) + j] =
                dy_[at * static_cast<std::size_t>(K_) + j] + byTime[at] * dt[j];
        }
    }
    return true;
}

bool EventTangents::start(const EventPoint& point, bool isFoundAtStart) {
    std::fill(dt_.begin(), dt_.end(), 0);
    for (int round = 0; round < 2; ++round) {  // the state may follow from slots that follow from it
        if (!takeParameters(point.parameters)) return false;
        std::vector<double> x(point.x.begin(), point.x.end());
        if (isFoundAtStart && n_ > 0 && !system_.initialise(workspace_, point.time, point.u, x, S_)) return false;
        if (!settled(point)) return false;
    }
    return true;
}

bool EventTangents::begin(const EventPoint& point, const EventMoment& moment) {
    std::fill(dt_.begin(), dt_.end(), 0);
    if (!takeParameters(point.parameters) || !readings(point, S_, dt_, readings_)) return false;
    model_.program.runTangents(point.values, slots_, readings_, dt_, steps_);
    if (!rates(point.time, point.x, S_.data(), point.u, f_, df_.data())) return false;
    if (moment.reading >= 0) {
        // along the solution: the state moves by f, the inputs by themselves, beside the parameters
        std::vector<double> dx = S_, one(dt_.size(), 0.0), moved(readings_.size());
        one[0] = 1;
        for (int i = 0; i < n_; ++i) dx[static_cast<std::size_t>(i * K_)] += f_[static_cast<std::size_t>(i)];
        if (!readings(point, dx, one, moved)) return false;
        const auto r = static_cast<std::size_t>(moment.reading * K_);
        const double rate = moved[r] - readings_[r];
        for (int k = 0; k < K_; ++k) {
            const auto j = static_cast<std::size_t>(k);
            dt_[j] = rate != 0 ? -readings_[r + j] / rate : 0;
        }
    } else if (moment.offset >= 0) {
        const std::vector<double> offset = ofStep(moment.offset);
        for (std::size_t k = 0; k < offset.size(); ++k) dt_[k] = -offset[k] / moment.factor;
    } else if (!moment.given.empty()) {
        dt_ = moment.given;
    }
    for (int i = 0; i < n_; ++i)
        for (int k = 0; k < K_; ++k)
            S_[static_cast<std::size_t>(i * K_ + k)] +=
                f_[static_cast<std::size_t>(i)] * dt_[static_cast<std::size_t>(k)];
    return readings(point, S_, dt_, readings_);
}

void EventTangents::takeLeftLimits() {
    for (const auto& [before, reading] : model_.leftLimits)
        std::copy_n(readings_.begin() + static_cast<std::ptrdiff_t>(reading) * K_, K_,
                    slots_.begin() + static_cast<std::ptrdiff_t>(before) * K_);
}

bool EventTangents::settled(const EventPoint& point) {
    for (int round = 0; round < 3; ++round) {
        if (!takeParameters(point.parameters) || !readings(point, S_, dt_, readings_)) return false;
        model_.program.runTangents(point.values, slots_, readings_, dt_, steps_);
        const std::vector<double> before = slots_;
        for (const HybridModel::Assignment& a : model_.assignments)
            std::copy_n(steps_.begin() + static_cast<std::ptrdiff_t>(a.step) * K_, K_,
                        slots_.begin() + static_cast<std::ptrdiff_t>(a.slot) * K_);
        if (slots_ == before) break;
    }
    return true;
}

void EventTangents::reset(int state, int step) {
    std::copy_n(steps_.begin() + static_cast<std::ptrdiff_t>(step) * K_, K_,
                S_.begin() + static_cast<std::ptrdiff_t>(state) * K_);
}

void EventTangents::shift() {
    for (const auto& [before, of] : model_.pres)
        std::copy_n(slots_.begin() + static_cast<std::ptrdiff_t>(of) * K_, K_,
                    slots_.begin() + static_cast<std::ptrdiff_t>(before) * K_);
}

bool EventTangents::end(const EventPoint& point) {
    if (!takeParameters(point.parameters)) return false;
    if (n_ == 0) return true;
    if (!rates(point.time, point.x, S_.data(), point.u, f_, df_.data())) return false;
    for (int i = 0; i < n_; ++i)
        for (int k = 0; k < K_; ++k)
            S_[static_cast<std::size_t>(i * K_ + k)] -=
                f_[static_cast<std::size_t>(i)] * dt_[static_cast<std::size_t>(k)];
    return true;
}

std::vector<double> EventTangents::ofStep(int step) const {
    const auto begin = steps_.begin() + static_cast<std::ptrdiff_t>(step) * K_;
    return {begin, begin + K_};
}

}  // namespace analogon
