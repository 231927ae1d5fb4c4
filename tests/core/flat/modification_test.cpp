#include "tests/core/flat/flat_support.hpp"

namespace analogon {
namespace {

using namespace test;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Modification, TheOuterOneOverridesTheInnerOne) {
    const FlatModel m = flatOf(R"(
        model Shaft Parts.Inertia rotor(J = 2, w(start = 1)); end Shaft;
        model Machine extends Shaft(rotor(J = 3)); end Machine;
        model M Machine a; Machine b(rotor(J = 4, w(start = 9))); end M;)");
    EXPECT_EQ(valueOf(m, "a.rotor.J"), 3);
    EXPECT_EQ(text(m, variable(m, "a.rotor.w").start), "1");
    EXPECT_EQ(valueOf(m, "b.rotor.J"), 4);
    EXPECT_EQ(text(m, variable(m, "b.rotor.w").start), "9");
}

TEST(Modification, NamesInItBelongToTheClassThatWritesIt) {
    const FlatModel m = flatOf(R"(
        model Shaft parameter Real J = 5; Parts.Inertia rotor(J = 2*J); end Shaft;
        model M parameter Real J = 7; Shaft s(J = J + 1); end M;)");
    EXPECT_EQ(text(m, variable(m, "s.J").binding), "J + 1");
    EXPECT_EQ(text(m, variable(m, "s.rotor.J").binding), "2*s.J");
    EXPECT_EQ(valueOf(m, "s.rotor.J"), 16);
}

TEST(Modification, TheValueOfARecordStandsAboveWhatWasSaidOfItsMembersBefore) {
    const FlatModel flat = test::flatOf(R"(
        record P parameter Real a(min = -100) = 1, b = 2; end P;
        model Part parameter P p(a = 5); Real y = p.a*time + p.b; end Part;
        model M parameter P other(a = 33); Part part(p = other), alone, both(p = other, p(b = 7)); end M;)");
    EXPECT_EQ(test::valueOf(flat, "part.p.a"), 33);
    EXPECT_EQ(test::valueOf(flat, "part.p.b"), 2);
    EXPECT_EQ(test::valueOf(flat, "alone.p.a"), 5);
    EXPECT_EQ(test::valueOf(flat, "both.p.a"), 33);
    EXPECT_EQ(test::valueOf(flat, "both.p.b"), 7);
    EXPECT_EQ(test::variable(flat, "part.p.a").min, -100);
}

TEST(Modification, FinalIsRespected) {
    const std::string source = "model Shaft Parts.Inertia rotor(final J = 2); end Shaft;";
    EXPECT_TRUE(variable(flatOf(source + "model M Shaft s; end M;"), "s.rotor.J").isFinal);
    EXPECT_THAT(faultsOf(source + "model M Shaft s(rotor(J = 3)); end M;"),
                ElementsAre(HasSubstr("'J' is final and cannot be modified")));
    EXPECT_THAT(faultsOf("model M Parts.Fixed f(phi0(quantity = \"x\")); end M;"),
                ElementsAre(HasSubstr("'quantity' is final")));
    EXPECT_TRUE(variable(flatOf("model M final parameter Real p = 1; end M;"), "p").isFinal);
    EXPECT_TRUE(variable(flatOf("model M final Parts.Inertia i(J = 2); end M;"), "i.J").isFinal);
}

TEST(Modification, UnknownNamesAreNamedWithASuggestion) {
    EXPECT_THAT(faultsOf("model M Parts.HeatCapacitor rotor(T_stat = 3, C = 1); end M;"),
                ElementsAre("'Parts.HeatCapacitor' has no element 'T_stat' to modify | did you mean 'T_start'?"));
    EXPECT_THAT(faultsOf("model N extends Parts.Inertia(Q = 3); end N; model M N n; end M;"),
                ElementsAre(HasSubstr("'N' has no element 'Q' to modify")));
    EXPECT_THAT(faultsOf("model M Real x(strat = 3) = 1; end M;"),
                ElementsAre("'strat' is not an attribute of Real | did you mean 'start'?"));
}

TEST(Modification, ProtectedElementsAreClosedToOthers) {
    const std::string source = "model P protected parameter Real k = 1; end P; model Q extends P(k = 2); end Q;";
    EXPECT_EQ(valueOf(flatOf(source + "model M Q q; end M;"), "q.k"), 2);
    EXPECT_TRUE(variable(flatOf(source + "model M Q q; end M;"), "q.k").isProtected);
    EXPECT_THAT(faultsOf(source + "model M P p(k = 3); end M;"),
                ElementsAre(HasSubstr("'k' of 'P' is protected and cannot be modified")));
    EXPECT_THAT(faultsOf(source + "model M P p; Real x = p.k; end M;"),
                ElementsAre(HasSubstr("'k' of component 'p' (P) is protected")));
}

TEST(Redeclaration, ReplacesAComponentAndKeepsItsModifications) {
    const std::string source = R"(
        partial model Load Parts.Flange flange; parameter Real b = 1; end Load;
        model Viscous extends Load; equation flange.tau = b*der(flange.phi); end Viscous;
        model Quadratic extends Load; parameter Real k = 0;
        equation flange.tau = b*der(flange.phi)*abs(der(flange.phi)) + k; end Quadratic;
        model Drive replaceable Viscous load(b = 5) constrainedby Load(b = 6); Parts.Inertia i;
        equation connect(load.flange, i.b); end Drive;
        model Open replaceable Load load(b = 8); end Open;)";
    const FlatModel m = flatOf(source + "model M Drive d(redeclare Quadratic load(k = 3)); end M;");
    EXPECT_EQ(valueOf(m, "d.load.k"), 3);
    EXPECT_EQ(valueOf(m, "d.load.b"), 6);
    EXPECT_EQ(m.components[1].className, "Quadratic");
    const FlatModel inherited = flatOf(source + "model M extends Open; redeclare Viscous load; end M;");
    EXPECT_EQ(valueOf(inherited, "load.b"), 8);
    EXPECT_EQ(inherited.components[0].className, "Viscous");
    EXPECT_THAT(faultsOf(source + "model M Open o; end M;"),
                ElementsAre(HasSubstr("'o.load' is of the partial class Load")));
    EXPECT_THAT(faultsOf(source + "model N Viscous load; end N; model M N n(redeclare Quadratic load); end M;"),
                ElementsAre(HasSubstr("'load' of 'N' is not replaceable")));
}

