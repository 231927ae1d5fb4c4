#include "core/effect/block/recorded_lead.hpp"

#include <cmath>

namespace analogon {

namespace {

// by which outputs of one simulation that are proportional may differ, as a share of their variation: rounding, and of
// one that was summed over the samples the trapezoidal rule
constexpr double sameCourse = 1e-6, sameRate = 1e-2;

/// Trapezoidal sum over the time, from 0 at the first sample.
Eigen::VectorXd summed(const Eigen::VectorXd& rate, const std::vector<double>& time) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(rate.size());
    for (Eigen::Index k = 1; k < rate.size(); ++k) {
        const auto i = static_cast<std::size_t>(k);
        sum[k] = sum[k - 1] + 0.5 * (rate[k] + rate[k - 1]) * (time[i] - time[i - 1]);
    }
    return sum;
}

/// What was measured less what is simulated; a lost sample has the difference of the one before.
Eigen::VectorXd difference(const Eigen::VectorXd& measured, const Eigen::VectorXd& simulated) {
    Eigen::VectorXd rest = measured - simulated;
    for (Eigen::Index k = 0; k < rest.size(); ++k)
        if (std::isnan(rest[k])) rest[k] = k > 0 ? rest[k - 1] : 0;
    return rest;
}

/// The factor by which one series varies as the other does in all experiments; nothing where it does not.
std::optional<double> proportion(const std::vector<Eigen::VectorXd>& of, const std::vector<Eigen::VectorXd>& to,
                                 double tolerance) {
    double both = 0, own = 0, all = 0;
    for (std::size_t e = 0; e < of.size(); ++e) {
        const Eigen::VectorXd x = of[e].array() - of[e].mean(), y = to[e].array() - to[e].mean();
        both += x.dot(y);
        own += y.squaredNorm();
        all += x.squaredNorm();
    }
    if (!(own > 0) || !(all > 0)) return std::nullopt;
    const double factor = both / own, rest = std::max(0.0, all - factor * both);
    return rest < tolerance * tolerance * all ? std::optional(factor) : std::nullopt;
}

}  // namespace

std::optional<std::vector<Eigen::VectorXd>> recordedLead(const NullModel& null, const FitProblem& problem,
                                                         const std::vector<Eigen::VectorXd>& simulated) {
    const std::size_t experiments = problem.experiments.size();
    if (experiments == 0 || simulated.size() != experiments) return std::nullopt;
    const auto output = [&](std::size_t e, Eigen::Index o) {
        return Eigen::VectorXd(null.fit.optimum.trajectories[e].outputs.row(o).transpose());
    };
    const Eigen::Index outputs = problem.experiments.front().measured.rows();
    for (const bool isRate : {false, true})
        for (Eigen::Index o = 0; o < outputs; ++o) {
            std::vector<Eigen::VectorXd> told, lead;
            for (std::size_t e = 0; e < experiments; ++e) {
                const FitExperiment& experiment = problem.experiments[e];
                if (!(experiment.weights[o] > 0) || simulated[e].size() != experiment.measured.cols()) break;
                const Eigen::VectorXd own = output(e, o),
                                      ahead = difference(experiment.measured.row(o).transpose(), own);
                told.push_back(isRate ? summed(own, experiment.inputs.time) : own);
                lead.push_back(isRate ? summed(ahead, experiment.inputs.time) : ahead);
            }
            if (told.size() != experiments) continue;
            const std::optional<double> factor = proportion(simulated, told, isRate ? sameRate : sameCourse);
            if (!factor) continue;
            for (Eigen::VectorXd& each : lead) each *= *factor;
            return lead;
        }
    return std::nullopt;
}

}  // namespace analogon
