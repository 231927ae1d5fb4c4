#include "core/measure/csv_dialect.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace analogon {

namespace {

bool isBlank(char c) { return c == ' ' || c == '\t'; }

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

constexpr std::array<std::string_view, 3> marksOfUnicode{"\xC2\xA0", "\xE2\x80\xAF",
                                                         "\xE2\x80\x89"};  // fixed, narrow, thin blank

/// A number without what only types it: a sign in front, blanks behind the sign, a long minus, an exponent of Fortran.
std::string plainNumber(std::string_view text) {
    std::string plain(text);
    for (const std::string_view blank : marksOfUnicode)
        for (std::size_t at; (at = plain.find(blank)) != std::string::npos;) plain.replace(at, blank.size(), " ");
    if (plain.starts_with("\xE2\x88\x92")) plain.replace(0, 3, "-");
    if (plain.starts_with('+') || plain.starts_with('-')) {
        const std::size_t digit = std::min(plain.find_first_not_of(" \t", 1), plain.size());
        plain.erase(1, digit - 1);
        if (plain.front() == '+') plain.erase(0, 1);
    }
    const std::size_t letter = plain.find_first_of("dD");
    if (letter != std::string::npos && letter > 0 && letter + 1 < plain.size() &&
        plain.find_first_not_of("0123456789.,+- dD'") == std::string::npos)
        plain[letter] = 'e';
    return plain;
}

/// Where a number's digits in front of its decimals and exponent end.
std::size_t endOfWhole(std::string_view plain, char decimal) {
    return std::min(plain.find_first_of(std::string{decimal, 'e', 'E'}), plain.size());
}

/// Groups of three digits behind one of one to three.
bool isGrouped(std::string_view whole, char mark) {
    if (whole.starts_with('-')) whole.remove_prefix(1);
    const std::size_t first = whole.find(mark);
    if (first == std::string_view::npos) return true;
    if (first == 0 || first > 3 || (whole.size() - first) % 4 != 0) return false;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        const bool isMark = i >= first && (i - first) % 4 == 0;
        if (isMark ? whole[i] != mark : !(whole[i] >= '0' && whole[i] <= '9')) return false;
    }
    return true;
}

/// False where the marks do not stand between thousands.
bool dropThousands(std::string& plain, char mark, char decimal) {
    const std::size_t end = endOfWhole(plain, decimal);
    const std::string_view whole = std::string_view(plain).substr(0, end);
    if (!isGrouped(whole, mark)) return false;
    plain.erase(std::remove(plain.begin(), plain.begin() + static_cast<std::ptrdiff_t>(end), mark),
                plain.begin() + static_cast<std::ptrdiff_t>(end));
    return true;
}

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// "-----" stands for no value, "*****" and ">>>>>" for one that has no room or no range.
bool isRowOf(std::string_view word, std::string_view marks, std::size_t fewest) {
    return word.size() >= fewest && marks.find(word.front()) != std::string_view::npos &&
           word.find_first_not_of(word.front()) == std::string_view::npos;
}

/// A cell that holds no digits that could be its value.
CellValue readWord(std::string_view text) {
    using Kind = CellValue::Kind;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::string word = inLowerCase(text);
    if (word.find('#') != std::string::npos) std::replace(word.begin(), word.end(), ',', '.');
    if (isOneOf(word, {"nan",   "-nan",    "na",      "n/a",      "#n/a",    "#nv",     "null",     "none",
                       "-",     "--",      "1.#qnan", "-1.#qnan", "1.#ind",  "-1.#ind", "nan(ind)", "-nan(ind)",
                       "n.a.",  "k.a.",    "no data", "nodata",   "invalid", "#div/0!", "#value!",  "#wert!",
                       "#ref!", "#bezug!", "#num!",   "#zahl!",   "burnout"}) ||
        isRowOf(word, "-", 3))
        return {Kind::Missing, nan};
    if (isOneOf(word, {"inf", "infinity", "1.#inf", "+inf"})) return {Kind::Infinite, infinity};
    if (isOneOf(word, {"-inf", "-infinity", "-1.#inf"})) return {Kind::Infinite, -infinity};
    if (isOneOf(word, {"ol",
                       "+ol",
                       "-ol",
                       "o.l",
                       "o.l.",
                       "ovl",
                       "ovld",
                       "ovf",
                       "ofl",
                       "+ofl",
                       "-ofl",
                       "over",
                       "+over",
                       "-over",
                       "under",
                       "+under",
                       "-under",
                       "overload",
                       "overflow",
                       "underflow",
                       "overrange",
                       "underrange",
                       "over range",
                       "under range",
                       "+overflow",
                       "-overflow",
                       "+overload",
                       "-overload",
                       "out of range",
                       "\xE2\x88\x9E",
                       "+\xE2\x88\x9E",
                       "-\xE2\x88\x9E",
                       "\xE2\x88\x92\xE2\x88\x9E"}) ||
        isRowOf(word, "*><", 3) || isRowOf(word, "#+", 4))
        return {Kind::Beyond, nan};
    return {};
}

}  // namespace

