#pragma once

#include <cmath>
#include <cstdint>

namespace analogon::speed {

/// splitmix64 with the Box-Muller transform.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    double uniform() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15ull;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }
    double normal() {
        const double a = uniform(), b = uniform();
        return std::sqrt(-2 * std::log(1 - a)) * std::cos(2 * M_PI * b);
    }
    int between(int first, int count) { return first + static_cast<int>(uniform() * count); }

private:
    std::uint64_t state_;
};

}  // namespace analogon::speed
