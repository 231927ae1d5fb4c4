#include "core/measure/text/stamp_parts.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <string>

#include "core/measure/csv_dialect.hpp"
#include "core/measure/text/stamp.hpp"

namespace analogon {

int numberOfDigits(std::string_view digits) {
    int value = 0;
    for (const char c : digits) value = 10 * value + (c - '0');
    return value;
}

int monthOf(std::string_view name) {
    const std::string word = inLowerCase(name);
    if (word.size() < 3) return 0;
    if (word.starts_with("m\xC3\xA4r") || word == "mrz") return 3;
    constexpr std::array<std::string_view, 12> names{"jan", "feb", "mar", "apr", "may", "jun",
                                                     "jul", "aug", "sep", "oct", "nov", "dec"};
    const std::string head = word.substr(0, 3);
    if (head == "mai") return 5;
    if (head == "okt") return 10;
    if (head == "dez") return 12;
    const auto found = std::find(names.begin(), names.end(), head);
    return found == names.end() ? 0 : static_cast<int>(found - names.begin()) + 1;
}

bool putOrdinal(int year, int dayOfYear, Stamp& stamp) {
    const std::chrono::year_month_day first{std::chrono::year(year), std::chrono::January, std::chrono::day(1)};
    const std::chrono::year_month_day date(std::chrono::sys_days(first) + std::chrono::days(dayOfYear - 1));
    if (dayOfYear < 1 || year < 1700 || year > 2250 || date.year() != first.year()) return false;
    stamp.date = {static_cast<std::int16_t>(year), static_cast<std::int16_t>(static_cast<unsigned>(date.month())),
                  static_cast<std::int16_t>(static_cast<unsigned>(date.day()))};
    stamp.orders = 1u << static_cast<unsigned>(DateOrder::YearMonthDay);
    return true;
}

std::int64_t readFraction(StampParts& parts) {
    std::int64_t value = 0, unit = 1'000'000'000;
    do {
        for (const char c : parts.digits(18)) {
            unit /= 10;
            value += (c - '0') * unit;
        }
    } while (parts.front() == '.' && parts.rest().size() > 3 && isDigit(parts.rest()[1]) && parts.take('.'));
    return value;
}

}  // namespace analogon
