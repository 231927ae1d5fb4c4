#pragma once

#include <optional>

#include "core/simulate/grid.hpp"

namespace analogon {

/// Steps that follow what the model does: as many in each sample interval as it needs there, by the explicit method
/// where that is stable, by the implicit one where a few of its steps are cheaper. The solution is walked once with
/// step doubling in every interval; what the plan yields is compared with it over the whole record, and the plan is
/// tightened until its outputs agree within the tolerance (a part of each output's range).
/// `gaps`: of the inputs. `survey` is a run over the record with its states: it shows how far they move. Nothing: the
/// record is too short, the model delays signals, or the walk failed. `taken`: receives the run with these steps.
std::optional<GridPlan> scheduleSteps(Dynamics& dynamics, const SampledInputs& inputs, const Gaps& gaps,
                                      const Trajectory& survey, double tolerance, const SimulationOptions& options,
                                      const Progress& progress, std::optional<Trajectory>* taken = nullptr);

/// Cost of an implicit step in explicit ones: measured, with machine code for the explicit method or without.
double costOfImplicitStep(Dynamics& dynamics);

/// Largest magnitude of the eigenvalues of a row-major n x n matrix, from above, within a quarter: the norm of its
/// 64th power (Gelfand's formula). Norms of lower powers lie above it: where one of them is no more than `enough` it is
/// returned at once. `matrix` and `scratch` (both n x n) are overwritten.
double spectralRadius(double* matrix, double* scratch, int n, double enough = 0.0);

}  // namespace analogon
