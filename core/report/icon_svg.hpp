#pragma once

#include <string>

#include "core/diagram/diagram.hpp"

namespace analogon {

/// "3.5", "-12": with as many digits as a picture shows; what is no number is 0.
std::string svgNumber(double value);

/// "#1763c6"
std::string svgColour(const Colour& colour);

/// The shapes of an icon in its own coordinates (y upward), without its texts, which must not be mirrored with it.
std::string iconShapes(const Icon& icon);

}  // namespace analogon
