#pragma once

#include "core/effect/judge/node.hpp"

/// Storage in the place of dead times that are only indicated, or that the data cannot tell from it.
namespace analogon {

class SearchContext;

/// Exchanges each long dead time that is only indicated, or whose class has a lag or a mass, for what stores (a mass, a
/// lag), where the model then predicts nearly as well: storage comes late, too, and a chain of two stores can hardly be
/// told from one and a dead time. True: one was exchanged.
bool storageForDeadTimes(SearchContext& search, Node& node);

}  // namespace analogon
