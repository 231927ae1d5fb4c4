#include <cmath>
#include <nlopt.hpp>

#include "core/fit/misfit.hpp"

namespace analogon {

namespace {

/// A simulation that failed is worse than any that did not, and still a number the simplex can sort.
constexpr double kFailed = 1e100;
constexpr double boxInMoves = 20;
constexpr int globalSimulations = 300;  // for each parameter, before the simplex takes over

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
            search.misfit.report(phrase("simulation {}", search.misfit.simulations()),
                                 search.misfit.simulations() / static_cast<double>(search.options.maxSimulations));
        }
        const double value = search.misfit.cost(
            search.coordinates.values(Eigen::Map<const Eigen::VectorXd>(z.data(), search.coordinates.size())));
        return std::isfinite(value) ? std::min(value, kFailed) : kFailed;
    }
};

enum class Ended { Converged, Limit, Cancelled, Failed };

bool isGlobal(FitMethod method) { return method >= FitMethod::Crs2; }

nlopt::algorithm algorithmOf(FitMethod method) {
    switch (method) {
        case FitMethod::Sbplx:
            return nlopt::LN_SBPLX;
        case FitMethod::Bobyqa:
            return nlopt::LN_BOBYQA;
        case FitMethod::Crs2:
            return nlopt::GN_CRS2_LM;
        case FitMethod::Isres:
            return nlopt::GN_ISRES;
        case FitMethod::Esch:
            return nlopt::GN_ESCH;
        default:
            return nlopt::LN_NELDERMEAD;
    }
}

/// A global search needs a box: what has no bound is looked for this many first moves around the start.
double boxed(double bound, double firstMove) {
    return std::isfinite(bound) ? bound : std::copysign(boxInMoves * firstMove, bound);
}

Ended runOnce(Search& search, FitMethod method, std::vector<double>& z, double moveFactor) {
    const int K = search.coordinates.size();
    nlopt::opt optimiser(algorithmOf(method), static_cast<unsigned>(K));
    search.optimiser = &optimiser;
    std::vector<double> lower, upper, moves;
    for (int i = 0; i < K; ++i) {
        const double move = search.coordinates.firstMove(i);
        lower.push_back(isGlobal(method) ? boxed(search.coordinates.lower(i), move) : search.coordinates.lower(i));
        upper.push_back(isGlobal(method) ? boxed(search.coordinates.upper(i), move) : search.coordinates.upper(i));
        moves.push_back(moveFactor * move);
    }
    int most = search.options.maxSimulations - search.misfit.simulations();
    if (isGlobal(method)) {
        nlopt::srand(search.options.seed);
        most = std::min(most / 2, globalSimulations * (K + 1));
    }
    try {
        optimiser.set_lower_bounds(lower);
        optimiser.set_upper_bounds(upper);
        optimiser.set_initial_step(moves);
        optimiser.set_min_objective(Search::cost, &search);
        optimiser.set_ftol_rel(search.options.costTolerance);
        optimiser.set_xtol_rel(1e-9);
        optimiser.set_maxeval(std::max(1, most));
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

// Eqs. 9 to 13 of the 2014 paper (docs/method.md, source [1]): linear interpolation and the mean square error,
// minimised by the simplex.
Minimum directSearch(Misfit& misfit, Coordinates& coordinates, const FitOptions& options) {
    Search search{misfit, coordinates, options, nullptr};
    const int K = coordinates.size();
    Minimum minimum;
    std::vector<double> z(static_cast<std::size_t>(K), 0.0);
    const auto goOnFromBest = [&] {
        if (!misfit.hasBest()) return;
        coordinates.moveOrigin(misfit.best());
        std::fill(z.begin(), z.end(), 0.0);
    };
    Ended ended = Ended::Limit;
    FitMethod local = options.method;
    if (isGlobal(options.method)) {
        // how far a global search came says nothing of convergence: the simplex does
        ended = runOnce(search, options.method, z, 1.0);
        goOnFromBest();
        local = FitMethod::NelderMead;
    }
    const bool mayGoOn = ended != Ended::Cancelled && ended != Ended::Failed;
    // A simplex can collapse before the optimum: start again from where it stopped, until that gains nothing.
    for (int round = 0; round < 12 && mayGoOn; ++round) {
        const double before = misfit.bestCost();
        ended = runOnce(search, local, z, round == 0 && !isGlobal(options.method) ? 1.0 : 0.2);
        ++minimum.iterations;
        goOnFromBest();
        if (ended != Ended::Converged) break;
        if (round > 0 && before - misfit.bestCost() <= 1e-8 * before) break;
    }
    minimum.values = misfit.hasBest() ? misfit.best() : coordinates.values(Eigen::VectorXd::Zero(K));
    minimum.cost = misfit.bestCost();
    for (int i = 0; i < K; ++i) minimum.atBound.push_back(0.0 <= coordinates.lower(i) || 0.0 >= coordinates.upper(i));
    switch (ended) {
        case Ended::Converged:
            minimum.status = misfit.hasBest() ? FitStatus::Converged : FitStatus::Failed;
            minimum.message =
                misfit.hasBest() ? phrase("converged after {} simulations", misfit.simulations()) : misfit.failure();
            break;
        case Ended::Limit:
            minimum.status = FitStatus::IterationLimit;
            minimum.message = phrase("stopped at the limit of {} simulations", misfit.simulations());
            break;
        case Ended::Cancelled:
            minimum.status = FitStatus::Cancelled;
            minimum.message = phrase("cancelled; the best parameters so far are kept");
            break;
        case Ended::Failed:
            minimum.status = FitStatus::Failed;
            minimum.message = phrase("the search could not be started");
            break;
    }
    return minimum;
}

}  // namespace analogon
