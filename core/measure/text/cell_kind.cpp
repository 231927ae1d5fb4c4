#include "core/measure/text/cell_kind.hpp"

#include "core/base/unit.hpp"
#include "core/base/usual_unit.hpp"
#include "core/measure/csv_dialect.hpp"
#include "core/measure/text/stamp.hpp"

namespace analogon {

namespace {

bool isPrefix(std::string_view unit) {
    return unit.size() == 1 && std::string_view("munpkMGT").find(unit) != std::string_view::npos;
}

bool isWrittenAsQuantity(std::string_view number, std::string_view behind, std::string_view unit) {
    if (behind.front() == ' ' || behind.starts_with("\xC2\xA0") || unit.front() == '%' || unit.starts_with("\xC2\xB0"))
        return true;
    // a letter that is a prefix as well ("1.5m") may stand for a part of a unit that is not written
    if (!isUsualUnit(unit) || isPrefix(unit)) return false;
    const std::size_t mark = number.find_first_of(".,");
    const bool hasDecimals = mark != std::string_view::npos && mark + 1 < number.size();
    return hasDecimals || unit.size() > 1;
}

}  // namespace

std::optional<QuantityText> readQuantity(std::string_view text, bool isAmongQuantities) {
    text = withoutBlanks(text);
    const std::size_t end = text.find_first_not_of("0123456789.,+-'");
    if (end == 0 || end == std::string_view::npos || text.find_first_of("0123456789") >= end) return std::nullopt;
    std::size_t numberEnd = end;
    if ((text[end] == 'e' || text[end] == 'E') && end + 1 < text.size()) {
        const std::size_t exponent = text.find_first_not_of("0123456789", end + 2);
        if (exponent != std::string_view::npos && exponent > end + 2) numberEnd = exponent;
    }
    const std::string_view number = text.substr(0, numberEnd), behind = text.substr(numberEnd);
    const std::string_view unit = withoutBlanks(behind);
    if (unit.empty() || unit.size() > 20 || !(isAmongQuantities || isWrittenAsQuantity(number, behind, unit)) ||
        !isKnownUnit(unit))
        return std::nullopt;
    if (!isNumeric(number) && !shapeOf(number).isNumber) return std::nullopt;
    return QuantityText{number, unit};
}

CellKind kindOf(std::string_view text) {
    using Kind = CellValue::Kind;
    for (const char decimal : {'.', ','}) {
        const Kind kind = readCell(text, decimal).kind;
        if (kind == Kind::Missing || kind == Kind::Beyond) return CellKind::Blank;
        if (kind != Kind::Text) return CellKind::Number;
    }
    if (shapeOf(text).isNumber) return CellKind::Number;
    if (readStamp(text)) return CellKind::Stamp;
    return readQuantity(text) ? CellKind::Quantity : CellKind::Words;
}

}  // namespace analogon
