#pragma once

#include <string>
#include <vector>

namespace analogon {

/// What recordings hold of a class beside its declared inputs and outputs.
struct MeasuredSignals {
    std::string className;
    std::vector<std::string> compared;  // variables of it: "inertia2.w"
    std::vector<std::string> driven;    // what it is driven by: "step1.y"
};

}  // namespace analogon
