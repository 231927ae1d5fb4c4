#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/effect/model/null_model.hpp"

namespace analogon {

/// Columns whose numbers are in another unit than the recording says.
struct MistakenUnit {
    std::vector<int> recordings;  // of the task
    std::vector<std::string> columns;
    std::vector<std::string> channels;  // of the model, that are read from them
    std::string unit, likely;
    std::vector<std::string> asLikely;  // less common units that leave as little: parameters make up for the factor
    NullModel read;                     // the model as it stands, fitted to the numbers in the likely unit

    /// Whether it is what one of these recordings says of a channel.
    bool concerns(const ChannelUnit& given) const;
};

/// The unit with which the model as it stands leaves next to nothing of all that it leaves without; nothing where its
/// residual is noise or no other common unit of the same kind does. Units that differ by a factor alone can be told
/// where the parameters cannot make up for it: by their bounds, by what is held, by another channel; else the commoner
/// is told first. Two fits at most, each from the start values of the study (`given`); which, is told by a tangent at
/// these.
std::optional<MistakenUnit> mistakenUnit(const NullModel& null, const Variant& given, const FitOptions& options,
                                         const Progress& progress);

/// "T_amb ('T_exhaust')": a channel and its column; in which recording, where that is one of several.
Text channelWords(const EstimationTask& task, const MistakenUnit& mistake);

/// The task with the numbers of these columns read so; the start values that are taken from them, too.
EstimationTask readAsLikely(EstimationTask task, const MistakenUnit& mistake);

}  // namespace analogon
