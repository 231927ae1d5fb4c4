#include <algorithm>
#include <array>

#include "core/measure/csv_dialect.hpp"
#include "core/measure/text/stamp.hpp"
#include "core/measure/text/stamp_parts.hpp"

namespace analogon {

namespace {

constexpr std::int64_t second = 1'000'000'000, minute = 60 * second, hour = 60 * minute;

/// The letters of other programs in those of strptime.
std::string inPercentLetters(std::string_view format) {
    if (format.find('%') != std::string_view::npos) return std::string(format);
    const bool isTwelve = format.find("tt") != std::string_view::npos || format.find("AP") != std::string_view::npos;
    struct Word {
        std::string_view letters, percent;
    };
    const std::array<Word, 17> words{Word{"yyyy", "%Y"}, {"YYYY", "%Y"},
                                     {"jjjj", "%Y"},     {"JJJJ", "%Y"},
                                     {"SSS", "%f"},      {"fff", "%f"},
                                     {"zzz", "%f"},      {"MMM", "%b"},
                                     {"yy", "%y"},       {"MM", "%m"},
                                     {"dd", "%d"},       {"TT", "%d"},
                                     {"HH", "%H"},       {"hh", isTwelve ? "%I" : "%H"},
                                     {"mm", "%M"},       {"ss", "%S"},
                                     {"tt", "%p"}};
    std::string result;
    while (!format.empty()) {
        const auto found = std::find_if(words.begin(), words.end(),
                                        [&](const Word& word) { return format.starts_with(word.letters); });
        result += found == words.end() ? format.substr(0, 1) : found->percent;
        format.remove_prefix(found == words.end() ? 1 : found->letters.size());
    }
    return result;
}

/// One field of a format.
class FormatReader {
public:
    explicit FormatReader(std::string_view text) : parts_(text) {}

    /// A field behind which another one follows at once has no more than its usual digits.
    bool read(char letter, bool isJoined) {
        switch (letter) {
            case 'Y':
                return number(4, year_) && (hasDate_ = true);
            case 'y':
                return number(2, year_) && (hasDate_ = true);
            case 'm':
                return number(2, month_);
            case 'd':
                return number(2, day_);
            case 'j':
                return number(3, dayOfYear_);
            case 'H':
            case 'I':
                return number(isJoined ? hourDigits() : 6, hours_) && (stamp_.hasClock = true);
            case 'M':
                return number(2, minutes_) && (stamp_.hasClock = true);
            case 'S':
                return number(2, seconds_) && (stamp_.hasClock = true) && decimals();
            case 'f':
                stamp_.hasFraction = true;
                fraction_ = readFraction(parts_);
                return true;
            case 'b':
            case 'B':
                return (month_ = monthOf(parts_.letters())) > 0;
            case 'p':
                return half();
            case 'z':
            case 'Z':
                return zone();
            default:
                return parts_.take(letter);
        }
    }
    bool literal(char c) {
        if (c != ' ') return parts_.take(c);
        parts_.skip(" ");
        return true;
    }
    std::optional<Stamp> stamp() {
        if (!parts_.isAtEnd() || (!hasDate_ && !stamp_.hasClock)) return std::nullopt;
        stamp_.nanoseconds = hours_ * hour + minutes_ * minute + seconds_ * second + fraction_ + half_ * hour;
        if (!hasDate_) {  // days that are counted by no year
            stamp_.countsDays = dayOfYear_ > 0;
            stamp_.nanoseconds += dayOfYear_ * 24 * hour;
            return stamp_;
        }
        if (dayOfYear_ > 0) {
            const int year = year_ >= 100 ? year_ : year_ + (year_ < 70 ? 2000 : 1900);
            return putOrdinal(year, dayOfYear_, stamp_) ? std::optional(stamp_) : std::nullopt;
        }
        stamp_.date = {static_cast<std::int16_t>(year_), static_cast<std::int16_t>(month_),
                       static_cast<std::int16_t>(day_)};
        stamp_.orders = 1u << static_cast<int>(DateOrder::YearMonthDay);
        return dayOf(stamp_, DateOrder::YearMonthDay) ? std::optional(stamp_) : std::nullopt;
    }

private:
    bool number(std::size_t digits, int& value) {
        const std::string_view found = parts_.digits(digits);
        value = numberOfDigits(found);
        return !found.empty();
    }
    /// A clock without marks may have lost the zero in front of its hours: 93000.
    std::size_t hourDigits() const {
        StampParts ahead = parts_;
        return ahead.digits(18).size() % 2 == 1 ? 1 : 2;
    }
    /// Decimals may follow though the format has none.
    bool decimals() {
        const std::string_view rest = parts_.rest();
        if (rest.size() < 2 || (rest[0] != '.' && rest[0] != ',') || !isDigit(rest[1])) return true;
        parts_.cut(1);
        stamp_.hasFraction = true;
        fraction_ = readFraction(parts_);
        return true;
    }
    bool half() {
        const std::string word = inLowerCase(parts_.letters());
        if ((word != "am" && word != "pm") || hours_ > 12) return false;
        half_ = word == "pm" ? (hours_ == 12 ? 0 : 12) : (hours_ == 12 ? -12 : 0);
        return true;
    }
    bool zone() {
        const std::optional<int> east = readZone(parts_.rest());
        if (!east) return false;
        stamp_.zone = static_cast<std::int16_t>(*east);
        parts_.cut(parts_.rest().size());
        return true;
    }

