#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/study/study.hpp"

/// The parameters of a study's model for tools of calibration.
namespace analogon {

struct ParameterRow {
    std::string name, unit, description;
    double value{};
    std::optional<double> min, max;  // as the study has them, else the model
    bool isFitted{};
};

struct ParameterTable {
    std::string className;
    std::vector<ParameterRow> rows;
};

enum class ParameterFormat { Csv, Json, Ssv, Dcm, Cdfx };

/// By the ending of a file's name; empty: by none that is known.
std::optional<ParameterFormat> parameterFormatOf(const std::filesystem::path& file);

/// Those that have a value and may be set: neither final nor protected, nor what has shaped the equations; with the
/// values that study.json holds for them.
Outcome<ParameterTable> parameterTable(const Study& study);

/// Comma-separated values; JSON; a parameter set of SSP 1.0; DCM 2.0 (Latin-1); ASAM CDF 2.0. Each value reads
/// back as the same number.
std::string parameterText(const ParameterTable& table, ParameterFormat format);

/// Whether a text that begins so was written here.
bool isParameterText(const std::string& begin, ParameterFormat format);

}  // namespace analogon
