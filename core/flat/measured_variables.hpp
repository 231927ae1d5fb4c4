#pragma once

namespace analogon {

struct Flattening;

/// Makes outputs of variables that are compared with recordings, and inputs of signals that recordings drive in place
/// of the block that makes them (core/library/measured_signals.hpp). What cannot be one stays as it is.
void takeMeasured(Flattening& work);

}  // namespace analogon