CsvRow splitCsvRow(std::string_view line, char separator) {
    CsvRow row;
    std::size_t i = 0;
    const bool byBlanks = separator == ' ';
    const auto isEdge = [&](char c) { return c == ' ' || (c == '\t' && separator != '\t'); };
    while (true) {
        while (i < line.size() && isEdge(line[i])) ++i;
        if (byBlanks && i >= line.size()) break;
        CsvCell cell;
        cell.position = static_cast<int>(i) + 1;
        if (i < line.size() && line[i] == '"') {
            cell.isQuoted = true;
            for (++i;; ++i) {
                if (i >= line.size()) {
                    row.openQuote = cell.position;
                    break;
                }
                if (line[i] == '"') {
                    if (i + 1 >= line.size() || line[i + 1] != '"') break;
                    ++i;  // a doubled quote stands for one
                }
                cell.text.push_back(line[i]);
            }
            if (i < line.size()) ++i;
        }
        const std::size_t begin = i;
        while (i < line.size() && line[i] != separator && !(byBlanks && isBlank(line[i]))) ++i;
        cell.text += line.substr(begin, i - begin);
        cell.text = std::string(trimmed(cell.text));
        row.cells.push_back(std::move(cell));
        if (i >= line.size()) break;
        ++i;
    }
    return row;
}

namespace {

/// The usual number: digits, one decimal mark, an exponent. Empty: it takes a closer look.
std::optional<double> readUsual(std::string_view text, char decimal) {
    std::array<char, 40> plain;
    if (text.starts_with('+')) text.remove_prefix(1);
    if (text.empty() || text.size() > plain.size()) return std::nullopt;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (decimal == ',' && c == '.') return std::nullopt;
        plain[i] = c == decimal ? '.' : c;
    }
    double value = 0;
    const char* const end = plain.data() + text.size();
    const auto [stop, code] = std::from_chars(plain.data(), end, value);
    if (stop != end || code != std::errc{} || !std::isfinite(value)) return std::nullopt;
    return value;
}

}  // namespace

CellValue readCell(std::string_view text, char decimal, char thousands) {
    using Kind = CellValue::Kind;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    text = withoutBlanks(text);
    if (text.empty()) return {Kind::Missing, nan};
    if (const std::optional<double> value = readUsual(text, decimal)) return {Kind::Number, *value};

    std::string plain = plainNumber(text);
    if (thousands != 0 && !dropThousands(plain, thousands, decimal)) return readWord(text);
    if (decimal == ',') {
        // The point is no mark of this file: "0.5" here is a mistake, not a number.
        if (plain.find('.') != std::string::npos) return readWord(text);
        std::replace(plain.begin(), plain.end(), ',', '.');
    }
    const char* const end = plain.data() + plain.size();
    double value = 0;
    const auto [stop, code] = std::from_chars(plain.data(), end, value);
    if (stop == end && code == std::errc{} && std::isfinite(value)) return {Kind::Number, value};
    if (stop == end && code == std::errc::result_out_of_range) {
        const std::size_t exponent = plain.find_first_of("eE");
        const bool isTiny = exponent != std::string::npos && plain.find('-', exponent) != std::string::npos;
        if (isTiny) return {Kind::Number, 0};
        return {Kind::Infinite, plain.front() == '-' ? -infinity : infinity};
    }
    return readWord(text);
}

bool isNumeric(std::string_view text) {
    return readCell(text, '.').kind != CellValue::Kind::Text || readCell(text, ',').kind != CellValue::Kind::Text;
}

std::string_view withoutBlanks(std::string_view text) {
    for (bool isDone = false; !isDone;) {
        isDone = true;
        text = trimmed(text);
        for (const std::string_view blank : marksOfUnicode) {
            if (text.starts_with(blank)) text.remove_prefix(blank.size()), isDone = false;
            if (text.ends_with(blank)) text.remove_suffix(blank.size()), isDone = false;
        }
    }
    return text;
}

std::string inLowerCase(std::string_view text) {
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return out;
}

NumberShape shapeOf(std::string_view text) {
    using Mark = NumberShape::Mark;
    text = withoutBlanks(text);
    std::string plain = plainNumber(text);
    for (std::size_t at; (at = plain.find("\xE2\x80\x99")) != std::string::npos;) plain.replace(at, 3, "'");
    std::string_view digits = plain;
    if (digits.starts_with('-')) digits.remove_prefix(1);
    const std::string_view mantissa = digits.substr(0, std::min(digits.find_first_of("eE"), digits.size()));
    if (mantissa.empty() || mantissa.find_first_not_of("0123456789., '") != std::string_view::npos ||
        mantissa.find_first_of("0123456789") == std::string_view::npos)
        return {};
    const bool hasExponent = mantissa.size() < digits.size();
    const auto count = [&](char c) { return std::count(mantissa.begin(), mantissa.end(), c); };
    NumberShape shape;
    for (const char mark : {' ', '\''})
        if (count(mark) > 0) shape.thousands = mark;
    const std::size_t last = mantissa.find_last_of(".,");
    char decimal = '.';
    if (last != std::string_view::npos) {
        const char mark = mantissa[last], other = mark == '.' ? ',' : '.';
        const std::size_t behind = mantissa.size() - last - 1;
        const bool isOpen = count(mark) == 1 && count(other) == 0 && shape.thousands == 0 && behind == 3 && last >= 1 &&
                            last <= 3 && mantissa.front() != '0' && !hasExponent;
        if (count(mark) > 1) {
            shape.thousands = mark;
            decimal = other;
        } else {
            if (count(other) > 0) shape.thousands = other;
            decimal = mark;
        }
        shape.decimal =
            isOpen ? (mark == '.' ? Mark::OpenPoint : Mark::OpenComma) : (decimal == '.' ? Mark::Point : Mark::Comma);
    }
    shape.isNumber = readCell(plain, decimal, shape.thousands).kind == CellValue::Kind::Number;
    shape.isLongWithout = shape.thousands == 0 && std::min(mantissa.find_first_of(".,"), mantissa.size()) > 3;
    return shape;
}

}  // namespace analogon
