#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <string>

#include "core/base/progress.hpp"
#include "core/study/study.hpp"

namespace analogon {

/// A Functional Mock-up Unit (FMI 2.0) before it is zipped.
struct Fmu {
    std::string modelIdentifier;
    bool hasModelExchange{};                   // beside Co-Simulation
    std::map<std::string, std::string> files;  // by path in the archive
};

/// The study's model with its present values: modelDescription.xml, C sources and a page of documentation. Parameters
/// with a value of their own are tunable; those that are exactly 0 and not fitted are part of the equations, as in a
/// simulation. The first experiment tells how it starts: its inputs, and start values that it has for itself. Faults:
/// those of reading the model, or of its first experiment.
Outcome<Fmu> fmuOf(const Study& study);

/// Writes the FMU with a binary for this platform, made by the C compiler on PATH. Without one, or on a platform for
/// which there is no name in FMI 2.0, it holds sources only, and a note says so; so it does where the compiler takes
/// longer than that, and is ended.
Outcome<Done> writeFmu(const Fmu& fmu, const std::filesystem::path& file,
                       std::chrono::seconds compilerLimit = std::chrono::seconds(120), const Progress& progress = {});

}  // namespace analogon
