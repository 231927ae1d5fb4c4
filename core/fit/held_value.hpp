#pragma once

#include <string>

#include "core/fit/problem.hpp"

namespace analogon {

/// Gives a parameter of the system a value in an experiment; nothing where the system has none of that name.
void setParameter(FitExperiment& experiment, const std::string& name, double value);

/// The same in all of them.
void setParameter(FitProblem& problem, const std::string& name, double value);

/// Writes the value of what is not fitted into an experiment: a parameter of its system, or the clock of an output.
void hold(FitExperiment& experiment, const std::string& name, double value);

}  // namespace analogon
