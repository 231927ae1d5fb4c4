#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/text.hpp"

namespace analogon {

struct DefaultBounds {
    double min{}, max{};
};

/// Within which a quantity is searched that nobody has bounded, from the range of its declaration and its value: one
/// that is declared not to be negative over three decades on either side of it, then on a logarithmic scale and never
/// at 0, where a model may have no solution. None: any other.
std::optional<DefaultBounds> defaultBounds(std::optional<double> least, std::optional<double> most, double value);

/// That these parameters were given such bounds; and whether a text says so.
Text defaultBoundsRemark(std::vector<std::string> names);
bool isDefaultBoundsRemark(const Text& text);

}  // namespace analogon
