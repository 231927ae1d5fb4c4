#pragma once

#include <string>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/measure/mat/mat_check.hpp"
#include "core/measure/mat/mat_values.hpp"
#include "core/measure/recording.hpp"

namespace analogon::mat {

/// The channels of a file, and where each has its values.
struct Channels {
    std::vector<RecordedGroup> groups{};
    std::vector<Text> notes{};
    std::vector<std::vector<VariablePlace>> places{};  // by group and channel
};

/// Vectors, columns of matrices, structures with a time of their own, Simulink's structure with time; `opaque` is told
/// and left out. Faults: the file cannot be opened, or holds no channel.
Outcome<Channels> findChannels(const std::string& file, const std::vector<OpaqueVariable>& opaque);

}  // namespace analogon::mat
