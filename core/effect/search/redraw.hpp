#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/effect/reading/readings.hpp"
#include "core/effect/search/recordings.hpp"

/// Inputs that are stamped late, or jump between two samples.
namespace analogon {

class SearchContext;

/// Inputs at their true times.
struct Late {
    std::vector<InputClock> clocks;
    Variant variant;
    Allowed with;
};
/// Inputs as they run between their samples.
struct Redrawn {
    std::vector<InputEdge> edges;
    Variant variant;
    Allowed with;
};
using Drawings = std::array<std::optional<Redrawn>, 2>;  // by whether all jumps are alike

/// The inputs earlier than they are stamped, where that explains more than so much. Jumps that were placed stay.
std::optional<Late> findClocks(const SearchContext& search, const NullModel& null, double threshold, double most);

/// The model beside inputs at their true times; so in all that is fitted from here on.
bool refitLate(SearchContext& search, NullModel& null, Late late);

/// Takes the columns as they are stamped where, beside the effects found since, being late explains nothing that
/// counts.
void holdUnneededClocks(SearchContext& search, NullModel& null);

/// Beside an equation that only stands for something the jumps would mend it.
bool canPlaceEdges(const SearchContext& search, const NullModel& null);

/// Each way to draw the inputs beside the parameters as they are: the jumps alone, all alike, and all one by one.
Drawings drawings(const SearchContext& search, const NullModel& null, double threshold);

/// Draws the inputs as they run between their samples, where that explains more than so much. `first`: see drawings().
bool placeEdges(SearchContext& search, NullModel& null, Drawings first, double threshold, double most);

/// A dead time or a lag of an input that is shorter than a sample may be no more than how the input runs between its
/// samples: the search then begins anew beside that.
bool takesEdgesForDelays(SearchContext& search, const NullModel& null);

}  // namespace analogon
