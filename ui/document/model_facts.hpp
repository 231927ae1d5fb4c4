#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/diagnostic.hpp"
#include "core/study/study.hpp"

namespace analogon::ui {

/// A parameter of the flat model, as the inspector lists it.
struct ParameterFact {
    std::string name;  // "heater.R"
    std::string unit;
    std::string description;
    std::optional<double> value;  // the model's own
    std::optional<double> min, max;
};

struct SignalFact {
    std::string name;
    std::string unit;
    std::string description;

    friend bool operator==(const SignalFact&, const SignalFact&) = default;
};

/// The unit of a signal; empty: it has none, or is not among them.
std::string unitOf(const std::vector<SignalFact>& facts, const std::string& signal);

/// What the lists need to know of a study's model; of one that cannot be flattened what its declarations tell.
struct ModelFacts {
    std::vector<ParameterFact> parameters;
    std::vector<SignalFact> inputs, outputs;
    std::vector<SignalFact> variables;  // every number that changes in time, where it can be simulated
    Diagnostics messages;
};

ModelFacts modelFacts(const Study& study);

}  // namespace analogon::ui
