#pragma once

#include <filesystem>

#include "core/base/progress.hpp"
#include "core/study/study.hpp"

namespace analogon {

enum class ExportFormat { Fmu, Modelica, Csv, Mf4, Parameters };

struct Exported {
    bool hasModelExchange{};  // of an FMU, beside Co-Simulation
};

/// What lies at the place of the new file: anything, which whoever names the file has agreed to, or an earlier export
/// of the same kind alone, told by what it holds.
enum class Existing { Replaced, OwnAlone };

/// Writes a study's model as it stands into one file for other tools: as an FMU, as Modelica text that stands alone, as
/// its simulated traces beside the measured ones (CSV, ASAM MDF 4), or as its parameters, in the format that the ending
/// of the file's name says. The file is always the old one or the whole new one.
Outcome<Exported> exportStudy(const Study& study, ExportFormat format, const std::filesystem::path& file,
                              const Progress& progress = {}, Existing existing = Existing::Replaced);

}  // namespace analogon
