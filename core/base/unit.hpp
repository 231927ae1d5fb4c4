#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/outcome.hpp"

namespace analogon {

/// target = factor * source + offset
struct UnitConversion {
    double factor{1};
    double offset{0};

    double operator()(double x) const { return factor * x + offset; }
};

/// Converts values from one unit to another (UDUNITS-2 behind a table of the field's aliases: degC, °C, rpm,
/// 1/min, %, Ohm, N.m, Nm, km/h, W/(m2.K), l/min …). Modelica unit strings are accepted on both sides.
/// An empty unit converts to itself alone; "1" is dimensionless. The message of a fault names both units;
/// it has no place (the caller knows where the unit stood).
Outcome<UnitConversion> convertUnit(std::string_view from, std::string_view to);

/// Whether the text names a unit that is known here.
bool isKnownUnit(std::string_view unit);

/// The known unit that a text which is none may stand for: "kPa" for "kpa", "degC" for "Deg.C"; empty: nobody can tell.
std::string unitAlike(std::string_view unit);

/// Whether a text that is no unit begins with one in which numbers of the other unit are measured ("kPa gauge" and Pa):
/// it was meant as a unit.
bool beginsWithUnitOf(std::string_view text, std::string_view other);

/// Whether both measure the same quantity (convertible).
bool areConvertible(std::string_view a, std::string_view b);

/// What stands behind a number: " K"; nothing without a unit and where it is 1.
inline std::string behindNumber(const std::string& unit) { return unit.empty() || unit == "1" ? "" : " " + unit; }

/// Powers of m, kg, s, A, K, mol and cd in a unit; an angle counts as 1. Empty: a unit that is not known.
using Dimension = std::array<double, 7>;
std::optional<Dimension> dimensionOf(std::string_view unit);
/// "kg.m2/s2"; "1" for none.
std::string text(const Dimension& dimension);

}  // namespace analogon
