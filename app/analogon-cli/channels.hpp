#pragma once

#include <iosfwd>

#include "app/analogon-cli/command_line.hpp"

namespace analogon::cli {

/// What a measurement file holds, as a table or as JSON; with values, what they are in few numbers.
int channels(const Options& options, std::ostream& out, std::ostream& err);

}  // namespace analogon::cli
