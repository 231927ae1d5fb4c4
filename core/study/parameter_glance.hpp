#pragma once

#include <Eigen/Core>
#include <string>

#include "core/study/trace_simulator.hpp"

namespace analogon {

/// The fitted experiments at other values of one parameter, as fast as they can be seen: the model is compiled and the
/// steps are planned once, at the values that the study has.
class ParameterGlance {
public:
    /// Faults: those of the study; there is no such parameter, or it may not change.
    static Outcome<ParameterGlance> make(const Study& study, const std::string& parameter,
                                         const Progress& progress = {});

    /// Nothing: it cannot be simulated there.
    std::optional<SimulatedTraces> at(double value, const Progress& progress = {}) const;

private:
    ParameterGlance() = default;

    FitProblem problem_;
    std::vector<GridPlan> plans_;  // one an experiment
    Eigen::VectorXd start_;        // of all that is fitted
    Eigen::Index turned_{};        // among them
};

}  // namespace analogon
