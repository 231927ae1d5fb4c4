#include "tests/core/flat/flat_support.hpp"

namespace analogon {
namespace {

using namespace test;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Numbers with two parts, which have operators of their own.
const std::string number = R"(
    operator record Complex
      Real re;
      Real im;
      encapsulated operator 'constructor'
        function fromReal
          import Complex;
          input Real re;
          input Real im = 0;
          output Complex result(re = re, im = im);
        algorithm
        end fromReal;
      end 'constructor';
      encapsulated operator '-'
        function negate
          import Complex;
          input Complex c;
          output Complex d;
        algorithm
          d := Complex(-c.re, -c.im);
        end negate;
        function subtract
          import Complex;
          input Complex a, b;
          output Complex d;
        algorithm
          d := Complex(a.re - b.re, a.im - b.im);
        end subtract;
      end '-';
      encapsulated operator function '+'
        import Complex;
        input Complex a, b;
        output Complex d;
      algorithm
        d := Complex(a.re + b.re, a.im + b.im);
      end '+';
      encapsulated operator function '*'
        import Complex;
        input Complex a, b;
        output Complex d;
      algorithm
        d := Complex(a.re*b.re - a.im*b.im, a.re*b.im + a.im*b.re);
      end '*';
    end Complex;
    connector Output = output Complex;
)";

TEST(ComplexNumbers, HaveTheOperatorsOfTheirRecord) {
    EXPECT_THAT(equations(flatOf(number + "model M Complex z = Complex(1, 2)*Complex(3, 4) - Complex(1, 1); end M;")),
                ElementsAre("z.re = -6", "z.im = 9"));
    EXPECT_THAT(equations(flatOf(number + "model M Complex z = -Complex(1, 2) + 5; end M;")),
                ElementsAre("z.re = 4", "z.im = -2"));
    EXPECT_THAT(equations(flatOf(number + "model M Complex z = sum({Complex(1, 2), 2*Complex(1, 1)}); end M;")),
                ElementsAre("z.re = 3", "z.im = 4"));
    EXPECT_THAT(equations(flatOf(number + "model M Complex z[2] = {Complex(1, 2), Complex(3)} + "
                                          "{Complex(1), Complex(1)}; end M;")),
                ElementsAre("z[1].re = 2", "z[1].im = 2", "z[2].re = 4", "z[2].im = 0"));
    EXPECT_THAT(faultsOf(number + "model M Complex z = Complex(1)/Complex(2); end M;"),
                Contains(HasSubstr("'/' cannot be applied to Complex and Complex")));
    EXPECT_THAT(faultsOf(number + "model M Complex z = Complex(true); end M;"),
                Contains(HasSubstr("'Complex' cannot be made of these arguments")));
}

TEST(ComplexNumbers, AreSignals) {
    EXPECT_THAT(equations(flatOf(number + "model M Output y = Complex(1, 2); Output w; equation w = y + y; end M;")),
                ElementsAre("y.re = 1", "y.im = 2", "w.re = y.re + y.re", "w.im = y.im + y.im"));
    EXPECT_THAT(
        equations(flatOf(number + "model M Complex z = if time > 1 then Complex(1) else Complex(2, 3); end M;")),
        ElementsAre("z.re = if time > 1 then 1 else 2", "z.im = if time > 1 then 0 else 3"));
}

// As Modelica.ComplexMath.sin calls the exp beside it; `.exp` is that of the language.
TEST(ComplexNumbers, HaveFunctionsThatHideThoseOfTheLanguage) {
    const FlatModel flat = flatOf(number + R"(
        package CM
          function exp input Complex c; output Complex d;
            algorithm d := Complex(.exp(c.re)*.cos(c.im), .exp(c.re)*.sin(c.im)); end exp;
          function twice input Complex c; output Complex d; algorithm d := exp(Complex(2*c.re, 2*c.im)); end twice;
        end CM;
        model M parameter Complex z = CM.twice(Complex(0.5, 0)); parameter Real e = exp(1); end M;)");
    EXPECT_NEAR(valueOf(flat, "z.re"), valueOf(flat, "e"), 1e-12);
}

TEST(ComplexNumbers, AreTheOnlyRecordsWithOperators) {
    EXPECT_THAT(faultsOf("operator record R Real x; end R; model M R r(x = 1); end M;"),
                Contains(HasSubstr("operator classes are not supported")));
}

}  // namespace
}  // namespace analogon
