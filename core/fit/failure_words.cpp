#include "core/fit/failure_words.hpp"

#include <algorithm>
#include <cmath>

namespace analogon {

Text fittedName(const FitProblem& problem, const FitParameter& p) {
    if (p.experiment < 0) return p.name;
    return phrase("{} of '{}'", p.name, problem.experiments[static_cast<std::size_t>(p.experiment)].name);
}

namespace {

/// "L went from 0.001 to 0": which parameters a fit that failed has taken how far.
Text journeysText(const FitProblem& problem, const Eigen::VectorXd& begin, const Eigen::VectorXd& end) {
    constexpr std::size_t most = 3;
    constexpr double worthTelling = 0.01;
    const auto distance = [&](Eigen::Index i) {
        return std::abs(end[i] - begin[i]) / std::max(std::abs(begin[i]), std::abs(end[i]));
    };
    std::vector<Eigen::Index> moved;
    for (Eigen::Index i = 0; i < end.size(); ++i)
        if (distance(i) > worthTelling) moved.push_back(i);
    std::stable_sort(moved.begin(), moved.end(),
                     [&](Eigen::Index a, Eigen::Index b) { return distance(a) > distance(b); });
    Text list;
    for (std::size_t k = 0; k < std::min(most, moved.size()); ++k) {
        if (k > 0) list += ", ";
        const Eigen::Index i = moved[k];
        list += phrase("{} went from {:.4g} to {:.4g}",
                       fittedName(problem, problem.parameters[static_cast<std::size_t>(i)]), begin[i], end[i]);
    }
    return list;
}

}  // namespace

void tellFailure(const FitProblem& problem, const Eigen::VectorXd& begin, FitResult& result) {
    if (result.status != FitStatus::Failed || !std::isfinite(result.cost)) return;
    if (const Text journeys = journeysText(problem, begin, result.values); !journeys.empty())
        result.message = phrase("{}; the best until then is kept: {}", result.message, journeys);
}

}  // namespace analogon
