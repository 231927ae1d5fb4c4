#include <gtest/gtest.h>

#include "core/eval/machine.hpp"

namespace analogon {
namespace {

TEST(LinearSolver, PivotsWhereTheDiagonalIsZero) {
    std::vector<double> matrix{0, 2, 1, 1, 0, 3, 4, 1, 0};
    const std::vector<double> original = matrix, solution{1, -2, 0.5};
    std::vector<double> right(3);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) right[i] += original[i * 3 + j] * solution[j];
    std::vector<int> pivots(3);
    std::vector<double> scale(3);
    ASSERT_TRUE(factorise(matrix, pivots, scale));
    substitute(matrix, pivots, right.data(), 1, 1);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(right[i], solution[i], 1e-14);
}

TEST(LinearSolver, IsNotMisledByTheScaleOfRowsAndColumns) {
    // Rows and columns of very different size, as units bring them; the system itself is well posed.
    std::vector<double> matrix{1e-9, 1e3, 2e3, 1e12}, right{1e-9 * 3 + 1e3 * 2, 2e3 * 3 + 1e12 * 2};
    std::vector<int> pivots(2);
    std::vector<double> scale(2);
    ASSERT_TRUE(factorise(matrix, pivots, scale));
    substitute(matrix, pivots, right.data(), 1, 1);
    EXPECT_NEAR(right[0], 3, 1e-3);
    EXPECT_NEAR(right[1], 2, 1e-12);
}

TEST(LinearSolver, RefusesASingularMatrix) {
    std::vector<int> pivots(2);
    std::vector<double> scale(2);
    std::vector<double> zeroRow{1, 2, 0, 0}, dependent{1, 3, 1.0 / 3, 1};
    EXPECT_FALSE(factorise(zeroRow, pivots, scale));
    EXPECT_FALSE(factorise(dependent, pivots, scale));
}

TEST(LinearSolver, SolvesManyRightHandSidesAtOnce) {
    std::vector<double> matrix{4, 1, 2, 3}, right{1, 0, 5, 0, 1, 5};
    std::vector<int> pivots(2);
    std::vector<double> scale(2);
    ASSERT_TRUE(factorise(matrix, pivots, scale));
    substitute(matrix, pivots, right.data(), 3, 3);
    const std::vector<double> expected{0.3, -0.1, 1, -0.2, 0.4, 1};
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(right[i], expected[i], 1e-15);
}

}  // namespace
}  // namespace analogon
