#include "core/effect/search/probe_twin.hpp"

#include <algorithm>
#include <cmath>

namespace analogon {

bool isTwin(const Probe& a, const Probe& b) {
    const Eigen::MatrixXd &one = a.plain.directions, &other = b.plain.directions;
    return one.cols() == 1 && other.cols() == 1 && std::abs(one.col(0).dot(other.col(0))) > twinCorrelation;
}

bool isTwin(const Probe& probe, const Screened& candidate) {
    return std::any_of(candidate.probes.begin(), candidate.probes.end(),
                       [&](const Probe& other) { return isTwin(probe, other); });
}

}  // namespace analogon
