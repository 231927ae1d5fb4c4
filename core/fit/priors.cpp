#include "core/fit/priors.hpp"

namespace analogon {

PriorResiduals priorResiduals(const FitProblem& problem, const Eigen::VectorXd& values, double scatter) {
    std::vector<Eigen::Index> known;
    for (std::size_t i = 0; i < problem.parameters.size(); ++i)
        if (problem.parameters[i].prior) known.push_back(static_cast<Eigen::Index>(i));
    const auto count = static_cast<Eigen::Index>(known.size());
    PriorResiduals result{Eigen::MatrixXd::Zero(count, values.size()), Eigen::VectorXd::Zero(count)};
    for (Eigen::Index row = 0; row < count; ++row) {
        const Eigen::Index i = known[static_cast<std::size_t>(row)];
        const NormalPrior& prior = *problem.parameters[static_cast<std::size_t>(i)].prior;
        result.jacobian(row, i) = scatter / prior.deviation;
        result.residuals[row] = scatter * prior.distance(values[i]);
    }
    return result;
}

ReducedMisfit withPriors(const ReducedMisfit& data, const PriorResiduals& priors) {
    if (priors.residuals.size() == 0 || !data.ok) return data;
    Eigen::MatrixXd jacobian(data.jacobian.rows() + priors.jacobian.rows(), data.jacobian.cols());
    Eigen::VectorXd residuals(jacobian.rows());
    jacobian << data.jacobian, priors.jacobian;
    residuals << data.residuals, priors.residuals;
    return reduce(jacobian, residuals);
}

}  // namespace analogon
