#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/study/run.hpp"

/// The runs of a study on disk: a folder beside study.json that readers of the study itself pass over. Each run is one
/// JSON file ("run-0001.json", the oldest first) with what it ran on, what it came to, and the names of its traces;
/// traces are files of little-endian doubles named by what they hold, so that recordings and times that many runs
/// share are there once.
namespace analogon {

inline constexpr const char* historyFolder = "run-history";
inline constexpr const char* traceEnding = ".f64";

/// A run as it was.
struct PastRun {
    std::string command;  // "simulate", "fit" or "discover"
    std::string ended;    // local time, "2026-03-01T14:02:11"
    double seconds{};
    std::shared_ptr<const Study> ranOn;
    std::shared_ptr<const RunResult> result;
    std::shared_ptr<const ModelState> before{};  // of a fit: the model with its start values; null: not known
    std::string name{}, note{};                  // given by the user
    bool isPinned{};                             // kept whatever follows, before all that are not
    bool isShown{};                              // the one whose result was before the user
    std::string plots{};  // the member "plots" of study.json as it was arranged with this run; empty: none
};

struct HistoryLimits {
    std::size_t runs{40};                 // that are not pinned
    std::uint64_t traceBytes{16u << 20};  // of all traces together
    std::size_t pinned{60};               // runs beside the others
};

/// Writes the pinned and the last of the other runs into a directory that does not exist yet. The one that is shown
/// keeps its traces first, then pinned ones, then the latest; a run whose traces have no room any more is kept with its
/// figures and values alone.
Outcome<Done> writeHistory(const std::vector<PastRun>& runs, const std::filesystem::path& directory,
                           const HistoryLimits& limits = {});

/// What can be read of a history, oldest first; what cannot is left out, with a warning. Measurements are those of the
/// study the history belongs to.
Outcome<std::vector<PastRun>> readHistory(const std::filesystem::path& directory, const Study& study);

/// Puts a history in the place of the one a study's directory has; files there that are of no history stay.
Outcome<Done> replaceHistory(const std::vector<PastRun>& runs, const std::filesystem::path& studyDirectory);

/// Whether the traces of a run were kept.
bool hasTraces(const RunResult& result);

}  // namespace analogon
