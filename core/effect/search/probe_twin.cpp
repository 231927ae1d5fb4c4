#include "core/effect/search/probe_twin.hpp"

#include <algorithm>
#include <cmath>

namespace analogon {

bool isTwin(const Probe& probe, const Screened& candidate) {
    const Eigen::MatrixXf& one = *probe.course;
    return std::any_of(candidate.probes.begin(), candidate.probes.end(), [&](const Probe& p) {
        const Eigen::MatrixXf& other = *p.course;
        return one.cols() == 1 && other.cols() == 1 && std::abs(one.col(0).dot(other.col(0))) > twinCorrelation;
    });
}

}  // namespace analogon
