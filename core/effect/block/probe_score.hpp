#pragma once

#include "core/effect/block/screen.hpp"

namespace analogon {

/// Rao's score test of the traces of an effect against the residual of a model, as it is and with the noise made white.
/// `columns`: rows of the residual x traces of the strength and of what is linear beside it, in units of the noise.
void scoreProbe(const NullModel& null, bool oneSided, const Eigen::MatrixXd& columns, Probe& probe);

/// The trace that residuals taken at a strength (not 0) show of it, in units of the noise per unit of the strength;
/// zeros where they differ from those of the model by no more than rounding.
Eigen::VectorXd secantTrace(const NullModel& null, const Eigen::VectorXd& residuals, double strength);

/// What a probe explains where it is visible and of the right sign.
double scoreOf(const ColumnScore& score);

/// The parameters of the model that imitate a trace (rows of the residual) most, the most first.
std::vector<std::string> imitators(const NullModel& null, const Eigen::VectorXd& trace);

/// Sorts the probes of a candidate, the best first, tells what imitates it, and drops what nobody asks for again: a
/// round keeps the probes of all candidates, which take more room than all else.
void keepBest(const NullModel& null, Screened& screened);

}  // namespace analogon
