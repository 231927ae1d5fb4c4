#include "core/effect/search/experiments.hpp"

#include <algorithm>

#include "core/effect/search/context.hpp"
#include "core/effect/search/trials.hpp"
#include "core/effect/search/without.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::experiments;

namespace {

constexpr int mostExperiments = 2;  // that are proposed

}  // namespace

Text whatItTells(const ProposedExperiment& next, const Text& names) {
    constexpr double most = 100;
    if (next.separation * next.separation < clearSeparation)
        return phrase(
            "no programme of the inputs within their range tells {} with these sensors (at most {:.1f} standard "
            "deviations): another quantity has to be measured",
            names, next.separation);
    if (next.separation > most)
        return phrase("{}, the other inputs at their means, would tell {} by more than {:.0f} standard deviations",
                      next.programme, names, most);
    return phrase("{}, the other inputs at their means, would tell {} by {:.0f} standard deviations", next.programme,
                  names, next.separation);
}

Text proposeExperiments(SearchContext& search, const Node& node) {
    Text text;
    int count = 0;
    for (std::size_t i = 0; i < node.steps.size() && count < mostExperiments && !search.progress.stopRequested(); ++i) {
        const PlacedEffect& own = node.null.variant.effects[i];
        const auto open = std::find_if(
            node.steps[i].alternatives.begin(), node.steps[i].alternatives.end(), [&](const Alternative& a) {
                return a.equivalent && !stands(node.null.variant, a.kind, a.at) && !a.kind.starts_with("proposal.");
            });
        if (open == node.steps[i].alternatives.end()) continue;
        const Text names = phrase("{} at {} from {} at {}", own.effect.kind, own.place.at, open->kind, open->at);
        search.say("next experiment", names, -1);
        const std::optional<NullModel> rest = without(search, node.null, i);
        if (!rest) continue;
        const auto other =
            std::find_if(node.steps[i].rivals.begin(), node.steps[i].rivals.end(),
                         [&](const Candidate& c) { return c.effect.kind == open->kind && c.place.at == open->at; });
        if (other == node.steps[i].rivals.end()) continue;
        const Screened screened = screen(*rest, *other, search.fit.simulation, search.progress);
        const std::vector<Trial> rival = tryThese(search, *rest, {&screened}, 2 * trialIterations, startsPerTrial);
        if (!rival.front().ok) continue;
        const std::optional<ProposedExperiment> next =
            nextExperiment(node.null, rival.front(), search.fit.simulation, search.progress);
        if (!next) continue;
        search.journal.add("next experiment", keyOf(own.effect, own.place), {{"separation", next->separation}}, "told",
                           next->programme);
        ++count;
        if (!text.empty()) text += ". ";
        text += whatItTells(*next, names);
    }
    return text;
}

}  // namespace analogon
