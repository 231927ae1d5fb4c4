#include "core/fit/held_input.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace analogon {

namespace {

constexpr double rounding = 1e-6;  // of a sample interval

/// The last sample at or before a time that does not fall from call to call; the first one before it.
class HeldSample {
public:
    explicit HeldSample(const std::vector<double>& time) : time_(time) {}
    std::size_t at(double t) {
        while (k_ + 1 < time_.size() && time_[k_ + 1] <= t) ++k_;
        return k_;
    }

private:
    const std::vector<double>& time_;
    std::size_t k_{};
};

double shortestInterval(const std::vector<double>& time) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < time.size(); ++k) least = std::min(least, time[k] - time[k - 1]);
    return least;
}

}  // namespace

void addMoments(Recording& recording, const std::vector<double>& moments) {
    if (moments.empty()) return;
    const Recording from = recording;
    const auto samples = static_cast<Eigen::Index>(from.time.size() + moments.size());
    recording.time.clear();
    recording.inputs.resize(from.inputs.rows(), samples);
    recording.outputs.setConstant(from.outputs.rows(), samples, std::nan(""));
    for (SpareChannel& spare : recording.spares) spare.values.clear();
    std::size_t next = 0;
    const auto add = [&](std::size_t k, double part, double t) {
        const auto to = static_cast<Eigen::Index>(recording.time.size()), sample = static_cast<Eigen::Index>(k);
        recording.time.push_back(t);
        for (Eigen::Index i = 0; i < from.inputs.rows(); ++i) recording.inputs(i, to) = from.between(i, sample, part);
        if (part == 0) recording.outputs.col(to) = from.outputs.col(sample);
        for (std::size_t s = 0; s < from.spares.size(); ++s) {
            const std::vector<double>& values = from.spares[s].values;
            recording.spares[s].values.push_back(part == 0 ? values[k] : (1 - part) * values[k] + part * values[k + 1]);
        }
    };
    for (std::size_t k = 0; k < from.time.size(); ++k) {
        add(k, 0, from.time[k]);
        for (; k + 1 < from.time.size() && next < moments.size() && moments[next] < from.time[k + 1]; ++next)
            add(k, (moments[next] - from.time[k]) / (from.time[k + 1] - from.time[k]), moments[next]);
    }
}

void shiftHeld(Recording& recording, std::size_t input, double offset) {
    const auto row = static_cast<Eigen::Index>(input);
    const Eigen::RowVectorXd column = recording.inputs.row(row);
    const std::vector<double> stamps = recording.time;
    if (stamps.size() < 2) return;
    const double slack = rounding * shortestInterval(stamps);
    std::vector<double> moments;
    HeldSample sample(stamps);
    for (std::size_t k = 1; k < stamps.size(); ++k) {
        const double t = stamps[k] - offset;
        const auto here = static_cast<Eigen::Index>(k);
        if (column[here] == column[here - 1] || t <= stamps.front() || t >= stamps.back()) continue;
        const std::size_t before = sample.at(t);
        if (t - stamps[before] > slack && stamps[before + 1] - t > slack) moments.push_back(t);
    }
    addMoments(recording, moments);
    HeldSample stamped(stamps);
    for (std::size_t j = 0; j < recording.time.size(); ++j)
        recording.inputs(row, static_cast<Eigen::Index>(j)) =
            column[static_cast<Eigen::Index>(stamped.at(recording.time[j] + offset + slack))];
}

Eigen::RowVectorXd heldMeans(const std::vector<double>& time, const Eigen::RowVectorXd& column,
                             const std::vector<double>& at) {
    Eigen::RowVectorXd means(static_cast<Eigen::Index>(at.size()));
    HeldSample sample(time);
    const auto value = [&](std::size_t k) { return column[static_cast<Eigen::Index>(k)]; };
    for (std::size_t j = 0; j < at.size(); ++j) {
        const auto to = static_cast<Eigen::Index>(j);
        std::size_t k = sample.at(at[j]);
        if (j + 1 == at.size()) {
            means[to] = value(k);
            break;
        }
        double sum = 0;
        for (double from = at[j]; from < at[j + 1];) {
            const double end = k + 1 < time.size() ? std::min(time[k + 1], at[j + 1]) : at[j + 1];
            sum += value(k) * (end - from);
            from = end;
            if (from < at[j + 1]) ++k;
        }
        means[to] = sum / (at[j + 1] - at[j]);
    }
    return means;
}

}  // namespace analogon
