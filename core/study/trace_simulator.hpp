#pragma once

#include <optional>
#include <vector>

#include "core/study/run.hpp"

namespace analogon {

/// What the model says of one output, and how far that is from the measured channel.
struct SimulatedTrace {
    std::string output;
    std::vector<double> values;  // at the samples of the recording
    double errorPercent{};
};

struct SimulatedExperiment {
    std::string name;
    std::vector<SimulatedTrace> outputs;  // those that were measured
    double errorPercent{};                // root mean square over them
};

struct SimulatedTraces {
    std::vector<SimulatedExperiment> experiments;
    double errorPercent{};  // root mean square over the experiments
};

/// Simulates the fitted experiments of a study at other values of its parameters, as a fit reports them. The model is
/// compiled once: this is fast enough to watch a fit by.
class TraceSimulator {
public:
    static Outcome<TraceSimulator> make(const Study& study, const RunOptions& options);

    /// Nothing where the values belong to another model (one with an effect on trial), or where it cannot be simulated.
    std::optional<SimulatedTraces> at(const std::vector<Progress::Value>& values, const Progress& progress = {}) const;

private:
    TraceSimulator(FitProblem problem, SimulationOptions options)
        : problem_(std::move(problem)), options_(std::move(options)) {}

    FitProblem problem_;
    SimulationOptions options_;
};

}  // namespace analogon
