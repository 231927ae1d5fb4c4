#include "core/base/unit_factors.hpp"

#include <algorithm>
#include <cctype>

namespace analogon {
namespace {

bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

}  // namespace

std::optional<UnitFactors> UnitFactors::of(std::string_view unit) {
    UnitFactors result;
    int side = 1, inBrackets = 0;
    bool wantsFactor = true;
    for (std::size_t at = 0; at < unit.size();) {
        const char c = unit[at];
        if (wantsFactor && c == '(' && inBrackets == 0) {
            inBrackets = side;
            ++at;
        } else if (wantsFactor && (isLetter(c) || c == '1')) {
            std::size_t end = at + 1;
            while (isLetter(c) && end < unit.size() && isLetter(unit[end])) ++end;
            Factor f{std::string(unit.substr(at, end - at)), 0};
            std::size_t digits = end;
            const bool isInverse = digits < unit.size() && unit[digits] == '-';
            if (isInverse) ++digits;
            for (end = digits; end < unit.size() && isDigit(unit[end]) && end - digits < 2; ++end)
                f.power = 10 * f.power + (unit[end] - '0');
            if (isInverse && end == digits) return std::nullopt;
            if (!isLetter(c) && end > digits) return std::nullopt;  // a number is no unit
            if (end == digits) f.power = 1;
            f.power *= isInverse ? -side : side;
            UnitFactors one;
            if (isLetter(c)) one.factors_.push_back(std::move(f));
            result = result.times(one);
            wantsFactor = false;
            at = end;
        } else if (!wantsFactor && c == ')' && inBrackets != 0) {
            inBrackets = 0;
            side = 1;
            ++at;
        } else if (!wantsFactor && (c == '.' || c == '*')) {
            if (inBrackets == 0) side = 1;
            wantsFactor = true;
            ++at;
        } else if (!wantsFactor && c == '/' && inBrackets == 0) {
            side = -1;
            wantsFactor = true;
            ++at;
        } else {
            return std::nullopt;
        }
    }
    if (wantsFactor || inBrackets != 0) return std::nullopt;
    return result;
}

UnitFactors UnitFactors::times(const UnitFactors& other, int power) const {
    UnitFactors result = *this;
    for (const Factor& f : other.factors_) {
        const auto same = std::find_if(result.factors_.begin(), result.factors_.end(),
                                       [&](const Factor& own) { return own.symbol == f.symbol; });
        if (same == result.factors_.end())
            result.factors_.push_back({f.symbol, f.power * power});
        else
            same->power += f.power * power;
    }
    std::erase_if(result.factors_, [](const Factor& f) { return f.power == 0; });
    return result;
}

std::string UnitFactors::text() const {
    std::string above, below;
    int countBelow = 0;
    for (const Factor& f : factors_) {
        std::string& side = f.power > 0 ? above : below;
        if (!side.empty()) side += '.';
        side += f.symbol;
        if (std::abs(f.power) != 1) side += std::to_string(std::abs(f.power));
        if (f.power < 0) ++countBelow;
    }
    if (above.empty()) above = "1";
    if (countBelow > 1) below = '(' + below + ')';
    return below.empty() ? above : above + '/' + below;
}

}  // namespace analogon
