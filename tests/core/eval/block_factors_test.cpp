#include "core/eval/block_factors.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/eval/machine.hpp"

namespace analogon {
namespace {

/// The balance of a chain of n nodes, each joined to the next by a conductance, the first and the last to the ground.
struct Chain {
    std::size_t n;
    std::vector<std::uint32_t> entries;
    std::vector<double> values;

    explicit Chain(std::size_t nodes, double first = 2) : n(nodes) {
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = i > 0 ? i - 1 : 0; j < std::min(n, i + 2); ++j) {
                entries.push_back(static_cast<std::uint32_t>(i * n + j));
                values.push_back(i != j ? -1 : i == 0 ? first : 2);
            }
    }
    std::vector<double> times(const std::vector<double>& x) const {
        std::vector<double> y(n);
        for (std::size_t k = 0; k < entries.size(); ++k) y[entries[k] / n] += values[k] * x[entries[k] % n];
        return y;
    }
};

void expectSolved(BlockFactors& factors, const Chain& chain) {
    ASSERT_TRUE(factors.factorise(chain.n, chain.entries, chain.values));
    std::vector<double> x(chain.n);
    for (std::size_t i = 0; i < chain.n; ++i) x[i] = std::sin(1.0 + static_cast<double>(i));
    std::vector<double> right = chain.times(x);
    factors.solve(right.data(), 1);
    for (std::size_t i = 0; i < chain.n; ++i) EXPECT_NEAR(right[i], x[i], 1e-10) << i << " of " << chain.n;
}

TEST(BlockFactors, SolveDenseAndSparse) {
    for (const std::size_t n : {8, 23, 24, 200}) {
        BlockFactors factors;
        expectSolved(factors, Chain(n));
    }
}

TEST(BlockFactors, FollowTheEntriesWhenTheyChange) {
    for (const std::size_t n : {8, 60}) {
        BlockFactors factors;
        expectSolved(factors, Chain(n));
        expectSolved(factors, Chain(n, 5));
        expectSolved(factors, Chain(n + 1));
        expectSolved(factors, Chain(n));
    }
}

TEST(BlockFactors, SolveManyRightHandSidesAtOnce) {
    for (const std::size_t n : {10, 60}) {
        const Chain chain(n);
        BlockFactors factors;
        ASSERT_TRUE(factors.factorise(n, chain.entries, chain.values));
        std::vector<double> x(n, 1), y(n, -3), right(2 * n);
        const std::vector<double> ofX = chain.times(x), ofY = chain.times(y);
        for (std::size_t i = 0; i < n; ++i) right[2 * i] = ofX[i], right[2 * i + 1] = ofY[i];
        factors.solve(right.data(), 2);
        for (std::size_t i = 0; i < n; ++i) {
            EXPECT_NEAR(right[2 * i], 1, 1e-9);
            EXPECT_NEAR(right[2 * i + 1], -3, 1e-9);
        }
    }
}

TEST(BlockFactors, RefuseASingularMatrixAndGoOnWithTheNext) {
    for (const std::size_t n : {9, 60}) {
        BlockFactors factors;
        Chain floating(n, 1);  // no node is held
        for (std::size_t k = 0; k < floating.entries.size(); ++k)
            if (floating.entries[k] == n * n - 1) floating.values[k] = 1;
        EXPECT_FALSE(factors.factorise(n, floating.entries, floating.values)) << n;
        EXPECT_FALSE(factors.factorise(n, floating.entries, floating.values)) << "nor is it taken for known";
        expectSolved(factors, Chain(n));
    }
}

TEST(BlockFactors, AreNotShared) {
    BlockFactors factors;
    expectSolved(factors, Chain(60));
    BlockFactors copy = factors;
    expectSolved(copy, Chain(60, 5));
    expectSolved(factors, Chain(60));
}

}  // namespace
}  // namespace analogon
