#include "tests/core/flat/flat_support.hpp"

namespace analogon {
namespace {

using namespace test;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Flatten, ASingleModelBecomesScalarEquations) {
    const FlatModel m = flatOf(R"(
        model M "decay"
          parameter Real a(unit = "1/s") = 2;
          Real x(start = 1, fixed = true, min = 0, max = 10, nominal = 3) "level";
          output Real y;
        initial equation
          y = 2;
        equation
          der(x) = -a*x;
          y = x^2;
        end M;)");
    EXPECT_EQ(m.name, "M");
    EXPECT_THAT(names(m), ElementsAre("a", "x", "y"));
    EXPECT_THAT(equations(m), ElementsAre("der(x) = -a*x", "y = x^2"));
    EXPECT_THAT(texts(m, m.initialEquations), ElementsAre("y = 2"));
    EXPECT_EQ(valueOf(m, "a"), 2);
    const FlatVariable& x = variable(m, "x");
    EXPECT_EQ(x.description, "level");
    EXPECT_TRUE(x.isFixed);
    EXPECT_EQ(text(m, x.start), "1");
    EXPECT_EQ(x.min, 0.0);
    EXPECT_EQ(x.max, 10.0);
    EXPECT_EQ(x.nominal, 3.0);
    EXPECT_EQ(variable(m, "y").causality, FlatCausality::Output);
    EXPECT_EQ(variable(m, "a").variability, FlatVariability::Parameter);
    EXPECT_EQ(variable(m, "a").unit, "1/s");
}

TEST(Flatten, InheritedElementsComeFirstAndTypeAliasesCarryAttributes) {
    const FlatModel m = flatOf("model M Parts.Inertia rotor(J = 3, w(start = 5)); end M;");
    EXPECT_THAT(names(m), ElementsAre("rotor.a.phi", "rotor.a.tau", "rotor.b.phi", "rotor.b.tau", "rotor.J",
                                      "rotor.phi", "rotor.w"));
    EXPECT_EQ(variable(m, "rotor.phi").unit, "rad");
    EXPECT_EQ(variable(m, "rotor.phi").displayUnit, "deg");
    EXPECT_EQ(variable(m, "rotor.phi").quantity, "Angle");
    EXPECT_TRUE(variable(m, "rotor.a.tau").isFlow);
    EXPECT_EQ(valueOf(m, "rotor.J"), 3);
    EXPECT_EQ(text(m, variable(m, "rotor.w").start), "5");
    EXPECT_THAT(equations(m),
                ElementsAre("rotor.phi = rotor.a.phi", "rotor.phi = rotor.b.phi", "rotor.w = der(rotor.phi)",
                            "rotor.J*der(rotor.w) = rotor.a.tau + rotor.b.tau", "rotor.a.tau = 0", "rotor.b.tau = 0"));
}

TEST(Flatten, TheSpanOfAValueIsWhereItStands) {
    const std::string source = "model M Parts.Inertia rotor(J = 3.25); Parts.Inertia other; end M;";
    const FlatModel m = flatOf(source);
    EXPECT_EQ(variable(m, "rotor.J").value.text(), "3.25");
    EXPECT_EQ(variable(m, "other.J").value.text(), "1");
    EXPECT_EQ(variable(m, "rotor.J").declared.text(), "J");
}

TEST(Flatten, ListsComponentsWithTheirBalance) {
    const FlatModel m = flatOf(R"(
        model Pair
          Parts.Inertia left; Parts.Inertia right; Parts.Flange shaft;
        equation
          connect(shaft, left.a); connect(left.b, right.a);
        end Pair;
        model M Pair pair; Parts.Fixed wall; equation connect(wall.flange, pair.shaft); end M;)");
    ASSERT_EQ(m.components.size(), 4u);
    std::vector<std::string> listed;
    for (const FlatComponent& c : m.components) {
        listed.push_back(c.name + ": " + c.className);
        EXPECT_EQ(c.unknowns, c.equations) << c.name;
    }
    EXPECT_THAT(listed, ElementsAre("pair: Pair", "pair.left: Parts.Inertia", "pair.right: Parts.Inertia",
                                    "wall: Parts.Fixed"));
}

TEST(Flatten, BindingOfAVariableIsAnEquation) {
    const FlatModel m = flatOf("model M Real x = 2*time; Real y(start = 1) = x + 1; end M;");
    EXPECT_THAT(equations(m), ElementsAre("x = 2*time", "y = x + 1"));
    EXPECT_FALSE(variable(m, "x").binding.valid());
}

TEST(Flatten, DerOfAnExpressionFollowsTheChainRule) {
    const FlatModel m = flatOf(R"(
        model M
          parameter Real p = 2;
          Real x, y, z;
        equation
          z = der(p*x - y*x);
          der(x) = 1;
          y = der(der(x)) + time;
        end M;)");
    EXPECT_THAT(equations(m), Contains("z = p*der(x) - (der(y)*x + y*der(x))"));
    EXPECT_THAT(equations(m), Contains("der(x) = der(x)"));  // the variable named der(x), and the derivative
    EXPECT_THAT(equations(m), Contains("y = der(der(x)) + time"));
    EXPECT_TRUE(m.find("der(x)").valid());
}

TEST(Flatten, BuiltInFunctionsKeepTheirMeaning) {
    const FlatModel m = flatOf(R"(
        model M
          input Real u;
          parameter Real T = 0.5;
          Real a, b, c, d, e, f;
        equation
          a = noEvent(if u > 0 then sqrt(u) else 0);
          b = smooth(1, u*abs(u));
          c = homotopy(actual = u^3, simplified = u);
          d = delay(u, T);
          e = atan2(u, 2) + mod(u, 3) + rem(u, 3) + div(u, 3) + max(u, 1) + min(u, -1);
          f = exp(sin(u)) + integer(u) + sign(u) + floor(u) + ceil(u) + log10(3 + tanh(u));
        end M;)");
    EXPECT_THAT(
        equations(m),
        ElementsAre("a = noEvent(if u > 0 then sqrt(u) else 0)", "b = smooth(1, u*abs(u))", "c = u^3",
                    "d = delay(u, T)", "e = atan2(u, 2) + mod(u, 3) + rem(u, 3) + div(u, 3) + max(u, 1) + min(u, -1)",
                    "f = exp(sin(u)) + floor(u) + sign(u) + floor(u) + ceil(u) + log10(3 + tanh(u))"));
}

TEST(Flatten, ATableIsLookedUpByTheLibraryFunctions) {
    const FlatModel m = flatOf(R"(
        model M
          input Real u;
          parameter Real xs[3] = {0, 1, 2};
          parameter Real ys[3] = {0, 10, 40};
          Real y, z;
        equation
          y = Analogon.Tables.linear(u, xs, ys);
          z = Analogon.Tables.monotoneCubic(u, {0, 1}, {0, 1});
        end M;)");
    const double y = m.pool->evaluate(m.equations[0].right, [](const ExpressionNode&) { return 1.5; });
    EXPECT_DOUBLE_EQ(y, 25);
    EXPECT_TRUE(variable(m, "ys[2]").isStructural);
    EXPECT_THAT(faultsOf("model M Real y = Analogon.Tables.linear(time, {0, 0}, {1, 2}); end M;"),
                ElementsAre(HasSubstr("must rise: 0 follows 0")));
}

TEST(Flatten, KnowsTheInterpolationOfTheStandardLibrary) {
    const FlatModel m = flatOf(R"(model M input Real u;
        Real y = Modelica.Math.Vectors.interpolate({0, 1, 3}, {0, 2, 4}, u);
        Real z = Analogon.Tables.linear(u, {0, 1, 3}, {0, 2, 4}); end M;)");
    EXPECT_EQ(m.equations[0].right, m.equations[1].right);
    EXPECT_THAT(faultsOf("model M Real y = Modelica.Math.Vectors.interpolate({1, 0}, {0, 2}, time); end M;"),
                ElementsAre(HasSubstr("the abscissas of the table must rise: 0 follows 1")));
    EXPECT_THAT(faultsOf("model M Real y = Modelica.Constants.pi; end M;"),
                ElementsAre(HasSubstr(
                    "'Modelica.Constants.pi' belongs to the Modelica Standard Library, which was not found")));
}

TEST(Flatten, AnIntegerHasNoDerivative) {
    EXPECT_THAT(faultsOf("model M Integer k; equation der(k) = 1; end M;"),
                ElementsAre(HasSubstr("der needs a Real variable")));
    EXPECT_TRUE(flatOf("model M parameter Real p = 1; Real x = der(p); end M;").equations.size() == 1);
}

TEST(Flatten, ParameterValuesFollowTheirBindings) {
    const FlatModel m = flatOf(R"(
        package Data constant Real g = 9.81; constant Real twice = 2*g; end Data;
        type Mode = enumeration(off, slow, fast);
        model M
          parameter Real a = 2;
          parameter Real b = a*Data.twice;
          final parameter Real c = if mode == Mode.fast then b else 0;
          parameter Mode mode = Mode.fast;
          parameter Boolean on = a > 1 and not (b < 0);
          parameter Integer n(start = 4);
          parameter String file = "base" + ".csv";
          Real x = if on then a else b;
        end M;)");
    EXPECT_DOUBLE_EQ(valueOf(m, "b"), 2 * 2 * 9.81);
    EXPECT_DOUBLE_EQ(valueOf(m, "c"), 2 * 2 * 9.81);
    EXPECT_DOUBLE_EQ(valueOf(m, "on"), 1);
    EXPECT_DOUBLE_EQ(valueOf(m, "n"), 4);
    EXPECT_TRUE(variable(m, "c").isFinal);
    EXPECT_EQ(variable(m, "file").text, "base.csv");
    EXPECT_FALSE(m.parameterValue(m.find("x")).has_value());
}

TEST(Flatten, AShortClassOfAnEnumerationHasItsValues) {
    const FlatModel flat = flatOf(R"(
        package P
          type Kind = enumeration(smooth, rough);
          function f input Kind k; output Real y;
            type T = Kind;
            algorithm y := if k == T.rough then 2 else 1; end f;
        end P;
        model M parameter Real y = P.f(P.Kind.rough), z = P.f(P.Kind.smooth); end M;)");
    EXPECT_EQ(valueOf(flat, "y"), 2);
    EXPECT_EQ(valueOf(flat, "z"), 1);
}

TEST(Flatten, IfEquationsOnParametersChooseTheirBranch) {
    const std::string source = R"(
        model Base
          parameter Boolean useLoss = false;
          parameter Integer order = 1;
          Real x;
        equation
          if useLoss then
            der(x) = -x;
          elseif order == 1 then
            der(x) = 1;
          else
            x = 1;
          end if;
        end Base;
        model M extends Base; end M;
        model N extends Base(useLoss = true); end N;
        model O extends Base(order = 2); end O;)";
    EXPECT_THAT(equations(flatOf(source)), ElementsAre("der(x) = 1"));
    EXPECT_THAT(equations(flatOf(source, "N")), ElementsAre("der(x) = -x"));
    EXPECT_THAT(equations(flatOf(source, "O")), ElementsAre("x = 1"));
    EXPECT_TRUE(variable(flatOf(source), "order").isStructural);
}

