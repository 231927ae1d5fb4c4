#pragma once

#include <memory>
#include <vector>

#include "core/measure/channel.hpp"
#include "core/measure/table.hpp"

/// The channels that an experiment uses, which may have rasters of their own, as one table over the experiment's.
namespace analogon {

/// The stamps of an experiment: all at which one of its outputs was measured, those of one channel, or equal steps.
struct Raster {
    enum class Kind { Outputs, Channel, Steps };
    Kind kind{Kind::Outputs};
    ChannelName channel{};
    double step{};  // [s]

    friend bool operator==(const Raster&, const Raster&) = default;
};

struct InputUse {
    ChannelName channel;
    Interpolation interpolation{Interpolation::Automatic};
};

struct RasterRequest {
    ChannelName time;
    std::vector<ChannelName> outputs;
    std::vector<InputUse> inputs;
    Raster raster{};
};

/// The table of a file with a single raster as it is. Else: the time, in seconds under the name that was asked for, at
/// the stamps of the raster; outputs where they were measured, at others NaN; inputs on straight lines between their
/// samples, or held, where each jump of a held one is a stamp too; all other channels that were read, as inputs are.
/// Where an input is not known (before its first sample, behind its last) the table ends, which a warning tells. A
/// channel that is unknown, or of which there are several, is left out. Faults: a group without a time or with one that
/// falls, gaps of an input that nobody asked to bridge, and channels that have no moment in common.
Outcome<std::shared_ptr<const Table>> onCommonRaster(const std::shared_ptr<const Table>& file,
                                                     const RasterRequest& request);

/// A file of one group whose channels have all been read: its table is that of any experiment.
bool isOnOneRaster(const Table& file);

/// Whether an input is held between its samples: as was asked for, or as its file says.
bool isHeld(const Column& column, Interpolation asked);

}  // namespace analogon
