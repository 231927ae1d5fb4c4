#include "core/fit/held_value.hpp"

#include "core/fit/clock.hpp"

namespace analogon {

void setParameter(FitExperiment& experiment, const std::string& name, double value) {
    if (const int index = experiment.system->parameterIndex(name); index >= 0)
        experiment.parameters[static_cast<std::size_t>(index)] = value;
}

void setParameter(FitProblem& problem, const std::string& name, double value) {
    for (FitExperiment& experiment : problem.experiments) setParameter(experiment, name, value);
}

void hold(FitExperiment& experiment, const std::string& name, double value) {
    setParameter(experiment, name, value);
    for (ChannelClock& clock : experiment.clocks)
        if (clockOf(experiment.system->outputs()[static_cast<std::size_t>(clock.output)].name) == name)
            clock.offset = value;
}

}  // namespace analogon
