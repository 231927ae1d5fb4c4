#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/analogon-cli/command_line.hpp"
#include "core/fit/fit.hpp"

namespace CLI {
class App;
}

/// How what was asked for is written on the command line.
namespace analogon::cli {

const char* name(Command command);

/// The ways to fit, by their names.
const std::map<std::string, FitMethod>& fitMethods();

/// Every command with its options; the callback of the one that was given sets options.command.
void describe(CLI::App& app, Options& options);

/// The words of the command line, the last one first, as App::parse takes them. A word for sbatch behind --slurm, which
/// looks like an option of its own, is taken out. Throws CLI::ValidationError where it cannot be passed on.
std::vector<std::string> argumentsOf(int argc, char** argv, const CLI::App& app, Options& options);

}  // namespace analogon::cli
