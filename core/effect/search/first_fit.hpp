#pragma once

#include "core/effect/model/null_model.hpp"
#include "core/effect/thresholds.hpp"

/// Where and how the model as given is fitted.
namespace analogon {

class SearchContext;

using threshold::firstFit::otherStarts;

/// Where the model cannot be simulated at its start values, it is fitted from others within the bounds.
FitOptions beginningAnywhere(FitOptions options);

/// To see whether its fit ends at the best optimum, it is fitted again from a few start values near the given ones.
FitOptions beginningNear(FitOptions options);

/// Relative tolerance with which a search integrates: as exactly as the noise of the quietest channel asks for, no more
/// than `asked`.
double toleranceBeside(const NullModel& base, double asked);

/// A fit may end at another optimum than the best, and what it leaves there is no missing effect. True: the model and
/// all that follows begin where start values near the given ones led to less.
bool beginElsewhere(SearchContext& search, NullModel& null);

/// Whether the last fit of a search, on the same samples and in units of the same noise, has come to a far poorer
/// optimum than the search: a model that cannot be integrated as exactly at the search's own is fitted from elsewhere.
bool isAstray(const NullModel& last, const NullModel& own);

}  // namespace analogon
