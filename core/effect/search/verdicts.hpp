#pragma once

#include <optional>

#include "core/effect/judge/node.hpp"
#include "core/effect/search/round.hpp"

/// What becomes of each candidate, as the report tells it.
namespace analogon {

class SearchContext;

/// The step that the round has decided on, with what came near it.
Step stepOf(SearchContext& search, const NullModel& null, const Round& round);

/// The round's line for every candidate of the table.
void noteAll(SearchContext& search, Node& node, const Round& round);

/// Of the last line of the table that is of this candidate; what is taken out was chosen there.
void setVerdict(const SearchContext& search, Node& node, const Candidate& candidate, Verdict verdict, const Text& why);

void setVerdict(const SearchContext& search, Node& node, const PlacedEffect& placed, Verdict verdict, const Text& why);

/// What was chosen on the way and is not in the end is no choice, nor are its equals.
void settleVerdicts(const Finding& finding, std::vector<CandidateResult>& candidates);

}  // namespace analogon
