#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/effect/judge/disturbance.hpp"
#include "core/effect/search/proposals.hpp"
#include "core/effect/tell/added_effects.hpp"

/// The end of a search, told.
namespace analogon {

class SearchContext;

/// What a search came to, before it is told.
struct Ending {
    Finding finding;                           // with the models as given and at the end
    Node node;                                 // the effects, fitted as they are reported
    NullModel base;                            // the model as given, as the search works with it
    Conclusion conclusion{};                   // its proposals are offered
    HeldValues held{};                         // values that would explain as much as an effect
    std::vector<HeldInstead> heldWrongly{};    // values that are the better account
    LikelySource source{};                     // where what is left is likeliest to come from; empty: not asked
    std::optional<NullModel> beforeReading{};  // the same model beside inputs without their noise
};

/// The finding: effects, what is left, what is proposed, and what an engineer should know before trusting any of it.
Finding tellEnding(SearchContext& search, Ending ending);

}  // namespace analogon