TEST(Flatten, IfEquationsOnVariablesBecomeIfExpressions) {
    EXPECT_THAT(equations(flatOf(R"(
        model M input Real u; Real x, y;
        equation
          if u > 1 then x = 1; y + x = u; elseif u > 0 then x = 2; y = 3; else x = 3; y = 4; end if;
        end M;)")),
                ElementsAre("x = if u > 1 then 1 else if u > 0 then 2 else 3",
                            "0 = if u > 1 then y + x - u else if u > 0 then y - 3 else y - 4"));
    EXPECT_THAT(faultsOf("model M Real x; equation if time > 1 then x = 1; end if; end M;"),
                ElementsAre(HasSubstr("needs as many equations in each branch")));
}

TEST(Flatten, AssertionsOnParametersAreChecked) {
    const std::string source = R"(
        model Part parameter Real R = 1; equation assert(R > 0, "R must be positive"); end Part;)";
    EXPECT_THAT(equations(flatOf(source + "model M Part p(R = 2); end M;")), IsEmpty());
    EXPECT_THAT(faultsOf(source + "model M Part p(R = -2); end M;"),
                ElementsAre(HasSubstr("component 'p' (Part): R must be positive")));
}

TEST(Flatten, ConditionalComponentsComeAndGoWithTheirConnections) {
    const std::string source = R"(
        model Base
          parameter Boolean loaded = true;
          Parts.Inertia rotor;
          Parts.Inertia load(J = 2) if loaded;
        equation
          connect(rotor.b, load.a);
        end Base;
        model M extends Base; end M;
        model N extends Base(loaded = false); end N;)";
    EXPECT_TRUE(flatOf(source).find("load.J").valid());
    const FlatModel without = flatOf(source, "N");
    EXPECT_FALSE(without.find("load.J").valid());
    EXPECT_THAT(equations(without), Contains("rotor.b.tau = 0"));
    EXPECT_THAT(faultsOf(source + "model O extends Base(loaded = false); Real x = load.J; end O;", "O"),
                ElementsAre(HasSubstr("'load' is switched off by its condition")));
}

