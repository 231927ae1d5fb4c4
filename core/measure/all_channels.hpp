#pragma once

#include <memory>
#include <set>
#include <string>

#include "core/base/outcome.hpp"
#include "core/measure/table.hpp"

/// What a file holds, whichever of it an experiment uses.
namespace analogon {

/// All channels of the groups that were recorded for as long as the longest one, on the stamps of all, to look at what
/// they are. The table of a file with a single raster as it is.
Outcome<std::shared_ptr<const Table>> allOnOneRaster(const std::shared_ptr<const Table>& file);

/// The names and units of those channels alone, without values; not of the stamps.
Table namesOfAll(const Table& file);

/// The channels of these names with the stamps of their groups; groups of which none is named are left out.
Table onlyChannels(const Table& file, const std::set<std::string>& names);

}  // namespace analogon
