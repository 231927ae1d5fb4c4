#pragma once

#include <iosfwd>

#include "app/analogon-cli/command_line.hpp"

namespace analogon::cli {

/// Composes a first model from its domains and a measurement, writes it as a study and prints what was assumed.
int generate(const Options& options, std::ostream& out, std::ostream& err);

}  // namespace analogon::cli
