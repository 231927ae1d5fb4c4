#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/eval/machine.hpp"
#include "tests/core/simulate/text_models.hpp"

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

/// y(1) … of a system without states at an input.
std::vector<double> outputsAt(const System& system, double u) {
    Workspace w = system.workspace(0);
    std::vector<double> y(static_cast<std::size_t>(system.outputCount()));
    EXPECT_TRUE(system.setParameters(w, test::ownParameters(system)));
    EXPECT_TRUE(system.outputs(w, 0, {}, std::vector<double>{u}, y)) << system.failure(w);
    return y;
}

TEST(LinearLoop, OfALongLadderKeepsItsDigits) {
    // From node to node a step multiplies rounding by two: 60 of them would leave nothing.
    constexpr int n = 60;
    std::string text = "model Ladder\n  input Real u;\n", equations = "equation\n";
    for (int i = 1; i <= n; ++i) {
        text += fmt::format("  output Real T{};\n", i);
        equations += fmt::format("  0 = {} - 2.5*T{}{};\n", i == 1 ? "u" : fmt::format("T{}", i - 1), i,
                                 i == n ? "" : fmt::format(" + T{}", i + 1));
    }
    const SystemPtr system = test::compileText(text + equations + "end Ladder;\n", "Ladder");
    ASSERT_TRUE(system);
    const std::vector<double> T = outputsAt(*system, 7);
    // T(i) = a 2^-i + b 2^i with T(0) = u and T(n + 1) = 0
    const double b = -7 * std::pow(0.25, n + 1) / (1 - std::pow(0.25, n + 1)), a = 7 - b;
    for (int i = 1; i <= n; ++i) {
        const double exact = a * std::pow(0.5, i) + b * std::pow(2.0, i);
        EXPECT_NEAR(T[static_cast<std::size_t>(i - 1)], exact, 1e-10) << i;
    }
}

TEST(LinearLoop, OfANetKeepsItsDigits) {
    // Nodes (i, j) of a square with a loss to the ambient and a source in one corner: it is symmetric about the
    // diagonal, and what flows in is lost.
    constexpr int n = 12;
    std::string text = "model Net\n  input Real u;\n", equations = "equation\n";
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            text += fmt::format("  output Real T{}_{};\n", i, j);
            std::string flows = i == 0 && j == 0 ? "u" : "0";
            for (const auto& [a, b] : {std::pair(i - 1, j), {i + 1, j}, {i, j - 1}, {i, j + 1}})
                if (a >= 0 && a < n && b >= 0 && b < n) flows += fmt::format(" + (T{}_{} - T{}_{})", a, b, i, j);
            equations += fmt::format("  0 = {} - 0.1*T{}_{};\n", flows, i, j);
        }
    const SystemPtr system = test::compileText(text + equations + "end Net;\n", "Net");
    ASSERT_TRUE(system);
    const std::vector<double> T = outputsAt(*system, 3);
    const auto at = [&](int i, int j) { return T[static_cast<std::size_t>(i * n + j)]; };
    double lost = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            lost += 0.1 * at(i, j);
            EXPECT_NEAR(at(i, j), at(j, i), 1e-8) << i << ' ' << j;
            EXPECT_GT(at(i, j), 0) << i << ' ' << j;
        }
    EXPECT_NEAR(lost, 3, 1e-8);
}

