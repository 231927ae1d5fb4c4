#pragma once

#include <string>
#include <vector>

#include "core/effect/model/null_model.hpp"

namespace analogon {

/// Channels that do not hold what the recording says: two that are exchanged, or one of the other sign.
struct MistakenWiring {
    std::vector<int> recordings;        // of the task
    std::vector<std::string> channels;  // of the model: two are exchanged, one alone is of the other sign
    NullModel read;                     // the model as it stands, fitted to the recordings as they are meant

    bool isOfSign() const { return channels.size() == 1; }
};

/// The wirings with which the model as it stands leaves next to nothing of all that it leaves without; of several that
/// the data do not tell apart, each (a motor that turns the other way is driven or measured so). Empty where its
/// residual is noise, or no one of them does. Exchanged are channels of one unit that were measured at the same
/// samples: in all recordings, or, where several are fitted, in one alone. Two fits at most, each from the start values
/// of the study (`given`).
std::vector<MistakenWiring> mistakenWirings(const NullModel& null, const Variant& given, const FitOptions& options,
                                            const Progress& progress);

/// "T_in ('TC1') and T_out ('TC2') seem to be exchanged": in which recording, where that is one of several.
Text wiringWords(const EstimationTask& task, const MistakenWiring& mistake);

/// The task with these channels as they are meant; the start values that are taken from their columns, too.
EstimationTask readAsMeant(EstimationTask task, const MistakenWiring& mistake);

}  // namespace analogon
