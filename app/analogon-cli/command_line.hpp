#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace analogon::cli {

/// The exit statuses of the program.
enum ExitStatus { done = 0, inputAtFault = 2, numericsFailed = 3, interrupted = 130 };

enum class Command {
    Check,
    Simulate,
    Fit,
    Discover,
    Export,
    Generate,
    Channels,
    Pack,
    Unpack,
    Campaign,
    CampaignWorker,
    CampaignTask,
};
enum class PrintKind { None, Flat, Structure, Program };
enum class ProgressKind { Automatic, Bar, Json, None };

/// What was asked for on the command line.
struct Options {
    Command command{Command::Check};
    std::filesystem::path input;  // study or model
    std::filesystem::path out;
    PrintKind print{PrintKind::None};
    std::string className;  // check: of a model file with several classes; simulate: of a library
    std::optional<double> stop, interval, tolerance;  // simulate --class
    std::vector<std::string> variables;               // simulate --class: patterns; empty: all
    ProgressKind progress{ProgressKind::Automatic};
    std::vector<std::filesystem::path> libraries;
    int threads{0};                       // 0: as many as the machine has
    std::string method{"least-squares"};  // or one without slopes
    std::vector<std::string> profiled;    // fit: parameters, or "all"
    std::vector<std::string> kinds;       // of effects; empty: all
    double mostWork{};                    // discover: millions of steps; 0: no limit
    double patience{1};                   // discover: of what a search may simulate; 0: no limit
    std::filesystem::path traceFile;      // discover: receives its decisions
    std::vector<std::string> domains;     // generate
    std::filesystem::path fmuFile, modelicaFile, csvFile, mf4File, parameterFile;  // export
    bool asJson{}, withValues{};                                                   // channels
    int jobs{0};                                                                   // campaign; 0: all processors
    bool retry{};                                                                  // campaign: failed units, too
    bool slurm{};                                                                  // campaign: on the cluster
    std::vector<std::string> sbatch;                                               // campaign --slurm: for sbatch
    std::size_t task{};                                                            // campaign-task
    std::vector<std::filesystem::path> data;  // generate: one, or several of which the last validates
};

/// The whole program: reads the arguments, does the work, returns the exit status.
int run(int argc, char** argv);

}  // namespace analogon::cli
