#pragma once

#include <gtest/gtest.h>

#include "core/fit/problem.hpp"

namespace analogon::test {

/// The columns of the Jacobian against central differences of the residuals. `tolerance`: relative to a column's norm.
inline void expectSlopesOf(const FitProblem& problem, const Eigen::VectorXd& at, const std::vector<GridPlan>& plans,
                           const Linearisation& line, double tolerance) {
    for (Eigen::Index i = 0; i < at.size(); ++i) {
        Eigen::VectorXd up = at, down = at;
        const double step = 1e-5 * at[i];
        up[i] += step;
        down[i] -= step;
        const Eigen::VectorXd slope =
            (linearise(problem, up, false, plans).residuals - linearise(problem, down, false, plans).residuals) /
            (2.0 * step);
        EXPECT_LT((line.jacobian.col(i) - slope).norm(), tolerance * slope.norm()) << i;
    }
}

}  // namespace analogon::test
