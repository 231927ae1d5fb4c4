#pragma once

#include <Eigen/Core>
#include <functional>

#include "tests/bench/speed/hand_written.hpp"
#include "tests/bench/speed/problems.hpp"

namespace analogon::speed {

using Pass = std::function<NormalEquations(const Eigen::VectorXd&)>;

struct HandFit {
    Eigen::VectorXd values;
    double cost{};
    int passes{};
};

/// Levenberg and Marquardt in logarithms of the parameters on the normal equations (Nielsen's damping), as somebody
/// would write it for one problem.
HandFit handFit(const SpeedProblem& problem, const Pass& pass);

}  // namespace analogon::speed
