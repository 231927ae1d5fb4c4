#pragma once

#include <optional>
#include <string_view>

namespace analogon {

/// What a cell holds. Blank: nothing, or a word that says that nothing was measured.
enum class CellKind { Blank, Number, Quantity, Stamp, Words };

CellKind kindOf(std::string_view text);

/// "812.5 rpm": a number with its unit in one cell.
struct QuantityText {
    std::string_view number, unit;
};
std::optional<QuantityText> readQuantity(std::string_view text);

}  // namespace analogon
