#pragma once

#include <filesystem>

#include "core/base/outcome.hpp"
#include "core/effect/judge/decision_trace.hpp"

namespace analogon {

/// A decision as one JSON object, without the line end; `number`: of all decisions. Figures have six significant
/// digits, what is not known is left out.
std::string decisionLine(const Decision& decision, std::size_t number);

/// All decisions, one a line. The file is whole, or what it was before.
Outcome<Done> writeDecisions(const std::vector<Decision>& decisions, const std::filesystem::path& file);

}  // namespace analogon
