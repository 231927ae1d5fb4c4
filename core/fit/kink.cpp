#include "core/fit/kink.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace analogon {
namespace {

struct Corner {
    double cost{};
    Eigen::VectorXd z;

    bool operator<(const Corner& other) const { return cost < other.cost; }
};

/// The coordinates of a fit around its minimum, in which every parameter may move freely within its bounds.
class Surroundings {
public:
    Surroundings(Misfit& misfit, const Coordinates& coordinates) : misfit_(misfit), coordinates_(coordinates) {}

    Corner at(const Eigen::VectorXd& z) const {
        Eigen::VectorXd inside = z;
        for (int i = 0; i < coordinates_.size(); ++i)
            inside[i] = std::clamp(z[i], coordinates_.lower(i), coordinates_.upper(i));
        return {misfit_.cost(coordinates_.values(inside)), inside};
    }

private:
    Misfit& misfit_;
    const Coordinates& coordinates_;
};

/// Standard errors along the axes of their ellipsoid: columns R^-1 s, with slopes = Q R and the scatter s of a
/// residual.
Eigen::MatrixXd axesOf(const Eigen::MatrixXd& slopes, double scatter) {
    const Eigen::Index K = slopes.cols();
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(slopes);
    const Eigen::MatrixXd R = qr.matrixQR().topRows(K).triangularView<Eigen::Upper>();
    return scatter * R.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(K, K));
}

/// One step of the method.
void turn(std::vector<Corner>& simplex, const Surroundings& around) {
    std::sort(simplex.begin(), simplex.end());
    const std::size_t last = simplex.size() - 1;
    Eigen::VectorXd middle = Eigen::VectorXd::Zero(simplex[0].z.size());
    for (std::size_t i = 0; i < last; ++i) middle += simplex[i].z / static_cast<double>(last);
    const auto along = [&](double by) { return around.at(middle + by * (simplex[last].z - middle)); };
    Corner next = along(-1);
    if (next < simplex[0])
        next = std::min(next, along(-2));
    else if (!(next < simplex[last - 1]))
        next = along(0.5);
    if (next < simplex[last]) {
        simplex[last] = std::move(next);
        return;
    }
    for (std::size_t i = 1; i <= last; ++i) simplex[i] = around.at(0.5 * (simplex[0].z + simplex[i].z));
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
    constexpr double close = 1e-8;       // of the cost: corners that differ by less lie at the least value
    const auto freedom = problem.residualCount() - coordinates.size();
    Coordinates here = coordinates;
    here.moveOrigin(misfit.hasBest() ? misfit.best() : from.values);
    const Eigen::VectorXd values = here.values(Eigen::VectorXd::Zero(here.size()));
    const ReducedMisfit known = misfit.reduced(values);
    if (!known.ok || freedom <= 0 || misfit.isRounding(known.cost())) return from;
    const double scatter = std::sqrt(2 * known.cost() / static_cast<double>(freedom));
    const Eigen::MatrixXd axes = axesOf(known.jacobian * here.slopes(values).asDiagonal(), scatter);
    if (!axes.allFinite()) return from;
    const Surroundings around(misfit, here);
    std::vector<Corner> simplex{{known.cost(), Eigen::VectorXd::Zero(here.size())}};
    for (Eigen::Index i = 0; i < axes.cols(); ++i) simplex.push_back(around.at(axes.col(i)));
    const int most = misfit.simulations() + simulationsEach * here.size();
    Minimum minimum = from;
    const auto isClose = [&] {
        const auto [least, greatest] = std::minmax_element(simplex.begin(), simplex.end());
        return greatest->cost - least->cost <= close * least->cost;
    };
    while (!isClose() && misfit.simulations() < most && !misfit.isCancelled()) turn(simplex, around);
    const Corner& best = *std::min_element(simplex.begin(), simplex.end());
    minimum.values = misfit.best();
    minimum.cost = misfit.bestCost();
    minimum.iterations = from.iterations + 1;
    if (isClose() && from.isAtKink) minimum.status = FitStatus::Converged;
    for (int i = 0; i < here.size(); ++i)
        minimum.atBound[static_cast<std::size_t>(i)] = best.z[i] <= here.lower(i) || best.z[i] >= here.upper(i);
    return minimum;
}

}  // namespace analogon
