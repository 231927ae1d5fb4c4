#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/library/library.hpp"

namespace analogon {

/// What recordings hold of a class beside its declared inputs and outputs.
struct MeasuredSignals {
    std::string className;
    std::vector<std::string> compared;  // variables of it: "inertia2.w"
    std::vector<std::string> driven;    // what it is driven by: "step1.y"
};

/// The library with that known of one of its classes. flatten() heeds it, also where the text of the class is varied.
Outcome<Library> withMeasured(const Library& library, const MeasuredSignals& signals);

/// What is known of a class; empty where nothing is.
MeasuredSignals measuredOf(const Library& library, std::string_view className);

}  // namespace analogon
