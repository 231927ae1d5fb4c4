#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace bench {

/// Random numbers whose sequence depends on the seed alone (the distributions of <random> differ between libraries).
/// The generator is splitmix64 (Steele, Lea, Flood 2014): a counter and a mixing function.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    }

    /// In [0, 1).
    double unit() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }
    double uniform(double low, double high) { return low + (high - low) * unit(); }
    double logUniform(double low, double high) { return low * std::pow(high / low, unit()); }
    bool chance(double probability) { return unit() < probability; }
    double sign() { return chance(0.5) ? 1.0 : -1.0; }
    int integer(int low, int high) {
        return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
    }

    /// Standard normal, by Box and Muller.
    double normal() {
        const double radius = std::sqrt(-2.0 * std::log(1.0 - unit()));
        return radius * std::cos(2.0 * std::numbers::pi * unit());
    }

    template <class T>
    const T& pick(const std::vector<T>& from) {
        return from[static_cast<std::size_t>(integer(0, static_cast<int>(from.size()) - 1))];
    }

    template <class T>
    void shuffle(std::vector<T>& items) {
        for (std::size_t k = items.size(); k > 1; --k)
            std::swap(items[k - 1], items[static_cast<std::size_t>(integer(0, static_cast<int>(k) - 1))]);
    }

private:
    std::uint64_t state_;
};

/// A physical constant as a data sheet states it: so many significant digits.
inline double rounded(double value, int digits) {
    if (value == 0.0) return 0.0;
    const double step = std::pow(10.0, digits - 1 - std::floor(std::log10(std::abs(value))));
    return std::round(value * step) / step;
}

}  // namespace bench
