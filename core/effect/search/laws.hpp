#pragma once

#include "core/effect/judge/node.hpp"

/// Equations that are written for what a model lacks, of which one joins it as an effect does.
namespace analogon {

class SearchContext;

/// Effects of a model, each term of a law for one.
std::size_t termsIn(const SearchContext& search, const NullModel& null);

/// Adds the law that passes the tests of an effect, where one does.
bool addLaw(SearchContext& search, Node& node);

}  // namespace analogon
