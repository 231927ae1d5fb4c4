#pragma once

#include "core/eval/system_builder.hpp"

namespace analogon {

/// Which operation of which equation has no value at a point, and at which values: "sqrt(h - h0) is the root of -0.1
/// (h = 0.6, h0 = 0.7), in the equation A*der(h) = q - a*sqrt(h - h0) (model.mo, line 11)". `values`: registers of the
/// observation, NaN where it did not get to. Empty: every operation has a value where its operands have one.
Text senselessOperation(const SystemPrograms& programs, const Observation& observation, double time,
                        const LineVector& values);

}  // namespace analogon
