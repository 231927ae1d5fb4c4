#pragma once

#include "core/effect/model/score.hpp"
#include "core/fit/problem.hpp"

namespace analogon {

/// What a fit of these columns leaves of a residual.
inline Linearisation leftBy(const Eigen::MatrixXd& columns, const Eigen::VectorXd& residual) {
    Linearisation l;
    l.ok = true;
    l.jacobian = columns;
    l.residuals = OrthogonalProjector(columns)(residual);
    return l;
}

}  // namespace analogon
