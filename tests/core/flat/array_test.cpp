#include <ctime>

#include "tests/core/flat/flat_support.hpp"

namespace analogon {
namespace {

using namespace test;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Arrays, AreExpandedToScalars) {
    const FlatModel m = flatOf(R"(
        model M
          parameter Integer n = 3;
          parameter Real p[n] = {i^2 for i in 1:n};
          Real x[n](start = {1, 2, 3}, each unit = "K");
          Real s, d;
        equation
          for i in 1:n - 1 loop
            der(x[i]) = x[i + 1] - p[i]*x[i];
          end for;
          x[end] = 0;
          s = sum(x) + sum(p[k]*x[k] for k in 1:2) + max(p);
          d = x*p;
        end M;)");
    EXPECT_THAT(names(m), ElementsAre("n", "p[1]", "p[2]", "p[3]", "x[1]", "x[2]", "x[3]", "s", "d"));
    EXPECT_THAT(equations(m),
                ElementsAre("der(x[1]) = x[2] - p[1]*x[1]", "der(x[2]) = x[3] - p[2]*x[2]", "x[3] = 0",
                            "s = x[1] + x[2] + x[3] + (p[1]*x[1] + p[2]*x[2]) + max(max(p[1], p[2]), p[3])",
                            "d = p[1]*x[1] + p[2]*x[2] + x[3]*p[3]"));
    EXPECT_EQ(valueOf(m, "p[3]"), 9);
    EXPECT_EQ(variable(m, "x[2]").unit, "K");
    EXPECT_EQ(text(m, variable(m, "x[2]").start), "2");
    EXPECT_TRUE(variable(m, "n").isStructural);
}

TEST(Arrays, ElementwiseEquationsAndSlices) {
    const FlatModel m = flatOf(R"(
        model M
          parameter Real A[2, 2] = {{1, 2}, {3, 4}};
          Real x[2], y[2], z[2], w;
        equation
          x = A*y;
          y = {time, 2*time} + fill(1, 2);
          z = 2*x .* y - ones(2);
          w = A[2, :]*x + size(A, 1) + x[2:2]*ones(1);
        end M;)");
    EXPECT_THAT(equations(m), Contains("x[2] = A[2,1]*y[1] + A[2,2]*y[2]"));
    EXPECT_THAT(equations(m), Contains("y[2] = 2*time + 1"));
    EXPECT_THAT(equations(m), Contains("z[1] = 2*x[1]*y[1] - 1"));
    EXPECT_THAT(equations(m), Contains("w = A[2,1]*x[1] + A[2,2]*x[2] + 2 + x[2]"));
    EXPECT_EQ(valueOf(m, "A[2,1]"), 3);
}

TEST(Arrays, OfComponentsTakeTheirOwnPartOfAModification) {
    const FlatModel m = flatOf(R"(
        model M
          parameter Integer n = 3;
          Parts.Inertia rotor[n](J = {1, 2, 3}, each w(start = 7));
          Parts.SpringDamper shaft[n - 1](each c = 100);
        equation
          for i in 1:n - 1 loop
            connect(rotor[i].b, shaft[i].a);
            connect(shaft[i].b, rotor[i + 1].a);
          end for;
        end M;)");
    EXPECT_EQ(valueOf(m, "rotor[2].J"), 2);
    EXPECT_EQ(variable(m, "rotor[2].J").value.text(), "2");
    EXPECT_EQ(text(m, variable(m, "rotor[3].w").start), "7");
    EXPECT_EQ(valueOf(m, "shaft[2].c"), 100);
    EXPECT_THAT(equations(m), Contains("shaft[1].b.tau + rotor[2].a.tau = 0"));
    EXPECT_EQ(m.connections.size(), 4u);
    EXPECT_THAT(faultsOf("model M Parts.Inertia r[2](J = 3); end M;"),
                ElementsAre(HasSubstr("a single value is given to an array of components")));
    EXPECT_THAT(faultsOf("model M Parts.Inertia r[3](J = {3, 4}); end M;"),
                ElementsAre(HasSubstr("the value has size [2], the array of components is larger")));
}

TEST(Arrays, OfConnectorsAreConnectedElementByElement) {
    const FlatModel m = flatOf(R"(
        model Mux Parts.RealInput u[2]; Parts.RealOutput y; equation y = u[1] + u[2]; end Mux;
        model M Parts.RealInput a[2]; Parts.RealOutput b; Mux mux; equation connect(a, mux.u); connect(mux.y, b); end M;)");
    EXPECT_THAT(equations(m),
                ElementsAre("mux.y = mux.u[1] + mux.u[2]", "mux.u[1] = a[1]", "mux.u[2] = a[2]", "b = mux.y"));
    EXPECT_EQ(variable(m, "a[2]").causality, FlatCausality::Input);
}

TEST(Arrays, SizesMayComeFromValuesAndLaterParameters) {
    const FlatModel m = flatOf(R"(
        model M
          Real x[n] = fill(time, n);
          parameter Real k[:] = {1, 2, 3, 4};
          parameter Integer n = size(k, 1) - 2;
        end M;)");
    EXPECT_TRUE(m.find("x[2]").valid());
    EXPECT_FALSE(m.find("x[3]").valid());
    EXPECT_EQ(valueOf(m, "k[4]"), 4);
}

TEST(Arrays, ComponentsHaveASizeToo) {
    EXPECT_EQ(valueOf(flatOf("model M parameter Integer n = size(i, 1); Parts.Inertia i[3]; end M;"), "n"), 3);
}

TEST(Arrays, FaultsAreNamed) {
    EXPECT_THAT(faultsOf("model M Real x[3] = {1, 2}; end M;"),
                ElementsAre("the value of 'x' has size [2], the variable [3]"));
    EXPECT_THAT(faultsOf("model M Real x[3] = 1; end M;"), ElementsAre(HasSubstr("has size of a single value")));
    EXPECT_THAT(faultsOf("model M Real x[2]; equation x[1] = 1; x[3] = 1; end M;"),
                ElementsAre("the subscript 3 is outside 1:2"));
    EXPECT_THAT(faultsOf("model M Real x[2]; equation x = {1, 2, 3}; end M;"),
                ElementsAre("the sides of the equation differ in size: Real[2] and Integer[3]"));
    EXPECT_THAT(faultsOf("model M Real n = 2; Real x[n]; end M;"),
                ElementsAre("the size of 'x' must be an Integer, not Real"));
    EXPECT_THAT(faultsOf("model M Integer n = 2; Real x[n]; end M;"),
                ElementsAre(HasSubstr("the size of 'x' must be known before the simulation")));
    EXPECT_THAT(faultsOf("model M Real x[size(x, 1)]; end M;"), Contains(HasSubstr("depends on itself")));
    EXPECT_THAT(faultsOf("model M Real x[2], y; equation x = {1, 2}; y = x + 1; end M;"),
                ElementsAre(HasSubstr("'+' cannot be applied to Real[2] and Integer")));
}

TEST(Arrays, ComponentsOfDifferentSizesAreNoArrayTogether) {
    const std::string model =
        "model M model S parameter Integer n = 1; Real v[n]; equation v = fill(1.0, n); end S; "
        "S s[2](n = {%}); Real z; Real w[2]; equation z = s[2].v[1]; w = ";
    const auto sized = [&](const std::string& sizes) { return std::string(model).replace(model.find('%'), 1, sizes); };
    EXPECT_TRUE(flatOf(sized("2, 2") + "s.v[2]; end M;").find("w[2]").valid());
    EXPECT_THAT(
        faultsOf(sized("3, 1") + "s.v[3]; end M;"),
        ElementsAre(HasSubstr("'s[1].v' has the size [3] and 's[2].v' the size [1]; they are no array together")));
    EXPECT_THAT(faultsOf(sized("1, 3") + "s.v[1]; end M;"), ElementsAre(HasSubstr("no array together")));
}

/// Each subscript once went through the whole array.
TEST(Arrays, ALoopOverALongArrayCostsWhatItsElementsCost) {
    const std::clock_t begin = std::clock();
    const FlatModel m = flatOf(
        "model M Real v[100000]; equation v[1] = time; for i in 2:100000 loop v[i] = 2*v[i - 1]; end for; end M;");
    EXPECT_EQ(m.equations.size(), 100000u);
    EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 5);
}

