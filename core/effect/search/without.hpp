#pragma once

#include <optional>
#include <vector>

#include "core/effect/judge/node.hpp"

/// A model refitted with other effects, beside the same noise.
namespace analogon {

class SearchContext;

/// The model with these effects instead, refitted beside the same noise.
std::optional<NullModel> refittedWith(const SearchContext& search, const NullModel& null,
                                      const std::vector<PlacedEffect>& effects);

/// Looks for a better optimum of a model from where the model as given (`given`, on the same samples) begins: beside
/// effects that are gone, or were not there yet, the parameters may have come to a valley that no descent leads out of.
void seekFromTheStart(const SearchContext& search, const Variant& given, NullModel& model);

/// The model refitted with one effect taken out. A whole number that another holds may only have been right beside it.
std::optional<NullModel> without(const SearchContext& search, const NullModel& null, std::size_t effect);

/// The same on all samples, of a model that was fitted to them; no more exact than the noise asks for.
std::optional<NullModel> withoutOnAll(const SearchContext& search, const NullModel& last, std::size_t effect);

/// Takes an effect out of the model of the search; false where the rest cannot be fitted.
bool takeOut(SearchContext& search, Node& node, std::size_t effect, const Text& why);

/// Evidence that a model with so many parameters more, which leaves so much, gains over another.
double gainOver(const NullModel& null, double sumOfSquares, int more);

}  // namespace analogon
