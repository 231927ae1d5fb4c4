/// Parameters with fixed = false (Modelica 3.6, section 8.6).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "flat_support.hpp"

namespace analogon {
namespace {

// The second function takes as many turns as its argument asks for: it can only be run where that is known.
TEST(FreeParameter, HasTheValueThatFunctionsOfOtherParametersGiveIt) {
    const FlatModel flat = test::flatOf(R"(
        function cornersOf input Real f; output Real low; output Real high; algorithm low := f/2; high := 2*f; end cornersOf;
        function rootOf input Real a; output Real x;
        protected Real low = 0; Real high = 1 + a; Boolean isFound = false;
        algorithm
          while not isFound loop
            x := (low + high)/2;
            if x*x > a then high := x; else low := x; end if;
            isFound := high - low < 1e-13;
          end while;
        end rootOf;
        model M
          parameter Real f = 3;
          parameter Real low(fixed = false), high(fixed = false), k[2](each fixed = false);
          Real y(start = 0, fixed = true);
        initial equation
          (low, high) = cornersOf(f);
          for i in 1:2 loop k[i] = i*rootOf(high); end for;
        equation
          der(y) = k[2] - low;
        end M;)");
    EXPECT_EQ(test::valueOf(flat, "low"), 1.5);
    EXPECT_NEAR(test::valueOf(flat, "k[2]"), 2 * std::sqrt(6), 1e-12);
    EXPECT_TRUE(flat.initialEquations.empty());
    EXPECT_EQ(flat.equations.size(), 1u);
}

TEST(FreeParameter, FollowsInitialEquationsInAnyOrderAndAlgorithms) {
    const FlatModel flat = test::flatOf(R"(
        model M
          parameter Real p = 2, a(fixed = false), b(fixed = false), c(fixed = false), d = 2*c;
          Real y = d*time;
        initial equation
          b = 3*a;
          p + 1 = a;
        initial algorithm
          c := b;
          while c < 100 loop c := 2*c; end while;
        end M;)");
    EXPECT_EQ(test::valueOf(flat, "b"), 9);
    EXPECT_EQ(test::valueOf(flat, "d"), 288);
    EXPECT_TRUE(flat.initialEquations.empty());
}

TEST(FreeParameter, IsFoundAtTheStartWhereTheModelDecidesIt) {
    const FlatModel flat = test::flatOf(R"(
        model M parameter Real k(fixed = false), twice = 2*k; Real x(start = 3, fixed = true);
        initial equation der(x) = 0;
        equation der(x) = twice - x;
        end M;)");
    EXPECT_EQ(flat.initialEquations.size(), 1u);
    EXPECT_EQ(flat.equations.size(), 3u) << "that of x, that k stays, that twice follows it";
}

TEST(FreeParameter, IsRefusedWithWhatItsFunctionAsserts) {
    EXPECT_THAT(test::faultsOf(R"(
        function rootOf input Real a; output Real x; algorithm assert(a >= 0, "no root"); x := sqrt(a); end rootOf;
        model M parameter Real p = -1, a(fixed = false); Real y = a*time; initial equation a = rootOf(p); end M;)"),
                testing::ElementsAre("no root | the condition of 'assert' does not hold"));
}

/// A fit may take the parameter to where it does not hold.
TEST(AssertionOfAFunction, OnAParameterStaysACheck) {
    const std::string text = R"(
        function rootOf input Real a; output Real x; algorithm assert(a >= 0, "no root"); x := sqrt(a); end rootOf;
        model M parameter Real p = 1; Real y = rootOf(p)*time; end M;)";
    EXPECT_EQ(test::flatOf(text).events.checks.size(), 1u);
}

}  // namespace
}  // namespace analogon
