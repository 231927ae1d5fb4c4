#pragma once

namespace analogon {

/// What study.json says to be.
inline constexpr const char* studyFormat = "analogon-study-1";

}  // namespace analogon
