#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/base/progress.hpp"

/// A file of ASAM MDF 4.10: groups of channels of 64-bit floats over a time each, sorted.
namespace analogon {

struct Mf4Channel {
    std::string name, unit, comment;
    std::vector<double> values;  // NaN: not measured
};

struct Mf4Group {
    std::string name, comment;
    std::vector<Mf4Channel> channels;  // the first one is the time [s]; all of one length
};

/// The file says that Analogon wrote it and gives no moment at which it was recorded, so that the same groups make the
/// same file.
Outcome<Done> writeMf4(const std::vector<Mf4Group>& groups, const std::string& comment,
                       const std::filesystem::path& file, const Progress& progress = {});

/// How such a file begins.
std::string mf4Begin();

}  // namespace analogon
