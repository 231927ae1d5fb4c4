#pragma once

#include <string>
#include <vector>

#include "core/fit/estimation_task.hpp"

namespace analogon {

/// An input that was recorded with white noise, which the component never felt but the model does.
struct NoisyInput {
    int recording{};  // of the task
    std::string name;
    double deviation{};  // of the noise, in the input's unit
};

/// Takes the white noise out of the inputs of the fitted recordings as far as that can be done without rounding steps
/// off: the mean of the neighbours that lie within the noise (sigma filter, Lee 1983). What it found; inputs without
/// such noise stay as they are.
std::vector<NoisyInput> quieten(EstimationTask& task);

}  // namespace analogon
