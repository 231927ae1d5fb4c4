#pragma once

#include "core/fit/misfit.hpp"

namespace analogon {

/// Whether it is worth while to look for another least value of the misfit beside one: where the model has events, the
/// times of which move across the samples, and few parameters.
bool mayHaveKinks(const FitProblem& problem);

/// Goes on from a minimum of a misfit with kinks. Where an event of the model moves across a sample (a body that begins
/// to slide), the sum of squares has another slope on either side: its least value may lie in the edge between them,
/// where no slope leads, or beyond it. The simplex of Nelder and Mead (1965), which needs no slopes, looks for it from
/// one standard error along each axis of the ellipsoid of errors.
Minimum pastKink(const FitProblem& problem, const Minimum& from, Misfit& misfit, const Coordinates& coordinates);

}  // namespace analogon
