#pragma once

#include "core/effect/search/path.hpp"
#include "core/effect/search/verdicts.hpp"
#include "core/effect/search/without.hpp"
#include "tests/core/effect/search/warm_search.hpp"

namespace analogon {

/// The end of the path of a body whose sensor lags.
inline Node lagFound(WarmSearch& of) {
    Node path{of.base, {}};
    goOn(of.search, path, of.decided());
    EXPECT_EQ(path.steps.size(), 1u);
    return path;
}

/// A node that has chosen the trial of a kind, whatever the round would have.
inline Node nodeThatChose(WarmSearch& of, const std::string& kind) {
    Round round = tryAll(of.search, of.base);
    for (std::size_t i = 0; i < round.trials.size(); ++i)
        if (round.candidate(i).effect.kind == kind) round.chosen = i;
    Node node{of.base, {}};
    EXPECT_TRUE(round.chosen) << kind << " was not refitted";
    if (!round.chosen) return node;
    node.steps.push_back(stepOf(of.search, of.base, round));
    noteAll(of.search, node, round);
    Outcome<NullModel> with = fitNull(node.steps.front().winner.variant, of.base.noise, NoiseLevel::Estimate,
                                      of.search.fit, of.search.progress);
    EXPECT_TRUE(with);
    if (with) node.null = std::move(*with);
    return node;
}

/// A node of one search with an effect of another node as well.
inline Node together(WarmSearch& of, Node node, const Node& other) {
    std::vector<PlacedEffect> both = node.null.variant.effects;
    both.push_back(other.null.variant.effects.front());
    std::optional<NullModel> with = refittedWith(of.search, node.null, both);
    EXPECT_TRUE(with);
    if (!with) return node;
    node.null = std::move(*with);
    node.steps.push_back(other.steps.front());
    node.steps.back().order = node.steps.front().order + 1;
    return node;
}

}  // namespace analogon
