#include "core/flat/external_table.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace analogon {
namespace {

namespace fs = std::filesystem;

Matrix matrixOf(std::size_t columns, std::vector<double> values) {
    return {values.size() / columns, columns, std::move(values)};
}

double valueOf(const ExternalTable& table, double u1, double u2) {
    double sum = 0;
    for (std::size_t j = 0; j < table.along.size(); ++j)
        sum += table.across[j].value(u2) * table.along[j].known.value(u1);
    return sum;
}

TEST(ExternalTable, ExtrapolatesAsAsked) {
    const Matrix table = matrixOf(2, {1, 10, 2, 20, 4, 60});
    const auto made = [&](TableExtrapolation e, Smoothness s = Smoothness::Linear) {
        return oneDimensional(table, {2}, s, e)->columns[0].known;
    };
    const LookupTable slope = made(TableExtrapolation::LastTwoPoints), hold = made(TableExtrapolation::Hold),
                      round = made(TableExtrapolation::Periodic), none = made(TableExtrapolation::None);
    EXPECT_DOUBLE_EQ(slope.value(0), 0);
    EXPECT_DOUBLE_EQ(slope.value(5), 80);
    EXPECT_DOUBLE_EQ(hold.value(0), 10);
    EXPECT_DOUBLE_EQ(hold.value(5), 60);
    EXPECT_DOUBLE_EQ(hold.derivative(5), 0);
    EXPECT_DOUBLE_EQ(round.value(4.5), 15);
    EXPECT_DOUBLE_EQ(round.value(-0.5), round.value(2.5));
    EXPECT_TRUE(std::isnan(none.value(4.1)));
    EXPECT_DOUBLE_EQ(none.value(4), 60);
    const LookupTable steps = made(TableExtrapolation::LastTwoPoints, Smoothness::Constant);
    EXPECT_DOUBLE_EQ(steps.value(1.999), 10);
    EXPECT_DOUBLE_EQ(steps.value(2), 20);
    EXPECT_DOUBLE_EQ(steps.value(3.999), 20);
    EXPECT_DOUBLE_EQ(steps.value(4), 60);
    EXPECT_DOUBLE_EQ(steps.value(9), 60 + 5 * 20) << "along the line through the last two points";
    EXPECT_DOUBLE_EQ(steps.value(0), 0);
    EXPECT_DOUBLE_EQ(steps.derivative(3), 0);
}

TEST(ExternalTable, WhatJumpsAtTheLastAbscissaIsAsItGoesOnBehindIt) {
    // at every other node the second derivative is that of the piece behind it; behind the last one lies a straight
    // line
    const Matrix table = matrixOf(2, {0, 1, 0.5, 2, 1, 1});
    const auto second = [&](TableExtrapolation e) {
        LookupTable curve = oneDimensional(table, {2}, Smoothness::Akima, e)->columns[0].known;
        curve.order = 2;
        return curve;
    };
    const LookupTable line = second(TableExtrapolation::LastTwoPoints), none = second(TableExtrapolation::None);
    EXPECT_NE(line.value(1 - 1e-9), 0);
    EXPECT_EQ(line.value(1), 0);
    EXPECT_EQ(line.value(1.1), 0);
    EXPECT_EQ(second(TableExtrapolation::Hold).value(1), 0);
    EXPECT_NEAR(none.value(1), none.value(1 - 1e-9), 1e-6) << "there is nothing behind it";
}

TEST(ExternalTable, SmoothCurvesPassThroughTheirPointsAndKeepTheirKind) {
    const std::vector<double> x{0, 1, 2, 3.5, 5, 6}, line{1, 3, 5, 8, 11, 13}, stair{0, 0, 1, 1, 5, 5};
    for (const Smoothness kind :
         {Smoothness::Akima, Smoothness::ModifiedAkima, Smoothness::FritschButland, Smoothness::Steffen})
        for (const double slope : cubicSlopes(x, line, kind)) EXPECT_NEAR(slope, 2, 1e-12);
    // Akima by hand: d = {0, 1, 0, 8/3, 0}; at x = 2: weights |8/3 - 0| of d1 = 1 and |1 - 0| of d2 = 0
    EXPECT_NEAR(cubicSlopes(x, stair, Smoothness::Akima)[2], (8.0 / 3 * 1 + 1 * 0) / (8.0 / 3 + 1), 1e-12);
    for (const Smoothness kind : {Smoothness::FritschButland, Smoothness::Steffen}) {
        Matrix table{6, 2, {}};
        for (std::size_t i = 0; i < 6; ++i) table.values.insert(table.values.end(), {x[i], stair[i]});
        const LookupTable curve = oneDimensional(table, {2}, kind, TableExtrapolation::Hold)->columns[0].known;
        double before = curve.value(0);
        for (double u = 0; u <= 6; u += 0.01) {
            EXPECT_GE(curve.value(u), before - 1e-12) << u;
            before = curve.value(u);
        }
        for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(curve.value(x[i]), stair[i], 1e-12);
    }
}

TEST(ExternalTable, ASurfaceIsThatOfTheGrid) {
    // z = 1 + 2 x + 3 y + 4 x y over an uneven grid
    const std::vector<double> x{0, 1, 3, 4}, y{-1, 0, 2, 5};
    Matrix table{5, 5, std::vector<double>(25)};
    const auto z = [](double u, double v) { return 1 + 2 * u + 3 * v + 4 * u * v; };
    for (std::size_t i = 0; i < 4; ++i) {
        table.values[(i + 1) * 5] = x[i];
        table.values[i + 1] = y[i];
        for (std::size_t j = 0; j < 4; ++j) table.values[(i + 1) * 5 + j + 1] = z(x[i], y[j]);
    }
    for (const Smoothness kind : {Smoothness::Linear, Smoothness::Akima}) {
        const auto made = twoDimensional(table, kind, TableExtrapolation::LastTwoPoints);
        ASSERT_TRUE(made);
        for (const double u : {-1.0, 0.0, 0.4, 2.2, 4.0, 5.0})
            for (const double v : {-2.0, -1.0, 1.3, 4.9, 6.0})
                EXPECT_NEAR(valueOf(*made, u, v), z(u, v), 1e-9) << u << v;
    }
    const auto steps = twoDimensional(table, Smoothness::Constant, TableExtrapolation::Hold);
    EXPECT_DOUBLE_EQ(valueOf(*steps, 2.9, 1.9), z(1, 0));
    EXPECT_FALSE(twoDimensional(table, Smoothness::Steffen, TableExtrapolation::Hold));
}

TEST(ExternalTable, ATimeTableKnowsItsEvents) {
    const Matrix table = matrixOf(2, {0, 0, 1, 1, 1, 3, 2, 4});
    const auto once = timeTable(table, {2}, Smoothness::Linear, TableExtrapolation::Hold, 0.5, 0.5, TimeEvents::Always);
    ASSERT_TRUE(once);
    EXPECT_DOUBLE_EQ(once->next.value(0.4), 0.5);
    EXPECT_DOUBLE_EQ(once->next.value(0.5), 1.5);
    EXPECT_DOUBLE_EQ(once->next.value(1.5), 2.5);
    EXPECT_GT(once->next.value(2.5), 1e100);
    EXPECT_DOUBLE_EQ(once->columns[0].known.value(0.4), 0);
    EXPECT_DOUBLE_EQ(once->columns[0].known.value(1.5), 3);
    const auto round =
        timeTable(table, {2}, Smoothness::Linear, TableExtrapolation::Periodic, 0, 0, TimeEvents::AtDiscontinuities);
    ASSERT_TRUE(round);
    EXPECT_NEAR(round->next.value(4.25), 0.75, 1e-12);
    EXPECT_DOUBLE_EQ(round->columns[0].known.value(4.25), 0.25);
}

/// As the tables of Booleans of the Modelica Standard Library have it: "from ever" must not blur when the next event
/// is.
TEST(ExternalTable, ATimeTableFromEverKnowsItsEvents) {
    const auto table = timeTable(matrixOf(2, {1, 0, 1, 1, 3, 0, 5, 1}), {2}, Smoothness::Constant,
                                 TableExtrapolation::Hold, -1e60, 0, TimeEvents::Always);
    ASSERT_TRUE(table);
    EXPECT_LT(table->rounding, 1e-9);
    EXPECT_EQ(table->next.value(0), 1);
    EXPECT_EQ(table->next.value(1 + table->rounding), 3);
    EXPECT_EQ(table->next.value(4), 5);
    EXPECT_GT(table->next.value(6), 1e100);
}

TEST(ExternalTable, GoesOnLevelBehindAJump) {
    const LookupTable table = oneDimensional(matrixOf(2, {0, 5, 0, 1, 1, 0, 1, 3}), {2}, Smoothness::Linear,
                                             TableExtrapolation::LastTwoPoints)
                                  ->columns[0]
                                  .known;
    EXPECT_DOUBLE_EQ(table.value(2.5), 3);
    EXPECT_DOUBLE_EQ(table.derivative(2.5), 0);
    EXPECT_DOUBLE_EQ(table.value(-1), 5);
    EXPECT_DOUBLE_EQ(table.value(0.5), 0.5);
}

/// Inside it is a step, outside a plane through the last two points of each direction.
TEST(ExternalTable, ASteppedSurfaceGoesOnAsAPlane) {
    const auto steps = twoDimensional(matrixOf(3, {0, 0, 1, 0, 1, 2, 1, 3, 4}), Smoothness::Constant,
                                      TableExtrapolation::LastTwoPoints);
    ASSERT_TRUE(steps);
    EXPECT_DOUBLE_EQ(valueOf(*steps, 0.5, 0.5), 1);
    ExternalTable outside = *steps;
    outside.along = steps->alongBeyond;
    outside.across = steps->acrossBeyond;
    EXPECT_DOUBLE_EQ(valueOf(outside, 0.5, 2), 1 + 0.5 * 2 + 2);
    EXPECT_TRUE(twoDimensional(matrixOf(3, {0, 0, 1, 0, 1, 2, 1, 3, 4}), Smoothness::Constant, TableExtrapolation::Hold)
                    ->alongBeyond.empty());
}

}  // namespace
}  // namespace analogon
