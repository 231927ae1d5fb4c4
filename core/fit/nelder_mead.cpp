#include <fmt/format.h>

#include <cmath>
#include <nlopt.hpp>

#include "core/fit/misfit.hpp"

namespace analogon {

namespace {

/// A simulation that failed is worse than any that did not, and still a number the simplex can sort.
constexpr double kFailed = 1e100;

struct Search {
    Misfit& misfit;
    const Coordinates& coordinates;
    const FitOptions& options;
    nlopt::opt* optimiser{};

    static double cost(const std::vector<double>& z, std::vector<double>&, void* self) {
        auto& search = *static_cast<Search*>(self);
        if (search.misfit.isCancelled()) {
            search.optimiser->force_stop();
            return kFailed;
        }
        if ((search.misfit.simulations() & 31) == 0) {
            search.misfit.report(fmt::format("simulation {}", search.misfit.simulations()),
                                 search.misfit.simulations() / static_cast<double>(search.options.maxSimulations));
        }
        const double value = search.misfit.cost(
            search.coordinates.values(Eigen::Map<const Eigen::VectorXd>(z.data(), search.coordinates.size())));
        return std::isfinite(value) ? std::min(value, kFailed) : kFailed;
    }
};

enum class Ended { Converged, Limit, Cancelled, Failed };

Ended runOnce(Search& search, std::vector<double>& z, double moveFactor) {
    const int K = search.coordinates.size();
    nlopt::opt optimiser(nlopt::LN_NELDERMEAD, static_cast<unsigned>(K));
    search.optimiser = &optimiser;
    std::vector<double> lower, upper, moves;
    for (int i = 0; i < K; ++i) {
        lower.push_back(search.coordinates.lower(i));
        upper.push_back(search.coordinates.upper(i));
        moves.push_back(moveFactor * search.coordinates.firstMove(i));
    }
    try {
        optimiser.set_lower_bounds(lower);
        optimiser.set_upper_bounds(upper);
        optimiser.set_initial_step(moves);
        optimiser.set_min_objective(Search::cost, &search);
        optimiser.set_ftol_rel(search.options.costTolerance);
        optimiser.set_xtol_rel(1e-9);
        optimiser.set_maxeval(std::max(1, search.options.maxSimulations - search.misfit.simulations()));
        double cost{};
        const nlopt::result result = optimiser.optimize(z, cost);
        return result == nlopt::MAXEVAL_REACHED ? Ended::Limit : Ended::Converged;
    } catch (const nlopt::roundoff_limited&) {
        return Ended::Converged;  // at the optimum, to the last digit
    } catch (const nlopt::forced_stop&) {
        return Ended::Cancelled;
    } catch (const std::exception&) {
        return Ended::Failed;
    }
}

}  // namespace

// Eqs. 9 to 13 of the 2014 paper: linear interpolation and the mean square error, minimised by the simplex.
Minimum nelderMead(Misfit& misfit, Coordinates& coordinates, const FitOptions& options) {
    Search search{misfit, coordinates, options, nullptr};
    const int K = coordinates.size();
    Minimum minimum;
    std::vector<double> z(static_cast<std::size_t>(K), 0.0);
    Ended ended = Ended::Limit;
    // A simplex can collapse before the optimum: start again from where it stopped, until that gains nothing.
    for (int round = 0; round < 12; ++round) {
        const double before = misfit.bestCost();
        ended = runOnce(search, z, round == 0 ? 1.0 : 0.2);
        ++minimum.iterations;
        if (misfit.hasBest()) {
            coordinates.moveOrigin(misfit.best());
            std::fill(z.begin(), z.end(), 0.0);
        }
        if (ended != Ended::Converged) break;
        if (round > 0 && before - misfit.bestCost() <= 1e-8 * before) break;
    }
    minimum.values = misfit.hasBest() ? misfit.best() : coordinates.values(Eigen::VectorXd::Zero(K));
    minimum.cost = misfit.bestCost();
    for (int i = 0; i < K; ++i) minimum.atBound.push_back(0.0 <= coordinates.lower(i) || 0.0 >= coordinates.upper(i));
    switch (ended) {
        case Ended::Converged:
            minimum.status = misfit.hasBest() ? FitStatus::Converged : FitStatus::Failed;
            minimum.message = misfit.hasBest()
                                  ? fmt::format("the simplex converged after {} simulations", misfit.simulations())
                                  : misfit.failure();
            break;
        case Ended::Limit:
            minimum.status = FitStatus::IterationLimit;
            minimum.message = fmt::format("stopped at the limit of {} simulations", misfit.simulations());
            break;
        case Ended::Cancelled:
            minimum.status = FitStatus::Cancelled;
            minimum.message = "cancelled; the best parameters so far are kept";
            break;
        case Ended::Failed:
            minimum.status = FitStatus::Failed;
            minimum.message = "the simplex could not be started";
            break;
    }
    return minimum;
}

}  // namespace analogon
