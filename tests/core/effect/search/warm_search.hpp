#pragma once

#include "core/effect/search/context.hpp"
#include "core/effect/search/round.hpp"
#include "core/effect/search/verdicts.hpp"
#include "tests/core/effect/lagging_body.hpp"

namespace analogon {

/// A search among a few faults of sensors, with the model as given fitted.
class WarmSearch {
public:
    explicit WarmSearch(const EstimationTask& task, DiscoverOptions options = {}) : search(task, options, progress_) {
        Outcome<std::vector<EffectClass>> all = effectCatalogue(task.library);
        EXPECT_TRUE(all) << format(all.diagnostics());
        for (EffectClass& e : *all)
            if (e.kind == "sensor.lag" || e.kind == "sensor.offset" || e.kind == "sensor.delay")
                search.catalogue.push_back(std::move(e));
        Outcome<NullModel> fitted =
            fitNull(search.readings.searched, {}, NoiseLevel::Estimate, search.fit, search.progress);
        EXPECT_TRUE(fitted) << format(fitted.diagnostics());
        if (fitted) base = std::move(*fitted);
    }

    Round decided() {
        Round round = tryAll(search, base);
        decide(search, base, round);
        return round;
    }
    static std::string kindOf(const Round& round) {
        return round.chosen ? round.candidate(*round.chosen).effect.kind : "";
    }

private:
    Progress progress_;

public:
    SearchContext search;
    NullModel base;
};

/// What was tried beside the model as given.
struct TriedOnce {
    explicit TriedOnce(const EstimationTask& task) : of(task), round(tryAll(of.search, of.base)) {}

    std::size_t trialOf(const std::string& kind) const {
        for (std::size_t i = 0; i < round.trials.size(); ++i)
            if (round.candidate(i).effect.kind == kind) return i;
        ADD_FAILURE() << "no trial of " << kind;
        return 0;
    }

    WarmSearch of;
    Round round;
};

/// The model with an effect of this kind, refitted.
inline Node nodeWith(WarmSearch& of, const std::string& kind) {
    Node node{of.base, {}};
    Round round = tryAll(of.search, of.base);
    for (std::size_t i = 0; i < round.trials.size() && !round.chosen; ++i)
        if (round.candidate(i).effect.kind == kind && round.trials[i].ok) round.chosen = i;
    if (!round.chosen) {
        ADD_FAILURE() << "no " << kind << " was tried";
        return node;
    }
    node.steps.push_back(stepOf(of.search, of.base, round));
    Outcome<NullModel> next =
        fitNull(node.steps.back().winner.variant, of.base.noise, NoiseLevel::Keep, of.search.fit, of.search.progress);
    EXPECT_TRUE(next) << format(next.diagnostics());
    if (next) node.null = std::move(*next);
    return node;
}

}  // namespace analogon
