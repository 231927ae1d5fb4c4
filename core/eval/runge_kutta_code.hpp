#pragma once

#include <vector>

#include "core/eval/program_emitter.hpp"

namespace analogon {

/// Where a step of length h finds what it reads, at its begin, middle and end.
struct StepPoints {
    VectorCode::Entity full{}, half{}, third{}, sixth{};  // h, h/2, h/3, h/6
    VectorCode::Entity time[3]{};
    std::vector<VectorCode::Entity> slots[3];  // u
    ProgramEmitter::Known known[3];            // registers of the derivative program that need no computing
};

/// x + h/6 (k1 + 2 k2 + 2 k3 + k4) with tangents (Kutta 1901), from and to the registers of the states.
void emitRungeKutta(const SystemPrograms& programs, ProgramEmitter& emitter, const StepPoints& points);

}  // namespace analogon
