#include "core/effect/search/laws.hpp"

#include <algorithm>
#include <map>
#include <memory>

#include "core/base/parallel.hpp"
#include "core/effect/block/law.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/round.hpp"
#include "core/effect/search/trials.hpp"

namespace analogon {
namespace {

/// Fits the likeliest laws of what the model lacks; their classes join the libraries.
std::vector<Trial> tryLaws(SearchContext& search, NullModel& null) {
    search.say("propose", phrase("a law for what is left"), -1);
    const std::vector<Law> laws = likelyLaws(null, static_cast<int>(search.laws.size()), search.fit.simulation,
                                             search.options.threads, search.progress);
    for (const Law& law : laws) {
        const std::string& name = law.candidate.effect.className;
        const auto source = std::make_shared<Source>(name + ".mo", law.text);
        for (Library* library :
             {&null.variant.task.library, &search.readings.searched.task.library, &search.readings.full.task.library}) {
            Outcome<Library> wider = library->withSource(source);
            if (!wider) return {};
            *library = std::move(*wider);
        }
        search.laws[name] = law.text;
    }
    std::vector<Screened> screened(laws.size());
    parallelFor(static_cast<int>(laws.size()), search.options.threads, [&](int k) {
        const auto i = static_cast<std::size_t>(k);
        screened[i] = screen(null, laws[i].candidate, search.fit.simulation, search.progress);
    });
    std::vector<const Screened*> chosen;
    for (const Screened& s : screened)
        if (s.failure.empty()) chosen.push_back(&s);
    return tryThese(search, null, chosen, 2 * trialIterations, startsPerTrial);
}

}  // namespace

std::size_t termsIn(const SearchContext& search, const NullModel& null) {
    std::size_t terms = 0;
    for (const PlacedEffect& e : null.variant.effects)
        terms += search.laws.contains(e.effect.className) ? e.freed.size() : 1;
    return terms;
}

bool addLaw(SearchContext& search, Node& node) {
    const Stay here = stayAt(search, node.null, node.null.sumOfSquares());
    if (std::any_of(search.frontier.stays.lawless.begin(), search.frontier.stays.lawless.end(),
                    [&](const Stay& s) { return s.isLike(here); }))
        return false;
    std::vector<Trial> trials = tryLaws(search, node.null);
    rank(node.null, trials);
    search.journal.trials("law", node.null, trials);
    std::map<std::size_t, Acceptance> examined;
    const auto accepted = [&](std::size_t i) {
        if (!trials[i].ok) return false;
        if (!examined.contains(i)) examined.emplace(i, examine(search, node.null, trials[i], 2 * equivalenceMargin));
        return examined.at(i).accepted();
    };
    for (std::size_t best = 0; best < trials.size() && !search.progress.stopRequested(); ++best) {
        if (!accepted(best)) continue;
        std::vector<std::size_t> places = equalPlaces(search, node.null, trials, best);
        std::erase_if(places, [&](std::size_t i) { return !accepted(i); });
        Trial& trial = trials[places.front()];
        Outcome<NullModel> next =
            fitNull(trial.variant, node.null.noise, NoiseLevel::Keep, search.fit, search.progress);
        if (!next) continue;
        Step step;
        step.order = ++search.journal.choices;
        step.acceptance = examined.at(places.front());
        step.tried = trials.size();
        for (const std::size_t i : places) {
            const Candidate& other = trials[i].screened.candidate;
            if (other.place.at != trial.screened.candidate.place.at)
                step.alternatives.push_back(
                    {other.effect.kind, other.place.at, trial.evidence - trials[i].evidence, true});
        }
        step.winner = std::move(trial);
        const Candidate& law = step.winner.screened.candidate;
        search.journal.test("law", keyOf(law.effect, law.place), step.acceptance, "chosen", law.effect.proposal);
        node.steps.push_back(std::move(step));
        node.null = std::move(*next);
        return true;
    }
    search.journal.model("law", node.null, "none passes");
    if (!search.progress.stopRequested()) search.frontier.stays.lawless.push_back(here);
    return false;
}

}  // namespace analogon
