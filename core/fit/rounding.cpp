#include "core/fit/rounding.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/range.hpp"
#include "core/fit/coordinates.hpp"

namespace analogon {

double roundingOf(const FitProblem& problem) {
    constexpr double ofValues = 2e-14;  // a hundred times that of a double: many operations lead to an output
    double squares = 0;
    for (const FitExperiment& e : problem.experiments)
        for (Eigen::Index o = 0; o < e.measured.rows(); ++o) {
            if (!e.isFitted(o)) continue;
            const Range range = rangeOf(e.measured.row(o));
            if (range.isEmpty()) continue;
            const double size = std::max(std::abs(range.low), std::abs(range.high));
            const double nominal = e.system->outputs()[static_cast<std::size_t>(o)].nominal;
            const auto count = static_cast<double>(e.measured.cols() - e.measured.row(o).array().isNaN().count());
            squares += count * std::pow(e.weights[o] * (size > 0 ? size : nominal), 2);
        }
    return ofValues * std::sqrt(squares);
}

Eigen::MatrixXd beyondRounding(const FitProblem& problem, const Eigen::VectorXd& values, Eigen::MatrixXd jacobian) {
    const double rounding = roundingOf(problem);
    for (Eigen::Index i = 0; i < jacobian.cols(); ++i) {
        const FitParameter& p = problem.parameters[static_cast<std::size_t>(i)];
        double size = std::abs(values[i]);
        if (size == 0)
            for (const double bound : {p.min, p.max})
                if (!Coordinates::isOpen(bound)) size = std::max(size, std::abs(bound));
        if (size > 0 && size * jacobian.col(i).norm() <= rounding) jacobian.col(i).setZero();
    }
    return jacobian;
}

}  // namespace analogon