TEST(Redeclaration, TheNewClassNeedsTheElementsOfTheOldOne) {
    const std::string source = R"(
        model Load parameter Real b = 1; Parts.Flange flange; equation flange.tau = b; end Load;
        model Drive replaceable Load load; replaceable model Rotor = Load; Rotor rotor; end Drive;)";
    EXPECT_THAT(
        faultsOf(source + "model M Drive d(redeclare Parts.Inertia load); end M;"),
        ElementsAre("Parts.Inertia cannot take the place of Load: it has no 'flange' | use a class that extends Load"));
    EXPECT_THAT(faultsOf(source + "model M Drive d(redeclare model Rotor = Parts.Inertia); end M;"),
                ElementsAre(HasSubstr("Parts.Inertia cannot take the place of Load")));
    EXPECT_THAT(faultsOf(source + "model M Drive d(redeclare Real load); end M;"),
                ElementsAre(HasSubstr("Real cannot take the place of Load")));
}

TEST(Redeclaration, ReplacesALocalClass) {
    const std::string source = R"(
        model Small parameter Real J = 1; end Small;
        model Large parameter Real J = 100; parameter Real extra = 1; end Large;
        model Drive replaceable model Rotor = Small(J = 2); Rotor first; Rotor second(J = 3); end Drive;)";
    const FlatModel plain = flatOf(source + "model M Drive d; end M;");
    EXPECT_EQ(valueOf(plain, "d.first.J"), 2);
    EXPECT_EQ(valueOf(plain, "d.second.J"), 3);
    const FlatModel m = flatOf(source + "model M Drive d(redeclare model Rotor = Large(extra = 7)); end M;");
    EXPECT_EQ(valueOf(m, "d.first.J"), 2);  // the modification of the replaced class stays
    EXPECT_EQ(valueOf(m, "d.second.extra"), 7);
    const FlatModel derived =
        flatOf(source + "model M extends Drive; redeclare model Rotor = Large(extra = 9); end M;");
    EXPECT_EQ(valueOf(derived, "first.extra"), 9);
}

TEST(Redeclaration, AShortClassMayUseParametersOfItsModel) {
    const FlatModel m = flatOf(R"(
        model Small parameter Real J = 1; end Small;
        model M parameter Real j = 4; model Rotor = Small(J = j); Rotor r; end M;)");
    EXPECT_EQ(valueOf(m, "r.J"), 4);
}

TEST(Inheritance, DeclarationsThatDifferInTheirWordsAloneAreOne) {
    const FlatModel m = flatOf(R"(
        partial model A parameter Real k = 1 "gain"; Real x(start = 2) "position" annotation(Dialog(tab = "a")); end A;
        model M extends A; parameter Real k=1; Real x(start=2) "where it is"; equation x = k*time; end M;)");
    EXPECT_EQ(m.variables.size(), 2u);
    EXPECT_EQ(m.equations.size(), 1u);
}

