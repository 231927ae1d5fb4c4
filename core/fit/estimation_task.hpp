#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/fit/fit.hpp"
#include "core/library/library.hpp"

/// A composed model together with the recordings it must explain: what a fit, and the search for effects,
/// work on. All values are in the model's units; file formats are behind us.
namespace analogon {

enum class Role { Fit, Validate };

/// A start value of one experiment: a number, or fitted from that number.
struct RecordingStart {
    std::string parameter;  // "element.T_start"
    double value{};
    bool isFitted{};
    std::string column{};  // from whose first cell the value was read; empty: it was told
};

/// The unit that a recording gives for the numbers of a channel, where nothing else was done to them.
struct ChannelUnit {
    std::string channel;  // an input or an output
    std::string column;
    std::string unit, modelUnit;
};

/// An output that was recorded by a logger with a clock of its own (core/fit/clock.hpp). Where the task has a parameter
/// of the name clockOf(output), that is the offset.
struct RecordingClock {
    std::string output;
    double offset{};  // [s] by which it is ahead
};

/// A recorded channel that the model does not use (yet).
struct SpareChannel {
    std::string name;
    std::string unit;
    std::vector<double> values;
};

struct Recording {
    std::string name;
    Role role{Role::Fit};
    std::vector<double> time;              // [s]
    std::vector<std::string> inputNames;   // model's top-level inputs
    Eigen::MatrixXd inputs;                // rows: inputNames, columns: samples
    std::vector<std::string> outputNames;  // model's top-level outputs that were measured
    Eigen::MatrixXd outputs;               // rows: outputNames; NaN: not measured there
    Eigen::VectorXd weights;               // per output, from the study (1: by the noise alone)
    std::vector<RecordingStart> starts;
    std::vector<SpareChannel> spares;
    std::vector<RecordingClock> clocks{};
    std::vector<ChannelUnit> units{};
    std::vector<std::string> held{};              // of the inputs: they keep the value of a sample until the next one
    std::map<std::string, std::string> asHeld{};  // by input: how the study would say that it is held (JSON)

    bool isHeld(const std::string& input) const;
    /// An input at a moment between a sample and the next one, of which this part has passed.
    double between(Eigen::Index input, Eigen::Index sample, double part) const;
    /// One more top-level input, with a value for each sample.
    void addInput(std::string input, const Eigen::VectorXd& values);
};

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
    std::vector<Recording> recordings;
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
