#include "core/study/study_with.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace analogon {

Study withLibraries(Study study, const std::vector<std::filesystem::path>& paths) {
    for (const std::filesystem::path& p : paths) study.libraryPaths.push_back(std::filesystem::absolute(p).string());
    return study;
}

std::string freeExperimentName(const Study& study, const std::string& wanted) {
    const auto isTaken = [&](const std::string& name) {
        return std::any_of(study.experiments.begin(), study.experiments.end(),
                           [&](const StudyExperiment& e) { return e.name == name; });
    };
    std::string name = wanted;
    for (int i = 2; isTaken(name); ++i) name = fmt::format("{} {}", wanted, i);
    return name;
}

}  // namespace analogon
