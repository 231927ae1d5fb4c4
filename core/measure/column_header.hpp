#pragma once

#include <string>
#include <string_view>

namespace analogon {

/// What the head of a column says.
struct ColumnHeader {
    std::string name;
    std::string unit;  // empty: none given
};

/// `T [degC]`; and, where the unit is one that is known here, `T (degC)`, `T in degC`, `T / degC`, `T °C`.
ColumnHeader readColumnHeader(std::string_view text);

/// `[degC]`, `(degC)` or `degC` as it stands in a units row.
std::string readUnitCell(std::string_view text);

/// The unit by which a name ends: "motor_speed_rad_s" in rad/s, "heater1_pct" in %, "i_mA", "oil degC"; empty: none of
/// those that names end with.
std::string unitAtEnd(std::string_view name);

}  // namespace analogon
