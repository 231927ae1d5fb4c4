#pragma once

#include <string>
#include <vector>

#include "core/base/diagnostic.hpp"
#include "core/study/study.hpp"

/// A recording with a fault of its own need not keep the others from being worked on.
namespace analogon {

/// A recording that cannot be used, and why.
struct FaultyRecording {
    std::size_t index{};  // among the experiments of the study
    std::string name;
    Diagnostics why;  // faults, and what was remarked beside them
};

/// The recordings that estimationTask cannot take, in their order; empty as well where the model itself is at fault.
std::vector<FaultyRecording> faultyRecordings(const Study& study);

struct SoundPart {
    Study study;  // without the recordings that are left out
    std::vector<FaultyRecording> leftOut;
    Diagnostics remarks;  // which were left out and why, as warnings
};

/// The study without its faulty recordings. All of it, and nothing left out, where every recording is sound, where none
/// is, or where all that were to be fitted have a fault.
SoundPart soundPart(const Study& study);

/// A study that came of the sound part of `whole`, with what had been left out at its place again.
Study withLeftOut(Study completed, const Study& whole, const std::vector<FaultyRecording>& leftOut);

}  // namespace analogon