TEST(LinearLoop, OfALargeNetKeepsItsDigitsWithSparseFactors) {
    // The nodes but three have no state; one corner is held at 300. What is left of the block once most of its unknowns
    // are eliminated has no diagonal to speak of.
    constexpr int n = 16;
    std::string text = "model Net\n  input Real u;\n  parameter Real g = 0.1;\n", equations = "equation\n";
    int count = 0;
    std::vector<std::string> balance(n * n);
    const auto name = [](int i, int j) { return fmt::format("T{}_{}", i, j); };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            text += fmt::format("  Real {};\n", name(i, j));
            for (const auto& [a, b] : {std::pair(i, j + 1), std::pair(i + 1, j)}) {
                if (a == n || b == n) continue;
                text += fmt::format("  Real q{};\n", ++count);
                equations += fmt::format("  q{} = (g + {})*({} - {});\n", count, 0.001 * count, name(i, j), name(a, b));
                balance[static_cast<std::size_t>(i * n + j)] += fmt::format(" - q{}", count);
                balance[static_cast<std::size_t>(a * n + b)] += fmt::format(" + q{}", count);
            }
        }
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const std::string own = balance[static_cast<std::size_t>(i * n + j)];
            const bool hasState = (i == 0 && j == 0) || (i == n / 2 && j == n / 2) || (i == n - 1 && j == 0);
            if (i == n - 1 && j == n - 1)
                equations += fmt::format("  {} = 300;\n", name(i, j));
            else
                equations += fmt::format("  {} = {}{};\n", hasState ? fmt::format("5*der({})", name(i, j)) : "0",
                                         i == 0 && j == 0 ? "u" : "0", own);
        }
    const SystemPtr system = test::compileText(text + equations + "end Net;\n", "Net", {"g"});
    ASSERT_TRUE(system);
    ASSERT_EQ(system->stateCount(), 3);
    Workspace w = system->workspace(0);
    ASSERT_TRUE(system->setParameters(w, test::ownParameters(*system)));
    const auto rates = [&](const std::vector<double>& x) {
        std::vector<double> f(3);
        EXPECT_TRUE(system->derivatives(w, 0, x, std::vector<double>{0}, f));
        return f;
    };
    const std::vector<double> none = rates({0, 0, 0}), all = rates({1.7, 0.8, -0.1});
    std::vector<double> sum = none;
    for (std::size_t j = 0; j < 3; ++j) {
        std::vector<double> x(3);
        x[j] = 1;
        const std::vector<double> unit = rates(x);
        for (std::size_t i = 0; i < 3; ++i) sum[i] += std::vector{1.7, 0.8, -0.1}[j] * (unit[i] - none[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(sum[i], all[i], 1e-13 * std::fabs(all[i])) << i;
}

TEST(NonlinearLoop, KnowsTheSlopeOfAPowerWhereItsBaseIsNothing) {
    // the derivative of x^1.5 is a quotient beside x^1.5, and 0 where x is 0
    const SystemPtr system = test::compileText(
        "model Power\n  input Real u;\n  output Real x(start = 0);\nequation\n  x^1.5 + x = u;\nend Power;\n", "Power");
    ASSERT_TRUE(system);
    EXPECT_NEAR(outputsAt(*system, 2).front(), 1, 1e-12);
    EXPECT_NEAR(outputsAt(*system, 12).front(), 4, 1e-11);
    EXPECT_NEAR(outputsAt(*system, 0).front(), 0, 1e-12);
}

TEST(Power, BesideAHigherOneOfTheSameBaseIsWhatItIsAlone) {
    // u^0.7 is u^1.7 / u where that is known already
    const auto at = [](const char* powers, double u) {
        const SystemPtr system = test::compileText(
            fmt::format("model Powers\n  input Real u;\n  output Real y = {};\nend Powers;\n", powers), "Powers");
        EXPECT_TRUE(system);
        return system ? outputsAt(*system, u).front() : NAN;
    };
    EXPECT_EQ(at("u^1.7 + u^0.7", 0), 0);
    EXPECT_EQ(at("u^0.7 + 1/(1 + u^(-0.3))", 0), 0) << "it is infinite there";
    EXPECT_EQ(at("u^1 + u^0", 0), 1) << "anything to the power 0 is 1";
    EXPECT_NEAR(at("u^1.7 + u^0.7", 3), std::pow(3, 1.7) + std::pow(3, 0.7), 1e-14);
    EXPECT_NEAR(at("u^0.7 + u^(-0.3)", 3), std::pow(3, 0.7) + std::pow(3, -0.3), 1e-14);
}

TEST(NonlinearLoop, FollowsARootDownToItsEnd) {
    // x^0.78 rises without limit at 0: its slope is no number there, and no step may begin with it
    const SystemPtr system = test::compileText(
        "model Root\n  input Real u;\n  output Real x(start = 3);\nequation\n  x^0.78 + x = u;\nend Root;\n", "Root");
    ASSERT_TRUE(system);
    EXPECT_NEAR(outputsAt(*system, 2).front(), 1, 1e-12);
    const double x = outputsAt(*system, 0.5).front();
    EXPECT_NEAR(std::pow(x, 0.78) + x, 0.5, 1e-12);
}

}  // namespace
}  // namespace analogon
