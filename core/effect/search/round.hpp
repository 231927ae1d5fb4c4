#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "core/effect/block/trial.hpp"

/// One round of the search: what was tried beside one model, and what is chosen of it.
namespace analogon {

class SearchContext;

/// Trials of a round that are not chosen, and why.
struct RefusedTrials {
    std::set<std::size_t> failsHeldOut;
    std::vector<std::size_t> tooFaint;  // that fail no test but by the little evidence
    std::map<std::size_t, Text> why;
    Text behind;  // what the trials that no test refused came second to
};

/// What was tried beside one model, and what was decided.
struct Round {
    std::vector<Screened> screened;
    std::vector<Trial> trials;  // best first
    double threshold{};
    std::optional<std::size_t> chosen;  // of the trials
    std::vector<std::size_t> members;   // of its class
    RefusedTrials refused;
    LeastPromise least;  // of a trial
    Acceptance acceptance;

    const Candidate& candidate(std::size_t trial) const { return trials[trial].screened.candidate; }
    /// Takes a trial, with what the data do not tell from it.
    void choose(const NullModel& null, std::size_t trial, const Acceptance& tests);
    /// Sets the choice aside.
    void passOver(const Text& why);
};

/// The trials of an equation at all places where it, or a law with as many terms, explains as much, `best` the best of
/// them. What has no name is not known so exactly that a small part of what it explains would tell two places apart.
/// First is that where most parts of the model meet: whatever it stands for may be in any of them.
std::vector<std::size_t> equalPlaces(const SearchContext& search, const NullModel& null,
                                     const std::vector<Trial>& trials, std::size_t best);

/// The class of a trial: it, and what the data do not tell from it.
std::vector<std::size_t> equivalents(const NullModel& null, const std::vector<Trial>& trials, std::size_t best);

/// What a trial beside this model has to promise: beside noise what would tell it apart; beside noise with a memory, or
/// structure, the evidence that a round asks for (`threshold`), which a score that is all explained has to exceed.
LeastPromise leastPromise(const NullModel& null, double threshold);

/// Screens every candidate and refits those that promise most.
Round tryAll(SearchContext& search, const NullModel& null);

/// The best that passes its tests; what lies close to it is its class, of which the simplest is taken.
void decide(const SearchContext& search, const NullModel& null, Round& round);

}  // namespace analogon