    StampParts parts_;
    Stamp stamp_;
    bool hasDate_{};
    int year_{}, month_{1}, day_{1}, dayOfYear_{}, hours_{}, minutes_{}, seconds_{}, half_{};
    std::int64_t fraction_{};
};

}  // namespace

std::optional<Stamp> readStamp(std::string_view text, std::string_view format) {
    std::string letters = inPercentLetters(format);
    for (const char* decimals : {"%S.%f", "%S,%f"})  // behind seconds they are read in any case
        if (const std::size_t at = letters.find(decimals); at != std::string::npos) letters.erase(at + 2, 3);
    FormatReader reader(withoutBlanks(text));
    for (std::size_t i = 0; i < letters.size(); ++i) {
        const bool isField = letters[i] == '%' && i + 1 < letters.size();
        const bool isJoined = i + 2 < letters.size() && letters[i + 2] == '%';
        if (!(isField ? reader.read(letters[i + 1], isJoined) : reader.literal(letters[i]))) return std::nullopt;
        i += isField;
    }
    return reader.stamp();
}

namespace {

/// The date in front of a stamp by the letters of its numbers; empty: none stands there.
std::string dateFormat(StampParts& parts, DateOrder order) {
    constexpr std::array<std::string_view, 3> letters{"Ymd", "dmY", "mdY"};
    std::string format;
    char mark = 0;
    for (const char letter : letters[static_cast<std::size_t>(order)]) {
        if (mark != 0) format += mark;
        const std::size_t digits = parts.digits(4).size();
        if (digits == 0) return {};
        format += letter == 'Y' && digits < 3 ? std::string("%y") : std::string{'%', letter};
        mark = parts.front();
        if (letter != letters[static_cast<std::size_t>(order)].back() && !parts.take(mark)) return {};
    }
    return format;
}

std::string clockFormat(StampParts& parts) {
    std::string format, rest(parts.rest());
    const std::string lower = inLowerCase(rest);
    const bool isTwelve = lower.find("am") != std::string::npos || lower.find("pm") != std::string::npos;
    std::string_view letters = isTwelve ? "IMS" : "HMS";
    for (; !letters.empty() && isDigit(parts.front()); letters.remove_prefix(1)) {
        format += {'%', letters.front()};
        parts.digits(6);
        if (parts.front() == ':' && letters.size() > 1) format += parts.front(), parts.cut(1);
    }
    if (letters.empty() && !parts.isAtEnd() && std::string_view(".,:").find(parts.front()) != std::string_view::npos) {
        format += {parts.front(), '%', 'f'};
        parts.cut(1);
        parts.digits(9);
    }
    if (parts.front() == ' ') format += ' ', parts.skip(" ");
    if (isTwelve && isLetter(parts.front())) format += "%p", parts.letters();
    if (parts.front() == ' ') format += ' ', parts.skip(" ");
    if (!parts.isAtEnd()) format += "%z";
    return format;
}

}  // namespace

std::string stampFormatOf(std::string_view text, DateOrder order) {
    StampParts parts(withoutBlanks(text));
    std::string format = dateFormat(parts, order);
    if (format.empty()) return {};
    while (!parts.isAtEnd() && !isDigit(parts.front())) format += parts.front(), parts.cut(1);
    if (!parts.isAtEnd()) format += clockFormat(parts);
    return readStamp(text, format) ? format : std::string();
}

}  // namespace analogon