TEST(Inheritance, DifferentDeclarationsOfOneNameAreRefused) {
    EXPECT_THAT(faultsOf(R"(
        partial model A Real x = 1; end A;
        model M extends A; parameter Real x = 2; end M;)"),
                ElementsAre(HasSubstr("'x' is declared in 'A' and, differently, in 'M'")));
    EXPECT_THAT(faultsOf(R"(
        partial model A Real x(start = 1); end A;
        model M extends A; Real x(start = 2) "where it is"; equation x = time; end M;)"),
                ElementsAre(HasSubstr("'x' is declared in 'A' and, differently, in 'M'")));
    // The same declaration through two paths is one.
    EXPECT_EQ(flatOf(R"(
        partial model A parameter Real x = 1; end A;
        partial model B extends A; end B;
        partial model C extends A; end C;
        model M extends B; extends C; end M;)")
                  .variables.size(),
              1u);
}

TEST(Redeclaration, AsAnElementKeepsTheConstrainingClassOfThePackage) {
    const std::string source = R"(
        package Lib
          partial model Law parameter Real k = 1; output Real y; end Law;
          model Lin extends Law; equation y = k*time; end Lin;
          model Quad extends Law(k = 2); equation y = k*time^2; end Quad;
          model Other Real z = 1; end Other;
          model Host replaceable Lin law constrainedby Law; Real y = law.y; end Host;
        end Lib;)";
    const FlatModel m = flatOf(source + "model M extends Lib.Host; redeclare Lib.Quad law(k = 9); end M;");
    EXPECT_EQ(valueOf(m, "law.k"), 9);
    EXPECT_THAT(faultsOf(source + "model M extends Lib.Host; redeclare Lib.Other law; end M;"),
                Contains(HasSubstr("Lib.Other cannot take the place of Lib.Law")));
}

TEST(Redeclaration, ReachesTheLocalClassesOfTheModel) {
    const std::string source = R"(
        package Lib
          model Lin Real y = time; end Lin;
          model Quad Real y = time^2; end Quad;
          model Host
            replaceable model Law = Lin;
            model Part Law law; end Part;
            Part part;
          end Host;
        end Lib;)";
    EXPECT_THAT(print(flatOf(source + "model M Lib.Host h; end M;")), HasSubstr("h.part.law.y = time;"));
    EXPECT_THAT(print(flatOf(source + "model M Lib.Host h(redeclare model Law = Lib.Quad); end M;")),
                HasSubstr("h.part.law.y = time^2;"));
}

TEST(Redeclaration, OfAPackageIsNeverHalfRead) {
    const std::string source = R"(
        package Lib
          package Medium constant Real cp = 1; model State Real h = cp; end State; end Medium;
          package Water extends Medium(cp = 4); end Water;
          package Oil = Medium(cp = 2);
          package Same extends Medium; end Same;
          model Host replaceable package Medium = Lib.Medium; Medium.State s; end Host;
        end Lib;)";
    EXPECT_THAT(print(flatOf(source + "model M Real a = Lib.Water.cp; Real b = Lib.Oil.cp; end M;")),
                testing::AllOf(HasSubstr("a = 4;"), HasSubstr("b = 2;")));
    EXPECT_THAT(print(flatOf(source + "model M Lib.Same.State s; end M;")), HasSubstr("s.h = 1;"));
    EXPECT_THAT(print(flatOf(source + "model M Lib.Host h; end M;")), HasSubstr("h.s.h = 1;"));
    EXPECT_THAT(
        faultsOf(source + "model M Lib.Water.State s; end M;"),
        ElementsAre(HasSubstr("'Lib.Water.State' is inherited by Lib.Water, which modifies what it inherits; that "
                              "is not supported for the classes of a package | use Lib.Medium.State")));
    EXPECT_THAT(faultsOf(source + "model M Lib.Host h(redeclare package Medium = Lib.Water); end M;"),
                ElementsAre(HasSubstr("'Medium.State' names a class within 'Medium', which is redeclared; that is not "
                                      "supported")));
}

TEST(Inheritance, AConstantThatIsModifiedByItselfIsNamed) {
    EXPECT_THAT(faultsOf(R"(package P constant Real c = 1; end P; package Q extends P(c = c); end Q;
                            model M Real y = Q.c; end M;)"),
                ElementsAre(HasSubstr("the constant 'Q.c' depends on itself")));
}

