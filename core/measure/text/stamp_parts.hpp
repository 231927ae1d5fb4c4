#pragma once

#include <cctype>
#include <cstdint>
#include <string_view>

/// What dates and clocks are made of.
namespace analogon {

inline bool isDigit(char c) { return c >= '0' && c <= '9'; }
inline bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) || (c & 0x80) != 0; }

/// Takes parts off the front of a text.
class StampParts {
public:
    explicit StampParts(std::string_view text) : text_(text) {}

    bool isAtEnd() const { return text_.empty(); }
    std::string_view rest() const { return text_; }
    char front() const { return text_.empty() ? '\0' : text_.front(); }
    bool take(char c) {
        if (front() != c || text_.empty()) return false;
        text_.remove_prefix(1);
        return true;
    }
    void skip(std::string_view any) {
        while (!text_.empty() && any.find(text_.front()) != std::string_view::npos) text_.remove_prefix(1);
    }
    std::string_view digits(std::size_t most = 9) {
        std::size_t count = 0;
        while (count < text_.size() && count < most && isDigit(text_[count])) ++count;
        return cut(count);
    }
    std::string_view letters() {
        std::size_t count = 0;
        while (count < text_.size() && isLetter(text_[count])) ++count;
        return cut(count);
    }
    std::string_view cut(std::size_t count) {
        const std::string_view part = text_.substr(0, count);
        text_.remove_prefix(part.size());
        return part;
    }

private:
    std::string_view text_;
};

int numberOfDigits(std::string_view digits);

/// 0: no month. The first letters of the names in English and German.
int monthOf(std::string_view name);

struct Stamp;
/// The date of a day of a year, counted from 1; false: there is no such day.
bool putOrdinal(int year, int dayOfYear, Stamp& stamp);

/// Decimals of a second [ns]; points between groups of three are left out (255.812.740).
std::int64_t readFraction(StampParts& parts);

}  // namespace analogon
