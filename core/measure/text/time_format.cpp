#include "core/measure/text/time_format.hpp"

#include <algorithm>

#include "core/base/unit.hpp"
#include "core/measure/csv_dialect.hpp"

namespace analogon {

std::optional<double> intervalOf(std::string_view timeFormat) {
    const std::string_view text = withoutBlanks(timeFormat);
    const std::size_t end = std::min(text.find(' '), text.size());
    const CellValue value = readCell(text.substr(0, end), '.');
    if (value.kind != CellValue::Kind::Number || !(value.value > 0)) return std::nullopt;
    const std::string unit(withoutBlanks(text.substr(end)));
    if (unit.empty()) return value.value;
    if (const auto seconds = convertUnit(unit, "s")) return (*seconds)(value.value);
    if (const auto hertz = convertUnit(unit, "Hz")) return 1 / (*hertz)(value.value);
    return std::nullopt;
}

std::optional<std::string> timeUnitOf(std::string_view timeFormat) {
    const std::string unit(withoutBlanks(timeFormat));
    const bool isUnit = !unit.empty() && areConvertible(unit, "s") && unit != "1";
    return isUnit ? std::optional(unit) : std::nullopt;
}

bool isStampFormat(std::string_view timeFormat) {
    return !timeFormat.empty() && !intervalOf(timeFormat) && !timeUnitOf(timeFormat);
}

std::optional<Stamp> readStampBy(std::string_view text, const std::string& timeFormat) {
    if (!isStampFormat(timeFormat)) return readStamp(text);
    if (std::optional<Stamp> whole = readStamp(text, timeFormat)) return whole;
    const std::size_t blank = timeFormat.find_first_of(" T");
    if (blank == std::string::npos) return std::nullopt;
    if (std::optional<Stamp> first = readStamp(text, timeFormat.substr(0, blank))) return first;
    return readStamp(text, timeFormat.substr(blank + 1));
}

bool isOfTimeFormat(std::string_view text, const std::string& timeFormat) {
    return isStampFormat(timeFormat) && readStampBy(text, timeFormat).has_value();
}

}  // namespace analogon
