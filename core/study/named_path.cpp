#include "core/study/named_path.hpp"

#include <fmt/format.h>

#include "core/study/pending_save.hpp"
#include "core/study/report_settings.hpp"

namespace analogon {

namespace fs = std::filesystem;

std::vector<NamedPath> namedPaths(const Study& study) {
    std::vector<NamedPath> paths;
    for (std::size_t i = 0; i < study.experiments.size(); ++i) {
        const StudyExperiment& e = study.experiments[i];
        paths.push_back({NamedPath::Key::Measurement, e.file, e.name, fmt::format("/experiments/{}/file", i)});
    }
    for (std::size_t i = 0; i < study.libraryPaths.size(); ++i)
        paths.push_back({NamedPath::Key::Library, study.libraryPaths[i], {}, fmt::format("/library/{}", i)});
    if (const std::string logo = reportHeadOf(study.extraJson).logo; !logo.empty())
        paths.push_back({NamedPath::Key::Logo, logo, {}, "/report/logo"});
    return paths;
}

bool staysWithin(const fs::path& directory, const fs::path& path) {
    if (path.empty() || leavesDirectory(path)) return false;
    std::error_code code;
    const fs::path around = fs::weakly_canonical(directory, code);
    const fs::path place = code ? fs::path() : fs::weakly_canonical(around / path, code);
    return !code && !leavesDirectory(place.lexically_relative(around));
}

}  // namespace analogon
