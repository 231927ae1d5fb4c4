#include "core/measure/column_header.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/base/unit.hpp"
#include "core/measure/csv_dialect.hpp"

namespace analogon {

namespace {

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

/// A number in brackets is an index, not a unit.
bool isUnit(std::string_view text) { return !isNumeric(text) && isKnownUnit(trimmed(text)); }

ColumnHeader make(std::string_view name, std::string_view unit) {
    return {std::string(trimmed(name)), std::string(trimmed(unit))};
}

/// "Temp, °C" and "Temp, °C (heater)", where the letter alone is a unit of the bench.
std::optional<ColumnHeader> behindComma(std::string_view text) {
    const std::size_t comma = text.find(", ");
    if (comma == std::string_view::npos || comma == 0) return std::nullopt;
    const std::string_view behind = text.substr(comma + 2);
    const std::size_t bracket = std::min(behind.find(" ("), behind.size());
    const std::string_view unit = trimmed(behind.substr(0, bracket));
    const bool isLetter = unit.size() == 1;
    if (isLetter && std::string_view("sVAWKNmJC%").find(unit.front()) == std::string_view::npos) return std::nullopt;
    if (unit.empty() || unit.find(',') != std::string_view::npos || !isUnit(unit)) return std::nullopt;
    return make(std::string(text.substr(0, comma)) + std::string(behind.substr(bracket)), unit);
}

}  // namespace

namespace {

/// "l/min": an amount by a time, and not a symbol by its unit ("T/K").
bool isRate(std::string_view unit) {
    constexpr std::string_view amounts = " l L ml m mm cm km m3 m^3 g kg mg rad deg rev U 1 \u00B0 \u00B0C m\u00B3 ";
    constexpr std::array<std::string_view, 4> times{"min", "s", "h", "sec"};
    const std::size_t slash = unit.find('/');
    return slash != std::string_view::npos &&
           amounts.find(' ' + std::string(unit.substr(0, slash)) + ' ') != std::string_view::npos &&
           std::find(times.begin(), times.end(), unit.substr(slash + 1)) != times.end();
}

/// "Flow l/min", "Temp °C": behind the last blank, a rate or a unit that begins with a sign that no word has.
std::optional<ColumnHeader> behindBlank(std::string_view text) {
    const std::size_t blank = text.find_last_of(" \t");
    if (blank == std::string_view::npos || blank == 0) return std::nullopt;
    const std::string_view unit = text.substr(blank + 1);
    const bool hasSign = unit == "%" || unit.starts_with("\xC2\xB0") || unit.starts_with("\xC2\xB5") ||
                         unit.ends_with("\xCE\xA9") || unit.ends_with("\xE2\x84\xA6");
    return (hasSign || isRate(unit)) && isUnit(unit) ? std::optional(make(text.substr(0, blank), unit)) : std::nullopt;
}

}  // namespace

ColumnHeader readColumnHeader(std::string_view text) {
    text = trimmed(text);
    if (text.ends_with(']')) {
        const std::size_t open = text.rfind('[');
        if (open != std::string_view::npos && open > 0)
            return make(text.substr(0, open), text.substr(open + 1, text.size() - open - 2));
    }
    for (const auto& [opening, closing] : {std::pair{'{', '}'}, {'<', '>'}})
        if (const std::size_t open = text.rfind(opening);
            text.ends_with(closing) && open != std::string_view::npos && open > 0)
            if (const std::string_view unit = text.substr(open + 1, text.size() - open - 2); isUnit(unit))
                return make(text.substr(0, open), unit);
    if (text.ends_with(')')) {
        // The outermost pair, so that W/(m2.K) in brackets stays whole.
        int depth = 0;
        for (std::size_t i = text.size(); i-- > 1;) {
            if (text[i] == ')') ++depth;
            if (text[i] == '(' && --depth == 0) {
                const std::string_view unit = text.substr(i + 1, text.size() - i - 2);
                const bool isQuotient = i > 1 && text[i - 1] == '/';  // "n/(1/min)"
                if (isUnit(unit)) return make(text.substr(0, isQuotient ? i - 1 : i), unit);
                break;
            }
        }
    }
    if (text.starts_with("in ") && isUnit(text.substr(3))) return make({}, text.substr(3));  // of a time, no name
    if (const std::size_t word = text.rfind(" in "); word != std::string_view::npos && word > 0)
        if (isUnit(text.substr(word + 4))) return make(text.substr(0, word), text.substr(word + 4));
    if (const std::size_t slash = text.find(" / "); slash != std::string_view::npos && slash > 0)
        if (isUnit(text.substr(slash + 3))) return make(text.substr(0, slash), text.substr(slash + 3));
    if (const auto header = behindBlank(text)) return *header;
    // "T/degC", but not a name that is itself a unit, as "m/s".
    if (const std::size_t slash = text.find('/'); slash != std::string_view::npos && slash > 0 && !isKnownUnit(text))
        if (isUnit(text.substr(slash + 1))) return make(text.substr(0, slash), text.substr(slash + 1));
    return behindComma(text).value_or(make(text, {}));
}

std::string unitAtEnd(std::string_view name) {
    const std::size_t last = name.find_last_of("_ ");
    if (last == std::string_view::npos || last == 0) return {};
    const std::string_view tail = name.substr(last + 1);
    const std::size_t before = name.rfind('_', last - 1);
    if (before != std::string_view::npos) {
        const std::string ratio = std::string(name.substr(before + 1, last - before - 1)) + '/' + std::string(tail);
        if (isKnownUnit(ratio)) return ratio;
    }
    if (tail == "pct" || tail == "percent") return "%";
    if (tail == "C") return "degC";
    constexpr std::array<std::string_view, 27> usual{"s",  "ms", "us",   "min", "V",   "mV",   "kV",  "A",  "mA",
                                                     "uA", "K",  "degC", "rpm", "rad", "deg",  "Nm",  "W",  "kW",
                                                     "mW", "Pa", "kPa",  "hPa", "bar", "mbar", "Ohm", "mm", "Hz"};
    return std::find(usual.begin(), usual.end(), tail) == usual.end() ? std::string() : std::string(tail);
}

std::string readUnitCell(std::string_view text) {
    text = trimmed(text);
    const bool bracketed = text.size() >= 2 &&
                           ((text.front() == '[' && text.back() == ']') || (text.front() == '(' && text.back() == ')'));
    return std::string(bracketed ? trimmed(text.substr(1, text.size() - 2)) : text);
}

}  // namespace analogon
