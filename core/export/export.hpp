#pragma once

#include <filesystem>

#include "core/base/progress.hpp"
#include "core/study/study.hpp"

namespace analogon {

enum class ExportFormat { Fmu, Modelica, Csv };

struct Exported {
    bool hasModelExchange{};  // of an FMU, beside Co-Simulation
};

/// Writes a study's model as it stands into one file for other tools: as an FMU, as Modelica text that stands alone, or
/// as its simulated traces beside the measured ones. The file is always the old one or the whole new one.
Outcome<Exported> exportStudy(const Study& study, ExportFormat format, const std::filesystem::path& file,
                              const Progress& progress = {});

}  // namespace analogon
