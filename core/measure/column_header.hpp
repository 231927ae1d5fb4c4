#pragma once

#include <string>
#include <string_view>

namespace analogon {

/// What the head of a column says.
struct ColumnHeader {
    std::string name;
    std::string unit;  // empty: none given
};

/// `T [degC]`; and, where the unit is one that is known here, `T (degC)`, `T in degC`, `T / degC`.
ColumnHeader readColumnHeader(std::string_view text);

/// `[degC]`, `(degC)` or `degC` as it stands in a units row.
std::string readUnitCell(std::string_view text);

}  // namespace analogon
