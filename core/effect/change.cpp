#include "core/effect/change.hpp"

#include <cmath>

namespace analogon {
namespace {

constexpr int coarse = 40;        // moments that are tried over a recording, then again around the best
constexpr double margin = 0.04;   // of the recording at either end, where a break is no break
constexpr double visible = 3e-3;  // |g_perp| / |g|

/// Rows of one experiment at or after a moment.
Eigen::VectorXd from(const NullModel& null, const std::vector<double>& time, int experiment, double moment,
                     const Eigen::VectorXd& column) {
    Eigen::VectorXd later = Eigen::VectorXd::Zero(column.size());
    for (const ResidualChannel& c : null.channels) {
        if (c.experiment != experiment) continue;
        for (int row = c.begin; row < c.end; ++row)
            if (time[static_cast<std::size_t>(c.samples[static_cast<std::size_t>(row - c.begin)])] >= moment)
                later[row] = column[row];
    }
    return later;
}

}  // namespace

std::optional<Change> strongestChange(const NullModel& null) {
    const Eigen::MatrixXd& jacobian = null.fit.optimum.jacobian;
    const Eigen::VectorXd& residual = null.fit.optimum.residuals;
    const Complement complement(jacobian);
    std::optional<Change> best;
    int experiment = 0;
    for (const Recording& recording : null.variant.task.recordings) {
        if (recording.role != Role::Fit) continue;
        const std::vector<double>& time = recording.time;
        const double begin = time.front(), span = time.back() - time.front();
        const auto take = [&](Eigen::Index j, double moment) {
            const Eigen::VectorXd column = from(null, time, experiment, moment, jacobian.col(j));
            const Eigen::VectorXd rest = complement(Eigen::MatrixXd(column)).col(0);
            const double squared = rest.squaredNorm();
            if (!(rest.norm() > visible * column.norm())) return;
            const double along = rest.dot(residual);
            const double explained = along * along / squared;
            if (best && explained <= best->explained) return;
            const FitEstimate& estimate = null.fit.estimates[static_cast<std::size_t>(j)];
            best = {estimate.name, experiment, moment, estimate.value, estimate.value - along / squared, explained};
        };
        for (Eigen::Index j = 0; j < jacobian.cols(); ++j) {
            if (null.fit.estimates[static_cast<std::size_t>(j)].experiment >= 0) continue;  // a start value
            for (int k = 0; k <= coarse; ++k)
                take(j, begin + span * (margin + (1 - 2 * margin) * k / static_cast<double>(coarse)));
        }
        if (best && best->experiment == experiment) {
            const double around = best->time, step = span / coarse;
            for (Eigen::Index j = 0; j < jacobian.cols(); ++j)
                if (null.fit.estimates[static_cast<std::size_t>(j)].name == best->parameter)
                    for (int k = -10; k <= 10; ++k) take(j, around + step * k / 10.0);
        }
        ++experiment;
    }
    return best;
}

}  // namespace analogon
