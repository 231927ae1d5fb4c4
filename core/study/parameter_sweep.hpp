#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/study/study.hpp"

namespace analogon {

/// One parameter that is led through values, in its own unit.
struct SweepAxis {
    std::string parameter;
    std::vector<double> values;
};

/// `count` values from one end to the other, evenly spaced, or by equal factors where `isLogarithmic` (both ends must
/// have the same sign and not be 0 then).
std::vector<double> sweepValues(double from, double to, int count, bool isLogarithmic);

/// The error of the fitted recordings where one or two parameters have other values and all else is as in the study.
struct ParameterSweep {
    std::vector<SweepAxis> axes;     // one or two
    std::vector<std::string> units;  // of their parameters
    Eigen::MatrixXd errorPercent;    // rows: second axis (one without it), columns: first; NaN: not simulated there
    int done{};                      // points worked out: fewer than all where it was asked to stop

    /// Row and column of the least error; both -1: there is none.
    std::pair<Eigen::Index, Eigen::Index> least() const;
};

/// Simulates each point of the grid; nothing is fitted. Stops between two points and tells what it has by then. Faults:
/// those of the study; no axis or more than two, the same twice, an axis without values; a parameter that the model
/// does not have or that may not change.
Outcome<ParameterSweep> sweep(const Study& study, const std::vector<SweepAxis>& axes, const Progress& progress = {});

}  // namespace analogon
