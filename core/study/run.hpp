#pragma once

#include <filesystem>
#include <functional>

#include "core/effect/search/discover.hpp"
#include "core/study/study.hpp"

/// The whole order, from a study on disk to results on disk: READ THIS FIRST.
namespace analogon {

/// What a command leaves behind.
struct RunResult {
    Finding finding;                  // simulate and fit fill `baseline` alone (and `final` with the same)
    Study completed;                  // the study with fitted values and effects wired in
    std::optional<Study> proposed{};  // the same with the equations that are proposed; empty: none can be added
};

struct RunOptions {
    DiscoverOptions discover;  // its `fit` serves simulate and fit as well
    std::vector<std::filesystem::path> libraryPaths;
    std::vector<std::string> profiled;  // parameters of which a fit gives the profile; "all": every one
    /// Takes what a run has found until now, whenever that is more than before.
    std::function<void(RunResult)> keep{};
};

/// Whether all traces are written, or no long ones: they take longer to write than all else together, and nobody who
/// has interrupted a run waits for them.
enum class Traces { All, Short };
bool leavesTracesOut(const Finding& finding, Traces traces = Traces::All);

/// What a run works on. Once its scope is asked to stop (core/base/stop) it ends with "cancelled".
Outcome<EstimationTask> taskOf(const Study& study, const RunOptions& options);

Outcome<RunResult> runSimulate(const Study& study, const RunOptions& options, const Progress& progress = {});
Outcome<RunResult> runFit(const Study& study, const RunOptions& options, const Progress& progress = {});
Outcome<RunResult> runDiscover(const Study& study, const RunOptions& options, const Progress& progress = {});

/// Blocks that were written for what the library has no name for; empty: none.
std::string proposedBlocks(const Finding& finding);

/// report.json, report.html, traces.csv and study/ under a directory, and where equations are proposed their blocks in
/// proposed.mo and the study with them in study-proposed/; the rules are those of ResultsPlace.
Outcome<Done> writeResults(const RunResult& result, const std::string& command, const std::filesystem::path& directory);

}  // namespace analogon
