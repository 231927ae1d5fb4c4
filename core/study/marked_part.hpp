#pragma once

#include <set>
#include <string>

#include "core/study/run.hpp"
#include "core/study/study.hpp"

/// A run on some recordings of a study alone, which leaves the study as it is.
namespace analogon {

/// The study in which only these of its recordings are used. A recording that the study itself does not use stays out.
Study markedPart(const Study& study, const std::set<std::string>& recordings);

/// What a run on the marked part came to, for the whole study: each recording is used in its studies as it was before,
/// and its warnings begin with what it looked at.
RunResult forWhole(RunResult result, const Study& whole, const Study& part);

}  // namespace analogon
