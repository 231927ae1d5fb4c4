#include "core/fit/kink.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <nlopt.hpp>

namespace analogon {
namespace {

/// Standard errors along the axes of their ellipsoid: columns R^-1 s, with slopes = Q R and the scatter s of a
/// residual.
Eigen::MatrixXd axesOf(const Eigen::MatrixXd& slopes, double scatter) {
    const Eigen::Index K = slopes.cols();
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(slopes);
    const Eigen::MatrixXd R = qr.matrixQR().topRows(K).triangularView<Eigen::Upper>();
    return scatter * R.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(K, K));
}

/// The misfit about a minimum, so many standard errors along each axis, within the bounds.
struct Surroundings {
    Misfit& misfit;
    const Coordinates& coordinates;
    const Eigen::MatrixXd& axes;
    nlopt::opt* optimiser{};

    static double cost(const std::vector<double>& errors, std::vector<double>&, void* self) {
        constexpr double failed = 1e100;  // worse than any that can be simulated, and a number the simplex can sort
        auto& around = *static_cast<Surroundings*>(self);
        if (around.misfit.isCancelled()) {
            around.optimiser->force_stop();
            return failed;
        }
        Eigen::VectorXd z =
            around.axes * Eigen::Map<const Eigen::VectorXd>(errors.data(), static_cast<Eigen::Index>(errors.size()));
        for (int i = 0; i < around.coordinates.size(); ++i)
            z[i] = std::clamp(z[i], around.coordinates.lower(i), around.coordinates.upper(i));
        const double value = around.misfit.cost(around.coordinates.values(z));
        return std::isfinite(value) ? std::min(value, failed) : failed;
    }
};

/// Whether the simplex, begun one standard error wide, ended at a least value within so many simulations.
bool searchAround(Surroundings around, int simulations) {
    constexpr double close = 1e-8;  // of the cost: corners that differ by less lie at the least value
    nlopt::opt optimiser(nlopt::LN_NELDERMEAD, static_cast<unsigned>(around.coordinates.size()));
    around.optimiser = &optimiser;
    optimiser.set_min_objective(Surroundings::cost, &around);
    optimiser.set_initial_step(1.0);
    optimiser.set_ftol_rel(close);
    optimiser.set_maxeval(simulations);
    std::vector<double> errors(static_cast<std::size_t>(around.coordinates.size()), 0.0);
    double cost{};
    try {
        return optimiser.optimize(errors, cost) != nlopt::MAXEVAL_REACHED;
    } catch (const nlopt::roundoff_limited&) {
        return true;  // at the least value, to the last digit
    } catch (const std::exception&) {
        return false;
    }
}

}  // namespace

bool mayHaveKinks(const FitProblem& problem) {
    constexpr std::size_t most = 6;  // parameters: of more, the simplex would take far longer than the fit
    return problem.parameters.size() <= most &&
           std::any_of(problem.experiments.begin(), problem.experiments.end(),
                       [](const FitExperiment& e) { return e.system->events() != nullptr; });
}

Minimum pastKink(const FitProblem& problem, const Minimum& from, Misfit& misfit, const Coordinates& coordinates) {
    constexpr int simulationsEach = 60;  // for each parameter: what it takes from one standard error
    const auto freedom = problem.residualCount() - coordinates.size();
    Coordinates here = coordinates;
    here.moveOrigin(misfit.hasBest() ? misfit.best() : from.values);
    const Eigen::VectorXd values = here.values(Eigen::VectorXd::Zero(here.size()));
    const ReducedMisfit known = misfit.reduced(values);
    if (!known.ok || freedom <= 0 || misfit.isRounding(known.cost())) return from;
    const double scatter = std::sqrt(2 * known.cost() / static_cast<double>(freedom));
    const Eigen::MatrixXd axes = axesOf(known.jacobian * here.slopes(values).asDiagonal(), scatter);
    if (!axes.allFinite()) return from;
    const bool isDone = searchAround({misfit, here, axes}, simulationsEach * here.size());
    Minimum minimum = from;
    minimum.values = misfit.best();
    minimum.cost = misfit.bestCost();
    minimum.iterations = from.iterations + 1;
    if (isDone && from.isAtKink) minimum.status = FitStatus::Converged;
    here.moveOrigin(minimum.values);
    for (int i = 0; i < here.size(); ++i)
        minimum.atBound[static_cast<std::size_t>(i)] = here.lower(i) >= 0 || here.upper(i) <= 0;
    return minimum;
}

}  // namespace analogon
