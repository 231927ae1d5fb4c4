#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/eval/c_code.hpp"
#include "core/eval/system.hpp"

namespace analogon {

/// A scalar variable of an FMU. Value references count parameters, inputs, outputs, states and derivatives through, in
/// the order of the system.
struct FmuVariable {
    enum class Kind { Parameter, Input, Output, State, Derivative };
    Kind kind{};
    std::string name, unit, description;
    unsigned valueReference{};
    std::optional<double> start;           // parameters and inputs
    std::optional<double> min, max;        // parameters, where the start value keeps to them
    double nominal{1};                     // states
    bool isFixed{};                        // parameters: not to be changed after the initialization
    std::optional<std::size_t> stateOf{};  // derivatives: position of the state among the variables
};

/// What an FMU says and holds, before it is written down.
struct FmuModel {
    std::string name;        // of the class
    std::string identifier;  // the same as a C identifier
    std::string study;
    SystemPtr system;
    CCode code;
    std::vector<FmuVariable> variables;
    std::vector<std::size_t> inputs, outputs, states, derivatives;  // positions among the variables, by system order
    bool hasModelExchange{};  // not where the equations need the past of a signal, or the rate of an input
    struct Experiment {
        double start{}, stop{}, step{};
    };
    std::optional<Experiment> experiment;
    double tolerance{1e-6};
};

/// The text of modelDescription.xml (FMI 2.0, section 2.2).
std::string modelDescription(const FmuModel& model, const std::string& guid);

/// A short page for people: what the model is, its inputs, outputs and parameters.
std::string modelDocumentation(const FmuModel& model);

}  // namespace analogon
