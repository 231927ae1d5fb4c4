#include "core/effect/caution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/range.hpp"

namespace analogon {
namespace {

constexpr double worthSaying = 0.1;                  // of the fitted range
constexpr double mostOfExcess = 0.5, least = 100.0;  // of what is above the noise; in units of the noise, squared

Range rangeIn(const Recording& recording, const std::vector<std::string>& names, const Eigen::MatrixXd& values,
              const std::string& name) {
    const auto at = std::find(names.begin(), names.end(), name);
    if (at == names.end() || values.cols() != static_cast<Eigen::Index>(recording.time.size())) return {};
    return rangeOf(values.row(at - names.begin()));
}

/// Rows of one experiment of a column; the rest 0.
Eigen::VectorXd within(const NullModel& null, int experiment, const Eigen::VectorXd& column) {
    Eigen::VectorXd part = Eigen::VectorXd::Zero(column.size());
    for (const ResidualChannel& c : null.channels)
        if (c.experiment == experiment)
            part.segment(c.begin, c.end - c.begin) = column.segment(c.begin, c.end - c.begin);
    return part;
}

}  // namespace

std::vector<std::string> extrapolations(const EstimationTask& task) {
    std::vector<std::string> said;
    for (const Recording& checked : task.recordings) {
        if (checked.role != Role::Validate) continue;
        const auto look = [&](const char* side, const std::string& name, const auto& rangeOfIts) {
            Range fitted;
            for (const Recording& r : task.recordings) {
                if (r.role != Role::Fit) continue;
                if (const Range own = rangeOfIts(r, name); own.width() > 0) fitted.take(own);
            }
            const Range own = rangeOfIts(checked, name);
            if (!(fitted.width() > 0) || own.isEmpty()) return;
            const double beyond = std::max(own.high - fitted.high, fitted.low - own.low) / fitted.width();
            if (beyond > worthSaying)
                said.push_back(
                    fmt::format("'{}' leaves the range of the fitted recordings on {} {} by {:.0f} % of that range: "
                                "what the model says there is extrapolated",
                                checked.name, side, name, 100 * beyond));
        };
        for (const std::string& name : checked.inputNames)
            look("input", name,
                 [](const Recording& r, const std::string& n) { return rangeIn(r, r.inputNames, r.inputs, n); });
        for (const std::string& name : checked.outputNames)
            look("output", name,
                 [](const Recording& r, const std::string& n) { return rangeIn(r, r.outputNames, r.outputs, n); });
    }
    return said;
}

std::vector<std::string> driftBetweenRecordings(const NullModel& null) {
    const std::vector<int> recordings = recordingsOf(null.variant.task, Role::Fit);
    if (recordings.size() < 2) return {};
    const Eigen::MatrixXd& jacobian = null.fit.optimum.jacobian;
    const Eigen::VectorXd& residual = null.fit.optimum.residuals;
    const double excess = residual.squaredNorm() - static_cast<double>(residual.size());
    const Complement complement(jacobian);
    struct Drift {
        double explained{}, before{}, after{};
        std::string parameter, recording;
    } best;
    for (std::size_t e = 0; e < recordings.size(); ++e)
        for (Eigen::Index j = 0; j < jacobian.cols(); ++j) {
            const FitEstimate& estimate = null.fit.estimates[static_cast<std::size_t>(j)];
            if (estimate.experiment >= 0) continue;  // a start value
            const Eigen::VectorXd column = within(null, static_cast<int>(e), jacobian.col(j));
            const ColumnScore score = scoreColumns(complement, residual, column, false);
            if (!(score.visible > leastVisible) || !(score.explained > best.explained)) continue;
            const double step = score.strengths[0];
            const double elsewhere = estimate.value - step * complement.coefficients(column)[j];
            best = {score.explained, elsewhere, elsewhere + step, estimate.name,
                    null.variant.task.recordings[static_cast<std::size_t>(recordings[e])].name};
        }
    if (!(best.explained > least) || !(best.explained > mostOfExcess * excess)) return {};
    return {
        fmt::format("{} seems to be another one in '{}' (about {:.4g}) than in the other recordings (about {:.4g}): "
                    "was the component, or its condition, the same?",
                    best.parameter, best.recording, best.after, best.before)};
}

std::vector<std::string> boundHits(const FitResult& fit) {
    std::vector<std::string> said;
    for (const FitEstimate& e : fit.estimates)
        if (e.atBound)
            said.push_back(
                fmt::format("{} rests at a bound ({:.4g}{}{}): the bound is too narrow, or the model lacks "
                            "something that the parameter stands in for",
                            e.name, e.value, e.unit.empty() ? "" : " ", e.unit));
    return said;
}

}  // namespace analogon
