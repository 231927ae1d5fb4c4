#pragma once

#include <string>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/base/progress.hpp"
#include "core/measure/mat/mat_channels.hpp"
#include "core/measure/mat/mat_values.hpp"

/// Level 7.3 is HDF5, whose library follows damaged lengths and pointers: it reads in a process of its own.
namespace analogon::mat {

/// Faults: as findChannels, and where the file brings the library down.
Outcome<Channels> findChannelsApart(const std::string& file);

/// As readPlaces.
Outcome<std::vector<ChannelValues>> readPlacesApart(const std::string& file, const std::vector<VariablePlace>& places,
                                                    const Progress& progress);

}  // namespace analogon::mat
