#pragma once

#include <iosfwd>

#include "app/analogon-cli/command_line.hpp"

namespace analogon::cli {

/// pack: a study directory as one .analogon file. unpack: the way back, byte for byte.
int pack(const Options& options, std::ostream& out, std::ostream& err);
int unpack(const Options& options, std::ostream& out, std::ostream& err);

/// export: the model as stand-alone Modelica, its simulated and measured traces as CSV.
int exportStudy(const Options& options, std::ostream& out, std::ostream& err);

}  // namespace analogon::cli
