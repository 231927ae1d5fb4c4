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
/// "2A" may be a code rather: without a blank between, it is a quantity where the number has decimals or nobody writes
/// codes so ("20mV"), and in a column of quantities.
std::optional<QuantityText> readQuantity(std::string_view text, bool isAmongQuantities = false);

}  // namespace analogon
