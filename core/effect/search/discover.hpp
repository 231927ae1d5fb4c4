#pragma once

#include <functional>
#include <memory>

#include "core/base/progress.hpp"
#include "core/effect/catalogue/finding.hpp"
#include "core/effect/judge/decision_trace.hpp"

namespace analogon {

struct DiscoverOptions {
    FitOptions fit;
    int maxRounds{4};
    int refitted{6};                    // candidates of a round that are refitted
    int threads{0};                     // 0: as many as the machine has
    std::vector<std::string> kinds;     // empty: all
    std::vector<EffectChoice> choices;  // of all places of these kinds; empty: all
    double mostWork{};  // in steps of its trials, after which a search ends as if it was stopped; 0: no limit
    /// Ends a search that simulates this many times as much as one is allowed (threshold::paths::mostOfAFit), with what
    /// it has, in the same way; 0: no limit.
    double patience{};
    std::shared_ptr<DecisionTrace> trace{};  // receives every decision; null: nobody asks
    /// Takes what is found until now, whenever that is more than before: what there is to tell of a search that is
    /// ended without a word. Called from the thread that searches.
    std::function<void(Finding)> keep{};
};

/// Fits the model as it stands.
Outcome<ModelState> fitModel(const EstimationTask& task, const FitOptions& options, const Progress& progress = {});

/// The model as it stands, no fit.
Outcome<ModelState> simulateModel(const EstimationTask& task, const SimulationOptions& options,
                                  const Progress& progress = {});

/// The closed loop: fit, find what is left, add the effect that explains it, refit, until what is left is noise.
/// Validation recordings are simulated for the report and used for nothing else.
Outcome<Finding> discover(const EstimationTask& task, const DiscoverOptions& options = {},
                          const Progress& progress = {});

}  // namespace analogon
