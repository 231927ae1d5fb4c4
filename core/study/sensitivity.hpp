#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/study/study.hpp"

namespace analogon {

/// How far one measured output of a recording moves with each parameter.
struct OutputSensitivity {
    std::string experiment, output, unit;
    std::vector<double> time;  // [s], where it was measured
    Eigen::MatrixXd slopes;    // rows: these times, columns: parameters; unit of the output per unit of the parameter
};

/// What the fitted recordings say of the parameters together, at the values that a study has for them.
struct Sensitivity {
    std::vector<std::string> parameters, units;  // with the recording in parentheses, where it is of that one alone
    Eigen::VectorXd values;
    Eigen::VectorXd standardErrors;  // of white residuals; NaN: the recordings do not determine it
    Eigen::MatrixXd correlation;     // NaN likewise
    std::vector<OutputSensitivity> outputs;
};

/// By the exact slopes of one simulation of each fitted recording: the covariance is that of a fit which ends there,
/// variance (JᵀJ)^-1 with what is known beforehand. Faults: those of the study; nothing is fitted; it cannot be
/// simulated at these values.
Outcome<Sensitivity> sensitivityOf(const Study& study, const Progress& progress = {});

}  // namespace analogon
