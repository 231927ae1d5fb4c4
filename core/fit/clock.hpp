#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

/// The clock of a logger of its own. It is ahead by an offset: what it stamps t was so at t - offset. The offset may
/// be an unknown of a fit, as a parameter that no model has.
namespace analogon {

/// Name of that parameter: "clock i_mod". No parameter of a model has a space in its name.
std::string clockOf(const std::string& signal);
bool isClock(const std::string& parameter);
/// "i_mod" of "clock i_mod".
std::string signalOfClock(const std::string& parameter);

/// A value between samples, as a sum over at most four of them: cubic Hermite with the slopes of the parabolas through
/// three neighbours, so that it moves smoothly as the time passes a sample. Beyond the ends: the first or last one.
struct TimeStencil {
    int first{}, count{};
    std::array<double, 4> weights{}, slopes{};  // of the value and of its derivative in time

    template <class At>
    double value(At at) const {
        return sum(weights, at);
    }
    template <class At>
    double slope(At at) const {
        return sum(slopes, at);
    }

private:
    template <class At>
    double sum(const std::array<double, 4>& factors, At at) const {
        double total = 0.0;
        for (int j = 0; j < count; ++j) total += factors[static_cast<std::size_t>(j)] * at(first + j);
        return total;
    }
};
TimeStencil stencilAt(const std::vector<double>& time, double t);

/// A column as it was at the true times, stamped by a clock that is ahead (stamped late: by a positive offset); on the
/// lines between its samples, as inputs run, and constant beyond its ends. `time` ascends, two samples at least.
Eigen::RowVectorXd onLinesAt(const std::vector<double>& time, const Eigen::RowVectorXd& column, double offset);

/// A trace at the stamps of a clock that is ahead by `offset`.
Eigen::RowVectorXd atStamps(const std::vector<double>& time, const Eigen::RowVectorXd& trace, double offset);

}  // namespace analogon
