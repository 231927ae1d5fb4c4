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

}  // namespace
}  // namespace analogon
