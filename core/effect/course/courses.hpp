#pragma once

#include <optional>

#include "core/effect/course/change.hpp"
#include "core/effect/course/dependence.hpp"

namespace analogon {

/// A parameter that is not constant, and accounts for what is left better than any effect.
struct Courses {
    std::optional<Change> change{};                 // in mid run
    std::optional<ChannelDependence> dependence{};  // on a recorded channel
    bool isSought{};                                // whether both were looked for

    bool areEmpty() const { return !change && !dependence; }
};

}  // namespace analogon
