#pragma once

#include <optional>
#include <vector>

#include "core/effect/model/evidence.hpp"
#include "core/effect/reading/start_value.hpp"

/// Recordings that begin elsewhere than the model.
namespace analogon {

class SearchContext;

/// Whether so many start values can be tried.
bool canTry(const std::vector<ToldStart>& starts);

/// Whether a state begins elsewhere than it was told to, by its fit; nothing: it was not fitted.
bool isElsewhere(const ToldStart& start, const FitEstimate* fitted);

/// Start values of records that begin elsewhere than the model, and what they explain.
struct Begun {
    std::vector<ToldStart> starts;
    Acceptance gain;
    std::vector<ParameterValue> values;  // of all that is fitted
    double sumOfSquares{};               // that is left
};

/// Where a record begins that does not begin where the model does: all its states at once, of which those stay that
/// are told apart from where the model begins.
std::optional<Begun> findBeginning(const SearchContext& search, const NullModel& null, Against against,
                                   double threshold);

/// Start values are fitted in all that the search fits from here on.
void freeStarts(SearchContext& search, const std::vector<ToldStart>& starts);

bool refitWith(SearchContext& search, NullModel& null, const std::vector<ToldStart>& starts,
               std::vector<ParameterValue> values);

/// Holds those start values again that explain nothing that counts.
void holdUnneededStarts(SearchContext& search, NullModel& null);

/// Recordings that only validate were often cut out of longer ones: where they begin elsewhere than the model, the
/// states they begin with are estimated from them, beside whatever model. A search that was stopped tells its errors
/// so, too.
void freeChecks(SearchContext& search, const NullModel& null);

}  // namespace analogon
