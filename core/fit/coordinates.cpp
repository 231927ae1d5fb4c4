#include "core/fit/coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace analogon {

namespace {

bool isLogarithmicScale(const FitParameter& p) {
    if (p.scale == ParameterScale::Linear) return false;
    if (p.scale == ParameterScale::Logarithmic) return p.start > 0.0;
    return p.min > 0.0 && p.start > 0.0 && p.max / p.min > 10.0;
}

}  // namespace

Coordinates::Coordinates(const std::vector<FitParameter>& parameters) : parameters_(parameters) {
    const auto count = static_cast<Eigen::Index>(parameters.size());
    origin_.resize(count);
    originValues_.resize(count);
    scale_ = Eigen::VectorXd::Ones(count);
    for (const FitParameter& p : parameters_) isLogarithmic_.push_back(isLogarithmicScale(p));
    for (Eigen::Index i = 0; i < count; ++i) {
        originValues_[i] = parameters[static_cast<std::size_t>(i)].start;
        origin_[i] = toQ(static_cast<int>(i), originValues_[i]);
    }
}

double Coordinates::toQ(int i, double value) const { return isLogarithmic(i) ? std::log(value) : value; }

void Coordinates::scaleBy(const Eigen::VectorXd& columnNorms) {
    for (int i = 0; i < size(); ++i) {
        const FitParameter& p = parameters_[static_cast<std::size_t>(i)];
        const double norm = columnNorms[i] * (isLogarithmic(i) ? std::exp(origin_[i]) : 1.0);
        if (norm > 1e-200 && std::isfinite(norm)) {
            scale_[i] = 1.0 / norm;
        } else if (isLogarithmic(i)) {
            scale_[i] = 1.0;
        } else if (p.start != 0.0) {
            scale_[i] = std::abs(p.start);
        } else {
            scale_[i] = !isOpen(p.min) && !isOpen(p.max) ? p.max - p.min : 1.0;
        }
    }
}

void Coordinates::moveOrigin(const Eigen::VectorXd& values) {
    originValues_ = values;
    for (int i = 0; i < size(); ++i) origin_[i] = toQ(i, values[i]);
}

Eigen::VectorXd Coordinates::values(const Eigen::VectorXd& z) const {
    Eigen::VectorXd result(size());
    for (int i = 0; i < size(); ++i) {
        const FitParameter& p = parameters_[static_cast<std::size_t>(i)];
        const double q = origin_[i] + scale_[i] * z[i];
        // On the bound exactly, whatever rounding makes of it.
        if (z[i] <= lower(i)) {
            result[i] = p.min;
        } else if (z[i] >= upper(i)) {
            result[i] = p.max;
        } else if (z[i] == 0.0) {
            result[i] = originValues_[i];  // exp(log(value)) is not quite the value
        } else {
            result[i] = std::clamp(isLogarithmic(i) ? std::exp(q) : q, p.min, p.max);
        }
    }
    return result;
}

Eigen::VectorXd Coordinates::slopes(const Eigen::VectorXd& values) const {
    Eigen::VectorXd result = scale_;
    for (int i = 0; i < size(); ++i) {
        if (isLogarithmic(i)) result[i] *= values[i];
    }
    return result;
}

double Coordinates::bound(int i, double value) const {
    const double open = std::numeric_limits<double>::infinity();
    if (isOpen(value)) return value < 0.0 ? -open : open;
    if (isLogarithmic(i) && value <= 0.0) return -open;
    return (toQ(i, value) - origin_[i]) / scale_[i];
}

double Coordinates::near(int i, double fraction, double factor) const {
    const FitParameter& p = parameters_[static_cast<std::size_t>(i)];
    return std::clamp(p.start * std::pow(factor, 2.0 * fraction - 1.0), p.min, p.max);
}

double Coordinates::within(int i, double fraction) const {
    const FitParameter& p = parameters_[static_cast<std::size_t>(i)];
    const double start = toQ(i, p.start);
    const double reach = isLogarithmic(i) ? std::log(10.0) : std::max(2.0 * std::abs(p.start), 1e-300);
    const bool hasMin = !isOpen(p.min) && (!isLogarithmic(i) || p.min > 0.0);
    double low = hasMin ? toQ(i, p.min) : start - reach;
    double high = isOpen(p.max) ? start + reach : toQ(i, p.max);
    if (!isLogarithmic(i) && p.start == 0.0) {
        if (!hasMin) low = isOpen(p.max) ? -1.0 : -high;
        if (isOpen(p.max)) high = hasMin && low != 0.0 ? std::abs(low) : 1.0;
    }
    const double q = low + fraction * (high - low);
    return std::clamp(isLogarithmic(i) ? std::exp(q) : q, p.min, p.max);
}

double Coordinates::firstMove(int i) const {
    const FitParameter& p = parameters_[static_cast<std::size_t>(i)];
    double move = isLogarithmic(i) ? 0.25 : 0.2 * std::abs(p.start);
    if (move == 0.0) move = !isOpen(p.min) && !isOpen(p.max) ? 0.1 * (p.max - p.min) : 10.0 * scale_[i];
    move /= scale_[i];
    const double room = upper(i) - lower(i);
    return std::isfinite(room) ? std::min(move, 0.25 * room) : move;
}

}  // namespace analogon
