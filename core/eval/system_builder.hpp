#pragma once

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/eval/lowering.hpp"
#include "core/eval/machine.hpp"
#include "core/eval/system.hpp"

namespace analogon {

/// Where a result is read.
struct ResultRegister {
    std::uint32_t place{};
    std::array<std::uint8_t, 2> active{};  // has tangents, by TangentMode
};

/// All programs of a system with what surrounds them. Registers are ordered: constants and what the prelude
/// computes, t, x, u (shared by all programs), then those of the program that runs.
struct SystemPrograms {
    Structure structure;
    InputLayout layout;
    std::vector<SignalInfo> states, inputs, outputs, parameters, tapSignals;
    std::vector<DelayInfo> delays;

    ProgramTables tables;
    Program prelude, initial, derivative, output, root;
    std::vector<std::pair<std::uint32_t, double>> preloads;
    std::uint32_t firstParameter{}, firstState{}, firstSlot{}, timeRegister{};
    std::uint32_t registerCount{}, guessCount{};
    std::vector<ResultRegister> initialStates, stateDerivatives, outputResults, tapResults, rootRegisters, delayTimes;
    bool isLinearTimeInvariant{};

    std::unique_ptr<Lowering> lowering;  // goes on when observation is asked for
};

/// A program that computes every unknown of the model.
struct Observation {
    Program program;
    ProgramTables tables;
    std::uint32_t guessCount{};
    std::unordered_map<std::string, int> handleOf;
    std::vector<std::uint32_t> results;  // by handle
};

Diagnostics buildPrograms(const Structure& structure, SystemPrograms& out);
Observation buildObservation(const SystemPrograms& programs);
std::string print(const SystemPrograms& programs);

}  // namespace analogon
