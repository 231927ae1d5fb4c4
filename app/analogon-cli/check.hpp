#pragma once

#include <iosfwd>

#include "app/analogon-cli/command_line.hpp"

namespace analogon::cli {

/// Parses, flattens and analyses a model file or the model of a study; prints unknowns, states and balance, or
/// one of the stages in full.
int check(const Options& options, std::ostream& out, std::ostream& err);

}  // namespace analogon::cli
