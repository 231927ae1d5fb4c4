#include "tests/core/flat/flat_support.hpp"

namespace analogon {
namespace {

using namespace test;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsNull;
using ::testing::Not;
using ::testing::NotNull;

TEST(Connect, PotentialsAreEqualAndFlowsSumToZero) {
    const FlatModel m = flatOf(R"(
        model M
          Parts.Inertia i1, i2; Parts.SpringDamper s(c = 10); Parts.SpeedSensor sensor;
          Parts.RealOutput w;
        equation
          connect(i1.b, s.a);
          connect(s.b, i2.a);
          connect(i2.a, sensor.flange);
          connect(sensor.w, w);
        end M;)");
    EXPECT_THAT(equations(m), Contains("s.a.phi = i1.b.phi"));
    EXPECT_THAT(equations(m), Contains("i1.b.tau + s.a.tau = 0"));
    EXPECT_THAT(equations(m), Contains("s.b.tau + i2.a.tau + sensor.flange.tau = 0"));
    EXPECT_THAT(equations(m), Contains("i1.a.tau = 0"));
    EXPECT_THAT(equations(m), Contains("w = sensor.w"));
    ASSERT_EQ(m.connections.size(), 3u);
    EXPECT_THAT(m.connections[1].connectors, ElementsAre("s.b", "i2.a", "sensor.flange"));
    EXPECT_EQ(m.connections[1].connectorClass, "Parts.Flange");
    EXPECT_THAT(m.connections[2].connectors, ElementsAre("sensor.w", "w"));
    EXPECT_THAT(m.connectionOf("sensor.flange"), NotNull());
    EXPECT_THAT(m.connectionOf("i1.a"), IsNull());
    for (const FlatEquation& e : m.equations)
        if (text(m, e.left) == "s.b.tau + i2.a.tau + sensor.flange.tau") {
            EXPECT_TRUE(e.fromConnection);
            EXPECT_EQ(e.component, "s.b");
            EXPECT_EQ(e.span.text(), "connect(s.b, i2.a);");
        }
}

TEST(Connect, AnOutsideConnectorCountsWithTheOtherSign) {
    const FlatModel m = flatOf(R"(
        model Train
          Parts.Flange in_, out; Parts.Inertia first, second;
        equation
          connect(in_, first.a); connect(first.b, second.a); connect(second.b, out);
        end Train;
        model M Train t; Parts.Inertia load; Parts.Fixed wall;
        equation connect(t.out, load.a); connect(load.b, wall.flange); end M;)");
    EXPECT_THAT(equations(m), Contains("t.first.a.tau - t.in_.tau = 0"));
    EXPECT_THAT(equations(m), Contains("t.out.tau + load.a.tau = 0"));
    EXPECT_THAT(equations(m), Contains("t.in_.tau = 0"));  // nothing is connected from outside
    ASSERT_NE(m.connectionOf("load.a"), nullptr);
    // One node through the border of the component.
    EXPECT_THAT(m.connectionOf("load.a")->connectors, ElementsAre("t.out", "load.a", "t.second.b"));
}

TEST(Connect, SignalsRunFromTheirSource) {
    const FlatModel m = flatOf(R"(
        model M
          Parts.RealInput u(unit = "V"); Parts.RealOutput y; Parts.Gain g1, g2(k = 3);
        equation
          connect(g2.y, y); connect(g1.u, u); connect(u, g2.u);
        end M;)");
    EXPECT_EQ(variable(m, "u").causality, FlatCausality::Input);
    EXPECT_EQ(variable(m, "u").unit, "V");
    EXPECT_EQ(variable(m, "y").causality, FlatCausality::Output);
    EXPECT_EQ(variable(m, "g1.u").causality, FlatCausality::Local);
    EXPECT_THAT(equations(m), ElementsAre("g1.y = g1.k*g1.u", "g2.y = g2.k*g2.u", "y = g2.y", "g1.u = u", "g2.u = u"));
}

TEST(Connect, AnInputMayHaveAValueInstead) {
    EXPECT_THAT(equations(flatOf("model M Parts.Gain g(u = 2*time); end M;")),
                ElementsAre("g.u = 2*time", "g.y = g.k*g.u"));
}

TEST(Connect, ConnectorsOfDifferentKindsAreNamedWithTheirVariables) {
    EXPECT_THAT(faultsOf(R"(
        model M Parts.Inertia i; Parts.HeatCapacitor c(C = 1); equation connect(i.a, c.port); end M;)"),
                ElementsAre("connect(i.a, c.port): the connectors do not fit: 'i.a' (Parts.Flange) has phi, tau, "
                            "'c.port' (Parts.HeatPort) has T, Q_flow | connect connectors of the same kind"));
    EXPECT_THAT(faultsOf(R"(
        model M Parts.RealInput u(unit = "V"); Parts.Torque t; equation connect(u, t.tau); end M;)"),
                ElementsAre(HasSubstr("connect(u, t.tau): the units differ: 'u' is in V, 't.tau' in N.m")));
    EXPECT_THAT(faultsOf("model M Parts.RealInput u; Parts.Fixed f; equation connect(u, f.flange); end M;"),
                ElementsAre(HasSubstr("'u' (Parts.RealInput) is a signal, 'f.flange' (Parts.Flange) has phi, tau")));
}

TEST(Connect, WrongEndsAreNamedWithASuggestion) {
    EXPECT_THAT(faultsOf("model M Parts.Fixed f; Parts.Inertia i; equation connect(f.flnge, i.a); end M;"),
                ElementsAre("component 'f' (Parts.Fixed) has no member 'flnge' | did you mean 'flange'?"));
    EXPECT_THAT(faultsOf("model M Parts.Inertia rotor; Parts.Fixed f; equation connect(roter.a, f.flange); end M;"),
                ElementsAre("'roter' is not declared in model 'M' | did you mean 'rotor'?"));
    EXPECT_THAT(faultsOf("model M Parts.Inertia i, j; equation connect(i.w, j.a); end M;"),
                ElementsAre(HasSubstr("connect: 'i.w' is a Real variable, not a connector")));
    EXPECT_THAT(faultsOf("model M Parts.Inertia i, j; equation connect(i, j.a); end M;"),
                ElementsAre(HasSubstr("connect: 'i' is a component of class Parts.Inertia, not a connector")));
    EXPECT_THAT(faultsOf(R"(
        model N Parts.Inertia inner_; end N;
        model M N n; Parts.Fixed f; equation connect(n.inner_.a, f.flange); end M;)"),
                ElementsAre(HasSubstr("'n.inner_.a' lies inside a component")));
}

TEST(Connect, EveryInputNeedsOneSource) {
    EXPECT_THAT(faultsOf("model M Parts.Gain g; end M;"),
                ElementsAre("the input 'g.u' of component 'g' (Parts.Gain) is not connected | connect it to an "
                            "output or a top-level input"));
    EXPECT_THAT(faultsOf("model M Parts.Gain g, h, k; equation connect(g.y, k.u); connect(h.y, k.u); "
                         "connect(g.u, g.y); connect(h.u, h.y); end M;"),
                ElementsAre(HasSubstr("two signals drive each other: 'g.y' and 'h.y' are both sources")));
    EXPECT_THAT(faultsOf("model M Parts.Gain g, h; equation connect(g.u, h.u); end M;"),
                ElementsAre(HasSubstr("the input 'g.u' is connected to inputs only")));
    EXPECT_THAT(faultsOf("model M Parts.Gain g(u = 1), h(u = 2); equation connect(g.y, h.u); end M;"),
                ElementsAre(HasSubstr("the input 'h.u' is connected and has a value as well")));
}

TEST(Connect, AProtectedConnectorOfTheClassIsAVariableBetweenTheOthers) {
    const FlatModel m = flatOf(R"(
        block Chosen
          parameter Boolean fromOutside = true; parameter Real k = 5;
          Parts.RealInput u if fromOutside; Parts.RealOutput y;
        protected
          Parts.RealInput used; Constant own(k = k) if not fromOutside;
        equation connect(u, used); connect(own.y, used); y = 2*used; end Chosen;
        block Constant parameter Real k; Parts.RealOutput y; equation y = k; end Constant;
        model M Chosen a, b(fromOutside = false); Parts.RealInput u; equation connect(u, a.u); end M;)");
    EXPECT_THAT(equations(m), Contains("a.used = a.u"));
    EXPECT_THAT(equations(m), Contains("b.used = b.own.y"));
}

TEST(Connect, AProtectedComponentHasInputsLikeAnyOther) {
    const FlatModel m = flatOf(R"(
        model N Parts.RealInput u; Parts.RealOutput y; protected Parts.Gain g;
        equation connect(u, g.u); connect(g.y, y); end N;
        model M N n; Parts.RealInput u; equation connect(u, n.u); end M;)");
    EXPECT_THAT(equations(m), Contains("n.g.u = n.u"));
    EXPECT_THAT(faultsOf("model M protected Parts.Gain g; end M;"),
                ElementsAre(HasSubstr("the input 'g.u' of component 'g' (Parts.Gain) is not connected")));
}

TEST(Connect, TheValueThatAnInputHasInItsOwnClassIsAnEquation) {
    const FlatModel m = flatOf(R"(
        model Pump
          parameter Boolean isDriven = false; parameter Real constant_ = 3;
          Parts.RealInput flow_(unit = "m3/s") = inside if isDriven;
          Real y;
        protected
          Real inside;
        equation
          if not isDriven then inside = constant_; end if;
          y = 2*inside;
        end Pump;
        model M Pump a(isDriven = true), b; Parts.RealInput u; equation connect(u, a.flow_); end M;)");
    EXPECT_THAT(equations(m), Contains("a.flow_ = a.inside"));
    EXPECT_THAT(equations(m), Contains("a.flow_ = u"));
    EXPECT_THAT(equations(m), Contains("b.inside = b.constant_"));
}

TEST(Connect, AnEquationMaySetTheInputOfAComponent) {
    const FlatModel m = flatOf("model M input Real x; Parts.Gain g; equation g.u = 2*x + 1; end M;");
    EXPECT_THAT(equations(m), Contains("g.u = 2*x + 1"));
    // One of two inputs that are joined, and one that is an array's element.
    flatOf("model M Parts.Gain g, h; equation connect(g.u, h.u); h.u = time; end M;");
    flatOf("model M Parts.Gain g[2]; equation for i in 1:2 loop g[i].u = i*time; end for; end M;");
    flatOf("model N Parts.Gain g; equation g.u = time; end N; model M N n; end M;");
    // To use it is not to set it, to set it twice is once too often; and a component sets only its own.
    EXPECT_THAT(faultsOf("model M Parts.Gain g; Real x; equation x = g.u; end M;"),
                ElementsAre(HasSubstr("has 1 equation for 2 unknowns: 1 too few")));
    EXPECT_THAT(faultsOf("model M Parts.Gain g; equation g.u = 1; g.u = 2*time; end M;"),
                ElementsAre(HasSubstr("has 2 equations for 1 unknown: 1 too many")));
    EXPECT_THAT(faultsOf("model N Parts.Gain g; end N; model M N n; equation n.g.u = 1; end M;"),
                ElementsAre(HasSubstr("the input 'n.g.u' of component 'n.g' (Parts.Gain) is not connected")));
}

TEST(Connect, HierarchicalConnectorsMatchMemberByMember) {
    const FlatModel m = flatOf(R"(
        connector Plug Parts.Flange shaft; Parts.HeatPort heat; end Plug;
        model Left Plug p; equation p.shaft.phi = time; p.heat.T = 300; end Left;
        model Right Plug p; equation p.shaft.tau = 1; p.heat.Q_flow = 2; end Right;
        model M Left l; Right r; equation connect(l.p, r.p); end M;)");
    EXPECT_THAT(equations(m), Contains("l.p.heat.Q_flow + r.p.heat.Q_flow = 0"));
    EXPECT_THAT(equations(m), Contains("r.p.shaft.phi = l.p.shaft.phi"));
    EXPECT_EQ(m.connections.size(), 1u);
}

TEST(Connect, OverconstrainedConnectorsAreRefusedOnceWhereTheModelNamesAComponentThatHasThem) {
    EXPECT_THAT(
        faultsOf(R"(
        record Turned
          Real T[2];
          function equalityConstraint input Turned a, b; output Real residue[1]; algorithm residue[1] := a.T[1] - b.T[1];
          end equalityConstraint;
        end Turned;
        connector Frame Turned R; Real r; flow Real f; flow Real t[2]; end Frame;
        model Arm Frame a, b; equation connect(a, b); end Arm;
        model M Arm arm, other; equation connect(arm.b, other.a); end M;)"),
        ElementsAre(::testing::AllOf(HasSubstr("'arm' (Arm) has connectors whose variables depend on each other"),
                                     HasSubstr("Use components whose connectors have potentials and flows"))));
}

/// A bus whose signals come from a part, go to a part, and one that nobody uses.
const char* const busText = R"(
  connector In = input Real; connector Out = output Real;
  expandable connector Sub Real level; Real idle; Integer count; end Sub;
  expandable connector Bus Real speed; Real unused; Sub sub; end Bus;
  block Source Out y; equation y = time; end Source;
  block Twice In u; Out y; equation y = 2*u; end Twice;
  model Writer Sub bus; Source s; equation connect(s.y, bus.level); end Writer;
  model Reader Bus bus; Twice g; equation connect(bus.speed, g.u); end Reader;
)";

TEST(Expandable, SignalsAreThereWhereSomethingIsConnected) {
    const FlatModel model = flatOf(busText + std::string(R"(
  model M Writer w; Reader r; Source s; Twice own;
  protected Bus bus;
  equation connect(s.y, bus.speed); connect(r.bus, bus); connect(w.bus, bus.sub); connect(bus.sub.level, own.u); end M;)"));
    const auto all = equations(model);
    EXPECT_EQ(variable(model, "bus.unused").variability, FlatVariability::Constant);
    EXPECT_EQ(variable(model, "w.bus.idle").variability, FlatVariability::Constant);
    EXPECT_EQ(variable(model, "bus.sub.level").variability, FlatVariability::Continuous);
    std::size_t unknowns = 0;
    for (const FlatVariable& v : model.variables) unknowns += v.variability == FlatVariability::Continuous ? 1 : 0;
    EXPECT_EQ(all.size(), unknowns);
}

TEST(Expandable, ASignalThatNobodyDrivesIsTold) {
    const auto named = faultsOf(busText + std::string(R"(
  model M Bus bus; Real x = bus.unused; end M;)"));
    ASSERT_EQ(named.size(), 1u);
    EXPECT_THAT(named[0], HasSubstr("nothing is connected to 'bus.unused'"));
    EXPECT_FALSE(faultsOf(busText + std::string(R"(
  model M Reader r; Twice t; protected Bus bus; equation connect(r.bus, bus); connect(bus.speed, t.u); end M;)"))
                     .empty());
}

TEST(Connections, CardinalityCountsTheConnectionsOfAConnectorWhereverTheyStand) {
    const FlatModel m = flatOf(R"(
        connector Pin Real v; flow Real i; end Pin;
        model Tap Pin p; Pin q[2];
        equation
          if cardinality(p) == 0 then p.v = 1; else p.i = p.v; end if;
          for k in 1:2 loop q[k].v = cardinality(q[k]); end for;
          assert(cardinality(p) <= 2, "too many");
        end Tap;
        model M Tap a, b; equation for k in 1:1 loop connect(a.p, b.q[k]); end for; connect(b.q[1], a.p); end M;)");
    EXPECT_THAT(equations(m), Contains("b.p.v = 1"));
    EXPECT_THAT(equations(m), Not(Contains("a.p.v = 1")));
    EXPECT_THAT(equations(m), Contains("a.q[1].v = 0"));
    EXPECT_THAT(equations(m), Contains("b.q[1].v = 2"));
    EXPECT_THAT(faultsOf("connector Pin Real v; flow Real i; end Pin; "
                         "model M Pin p; parameter Integer n = cardinality(p); equation p.v = n; end M;"),
                Contains(HasSubstr("can stand in equations and their conditions alone")));
    EXPECT_THAT(faultsOf("model M Real x; equation x = cardinality(x); end M;"),
                Contains(HasSubstr("'cardinality' takes one connector")));
}

TEST(Connections, AComponentMaySetAnInputThatItFoundOpen) {
    const std::string classes = R"(
        connector In = input Real; connector Out = output Real;
        model Half In u; Out y; equation y = u/2; if cardinality(u) == 0 then u = 4; end if; end Half;)";
    const FlatModel m = flatOf(classes + "model M Half a, b; equation connect(a.y, b.u); end M;");
    EXPECT_THAT(equations(m), Contains("a.u = 4"));
    EXPECT_EQ(m.equations.size(), 4u);
    EXPECT_THAT(faultsOf("connector In = input Real; model Half In u; Real y; equation y = u/2; u = 4; end Half; "
                         "model M Half a; end M;"),
                Contains(HasSubstr("the input 'a.u' of component 'a' (Half) is not connected")));
}

}  // namespace
}  // namespace analogon
