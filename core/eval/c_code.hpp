#pragma once

#include <string>
#include <vector>

namespace analogon {

struct SystemPrograms;

/// What a result is computed from, by position in the system. Delayed values count for nothing: they are known
/// beforehand.
struct DependsOn {
    std::vector<int> parameters, states, inputs;
};

/// The programs of a system as C99: sizes (STATES, INPUTS, SLOTS, …), a struct `Equations` that holds everything one
/// evaluation needs, and the functions setParameters, initialise, derivatives, outputs, roots and delayTimes on it,
/// with the meaning they have in System. Blocks and look-up tables are solved and interpolated as the interpreter does.
struct CCode {
    std::string text;
    std::vector<DependsOn> derivatives, outputs;  // by state, by output
    std::vector<DependsOn> initialStates;
    std::vector<DependsOn> delayTimes;
};

CCode cCode(const SystemPrograms& programs);

}  // namespace analogon
