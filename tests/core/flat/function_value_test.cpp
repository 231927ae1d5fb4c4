#include <cmath>

#include "tests/core/flat/flat_support.hpp"

namespace analogon {
namespace {

using namespace test;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string functions = R"(
    partial function Shape input Real x; output Real y; end Shape;
    function Square extends Shape; algorithm y := x*x; end Square;
    function Line extends Shape; input Real a; algorithm y := a*x; end Line;
    function twice input Shape shape; input Real x; output Real y; algorithm y := shape(shape(x)); end twice;
)";

TEST(FunctionValues, AreCalledByTheFunctionThatTakesThem) {
    EXPECT_THAT(equations(flatOf(functions + "model M Real x = twice(Square, 3); end M;")), ElementsAre("x = 81"));
    EXPECT_THAT(equations(flatOf(functions + "model M Real x = twice(function Line(a = 5), 3); end M;")),
                ElementsAre("x = 75"));
    EXPECT_THAT(faultsOf(functions + "model M Real x = Line(Square, 1); end M;"),
                Contains(HasSubstr("'Line' takes no function as its argument 'x'")));
}

TEST(FunctionValues, AScalarFunctionOfAnArrayIsCalledForEachElement) {
    EXPECT_THAT(equations(flatOf(functions + "model M Real x[2] = Square({2, 3}); end M;")),
                ElementsAre("x[1] = 4", "x[2] = 9"));
    EXPECT_THAT(equations(flatOf(functions + "model M Real x[2] = Line({2, 3}, 10); end M;")),
                ElementsAre("x[1] = 20", "x[2] = 30"));
    EXPECT_THAT(faultsOf(functions + "model M Real x[2] = Line({2, 3}, {1, 2, 3}); end M;"),
                Contains(HasSubstr("the arguments of 'Line' differ in size")));
    EXPECT_THAT(faultsOf("function f input Real x; output Real y, z; algorithm y := x; z := x; end f; "
                         "model M Real x[2] = f({1, 2}); end M;"),
                Contains(HasSubstr("'f' has several outputs and cannot be called for each element of an array")));
}

/// The one equation of the model at this time.
double atTime(const FlatModel& m, double time) {
    return m.pool->evaluate(m.equations.at(0).right, [&](const ExpressionNode&) { return time; });
}

const std::string complexNumbers = R"(
    record C Real re; Real im; end C;
    function first input C u; output Real y; algorithm y := u.re; end first;
)";

TEST(RecordArrays, AreReadByTheirElementsInFunctions) {
    const std::string text = complexNumbers + R"(
        function pairSum input C u[:]; output Real y; algorithm y := sum(u[k].re*u[k].im for k in 1:size(u, 1));
        end pairSum;
        function mixed input C u[:]; output Real y; protected C one; C some[2]; algorithm
          one := u[2]; some := u[{1, 2}]; y := first(u[1]) + 10*one.im + 100*some[2].re; end mixed;
        model M Real a = pairSum({C(1, 2), C(3, 4)}), b = mixed({C(1, 2), C(3, 4)}); end M;)";
    EXPECT_THAT(equations(flatOf(text)), ElementsAre("a = 14", "b = 341"));
}

TEST(RecordArrays, AreWrittenByTheirElementsInFunctions) {
    EXPECT_THAT(equations(flatOf(complexNumbers + R"(
        function turned input C u[2]; output Real y; protected C v[2]; algorithm
          v[1] := u[2]; v[2] := C(5, 7); v[2].im := 6; y := v[1].re + 10*v[1].im + 100*v[2].re + 1000*v[2].im; end turned;
        model M Real a = turned({C(1, 2), C(3, 4)}); end M;)")),
                ElementsAre("a = 6543"));
}

TEST(RecordArrays, WhatIsNoArrayHasNoElements) {
    EXPECT_THAT(faultsOf(functions + R"(
        function wrong input Shape shape; output Real y; algorithm y := shape[1]; end wrong;
        model M Real x = wrong(Square); end M;)"),
                ::testing::Not(::testing::IsEmpty()));
}

TEST(OpenLoops, TakeAsManyTurnsAsTheirConditionAllows) {
    const FlatModel m = flatOf(R"(
        function rows input Real table[:, 2]; input Real u; output Real y; protected Integer i;
        algorithm
          i := 1;
          while i < size(table, 1) and u >= table[i, 1] loop i := i + 1; end while;
          y := table[i, 2];
        end rows;
        model M Real y = rows([0, 10; 1, 20; 2, 30], time); end M;)");
    EXPECT_EQ(atTime(m, -1), 10);
    EXPECT_EQ(atTime(m, 0.5), 20);
    EXPECT_EQ(atTime(m, 1.5), 30);
    EXPECT_EQ(atTime(m, 9), 30);
}

TEST(OpenLoops, HaveNoValueWhereTheyWouldGoOn) {
    const FlatModel m = flatOf(R"(
        function count input Real u; output Real y;
        algorithm y := 0; while y < u loop y := y + 1; if y > 20 then break; end if; end while;
        end count;
        function climb input Real u; output Real y; algorithm y := 0; while y < u loop y := y + 1; end while; end climb;
        model M Real y = if time < 50 then count(time) else climb(time); end M;)");
    EXPECT_EQ(atTime(m, 2.5), 3);
    EXPECT_EQ(atTime(m, 40), 21);
    EXPECT_EQ(atTime(m, 60.5), 61);
    EXPECT_TRUE(std::isnan(atTime(m, 1000)));
}

}  // namespace
}  // namespace analogon
