#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/fit/fit.hpp"
#include "core/fit/recordings.hpp"
#include "core/library/library.hpp"

/// A composed model together with the recordings it must explain: what a fit, and the search for effects,
/// work on. All values are in the model's units; file formats are behind us.
namespace analogon {

/// A parameter that may take another value in mid run (`stepOf` and `momentOf` it are then parameters, too), or that
/// moves with a signal of the recordings (`slopeOf` it is then one).
struct ParameterChange {
    std::string parameter;
    double width{};       // [s] over which it changes
    std::string input{};  // among Recording::inputNames, with which it moves; empty: it changes at a moment
};

/// A variable of the model that a signal of the recordings sets instead of the model's own equation.
struct ImposedVariable {
    std::string variable;
    std::string input;  // among Recording::inputNames
};

struct EstimationTask {
    Library library;  // with the model's own text in it
    SourcePtr model;  // text of the composed model
    std::string className;
    std::vector<FitParameter> parameters;  // fitted for all experiments: of the model, and clocks
    Recordings recordings;
    std::optional<ParameterChange> change;
    std::optional<ImposedVariable> imposed;
};

/// A task made ready to simulate: one system for all experiments, the problem for the experiments with a role.
struct PreparedTask {
    SystemPtr system;
    FitProblem problem;              // experiments with Role::Fit, in order
    std::vector<int> fitRecordings;  // index of the recording of each experiment of `problem`
};

/// Leaves out what a clock that is ahead by `least` to `most` may stamp outside the recording.
void blankBeyond(Recording& recording, const std::string& output, double least, double most);

/// Takes over the channels of a recording in the order of the experiment's system; NaN where a signal has none.
void setSignals(FitExperiment& experiment, const Recording& recording);

/// Compiles the model with the fitted parameters and start values kept symbolic, orders channels as the system
/// does, weights by `noise` (per recording and output of the system: standard deviation; empty: 1 / range of
/// the channel). Faults: a fitted name that is no parameter of the model, an input without a channel, an
/// output that does not exist.
Outcome<PreparedTask> prepare(const EstimationTask& task, const std::vector<Eigen::VectorXd>& noise = {},
                              Role role = Role::Fit, const std::vector<std::string>& alsoKeep = {});

}  // namespace analogon
