#pragma once

#include <iosfwd>

#include "app/analogon-cli/command_line.hpp"

namespace analogon::cli {

/// simulate --class: a class of a library by itself, as its annotation `experiment` says; leaves traces.csv. Returns
/// the exit status.
int simulateClass(const Options& options, std::ostream& out, std::ostream& err);

}  // namespace analogon::cli
