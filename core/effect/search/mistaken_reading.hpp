#pragma once

#include "core/effect/catalogue/finding.hpp"
#include "core/effect/reading/mistaken_unit.hpp"
#include "core/effect/reading/mistaken_wiring.hpp"

namespace analogon {

class SearchContext;

/// What is found where numbers are in another unit than the recordings say: whatever an effect would explain beside
/// them is that.
Finding besideMistake(const SearchContext& search, Finding finding, const NullModel& null, const MistakenUnit& mistake);

/// The same where channels are exchanged or of the wrong sign, in one of these ways.
Finding besideMistake(const SearchContext& search, Finding finding, const NullModel& null,
                      const std::vector<MistakenWiring>& alike);

}  // namespace analogon
