#include "core/effect/block/probe_score.hpp"

#include <algorithm>
#include <cmath>

#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::screen;

namespace {

/// Rows that tell the directions of candidates apart, those of all of which are held against each other.
constexpr Eigen::Index mostRows = 8192;

/// The one direction of a score at no more rows than tell courses apart; empty: it has several.
SharedColumns courseOf(const ColumnScore& score) {
    constexpr Eigen::Index mostRowsOfACourse = 2000;
    return score.directions->cols() == 1 ? atSomeRows(score.directions, mostRowsOfACourse) : SharedColumns();
}

/// A trace's part beside the model's parameters in the orthonormal `directions` that hold it, of length 1; zeros where
/// there is none.
Eigen::VectorXd directionOf(const NullModel& null, const Eigen::VectorXd& trace, const Eigen::MatrixXf& directions) {
    const Eigen::VectorXd parts = directions.cast<double>().transpose() * null.scores().plain(trace).col(0);
    return parts.norm() > 0 ? Eigen::VectorXd(parts.normalized()) : parts;
}

}  // namespace

std::vector<std::string> imitators(const NullModel& null, const Eigen::VectorXd& trace) {
    const Eigen::VectorXd c = null.scores().plain.coefficients(trace);
    std::vector<std::pair<double, std::string>> parts;
    for (Eigen::Index j = 0; j < c.size(); ++j)
        parts.emplace_back(std::abs(c[j]) * null.fit.optimum.jacobian.col(j).norm(),
                           null.fit.estimates[static_cast<std::size_t>(j)].name);
    std::sort(parts.rbegin(), parts.rend());
    std::vector<std::string> names;
    for (const auto& [part, name] : parts)
        if (part > 0.1 * parts.front().first) names.push_back(name);
    return names;
}

void scoreProbe(const NullModel& null, bool oneSided, const Eigen::MatrixXd& columns, Probe& probe) {
    const ScoresBeside& scores = null.scores();
    probe.plain = scoreColumns(scores.plain, null.fit.optimum.residuals, columns, oneSided);
    probe.whitened = scoreColumns(scores.white, scores.whiteResidual, null.whitener(columns), oneSided);
}

Eigen::VectorXd secantTrace(const NullModel& null, const Eigen::VectorXd& residuals, double strength) {
    constexpr double rounding = 1e-5;  // of the noise, root mean square
    const Eigen::VectorXd difference = residuals - null.fit.optimum.residuals;
    const double least = rounding * std::sqrt(static_cast<double>(difference.size()));
    if (difference.norm() <= least) return Eigen::VectorXd::Zero(difference.size());
    return difference / strength;
}

double scoreOf(const ColumnScore& score) {
    return score.wrongSign || score.visible < leastVisible ? 0 : score.explained;
}

void keepBest(const NullModel& null, Screened& screened) {
    std::vector<Probe>& probes = screened.probes;
    std::stable_sort(probes.begin(), probes.end(),
                     [](const Probe& a, const Probe& b) { return scoreOf(a.plain) > scoreOf(b.plain); });
    for (std::size_t i = 0; i < probes.size(); ++i) {
        probes[i].course = courseOf(probes[i].plain);
        probes[i].whitened.directions.reset();
        if (i > 0) probes[i].plain.directions.reset();
    }
    Probe& best = probes.front();
    if (screened.isAbsorbed()) screened.absorbedBy = imitators(null, best.column);
    best.strengthIn = directionOf(null, best.column, *best.plain.directions);
    best.plain.directions = atSomeRows(best.plain.directions, mostRows);
    for (Probe& probe : probes) probe.column.resize(0);
}

}  // namespace analogon
