#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/study/study.hpp"

namespace analogon {

/// The study with more places to look for libraries in; those that are told relative are of the working directory.
Study withLibraries(Study study, const std::vector<std::filesystem::path>& paths);

/// The name, with a number behind it where an experiment of the study has it already: "run", "run 2", …
std::string freeExperimentName(const Study& study, const std::string& wanted);

}  // namespace analogon
