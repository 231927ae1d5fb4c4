#pragma once

#include <functional>
#include <vector>

#include "core/effect/block/trial.hpp"
#include "core/effect/thresholds.hpp"

/// Candidates screened beside a model, and those that promise most refitted: what the blocks family proposes.
namespace analogon {

class SearchContext;

using threshold::rounds::rivalShare;
using threshold::rounds::startsPerTrial;

/// Every effect at every place, of what the options ask for.
Outcome<std::vector<Candidate>> candidatesIn(const SearchContext& search, const Variant& variant);

/// All of them beside a model; an equation that is the twin of a name of the wrong sign is refused with it.
std::vector<Screened> screenAll(const SearchContext& search, const NullModel& null);

/// Lean: without the slopes of their fits, which are many and of which few are asked for.
enum class TrialSize { Whole, Lean };
/// Refits candidates, each from its best start and, where that may change what is chosen, from further ones. Counts as
/// work of the search; in the order of `chosen`.
std::vector<Trial> tryThese(SearchContext& search, const NullModel& null, const std::vector<const Screened*>& chosen,
                            int iterations, int starts, TrialSize size = TrialSize::Whole);

/// The fit of a trial with its slopes: one that was kept lean is simulated once more. Nothing: it cannot be.
std::optional<FitResult> withSlopes(const SearchContext& search, const NullModel& null, const Trial& trial);

/// The tests that a trial must pass; one that was kept lean is simulated once more.
Acceptance examine(const SearchContext& search, const NullModel& null, const Trial& trial, double threshold);

/// Goes on with the fit of a trial that has not converged, by one `step` after the other, as long as each still tells
/// more, and so many times at most.
void continueFit(Trial& trial, const std::function<void(Trial&)>& step);

/// Takes the trials that a short fit brought to the front further.
void continueBest(const SearchContext& search, const NullModel& null, std::vector<Trial>& trials);

/// What does nearly as well as the best may only have been fitted from farther away, and what promises as much but ends
/// worse than it began has lost its way: it begins once more where the best has led the other parameters (`values`),
/// which left so much.
void retryNear(SearchContext& search, const NullModel& null, const std::vector<ParameterValue>& values,
               double sumOfSquares, std::vector<Trial>& trials);

/// Refits the candidates that promise most by either score; where the residual is large against the noise, all that
/// promise enough (`least`). Ranked.
std::vector<Trial> tryBest(SearchContext& search, const NullModel& null, const std::vector<Screened>& screened,
                           const LeastPromise& least);

}  // namespace analogon
