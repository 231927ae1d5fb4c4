#include "core/eval/recurrence.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace analogon {
namespace {

/// x' = (k u - x)/T with tangents along T and k: x(t + h) = e x + k (1 - e) u, e = exp(-h/T), where u is constant.
LinearRates lag(double T, double k) {
    LinearRates rates;
    rates.states = 1;
    rates.slots = 1;
    rates.directions = 2;
    rates.matrix = {-1 / T, k / T, 0};
    rates.tangents = {1 / (T * T), 0, -k / (T * T), 1 / T, 0, 0};
    return rates;
}

void expectClose(double value, double expected) { EXPECT_NEAR(value, expected, 1e-12 * std::fabs(expected)); }

TEST(Recurrence, IsAsExactWhateverTheUnitsOfTheInput) {
    const double T = 1.5, h = 0.05, e = std::exp(-h / T);
    for (const double k : {1e-200, 1e-30, 1.0, 1e5, 1e10, 1e30, 1e200}) {
        SCOPED_TRACE(k);
        const LinearRecurrence found = recurrenceOf(lag(T, k), h);
        expectClose(found.matrix[0], e);
        expectClose(found.matrix[1] + found.matrix[2], k * (1 - e));
        const auto slope = [&](std::size_t entry, std::size_t direction) {
            return found.tangents[entry * 2 + direction];
        };
        expectClose(slope(0, 0), e * h / (T * T));
        EXPECT_EQ(slope(0, 1), 0);
        expectClose(slope(1, 0) + slope(2, 0), -k * e * h / (T * T));
        expectClose(slope(1, 1) + slope(2, 1), 1 - e);
    }
}

/// Two tanks, one counted in millionths: x1' = -x1 + c x2, x2' = x1/c - x2 has the eigenvalues 0 and -2.
TEST(Recurrence, IsAsExactWhateverTheUnitsOfTheStates) {
    const double h = 0.1, fall = std::exp(-2 * h);
    for (const double c : {1.0, 1e6, 1e12, 1e60}) {
        SCOPED_TRACE(c);
        LinearRates rates;
        rates.states = 2;
        rates.matrix = {-1, c, 0, 1 / c, -1, 0};
        const LinearRecurrence found = recurrenceOf(rates, h);
        expectClose(found.matrix[0], 0.5 * (1 + fall));
        expectClose(found.matrix[1], 0.5 * c * (1 - fall));
        expectClose(found.matrix[3], 0.5 / c * (1 - fall));
        expectClose(found.matrix[4], 0.5 * (1 + fall));
    }
}

}  // namespace
}  // namespace analogon
