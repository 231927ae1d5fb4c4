#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

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

}  // namespace analogon
