#include "core/flat/expression.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <map>

#include "core/base/guard.hpp"
#include "core/flat/dependent_nodes.hpp"

namespace analogon {
namespace {

using enum Operation;

class Expressions : public ::testing::Test {
protected:
    ExpressionPool pool;
    ExpressionId x = pool.variable({0}), y = pool.variable({1}), z = pool.variable({2});

    ExpressionId number(double value) { return pool.constant(value); }
    std::string text(ExpressionId id) const {
        return pool.print(id, [](VariableId v) { return std::string(1, "xyz"[v.value]); });
    }
    double at(ExpressionId id, double vx, double vy = 0, double vz = 0) const {
        return pool.evaluate(id, [&](const ExpressionNode& leaf) {
            if (leaf.operation == Time) return 10.0;
            return leaf.variable.value == 0 ? vx : leaf.variable.value == 1 ? vy : vz;
        });
    }
    /// Central difference with respect to x.
    double slope(ExpressionId id, double vx, double vy) const {
        const double h = 1e-6;
        return (at(id, vx + h, vy) - at(id, vx - h, vy)) / (2 * h);
    }
};

TEST_F(Expressions, EqualSubexpressionsAreTheSameNode) {
    EXPECT_EQ(pool.add(x, y), pool.add(y, x));
    EXPECT_EQ(pool.multiply(pool.add(x, y), z), pool.multiply(z, pool.add(y, x)));
    EXPECT_NE(pool.subtract(x, y), pool.subtract(y, x));
    EXPECT_EQ(number(0.0), number(-0.0));
}

TEST_F(Expressions, FoldsConstantsAndNeutralElements) {
    EXPECT_TRUE(pool.isConstant(pool.power(number(2), number(10)), 1024));
    EXPECT_EQ(pool.add(x, number(0)), x);
    EXPECT_EQ(pool.multiply(number(1), x), x);
    EXPECT_TRUE(pool.isConstant(pool.multiply(x, number(0)), 0));
    EXPECT_TRUE(pool.isConstant(pool.subtract(x, x), 0));
    EXPECT_EQ(pool.negate(pool.negate(x)), x);
    EXPECT_EQ(pool.add(x, pool.negate(y)), pool.subtract(x, y));
    EXPECT_EQ(pool.divide(x, number(1)), x);
    EXPECT_EQ(pool.ifThenElse(number(1), x, y), x);
    EXPECT_EQ(pool.ifThenElse(z, x, x), x);
}

TEST_F(Expressions, KeepsWhatIsNotDefinedEverywhere) {
    EXPECT_EQ(pool[pool.divide(x, x)].operation, Divide);
    EXPECT_EQ(pool[pool.divide(number(1), number(0))].operation, Divide);
    EXPECT_EQ(pool[pool.unary(Log, number(-1))].operation, Log);
    EXPECT_EQ(pool[pool.divide(number(0), x)].operation, Divide);
}

TEST_F(Expressions, SymbolicDerivativesAgreeWithDifferenceQuotients) {
    const LookupTable curve{{0, 1, 2, 4}, {0, 1, 1.5, 5}, LookupTable::Interpolation::MonotoneCubic, 0, {}};
    const LookupTable line{{0, 1, 2, 4}, {0, 1, 1.5, 5}, LookupTable::Interpolation::Linear, 0, {}};
    std::vector<ExpressionId> cases{
        pool.multiply(x, pool.add(x, y)),
        pool.divide(y, x),
        pool.divide(x, pool.add(x, y)),
        pool.power(x, number(0.78)),
        pool.power(number(3), x),
        pool.power(x, x),
        pool.binary(Atan2, x, y),
        pool.binary(Min, x, y),
        pool.binary(Max, pool.multiply(x, x), y),
        pool.binary(Mod, x, number(0.4)),
        pool.binary(Rem, x, number(0.4)),
        pool.ifThenElse(pool.binary(Less, x, y), pool.multiply(x, x), y),
        pool.smooth(1, pool.multiply(x, pool.unary(Abs, x))),
        pool.unary(NoEvent, pool.multiply(x, pool.unary(Abs, x))),
        pool.table(curve, pool.multiply(number(2), x)),
        pool.table(line, pool.multiply(number(2), x)),
        pool.table(curve, pool.multiply(number(20), x)),
    };
    for (Operation f : {Abs, Sqrt, Exp, Log, Log10, Sin, Cos, Tan, Asin, Acos, Atan, Sinh, Cosh, Tanh})
        cases.push_back(pool.unary(f, pool.multiply(number(0.5), x)));
    for (ExpressionId f : cases) {
        const ExpressionId df = pool.differentiate(f, x);
        EXPECT_NEAR(at(df, 0.7, 1.3), slope(f, 0.7, 1.3), 1e-8) << text(f) << " -> " << text(df);
    }
    const ExpressionId second = pool.differentiate(pool.differentiate(cases[14], x), x);
    EXPECT_NEAR(at(second, 0.7), slope(pool.differentiate(cases[14], x), 0.7, 0), 1e-6);
    EXPECT_TRUE(pool.isConstant(pool.differentiate(pool.unary(Sin, y), x), 0));
}

/// The slopes along each leaf are the very nodes that a walk through the whole expression gives.
TEST_F(Expressions, SlopesByWhatDependsOnALeafAreTheSame) {
    const ExpressionId shared = pool.unary(Sin, pool.multiply(x, y));
    const ExpressionId all[] = {
        pool.add(pool.multiply(shared, x), pool.divide(y, shared)),
        pool.add(pool.delay(x, number(0.1)), pool.multiply(number(2), y)),
        pool.ifThenElse(pool.binary(Less, x, y), pool.multiply(x, x), shared),
        pool.power(x, number(3)),
    };
    for (const ExpressionId f : all) {
        DependentNodes dependent(pool, f);
        for (const ExpressionId leaf : {x, y})
            EXPECT_EQ(pool.differentiate(f, leaf, dependent.of(leaf)), pool.differentiate(f, leaf)) << text(f);
    }
    DependentNodes dependent(pool, all[3]);
    EXPECT_TRUE(dependent.of(y).empty());
    EXPECT_EQ(DependentNodes(pool, all[1]).of(x).size(), 0u);  // what is delayed is given by the past
}

TEST_F(Expressions, SlopesOfALongSumCostLittleMoreThanTheSum) {
    constexpr std::uint32_t count = 3000;
    ExpressionId sum = number(0);
    for (std::uint32_t i = 0; i < count; ++i) sum = pool.add(pool.unary(Sin, pool.variable({i})), sum);
    const std::clock_t begin = std::clock();
    DependentNodes dependent(pool, sum);
    for (std::uint32_t i = 0; i < count; ++i) {
        const ExpressionId leaf = pool.variable({i});
        EXPECT_EQ(pool.differentiate(sum, leaf, dependent.of(leaf)), pool.unary(Cos, leaf));
    }
    EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 2);
}

TEST(ExpressionLimits, AreToldBeforeTheyCostMemory) {
    const auto messageOf = [] {
        ExpressionPool pool;
        try {
            for (int i = 0; i < 5'000'000; ++i) pool.constant(i);
        } catch (const LimitReached& limit) {
            return limit.fault().message.english();
        }
        return std::string();
    };
    EXPECT_EQ(messageOf(), "the equations of the model, or their derivatives, take more than 4000000 expressions");
    setenv("ANALOGON_MEMORY", "20", 1);
    EXPECT_EQ(messageOf(),
              "the 262144 expressions of the model would take 0.0176 GB of memory, of 0.0195 GB that the "
              "machine has");
    unsetenv("ANALOGON_MEMORY");
}

TEST_F(Expressions, TotalTimeDerivativeFollowsTheChainRule) {
    // d/dt (x*y + t^2), y a parameter
    const ExpressionId f = pool.add(pool.multiply(x, y), pool.power(pool.time(), number(2)));
    const ExpressionId df = pool.timeDerivative(f, [&](const ExpressionNode& leaf) {
        return leaf.variable.value == 0 ? pool.derivativeOf(leaf.variable) : number(0);
    });
    EXPECT_EQ(df, pool.add(pool.multiply(y, pool.derivativeOf({0})), pool.multiply(number(2), pool.time())));
    const ExpressionId delayed = pool.delay(x, y);
    EXPECT_EQ(pool.timeDerivative(delayed,
                                  [&](const ExpressionNode& leaf) {
                                      return leaf.variable.value == 0 ? pool.derivativeOf(leaf.variable) : number(0);
                                  }),
              pool.delay(pool.derivativeOf({0}), y));
}

TEST_F(Expressions, SubstitutionFoldsWhatBecomesConstant) {
    const ExpressionId f = pool.add(pool.multiply(x, y), z);
    const ExpressionId g = pool.substitute(
        f, [&](const ExpressionNode& leaf) { return leaf.variable.value == 0 ? number(0) : ExpressionId{}; });
    EXPECT_EQ(g, z);
    const ExpressionId same = pool.substitute(f, [](const ExpressionNode&) { return ExpressionId{}; });
    EXPECT_EQ(same, f);
}

TEST_F(Expressions, ListsEachLeafOnce) {
    const std::vector<ExpressionId> roots{pool.multiply(x, x), pool.add(x, pool.derivativeOf({1})), pool.time()};
    EXPECT_THAT(pool.leaves(roots), ::testing::ElementsAre(x, pool.derivativeOf({1})));
}

TEST_F(Expressions, PrintsModelicaWithTheParenthesesItNeeds) {
    EXPECT_EQ(text(pool.multiply(pool.add(x, y), z)), "(x + y)*z");
    EXPECT_EQ(text(pool.subtract(x, pool.subtract(y, z))), "x - (y - z)");
    EXPECT_EQ(text(pool.subtract(pool.subtract(x, y), z)), "x - y - z");
    EXPECT_EQ(text(pool.divide(x, pool.multiply(y, z))), "x/(y*z)");
    EXPECT_EQ(text(pool.power(pool.power(x, y), z)), "(x^y)^z");
    EXPECT_EQ(text(pool.power(x, number(-2))), "x^(-2)");
    EXPECT_EQ(text(pool.multiply(x, pool.negate(y))), "-x*y");
    EXPECT_EQ(text(pool.negate(pool.add(x, y))), "-(x + y)");
    EXPECT_EQ(text(pool.add(x, pool.ifThenElse(pool.binary(Less, x, y), y, z))), "x + (if x < y then y else z)");
    EXPECT_EQ(text(pool.unary(Not, pool.binary(And, x, pool.binary(Or, y, z)))), "not (x and (y or z))");
    EXPECT_EQ(text(pool.binary(Atan2, pool.derivativeOf({0}), pool.time())), "atan2(der(x), time)");
    EXPECT_EQ(text(number(0.1)), "0.1");
}

TEST_F(Expressions, AHundredThousandNodesDeepNeedNoStack) {
    ExpressionId sum = x;
    for (int i = 0; i < 50000; ++i) sum = pool.unary(Sin, pool.add(sum, y));
    EXPECT_TRUE(std::isfinite(at(sum, 1, 2)));
    EXPECT_TRUE(std::isfinite(at(pool.differentiate(sum, y), 1, 2)));
    const ExpressionId replaced =
        pool.substitute(sum, [&](const ExpressionNode& leaf) { return leaf.variable.value == 0 ? z : ExpressionId{}; });
    EXPECT_EQ(at(replaced, 0, 2, 1), at(sum, 1, 2));
    EXPECT_LT(text(sum).size(), 200000u);
}

TEST_F(Expressions, SharedSubexpressionsAreVisitedOnce) {
    // Doubling 64 times: as a tree this has 2^64 leaves.
    ExpressionId f = x;
    for (int i = 0; i < 64; ++i) f = pool.add(f, pool.unary(Sin, f));
    EXPECT_TRUE(std::isfinite(at(f, 0.5)));
    EXPECT_TRUE(std::isfinite(at(pool.differentiate(f, x), 0.5)));
    EXPECT_LT(text(f).size(), 200000u);
}

TEST(LookupTable, LinearInterpolationExtrapolatesWithTheEndSlopes) {
    const LookupTable t{{0, 1, 3}, {1, 2, 8}, LookupTable::Interpolation::Linear, 0, {}};
    EXPECT_DOUBLE_EQ(t.value(-1), 0);
    EXPECT_DOUBLE_EQ(t.value(0.5), 1.5);
    EXPECT_DOUBLE_EQ(t.value(1), 2);
    EXPECT_DOUBLE_EQ(t.value(4), 11);
    EXPECT_DOUBLE_EQ(t.derivative(2), 3);
}

TEST(LookupTable, MonotoneCubicMeetsItsNodesAndDoesNotOvershoot) {
    LookupTable t{{0, 1, 2, 3, 4}, {0, 0, 0.1, 5, 5}, LookupTable::Interpolation::MonotoneCubic, 0, {}};
    for (const bool prepared : {false, true}) {
        if (prepared) t.prepare();
        for (std::size_t i = 0; i < t.x.size(); ++i) EXPECT_NEAR(t.value(t.x[i]), t.y[i], 1e-14);
        double previous = 0;
        for (int i = 0; i <= 400; ++i) {
            const double value = t.value(i * 0.01);
            EXPECT_GE(value, previous - 1e-12);
            EXPECT_LE(value, 5 + 1e-12);
            previous = value;
        }
    }
    // A straight line is reproduced.
    const LookupTable line{{0, 1, 3}, {1, 2, 4}, LookupTable::Interpolation::MonotoneCubic, 0, {}};
    EXPECT_NEAR(line.value(2.3), 3.3, 1e-14);
    EXPECT_NEAR(line.value(5), 6, 1e-14);
}

}  // namespace
}  // namespace analogon
