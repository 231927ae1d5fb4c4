#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/measure/mdf/formula.hpp"

namespace analogon::mdf {

/// From the number in a record to the quantity it stands for.
struct Conversion {
    enum class Kind {
        Identity,
        Linear,    // numbers: offset, factor
        Rational,  // numbers: P1 … P6, (P1*X^2 + P2*X + P3) / (P4*X^2 + P5*X + P6)
        Formula,
        Interpolated,  // numbers: key, value, key, value …; clamped outside
        Nearest,       // the same; a key that is no nearer than the next counts
        Ranges,        // entries with values; fallback
        Polynomial,    // numbers: P1 … P6 of format 3
        Exponential,   // numbers: P1 … P7 of format 3
        Logarithmic,
        Texts,      // entries with texts, or with conversions of their own
        FromText,   // entries: text and value; fallback
        Unreadable  // says what cannot be read; the numbers stay as they are
    };
    /// What happens to the values between two limits.
    struct Entry {
        double lower{}, upper{};
        double value{};
        std::string text;
        std::shared_ptr<const Conversion> nested{};  // in place of the text
    };
    Kind kind{Kind::Identity};
    std::vector<double> numbers{};
    std::optional<Formula> formula{};
    std::vector<Entry> entries{};
    std::optional<Entry> fallback{};
    bool includesUpper{true};  // a range of integers ends with its upper limit, one of real numbers before it
    std::string unit{};
    std::string unreadable{};

    /// Texts for every value that has an entry, numbers for none: a status.
    bool givesTextsOnly() const;
};

/// In place. Gaps (NaN) stay gaps; a value that has only a text becomes one.
void convert(const Conversion& conversion, std::span<double> values);

}  // namespace analogon::mdf
