#include "tests/core/flat/flat_support.hpp"

namespace analogon {
namespace {

using namespace test;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(ClassRules, NamesOfTheLanguageAreKept) {
    EXPECT_THAT(faultsOf("model M Real Boolean = 1; end M;"),
                Contains(HasSubstr("'Boolean' is a type of the language; nothing else may have this name")));
    EXPECT_THAT(faultsOf("model M model String Real x = 1; end String; Real y = 2; end M;"),
                Contains(HasSubstr("'String' is a type of the language")));
}

TEST(ClassRules, LiteralsAreDistinctAndNoAttributes) {
    EXPECT_THAT(faultsOf("model M type E = enumeration(a, b, a); E e = E.b; end M;"),
                Contains(HasSubstr("'a' stands twice among the values of the enumeration M.E")));
    EXPECT_THAT(faultsOf("model M type E = enumeration(a, min); E e = E.a; end M;"),
                Contains(HasSubstr("'min' cannot be a value of the enumeration M.E")));
}

TEST(ClassRules, RecordsAndConnectorsHoldPublicVariablesOnly) {
    EXPECT_THAT(faultsOf("model M record R Real x; initial equation x = 1; end R; R r(x = time); end M;"),
                Contains(HasSubstr("a record has no equations and no algorithms")));
    EXPECT_THAT(faultsOf("model M record R Real x = 1; protected Real y = 2; end R; R r; end M;"),
                Contains(HasSubstr("'y' cannot be protected in a record")));
    EXPECT_THAT(faultsOf("model M record R output Real x = 1; end R; R r; end M;"),
                Contains(HasSubstr("'x' cannot be output in a record")));
    EXPECT_THAT(faultsOf("model M connector C inner Real e = 1; flow Real f; end C; C c; end M;"),
                Contains(HasSubstr("'e' cannot be inner in a connector")));
}

TEST(ClassRules, AClassExtendsItsOwnKindOnly) {
    EXPECT_THAT(faultsOf("model M block B Real y = 1; end B; record R extends B; end R; R r; end M;"),
                Contains(HasSubstr("'M.R' is a record and cannot extend M.B, which is a block")));
    EXPECT_THAT(faultsOf("model M model A Real y = 1; end A; block B extends A; end B; B b; end M;"),
                Contains(HasSubstr("'M.B' is a block and cannot extend M.A, which is a model")));
    EXPECT_THAT(faultsOf("model M block B output Real y = 1; end B; model A extends B; end A; A a; end M;"), IsEmpty());
    EXPECT_THAT(faultsOf("model M replaceable model A Real x = 1; end A; extends A; end M;"),
                Contains(HasSubstr("the base class 'M.A' is replaceable")));
    EXPECT_THAT(
        faultsOf(
            "model M model A Real x = 1; end A; model A3 = A[3]; model B extends A3; Real y = 1; end B; B b; end M;"),
        Contains(HasSubstr("a class that extends it can hold nothing else")));
}

TEST(ClassRules, FunctionsHaveOneAlgorithmAndKeepTheirInputs) {
    const auto function = [](const std::string& body) {
        return "model M function f input Real a; output Real b; " + body + " end f; Real x = f(2); end M;";
    };
    EXPECT_THAT(faultsOf(function("algorithm a := 1; b := a;")),
                Contains(HasSubstr("'a' is an input of the function and cannot be assigned")));
    EXPECT_THAT(faultsOf(function("algorithm b := a; algorithm b := 2;")),
                Contains(HasSubstr("a function has one algorithm and no initial one")));
    EXPECT_THAT(faultsOf(function("Real c; algorithm c := a; b := c;")),
                Contains(HasSubstr("'c' of the function M.f is neither input nor output nor protected")));
    EXPECT_THAT(faultsOf(function("algorithm b := a*time;")),
                Contains(HasSubstr("'time' can be used in models and blocks only")));
    EXPECT_THAT(faultsOf("model M partial function f input Real a; output Real b; algorithm b := a; end f; "
                         "Real x = f(2); end M;"),
                Contains(HasSubstr("the function 'M.f' is partial and cannot be called")));
    EXPECT_THAT(faultsOf(function("algorithm b := a;")), IsEmpty());
}

TEST(ClassRules, BreakReturnAndWhenStandWhereTheyMeanSomething) {
    EXPECT_THAT(faultsOf("model M Real x; algorithm x := 1; break; end M;"),
                Contains(HasSubstr("'break' stands outside of a loop")));
    EXPECT_THAT(faultsOf("model M Real x; algorithm x := 1; return; end M;"),
                Contains(HasSubstr("'return' stands outside of a function")));
    EXPECT_THAT(faultsOf("model M Real x; algorithm when time > 1 then when time > 2 then x := 1; end when; end when; "
                         "end M;"),
                Contains(HasSubstr("'when' cannot stand within another 'when'")));
    EXPECT_THAT(faultsOf("model M Real x; algorithm while 1 loop x := 1; end while; end M;"),
                Contains(HasSubstr("the condition after 'while' must be Boolean")));
}

TEST(ClassRules, WhatIsProtectedOrInNoPackageIsNotReachedByADot) {
    EXPECT_THAT(faultsOf("model M package P protected constant Real y = 3; end P; Real x = P.y; end M;"),
                Contains(HasSubstr("'y' of M.P is protected")));
    EXPECT_THAT(faultsOf("model M model A Real x = 1; model B Real y = 2; end B; end A; A.B b; end M;"),
                Contains(HasSubstr("'M.A' is no package: 'B' in it cannot be used from outside")));
    EXPECT_THAT(faultsOf("model M model A Real x = 1; encapsulated model B Real y = 2; end B; end A; A.B b; end M;"),
                IsEmpty());
    EXPECT_THAT(faultsOf("package P constant Real x = 4; model A Real x = 3; model B Real y = x; end B; B b; end A; "
                         "end P; model M P.A a; end M;"),
                Contains(HasSubstr("'x' is not declared")));
}

TEST(ClassRules, ImportsNameElementsOfPackages) {
    const std::string package =
        "package P constant Real x = 1; protected constant Real y = 2; end P; "
        "package Q constant Real x = 3; end Q; model A Real z = 1; model B Real z = 1; end B; end A; ";
    EXPECT_THAT(faultsOf(package + "model M import P.x; Real u = x; end M;"), IsEmpty());
    EXPECT_THAT(faultsOf(package + "model M import P.y; Real u = y; end M;"),
                Contains(HasSubstr("'y' of P is protected")));
    EXPECT_THAT(faultsOf(package + "model M import A.B; B b; end M;"),
                Contains(HasSubstr("'A.B' is no package and no element of a package")));
    EXPECT_THAT(faultsOf(package + "model M import P; import P = Q; Real u = P.x; end M;"),
                Contains(HasSubstr("two imports have the same name 'P'")));
}

TEST(Prefixes, BelongToVariables) {
    EXPECT_THAT(faultsOf("model M model A Real x = 1; end A; parameter A a; end M;"),
                Contains(HasSubstr("'a' is a model and cannot have the prefix of a variable")));
    EXPECT_THAT(faultsOf("model M connector C input Real x = 1; end C; constant C c; end M;"),
                Contains(HasSubstr("'c' is a connector and cannot have the prefix of a variable")));
    EXPECT_THAT(faultsOf("model M connector C Real e; flow Integer f; end C; C c(e = 1); end M;"),
                Contains(HasSubstr("'f' is a flow and must be Real, not Integer")));
    EXPECT_THAT(
        faultsOf("model M connector C Real e; flow Real f; output Real x; end C; output C c(e = 1, x = 2); end M;"),
        Contains(HasSubstr("'x' is an input or output, and so is 'c', which holds it")));
    EXPECT_THAT(faultsOf("model M Real x = 2 if true; Real y = x; end M;"),
                Contains(HasSubstr("'x' is declared on a condition")));
    EXPECT_THAT(faultsOf("model M parameter Real x = 6; constant Real y = x; Real z = y; end M;"),
                Contains(HasSubstr("the constant 'y' depends on the parameter 'x'")));
}

TEST(Redeclarations, LeaveFinalConstantAndVisibilityAsTheyAre) {
    EXPECT_THAT(
        faultsOf("model M model A replaceable constant Real x = 1; end A; extends A; redeclare Real x = 2; end M;"),
        Contains(HasSubstr("'x' is a constant and cannot be redeclared")));
    EXPECT_THAT(
        faultsOf("model M model A final replaceable Real x = 2; end A; extends A; redeclare Real x = 3; end M;"),
        Contains(HasSubstr("'x' is final and cannot be redeclared")));
    EXPECT_THAT(
        faultsOf("model M model A replaceable Real x = 2; end A; extends A; protected redeclare Real x = 3; end M;"),
        Contains(HasSubstr("'x' is public where it is inherited from, and protected here")));
    EXPECT_THAT(faultsOf("model M model A protected replaceable model B Real x = 2; end B; B b; end A; "
                         "model C Real x = 3; end C; A a(redeclare model B = C); end M;"),
                Contains(HasSubstr("'B' of 'M.A' is protected and cannot be modified")));
    EXPECT_THAT(faultsOf("model M model A final replaceable model B Real x = 2; end B; B b; end A; "
                         "model C Real x = 3; end C; A a(redeclare model B = C); end M;"),
                Contains(HasSubstr("'B' of 'M.A' is final and cannot be redeclared")));
    EXPECT_THAT(
        faultsOf("model M model P Real x = 1; end P; model Q Real x = 2; end Q; model A replaceable P m; end A; "
                 "model B extends A(redeclare P m); end B; model C extends B(redeclare Q m); end C; C c; end M;"),
        Contains(HasSubstr("'m' was redeclared before, and is not replaceable since")));
    EXPECT_THAT(faultsOf("model M model A Real x = 2; end A; model B Real x = 1; Real y = 1; end B; "
                         "replaceable A a constrainedby B; end M;"),
                Contains(HasSubstr("M.A cannot take the place of M.B: it has no 'y'")));
    EXPECT_THAT(faultsOf("model M model A Real x[:, :] = ones(size(x, 1), size(x, 2)); end A; "
                         "A a(redeclare Real x[2, 3]); end M;"),
                IsEmpty());
}

TEST(Redeclarations, AClassMayContinueTheOneThatIsInherited) {
    const FlatModel m = flatOf(
        "model M model A replaceable model B Real x = 0; end B; end A; extends A; "
        "redeclare model extends B(x = 1) Real y = 2; end B; B b; end M;");
    EXPECT_THAT(equations(m), ElementsAre("b.x = 1", "b.y = 2"));
    EXPECT_THAT(faultsOf("model M model A model B Real x = 0; end B; end A; extends A; "
                         "model extends B Real y = 2; end B; B b; end M;"),
                Contains(HasSubstr("the class 'B' of 'M.A' is not replaceable")));
    EXPECT_THAT(faultsOf("model M model extends B Real y = 2; end B; B b; end M;"),
                Contains(HasSubstr("'M.B' continues a class of its name, but none is inherited")));
}

TEST(Redeclarations, AnInheritedClassOfTheSameNameIsTheSame) {
    EXPECT_THAT(faultsOf("model M model Base model A Real x = 2; end A; end Base; model A Real x = 3; end A; "
                         "extends Base; A a; end M;"),
                Contains(HasSubstr("'A' is declared in 'M' and, differently, in 'M.Base'")));
    EXPECT_THAT(faultsOf("model M model Base model A Real x = 2;   end A; end Base; model A Real x = 2; end A; "
                         "extends Base; A a; end M;"),
                IsEmpty());
}

TEST(Outer, IsOfTheSameSizeAndUnmodified) {
    EXPECT_THAT(faultsOf("model M model A outer Real p; end A; inner Real p[1] = {1}; A a; end M;"),
                Contains(HasSubstr("the outer component 'p' has the size of a single value, the inner one [1]")));
    EXPECT_THAT(
        faultsOf("model M model A outer parameter Real p; end A; inner parameter Real p = 1; A a(p = 2); end M;"),
        Contains(HasSubstr("the outer component 'p' cannot be modified")));
}

/// Section 5.3.1: what is imported by its name hides what comes with a whole package.
TEST(ClassRules, ImportsOfWholePackagesComeLastAndMustBeClear) {
    const std::string packages =
        "encapsulated package P constant Real x = 2; protected constant Real y = 3; end P; "
        "encapsulated package Q constant Real x = 4; end Q; ";
    const FlatModel m = flatOf(packages + "model M import P.*; import Q.x; parameter Real u = x; end M;");
    EXPECT_EQ(valueOf(m, "u"), 4);
    EXPECT_THAT(faultsOf(packages + "model M import P.*; import Q.*; parameter Real u = x; end M;"),
                ElementsAre(HasSubstr("'x' is imported from 'P' and from 'Q'")));
    EXPECT_THAT(faultsOf(packages + "model M import P.*; parameter Real u = y; end M;"),
                Contains(HasSubstr("'y' is not declared")));
}

TEST(ClassRules, ADelayIsAtMostAsLongAsItsLongest) {
    const auto model = [](const std::string& longest) {
        return "model M Real y = time, z = delay(y, 5.5, " + longest + "); end M;";
    };
    EXPECT_THAT(faultsOf(model("6")), IsEmpty());
    EXPECT_THAT(faultsOf(model("1")), ElementsAre(HasSubstr("the delay time 5.5 is longer than the longest one, 1")));
}

TEST(ClassRules, WhatChangesAtEventsAloneHasNoDerivative) {
    EXPECT_THAT(faultsOf("model M discrete Real p = 1; Real a = der(p); end M;"),
                Contains(HasSubstr("'p' changes at events alone and has no derivative")));
}

}  // namespace
}  // namespace analogon
