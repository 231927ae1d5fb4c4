#pragma once

#include <optional>
#include <vector>

#include "core/effect/block/trial.hpp"
#include "core/effect/catalogue/finding.hpp"

/// Where a search is: a model with the effects that were added to it, and the account of how it came there.
namespace analogon {

/// One choice of the search: the trial that was taken, the tests that it passed, and what came near it.
struct Step {
    Trial winner;
    Acceptance acceptance;
    std::size_t tried{1};                   // candidates from which it was chosen
    std::vector<Alternative> alternatives;  // deltaBic: by how much they are worse than the chosen one
    std::vector<Candidate> rivals;          // what else explained a good part of the same
    Text equation;                          // without a name, that explained as much at its place; empty: none did
    int order{};                            // of all choices
    double chi2Decrease{};                  // that it alone is missed for, in the sum of squares
    double errorWithout{-1};                // [%] of the fitted data when this effect alone is left out; -1: not known
    /// What it is indicated by; empty: it is established.
    std::optional<Prediction> prediction{};
};

/// A named effect that was not needed any more beside a proposed equation.
struct Displaced {
    PlacedEffect effect;
    Step step;
};

/// Effects added one after the other, the model they lead to, and how each candidate fared on the way. To go back is
/// to go on from another node.
struct Node {
    NullModel null;
    std::vector<Step> steps;  // one for each effect of the model, in its order
    std::vector<Displaced> displaced{};
    std::vector<CandidateResult> candidates{};
    std::optional<ModelState> state{};  // where it is known
    bool meetsAnother{};                // it came to effects from which another has gone on already
};

}  // namespace analogon