TEST(Connection, AnInputThatIsNoConnectorGetsItsValueWhereItIsDeclared) {
    const std::string source = "model Law input Real u; output Real y; equation y = 2*u; end Law;";
    EXPECT_THAT(print(flatOf(source + "model M Law law(u = time); end M;")), HasSubstr("law.u = time;"));
    EXPECT_THAT(faultsOf(source + "model M Law law; equation law.u = time; end M;"),
                ElementsAre(HasSubstr("the input 'law.u' of component 'law' (Law) has no value | give it one where the "
                                      "component is declared: law(u = …)")));
}

TEST(Inheritance, AModelExtendsNoPackage) {
    EXPECT_THAT(faultsOf("package P end P; model M extends P; Real x = 1; end M;"),
                ElementsAre("'M' is a model and cannot extend P, which is a package"));
}

TEST(Redeclaration, AnEnumerationMayTakeThePlaceOfAnother) {
    const FlatModel m = flatOf(R"(
        package P type Fine = enumeration(a, b, c); end P;
        model Part replaceable type Level = enumeration(a, b); parameter Level l; end Part;
        model M Part p(redeclare type Level = P.Fine, l = P.Fine.c); end M;)");
    EXPECT_EQ(valueOf(m, "p.l"), 3);
}

/// Section 7.3.2: also in the declaration itself, below what it says; and in each redeclaration.
TEST(Redeclaration, WhatAConstrainingClauseModifiesIsInForceFromTheStart) {
    const FlatModel m = flatOf(R"(
        model A parameter Real x = 1; end A;
        model B parameter Real x = 5; parameter Real y = 6; end B;
        model H replaceable model X = B constrainedby A(x = 2); X m; end H;
        model H2 extends H(redeclare model X = B(y = 3)); end H2;
        model K replaceable B b(y = 7) constrainedby A(x = 3); end K;
        model O replaceable B b(x = 4) constrainedby A(final x = 3); end O;
        model M H h; H2 h2; K k; K k2(b(x = 9)); K k3(redeclare B b(y = 8)); O o; end M;)");
    EXPECT_EQ(valueOf(m, "h.m.x"), 2);
    EXPECT_EQ(valueOf(m, "h.m.y"), 6);
    EXPECT_EQ(valueOf(m, "h2.m.x"), 2);
    EXPECT_EQ(valueOf(m, "h2.m.y"), 3);
    EXPECT_EQ(valueOf(m, "k.b.x"), 3);
    EXPECT_EQ(valueOf(m, "k.b.y"), 7);
    EXPECT_EQ(valueOf(m, "k2.b.x"), 9);
    EXPECT_EQ(valueOf(m, "k3.b.x"), 3);
    EXPECT_EQ(valueOf(m, "k3.b.y"), 8);
    EXPECT_EQ(valueOf(m, "o.b.x"), 4);
}

TEST(Redeclaration, OfARedeclarationTakesWhatTheLastOneSaysAndWhatConstrainsIt) {
    const FlatModel m = flatOf(R"(
        model A parameter Real x = 1; end A;
        model B parameter Real x = 1; parameter Real y = 1; parameter Real z = 1; end B;
        model D replaceable B b constrainedby A; end D;
        model E extends D(redeclare replaceable B b(z = 8) constrainedby B(x = 2, y = 3)); end E;
        model F extends E(redeclare B b(y = 4)); end F;
        model G extends D(b(x = 7)); end G;
        model N extends G(redeclare B b(x = 9)); end N;
        model M E e; F f; N n; end M;)");
    EXPECT_EQ(valueOf(m, "e.b.x"), 2);
    EXPECT_EQ(valueOf(m, "e.b.z"), 8);
    EXPECT_EQ(valueOf(m, "f.b.x"), 2);
    EXPECT_EQ(valueOf(m, "f.b.y"), 4);
    EXPECT_EQ(valueOf(m, "f.b.z"), 1);
    EXPECT_EQ(valueOf(m, "n.b.x"), 9);
}

// As the matrix of cells of a battery stack of the Modelica Standard Library, of which only the type is redeclared.
TEST(Redeclaration, AValueStaysThroughARedeclarationThatTellsNone) {
    const FlatModel m = flatOf(R"(
        record Base parameter Real a = 3; replaceable parameter Real c[2](each max = 9) = {a, 2*a}; end Base;
        record Own = Base(redeclare parameter Real c[2](each min = 0));
        model M parameter Own own; parameter Own other(c = {1, 1}); Real y = own.c[2] + other.c[2]; end M;)");
    EXPECT_EQ(valueOf(m, "own.c[2]"), 6);
    EXPECT_EQ(valueOf(m, "other.c[2]"), 1);
    EXPECT_EQ(variable(m, "own.c[1]").min, 0);
    EXPECT_EQ(variable(m, "own.c[1]").max, 9);
}

}  // namespace
}  // namespace analogon
