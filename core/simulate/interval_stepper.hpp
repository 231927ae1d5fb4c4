#pragma once

#include <memory>
#include <vector>

#include "core/simulate/step_method.hpp"

namespace analogon {

/// Values across single sample intervals, by either method: machine code for the explicit one where there is some.
/// For models without delays.
class IntervalStepper {
public:
    IntervalStepper(Dynamics& dynamics, InputSlots& slots, const SampledInputs& inputs,
                    const SimulationOptions& options);

    /// From sample `interval` to the next; `from` and `to` (n values) may not overlap.
    bool cross(int interval, bool isImplicit, int substeps, const double* from, double* to);

private:
    bool byCode(int interval, int substeps, const double* from, double* to);

    Dynamics& dynamics_;
    InputSlots& slots_;
    const SampledInputs& inputs_;
    bool hasCode_{};
    std::unique_ptr<StepMethod> explicit_, implicit_;
    std::vector<double> u_[3];
};

}  // namespace analogon
