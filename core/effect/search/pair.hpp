#pragma once

#include <optional>
#include <vector>

#include "core/effect/judge/node.hpp"
#include "core/effect/search/round.hpp"
#include "core/effect/thresholds.hpp"

/// Two effects that hide each other: neither need show alone, and the strongest alone need not be one of them.
namespace analogon {

class SearchContext;

using threshold::pairs::mostForPairs;

/// A lag of one signal and a dead time of another look much like the dead time of the one and the lag of the other, and
/// no exchange of one alone leads from there to here: the newest effect is tried the other way round with each before
/// it.
void crossOver(SearchContext& search, Node& node);

/// Of the candidates of a round those by names that are worth pairing, best first.
std::vector<const Screened*> worthPairing(const std::vector<Screened>& screened);

/// The same round with trials of those that explain most together with another: the best alone may have left them no
/// place among what was tried.
Round withPairMembers(SearchContext& search, const NullModel& null, Round round);

/// Where one effect leaves another, what is left has a long memory: few of its samples are independent, and neither of
/// the two may show by itself, however much it explains. With one of them for granted another is sought; both are
/// chosen where they pass the tests together, and each is missed beside the other. The choice beside the round's own;
/// nothing: there are no two. `node`: the path of which it is a round.
std::optional<Round> chosenTogether(SearchContext& search, const Node& node, Round& round);

/// The members of the pairs that explain most together, each pair by the one that explains more alone; at most `most`,
/// none of `taken`.
std::vector<std::size_t> pairBeginnings(const NullModel& null, const Round& round, std::size_t most,
                                        const std::vector<Candidate>& taken);

}  // namespace analogon