TEST(Arrays, FillRepeatsAnArrayAsWell) {
    const FlatModel m = flatOf("model M Real x[2, 3] = fill({1, 2, 3}, 2); Real y[0, 2] = fill({1, 2}, 0); end M;");
    EXPECT_THAT(equations(m), Contains("x[2,3] = 3"));
    EXPECT_EQ(m.equations.size(), 6u);
}

TEST(Arrays, ASizeMaySpeakOfTheSizesBeforeIt) {
    const FlatModel m = flatOf(R"(
        block S parameter Real A[:, size(A, 1)] = [1, 2; 3, 4]; parameter Real B[size(A, 1), :] = [5; 6];
          Real x[size(A, 1)] = A*{1, 1}; end S;
        model M S s, t(A = identity(3), B = ones(3, 2), x = zeros(3)); end M;)");
    EXPECT_EQ(valueOf(m, "s.A[2,1]"), 3);
    EXPECT_TRUE(m.find("t.A[3,3]").valid());
    EXPECT_TRUE(m.find("t.B[3,2]").valid());
    EXPECT_THAT(faultsOf("model M parameter Real A[size(A, 2), :] = [1, 2]; end M;"),
                ElementsAre(HasSubstr("the size or condition of 'A' depends on itself")));
}

TEST(Arrays, TheLeastAndTheGreatestOfBooleansIsWhetherAllAndWhetherAnyIsTrue) {
    const FlatModel m = flatOf(R"(
        model M Real x; Boolean b[2] = {x > 1, x > 2}; Boolean all = min(b), any = max(b);
        parameter Boolean none = max({false, false}); equation x = time; end M;)");
    EXPECT_THAT(equations(m), Contains("all = b[1] and b[2]"));
    EXPECT_THAT(equations(m), Contains("any = b[1] or b[2]"));
    EXPECT_EQ(valueOf(m, "none"), 0);
    EXPECT_THAT(faultsOf("model M Real x = sum({true, false}); end M;"),
                Contains(HasSubstr("'sum' needs an array of numbers, not Boolean[2]")));
}

TEST(Arrays, OfNoBooleansAreAllTrueAndNoneIs) {
    const FlatModel model =
        flatOf("model M parameter Boolean b[0]; parameter Boolean all = min(b), any = max(b); end M;");
    EXPECT_EQ(valueOf(model, "all"), 1);
    EXPECT_EQ(valueOf(model, "any"), 0);
    EXPECT_THAT(faultsOf("model M parameter Real b[0]; parameter Real x = min(b); end M;"),
                ElementsAre(HasSubstr("'min' of an empty array")));
}

TEST(Arrays, AnArrayInBracketsByItselfKeepsItsDimensions) {
    const FlatModel m =
        flatOf("model M parameter Real a[2, 1, 2] = [{{{1, 2}}, {{3, 4}}}], b[2, 1] = [{5, 6}]; end M;");
    EXPECT_EQ(valueOf(m, "a[2,1,1]"), 3);
    EXPECT_EQ(valueOf(m, "b[2,1]"), 6);
}

}  // namespace
}  // namespace analogon
