#include "core/measure/xlsx/cell_value.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <string>

namespace analogon::xlsx {

namespace {

constexpr std::string_view fixedBlank = "\xC2\xA0";  // a blank at which no line may break

std::string_view trimmed(std::string_view text) {
    while (text.starts_with(fixedBlank)) text.remove_prefix(fixedBlank.size());
    while (text.ends_with(fixedBlank)) text.remove_suffix(fixedBlank.size());
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
    return text;
}

/// Marks between thousands stand before groups of three digits each, and behind no zero.
bool hasThousandsWhereTheyBelong(std::string_view whole, char mark) {
    const std::size_t first = whole.find(mark);
    if (first == std::string_view::npos) return true;
    for (std::size_t i = first; i < whole.size(); i += 4)
        if (whole[i] != mark || i + 4 > whole.size()) return false;
    const std::size_t sign = whole.front() == '-' || whole.front() == '+' ? 1 : 0;
    return first > sign && whole[sign] != '0';
}

}  // namespace

std::optional<double> numberOf(std::string_view text, char decimal) {
    text = trimmed(text);
    const char thousands = decimal == ',' ? '.' : ',';
    const std::string_view whole = text.substr(0, text.find_first_of(std::string{decimal, 'e', 'E'}));
    if (text.empty() || !hasThousandsWhereTheyBelong(whole, thousands)) return std::nullopt;
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == thousands && i < whole.size()) continue;
        plain.push_back(text[i] == decimal ? '.' : text[i]);
    }
    if (plain.front() == '+') plain.erase(plain.begin());
    double value = 0;
    const auto [end, code] = std::from_chars(plain.data(), plain.data() + plain.size(), value);
    if (code != std::errc() || end != plain.data() + plain.size()) return std::nullopt;
    return value;
}

namespace {

/// 10:30:00,5 as a part of a day.
std::optional<double> clockOf(const std::string& text) {
    int hour = 0, minute = 0, used = 0;
    char seconds[20] = "0";
    const int fields = std::sscanf(text.c_str(), "%2d:%2d:%15[0-9.,]%n", &hour, &minute, seconds, &used);
    if (fields < 3 || static_cast<std::size_t>(used) != text.size() || hour < 0 || hour > 23 || minute < 0 ||
        minute > 59)
        return std::nullopt;
    std::replace(seconds, seconds + sizeof seconds, ',', '.');
    double second = 0;
    std::from_chars(seconds, seconds + std::char_traits<char>::length(seconds), second);
    return (hour * 3600 + minute * 60 + second) / 86400;
}

}  // namespace

std::optional<double> dateOf(std::string_view text) {
    const std::string date(trimmed(text));
    int year = 0, month = 0, day = 0, hour = 0, minute = 0, used = 0;
    char seconds[20] = "0";
    if (date.size() > 40) return std::nullopt;
    if (const std::optional<double> clock = clockOf(date)) return clock;
    const bool isGerman = std::sscanf(date.c_str(), "%2d.%2d.%4d%n", &day, &month, &year, &used) == 3 && used > 0;
    const bool isIso = !isGerman && std::sscanf(date.c_str(), "%4d-%2d-%2d%n", &year, &month, &day, &used) == 3;
    if (!isGerman && !isIso) return std::nullopt;
    if (static_cast<std::size_t>(used) < date.size()) {
        const char* rest = date.c_str() + used + 1;  // behind a blank or a T
        int behind = 0;
        const int fields = std::sscanf(rest, "%2d:%2d%n:%15[0-9.,]%n", &hour, &minute, &behind, seconds, &behind);
        if (fields < 2 || static_cast<std::size_t>(used + 1 + behind) != date.size()) return std::nullopt;
    }
    std::replace(seconds, seconds + sizeof seconds, ',', '.');
    const std::chrono::year_month_day calendar{std::chrono::year(year),
                                               std::chrono::month(static_cast<unsigned>(month)),
                                               std::chrono::day(static_cast<unsigned>(day))};
    if (!calendar.ok() || hour > 24 || minute > 59) return std::nullopt;
    double second = 0;
    std::from_chars(seconds, seconds + std::char_traits<char>::length(seconds), second);
    const auto days =
        (std::chrono::sys_days(calendar) - std::chrono::sys_days(std::chrono::year(1899) / 12 / 30)).count();
    return static_cast<double>(days) + (hour * 3600 + minute * 60 + second) / 86400;
}

bool meansNothing(std::string_view text) {
    static constexpr std::array<std::string_view, 10> words{"-",   "--",   "---",  "n/a",  "na",
                                                            "nan", "null", "#n/a", "k.a.", "inf"};
    std::string lower(trimmed(text));
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower.empty() || std::find(words.begin(), words.end(), lower) != words.end();
}

}  // namespace analogon::xlsx
