#include "core/measure/mdf/conversion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace analogon::mdf {

namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

template <class Function>
void each(std::span<double> values, Function function) {
    for (double& value : values) value = function(value);
}

/// (P2 - P4*(X - P5 - P6)) / (P3*(X - P5 - P6) - P1)
double polynomial(const std::vector<double>& p, double x) {
    const double shifted = x - p[4] - p[5];
    return (p[1] - p[3] * shifted) / (p[2] * shifted - p[0]);
}

/// f((((X - P7)*P6 - P3)/P1)/P2 where P4 = 0, f((P3/(X - P7) - P6)/P4)/P5 where P1 = 0.
template <class Function>
double byFunction(const std::vector<double>& p, double x, Function function) {
    if (p[3] == 0) return function(((x - p[6]) * p[5] - p[2]) / p[0]) / p[1];
    if (p[0] == 0) return function((p[2] / (x - p[6]) - p[5]) / p[3]) / p[4];
    return gap;
}

struct TablePoint {
    double key, value;
};

std::vector<TablePoint> tableOf(const std::vector<double>& numbers) {
    std::vector<TablePoint> table;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) table.push_back({numbers[i], numbers[i + 1]});
    std::erase_if(table, [](const TablePoint& point) { return std::isnan(point.key); });
    std::stable_sort(table.begin(), table.end(),
                     [](const TablePoint& a, const TablePoint& b) { return a.key < b.key; });
    return table;
}

void lookUp(const std::vector<double>& numbers, bool interpolates, std::span<double> values) {
    const std::vector<TablePoint> table = tableOf(numbers);
    if (table.empty()) return each(values, [](double) { return gap; });
    each(values, [&](double x) {
        if (std::isnan(x)) return gap;
        const auto above = std::upper_bound(table.begin(), table.end(), x,
                                            [](double key, const TablePoint& point) { return key < point.key; });
        if (above == table.begin()) return above->value;
        const TablePoint& left = *(above - 1);
        if (above == table.end()) return left.value;
        if (!interpolates) return x - left.key <= above->key - x ? left.value : above->value;
        return left.value + (x - left.key) * (above->value - left.value) / (above->key - left.key);
    });
}

/// Finds the entry of a value: by halving where the ranges are in order, else one by one.
class EntryFinder {
public:
    explicit EntryFinder(const Conversion& conversion) : conversion_(&conversion) {
        const auto& entries = conversion.entries;
        for (std::size_t i = 0; i + 1 < entries.size() && isOrdered_; ++i)
            isOrdered_ = entries[i].lower <= entries[i].upper &&
                         (conversion.includesUpper ? entries[i].upper < entries[i + 1].lower
                                                   : entries[i].upper <= entries[i + 1].lower);
    }

    const Conversion::Entry* find(double x) const {
        const auto& entries = conversion_->entries;
        if (!isOrdered_) {
            const auto found =
                std::find_if(entries.begin(), entries.end(), [&](const Conversion::Entry& e) { return holds(e, x); });
            return found == entries.end() ? fallback() : &*found;
        }
        const auto above = std::upper_bound(entries.begin(), entries.end(), x,
                                            [](double value, const Conversion::Entry& e) { return value < e.lower; });
        return above != entries.begin() && holds(*(above - 1), x) ? &*(above - 1) : fallback();
    }

private:
    bool holds(const Conversion::Entry& entry, double x) const {
        if (entry.lower == entry.upper) return x == entry.lower;
        return x >= entry.lower && (conversion_->includesUpper ? x <= entry.upper : x < entry.upper);
    }
    const Conversion::Entry* fallback() const { return conversion_->fallback ? &*conversion_->fallback : nullptr; }

    const Conversion* conversion_;
    bool isOrdered_{true};
};

void convertByEntries(const Conversion& conversion, std::span<double> values) {
    const EntryFinder finder(conversion);
    each(values, [&](double x) {
        if (std::isnan(x)) return gap;
        const Conversion::Entry* entry = finder.find(x);
        if (conversion.kind == Conversion::Kind::Ranges) return entry ? entry->value : gap;
        if (!entry) return x;
        if (!entry->nested) return gap;
        convert(*entry->nested, std::span(&x, 1));
        return x;
    });
}

}  // namespace

bool Conversion::givesTextsOnly() const {
    return kind == Kind::Texts && !(fallback && fallback->nested) &&
           std::none_of(entries.begin(), entries.end(), [](const Entry& entry) { return entry.nested != nullptr; });
}

void convert(const Conversion& conversion, std::span<double> values) {
    const std::vector<double>& p = conversion.numbers;
    switch (conversion.kind) {
        case Conversion::Kind::Linear:
            return each(values, [&](double x) { return p[1] * x + p[0]; });
        case Conversion::Kind::Rational:
            return each(values,
                        [&](double x) { return (p[0] * x * x + p[1] * x + p[2]) / (p[3] * x * x + p[4] * x + p[5]); });
        case Conversion::Kind::Formula:
            return conversion.formula->evaluate(values);
        case Conversion::Kind::Interpolated:
            return lookUp(p, true, values);
        case Conversion::Kind::Nearest:
            return lookUp(p, false, values);
        case Conversion::Kind::Polynomial:
            return each(values, [&](double x) { return polynomial(p, x); });
        case Conversion::Kind::Exponential:
            return each(values, [&](double x) { return byFunction(p, x, [](double y) { return std::log(y); }); });
        case Conversion::Kind::Logarithmic:
            return each(values, [&](double x) { return byFunction(p, x, [](double y) { return std::exp(y); }); });
        case Conversion::Kind::Ranges:
            return convertByEntries(conversion, values);
        case Conversion::Kind::Texts:
            if (!conversion.givesTextsOnly()) convertByEntries(conversion, values);
            return;
        default:
            return;
    }
}

}  // namespace analogon::mdf
