#include "core/simulate/interval_stepper.hpp"

#include <algorithm>
#include <cmath>

namespace analogon {

IntervalStepper::IntervalStepper(Dynamics& dynamics, InputSlots& slots, const SampledInputs& inputs,
                                 const SimulationOptions& options)
    : dynamics_(dynamics),
      slots_(slots),
      inputs_(inputs),
      hasCode_(dynamics.prepareSteps()),
      explicit_(makeStepMethod(GridMethod::RungeKutta4, dynamics, slots, options)),
      implicit_(makeStepMethod(GridMethod::Esdirk, dynamics, slots, options)) {
    for (std::vector<double>& u : u_) u.resize(static_cast<std::size_t>(dynamics.shape().slots));
}

bool IntervalStepper::cross(int interval, bool isImplicit, int substeps, const double* from, double* to) {
    if (!isImplicit && hasCode_) return byCode(interval, substeps, from, to);
    std::copy_n(from, dynamics_.shape().states, to);
    const auto k = static_cast<std::size_t>(interval);
    const Substeps steps = isImplicit ? slots_.gaps().implicitSteps(interval, substeps)
                                      : Substeps{inputs_.time[k], inputs_.time[k + 1], substeps};
    StepMethod& method = isImplicit ? *implicit_ : *explicit_;
    for (int s = 0; s < substeps; ++s)
        if (!method.step(interval, steps.time(s), steps.length(s), to, nullptr)) return false;
    return true;
}

bool IntervalStepper::byCode(int interval, int substeps, const double* from, double* to) {
    const double begin = inputs_.time[static_cast<std::size_t>(interval)];
    const double end = inputs_.time[static_cast<std::size_t>(interval) + 1], h = (end - begin) / substeps;
    dynamics_.loadState(from, nullptr);
    slots_.at(interval, begin, u_[2].data());
    for (int s = 0; s < substeps; ++s) {
        std::swap(u_[0], u_[2]);
        slots_.at(interval, s + 1 == substeps ? end : begin + (s + 1) * h, u_[2].data());
        for (std::size_t i = 0; i < u_[1].size(); ++i) u_[1][i] = 0.5 * (u_[0][i] + u_[2][i]);
        if (!dynamics_.step(begin + s * h, h, u_[0].data(), u_[1].data(), u_[2].data())) return false;
    }
    dynamics_.storeState(to, nullptr);
    return std::all_of(to, to + dynamics_.shape().states, [](double x) { return std::isfinite(x); });
}

}  // namespace analogon