TEST(Flatten, RecordsGroupParameters) {
    const std::string source = R"(
        record Motor parameter Real R = 1; parameter Real k = 2; end Motor;
        record Small = Motor(R = 5);
        model Drive parameter Motor data; Real v = data.R*time; end Drive;
        model M
          parameter Motor large(k = 7);
          Small other;
          Drive first(data = large);
          Drive second(data(R = 3));
        end M;)";
    const FlatModel m = flatOf(source);
    EXPECT_EQ(valueOf(m, "first.data.k"), 7);
    EXPECT_EQ(valueOf(m, "first.data.R"), 1);
    EXPECT_EQ(valueOf(m, "second.data.R"), 3);
    EXPECT_EQ(valueOf(m, "other.R"), 5);
    EXPECT_THAT(equations(m), ElementsAre("first.v = first.data.R*time", "second.v = second.data.R*time"));
}

TEST(Flatten, PrintsAReadableListing) {
    EXPECT_EQ(print(flatOf(R"(
        model M
          parameter Real a(unit = "1/s", min = 0) = 2;
          parameter Boolean on = true;
          input Real u;
          Real x(start = 1, fixed = true);
        protected
          final parameter Real b = 2*a;
        initial equation
          der(x) = 0;
        equation
          der(x) = -a*x + (if on then u else b);
        end M;)")),
              R"(model M
  parameter Real a(unit = "1/s", min = 0) = 2;
  parameter Boolean on = true;
  input Real u;
  Real x(start = 1, fixed = true);
  protected final parameter Real b = 2*a;
initial equation
  der(x) = 0;
equation
  der(x) = (if on then u else b) - a*x;
end M;
)");
}

TEST(Flatten, AnEnumerationIsTheSameUnderEveryShortClass) {
    const FlatModel m = flatOf(R"(
        package P
          type Level = enumeration(low, high);
          connector In = input Level; connector Out = output Level;
        end P;
        model Source P.Out y; equation y = if time < 1 then P.Level.low else P.Level.high; end Source;
        model M P.In u; P.Out w; Boolean isHigh; Source s; equation connect(s.y, w); isHigh = u == P.Level.high; end M;)");
    EXPECT_THAT(texts(m, m.equations), Contains("isHigh = u == 2"));
    EXPECT_THAT(faultsOf("package P type A = enumeration(a); type B = enumeration(a); connector In = input A; end P; "
                         "model M P.In u; Boolean b = u == P.B.a; end M;"),
                ElementsAre(HasSubstr("'==' cannot compare P.A with P.B")));
}

}  // namespace
}  // namespace analogon
