#pragma once

#include <vector>

#include "core/effect/model/variant.hpp"

namespace analogon {

/// Takes the values that were found elsewhere for those of its own parameters that are named there.
inline void takeValues(std::vector<ParameterValue>& own, const std::vector<ParameterValue>& found) {
    for (ParameterValue& value : own)
        for (const ParameterValue& other : found)
            if (other.name == value.name && other.experiment == value.experiment) value.value = other.value;
}

}  // namespace analogon
