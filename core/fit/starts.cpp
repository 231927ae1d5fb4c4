#include "core/fit/starts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "core/base/parallel.hpp"
#include "core/fit/misfit.hpp"

namespace analogon {

std::vector<Eigen::VectorXd> startsOf(const FitProblem& problem, const FitOptions& options) {
    const auto K = static_cast<Eigen::Index>(problem.parameters.size());
    const Eigen::VectorXd own = problem.startValues();
    std::vector<Eigen::VectorXd> starts{own};
    const int further = options.starts - 1;
    if (further <= 0) return starts;
    starts.resize(static_cast<std::size_t>(options.starts), own);
    const Coordinates coordinates(problem.parameters);
    for (Eigen::Index i = 0; i < K; ++i) {
        std::mt19937_64 random(options.seed * 0x9E3779B97F4A7C15ull + static_cast<std::uint64_t>(i));
        std::vector<int> strata(static_cast<std::size_t>(further));
        std::iota(strata.begin(), strata.end(), 0);
        // Own shuffle and own uniform numbers: those of the standard library differ between implementations.
        for (std::size_t s = strata.size(); s > 1; --s) std::swap(strata[s - 1], strata[random() % s]);
        for (int s = 0; s < further; ++s) {
            const double within = static_cast<double>(random() >> 11) * 0x1p-53;
            const double fraction = (strata[static_cast<std::size_t>(s)] + within) / further;
            const int index = static_cast<int>(i);
            starts[static_cast<std::size_t>(s) + 1][i] = options.startsWithin > 1.0
                                                             ? coordinates.near(index, fraction, options.startsWithin)
                                                             : coordinates.within(index, fraction);
        }
    }
    return starts;
}

StartsElsewhere startsElsewhere(const FitProblem& problem, const FitOptions& options, const Progress& progress) {
    StartsElsewhere result;
    constexpr std::size_t enough = 4;
    constexpr int atOnce = 16;  // whatever the number of threads
    FitOptions around = options;
    around.starts = options.otherStarts + 1;
    around.startsWithin = 0;
    const std::vector<Eigen::VectorXd> all = startsOf(problem, around);
    std::vector<std::pair<double, int>> found;  // misfit, number
    for (int from = 1; from < around.starts && found.size() < enough && !progress.stopRequested(); from += atOnce) {
        progress.report({"fit", phrase("looking for start values: {} of {}", from, options.otherStarts), 0.0});
        const int count = std::min(atOnce, around.starts - from);
        std::vector<double> costs(static_cast<std::size_t>(count), std::numeric_limits<double>::infinity());
        parallelFor(count, std::max(1, options.threads), [&](int index) {
            if (progress.stopRequested()) return;
            const Eigen::VectorXd& start = all[static_cast<std::size_t>(from + index)];
            Misfit misfit(problem, options, progress);
            misfit.plan(start, farLooseness);
            costs[static_cast<std::size_t>(index)] = misfit.cost(start);
        });
        result.simulations += count;
        for (int i = 0; i < count; ++i)
            if (std::isfinite(costs[static_cast<std::size_t>(i)]))
                found.emplace_back(costs[static_cast<std::size_t>(i)], from + i);
            else
                ++result.failedSimulations;
    }
    std::sort(found.begin(), found.end());
    for (std::size_t s = 0; s < std::min(enough, found.size()); ++s)
        result.starts.push_back(all[static_cast<std::size_t>(found[s].second)]);
    return result;
}

}  // namespace analogon
