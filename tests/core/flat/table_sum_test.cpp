#include "core/flat/table_sum.hpp"

#include <gtest/gtest.h>

#include "core/flat/external_table.hpp"

namespace analogon {
namespace {

/// A table with one open entry, and the same with the number that it stands for.
class TableWithAnOpenEntry : public ::testing::Test {
protected:
    static constexpr double number = 2.5;

    OpenEntries open(std::size_t at) { return {&pool, {{at, pool.variable({0})}}}; }
    double valueOf(ExpressionId id) const {
        return pool.evaluate(id, [](const ExpressionNode&) { return number; });
    }
    double valueAt(const TableSum& table, double x) { return valueOf(table.at(pool, pool.constant(x))); }

    ExpressionPool pool;
};

TEST_F(TableWithAnOpenEntry, IsTheSameInTime) {
    const Matrix closed{4, 2, {0, 1, 1, number, 1, 3, 2, 4}}, shown{4, 2, {0, 1, 1, 0, 1, 3, 2, 4}};
    for (const Smoothness pieces : {Smoothness::Linear, Smoothness::Constant})
        for (const auto beyond : {TableExtrapolation::Hold, TableExtrapolation::Periodic}) {
            const auto a = timeTable(closed, {2}, pieces, beyond, 0.5, 0.25, TimeEvents::Always);
            const auto b = timeTable(shown, {2}, pieces, beyond, 0.5, 0.25, TimeEvents::Always, open(3));
            ASSERT_TRUE(a && b);
            EXPECT_EQ(b->columns[0].parts.size(), 1u);
            for (double t = 0; t < 5; t += 0.1)
                EXPECT_NEAR(valueAt(b->columns[0], t), a->columns[0].known.value(t), 1e-12) << t;
            EXPECT_EQ(a->next, b->next);
        }
}

TEST_F(TableWithAnOpenEntry, IsTheSameOverASurface) {
    const auto table = [](double z) { return Matrix{3, 4, {0, 1, 2, 4, 1, 5, z, 7, 3, 8, 9, 6}}; };
    for (const Smoothness pieces : {Smoothness::Linear, Smoothness::Constant}) {
        const auto a = twoDimensional(table(number), pieces, TableExtrapolation::LastTwoPoints);
        const auto b = twoDimensional(table(0), pieces, TableExtrapolation::LastTwoPoints, open(6));
        ASSERT_TRUE(a && b);
        for (double u = 0; u < 5; u += 0.3)
            for (double v = 0; v < 5; v += 0.3) {
                double number1 = 0, number2 = 0;
                for (std::size_t j = 0; j < a->along.size(); ++j) {
                    number1 += a->across[j].value(v) * a->along[j].known.value(u);
                    number2 += b->across[j].value(v) * valueAt(b->along[j], u);
                }
                EXPECT_NEAR(number1, number2, 1e-12) << u << ", " << v;
            }
        EXPECT_EQ(a->alongBeyond.size(), b->alongBeyond.size());
    }
}

/// Beyond its steps a table of constant pieces goes on along a line through the last two points.
TEST_F(TableWithAnOpenEntry, IsTheSameBehindSteps) {
    const Matrix closed{3, 2, {1, 10, 2, number, 4, 60}}, shown{3, 2, {1, 10, 2, 0, 4, 60}};
    const auto a = oneDimensional(closed, {2}, Smoothness::Constant, TableExtrapolation::LastTwoPoints);
    const auto b = oneDimensional(shown, {2}, Smoothness::Constant, TableExtrapolation::LastTwoPoints, open(3));
    ASSERT_TRUE(a && b);
    for (double x = -1; x < 7; x += 0.25)
        EXPECT_NEAR(valueAt(b->columns[0], x), a->columns[0].known.value(x), 1e-12) << x;
}

}  // namespace
}  // namespace analogon
