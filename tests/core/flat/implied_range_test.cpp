#include "tests/core/flat/flat_support.hpp"

namespace analogon {
namespace {

using namespace test;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Ranges, ATypeIsASizeAndARange) {
    EXPECT_THAT(equations(flatOf("model M type E = enumeration(a, b); Real x[E]; equation "
                                 "for e in E loop x[e] = Integer(e); end for; end M;")),
                ElementsAre("x[1] = 1", "x[2] = 2"));
    EXPECT_THAT(equations(flatOf("model M Real x[Boolean]; equation "
                                 "for b in false:true loop x[b] = if b then 5 else 3; end for; end M;")),
                ElementsAre("x[1] = 3", "x[2] = 5"));
    EXPECT_THAT(faultsOf("model M type E = enumeration(a, b); Real x[E] = {1, 2}; Real y = x[1]; end M;"),
                Contains(HasSubstr("a subscript of this dimension is a value of E, not Integer")));
}

TEST(Ranges, AnIteratorWithoutARangeTakesTheDimensionWhoseSubscriptItIs) {
    EXPECT_THAT(equations(flatOf("model M Real x[2, 3]; equation for i, j loop x[i, j] = 10*i + j; end for; end M;")),
                ElementsAre("x[1,1] = 11", "x[1,2] = 12", "x[1,3] = 13", "x[2,1] = 21", "x[2,2] = 22", "x[2,3] = 23"));
    EXPECT_THAT(equations(flatOf("model M parameter Real p[3] = {1, 2, 4}; Real y = sum(p[i]*i for i); end M;")),
                ElementsAre("y = p[1] + p[2]*2 + p[3]*3"));
    EXPECT_THAT(faultsOf("model M Real x[2], y[3]; equation for i loop x[i] = 1; y[i] = 2; end for; end M;"),
                Contains(HasSubstr("the iterator 'i' stands for dimensions of different sizes")));
    EXPECT_THAT(faultsOf("model M Real x[2]; equation for i loop x[1] = i; end for; end M;"),
                Contains(HasSubstr("the iterator 'i' needs a range")));
}

TEST(Matrices, HaveIntegerPowers) {
    EXPECT_THAT(equations(flatOf("model M Real x[2, 2] = [1, 2; 3, 4]^2; end M;")),
                ElementsAre("x[1,1] = 7", "x[1,2] = 10", "x[2,1] = 15", "x[2,2] = 22"));
    EXPECT_THAT(equations(flatOf("model M Real x[2, 2] = [1, 2; 3, 4]^0; end M;")),
                ElementsAre("x[1,1] = 1", "x[1,2] = 0", "x[2,1] = 0", "x[2,2] = 1"));
}

TEST(Texts, AreSetByAnEquationOnce) {
    const FlatModel m = flatOf(
        "model M type E = enumeration(one, two); String s; String t = String(E.two); equation "
        "s = String(3.14159265, significantDigits = 4) + String(5.23, format = \"6.1f\"); "
        "assert(s == \"3.142   5.2\", s); assert(t == \"two\", t); end M;");
    EXPECT_EQ(variable(m, "s").text, "3.142   5.2");
    EXPECT_EQ(variable(m, "t").text, "two");
    EXPECT_THAT(faultsOf("model M String s; equation s = \"a\"; s = \"b\"; end M;"),
                Contains(HasSubstr("the text 's' is set twice")));
    EXPECT_THAT(faultsOf("model M String s; equation assert(s == \"a\", s); s = \"a\"; end M;"),
                Contains(HasSubstr("the text 's' is used before it is set")));
    EXPECT_THAT(faultsOf("model M String s = String(1.5, format = \"q\"); end M;"),
                Contains(HasSubstr("'q' is no format of a number")));
}

TEST(Checks, StandBelowAConditionThatChanges) {
    const FlatModel m = flatOf("model M Real x = time; equation if x > 1 then assert(x < 5, \"far\"); end if; end M;");
    EXPECT_EQ(m.events.checks.size(), 1u);
    EXPECT_THAT(texts(m, m.equations), ElementsAre("x = time"));
}

}  // namespace
}  // namespace analogon
