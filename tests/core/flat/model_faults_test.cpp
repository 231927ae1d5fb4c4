#include "tests/core/flat/flat_support.hpp"

namespace analogon {
namespace {

using namespace test;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

TEST(Balance, ASurplusOrALackNamesTheComponent) {
    const std::string source = R"(
        model Loose extends Parts.TwoFlanges; Real w; equation w = der(a.phi); a.phi = b.phi; end Loose;
        model Tight extends Parts.TwoFlanges; equation a.phi = b.phi; a.tau + b.tau = 0; a.phi = 1; end Tight;)";
    EXPECT_THAT(faultsOf(source + "model M Parts.Inertia i; Loose joint; equation connect(i.b, joint.a); end M;"),
                ElementsAre(HasSubstr("component 'joint' (Loose) has 4 equations for 5 unknowns: 1 too few")));
    EXPECT_THAT(faultsOf(source + "model M Tight joint; end M;"),
                ElementsAre(HasSubstr("component 'joint' (Tight) has 5 equations for 4 unknowns: 1 too many")));
    EXPECT_THAT(faultsOf("model M Real x, lost; equation x = 1; end M;"),
                ElementsAre("model 'M' has 1 equation for 2 unknowns: 1 too few | no equation holds lost"));
    EXPECT_THAT(faultsOf("connector Out = output Real; model M Real x; Out lost; equation x = 1; end M;"),
                ElementsAre("model 'M' has 1 equation for 2 unknowns: 1 too few | no equation holds the output lost"));
    EXPECT_THAT(faultsOf("model M Real x; equation x = 1; x = 2; end M;"),
                ElementsAre(HasSubstr("model 'M' has 2 equations for 1 unknown: 1 too many")));
}

TEST(Balance, AConnectorNeedsAsManyFlowsAsPotentials) {
    EXPECT_THAT(faultsOf(R"(
        connector Bad Real p; Real T; flow Real m; end Bad;
        model M Bad b; equation b.p = 1; b.T = 2; end M;)"),
                ElementsAre(HasSubstr("the connector Bad has 1 flow and 2 potential variables")));
}

TEST(Faults, UnknownNamesAreNamedWithASuggestion) {
    EXPECT_THAT(faultsOf("model M Real speed; equation der(sped) = 1; end M;"),
                ElementsAre("'sped' is not declared in model 'M' | did you mean 'speed'?"));
    EXPECT_THAT(faultsOf("model M Parts.Inertai i; end M;"),
                ElementsAre("the class 'Parts.Inertai' is not known in 'M' | did you mean 'Parts.Inertia'?"));
    EXPECT_THAT(faultsOf("model M extends Parts.Inerta; end M;"),
                ElementsAre(HasSubstr("did you mean 'Parts.Inertia'?")));
    EXPECT_THAT(faultsOf("model M Real x = sqr(2); end M;"),
                ElementsAre("the function 'sqr' is not known | did you mean 'sqrt'?"));
    EXPECT_THAT(faultsOf("model M Real x = pre(2); end M;"), ElementsAre("the function 'pre' is not supported"));
    EXPECT_THAT(faultsOf("model M Real x = 1; end M;", "N"), SizeIs(1));
    EXPECT_THAT(faultsOf("type E = enumeration(low, high); model M parameter E e = E.hihg; end M;"),
                ElementsAre(HasSubstr("did you mean 'high'?")));
}

TEST(Faults, TypesMustAgree) {
    EXPECT_THAT(faultsOf("model M parameter Integer n = 2.5; end M;"),
                ElementsAre("'n' is Integer and cannot be Real"));
    EXPECT_THAT(faultsOf("model M parameter Boolean b = 1; end M;"),
                ElementsAre("'b' is Boolean and cannot be Integer"));
    EXPECT_THAT(faultsOf("model M Real x; equation x = true; end M;"),
                ElementsAre("the sides of the equation differ in type: Real and Boolean"));
    EXPECT_THAT(faultsOf("model M Real x = if 1 then 2 else 3; end M;"),
                ElementsAre("the condition after 'if' must be Boolean, not Integer"));
    EXPECT_THAT(faultsOf("model M Real x = 1 + true; end M;"),
                ElementsAre(HasSubstr("'+' cannot be applied to Integer and Boolean")));
    EXPECT_THAT(faultsOf("model M Real x(unit = 3) = 1; end M;"),
                ElementsAre("the attribute 'unit' of 'x' cannot be Integer"));
    EXPECT_THAT(faultsOf("model M Real x = sin(1, 2); end M;"), ElementsAre("'sin' takes 1 argument, not 2"));
    EXPECT_THAT(faultsOf("model M Parts.Fixed f; Real x = f; end M;"),
                ElementsAre(HasSubstr("'f' is a component of class Parts.Fixed, not a value")));
}

TEST(Faults, ParametersNeedAConstantValue) {
    EXPECT_THAT(faultsOf("model M Parts.SpringDamper s; end M;"),
                ElementsAre("the parameter 's.c' has no value | give it one, for example c = 1"));
    EXPECT_THAT(faultsOf("model M parameter Real a = b + 1; parameter Real b = 2*c; parameter Real c = a; end M;"),
                ElementsAre(HasSubstr("parameters depend on each other: a -> b -> c -> a")));
    EXPECT_THAT(faultsOf("model M Real x = 1; parameter Real a = 2*x; end M;"),
                ElementsAre(HasSubstr("the parameter 'a' depends on 'x', which changes while the model runs")));
    EXPECT_THAT(faultsOf("model M Real x = 1; Real y(start = x) = 2; end M;"),
                ElementsAre(HasSubstr("the start value of 'y' changes while the model runs")));
    EXPECT_THAT(faultsOf("model M parameter Real a = time; end M;"), ElementsAre(HasSubstr("depends on time")));
    EXPECT_THAT(faultsOf("model M parameter Integer n = n; Real x[n]; end M;"), Contains(HasSubstr("the size of 'x'")));
}

TEST(Faults, OnlyWholeModelsCanBeFlattened) {
    EXPECT_THAT(faultsOf("model M end M;", "Parts"), ElementsAre(HasSubstr("'Parts' is a package, not a model")));
    EXPECT_THAT(faultsOf("model M end M;", "Parts.TwoFlanges"), ElementsAre(HasSubstr("is partial")));
    EXPECT_THAT(faultsOf("model M Parts p; end M;"),
                ElementsAre(HasSubstr("'p' cannot be a component: Parts is a package")));
}

TEST(Faults, PointAtTheirPlace) {
    const auto model = flatten(libraryOf("model M\n  Parts.Inertia i(Q = 3);\nend M;"), "M");
    ASSERT_FALSE(model);
    ASSERT_EQ(model.diagnostics().size(), 1u);
    EXPECT_EQ(model.diagnostics()[0].place.line, 2);
    EXPECT_EQ(model.diagnostics()[0].place.column, 19);
    EXPECT_EQ(model.diagnostics()[0].place.file, "test.mo");
}

TEST(Faults, AreBoundedInNumber) {
    std::string source = "model M ";
    for (int i = 0; i < 500; ++i) source += "Real x" + std::to_string(i) + " = unknown" + std::to_string(i) + "; ";
    EXPECT_THAT(faultsOf(source + "end M;"), SizeIs(20));
    // An array repeats its faults in each element; they are told once.
    EXPECT_THAT(faultsOf("model N Real y = lost; end N; model M N n[100]; end M;"), SizeIs(testing::Le(20u)));
}

}  // namespace
}  // namespace analogon
