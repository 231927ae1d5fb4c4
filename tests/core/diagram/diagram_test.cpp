#include "core/diagram/diagram.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/diagram/edit.hpp"
#include "core/syntax/parser.hpp"

namespace analogon {
namespace {

using testing::ElementsAre;

// A little library of its own: what is read here must not depend on how the built-in blocks are drawn.
const char* const parts = R"(
package Parts
  connector Flange "a shaft end"
    Real phi;
    flow Real tau;
    annotation (Icon(graphics={Ellipse(extent={{-100,-100},{100,100}}, fillColor={95,95,95}, fillPattern=FillPattern.Solid)}));
  end Flange;
  connector Flange_a extends Flange; end Flange_a;
  connector Heat Real T; flow Real Q_flow; end Heat;
  connector RealInput = input Real annotation (Icon(graphics={Polygon(points={{-100,100},{100,0},{-100,-100}})}));
  connector RealOutput = output Real;
  partial model TwoFlanges
    Flange_a flange_a annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
    Flange flange_b "the far end" annotation (Placement(transformation(extent={{90,-10},{110,10}}),
      iconTransformation(extent={{80,-20},{120,20}})));
    annotation (Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
      Rectangle(extent={{-100,20},{100,-20}}, lineColor={1,2,3}, pattern=LinePattern.Dash, lineThickness=0.5,
                fillColor={192,192,192}, fillPattern=FillPattern.HorizontalCylinder, radius=5, origin={1,2}, rotation=90)}));
  end TwoFlanges;
  model Shaft "elastic"
    extends TwoFlanges;
    parameter Real c;
  protected
    Flange hidden;
    annotation (Icon(graphics={
      Line(points={{0,0},{10,-20},{20,0}}, color={0,0,127}, thickness=1, smooth=Smooth.Bezier, arrow={Arrow.None,Arrow.Filled}),
      Text(extent={{-150,60},{150,100}}, textString="%name", textColor={0,0,255}, textStyle={TextStyle.Bold}),
      Ellipse(extent={{-10,-10},{10,10}}, startAngle=0, endAngle=180),
      Text(extent={{-1,-1},{1,1}}, textString="not drawn", visible=false),
      Nonsense(extent={{0,0},{1,1}})}));
  end Shaft;
  model Friction
    Flange flange annotation (Placement(transformation(extent={{-10,90},{10,110}})));
    annotation (__Analogon(effect(kind="friction.coulomb")));
  end Friction;
end Parts;
)";

const char* const drive = R"(
model Drive
  Parts.RealInput u annotation (Placement(transformation(extent={{-100,-10},{-80,10}})));
  Parts.RealOutput y annotation (Placement(transformation(extent={{80,-10},{100,10}})));
  Parts.Shaft first(c=5) annotation (Placement(transformation(extent={{-10,-10},{10,10}})));
  Parts.Shaft turned(c=c0) annotation (Placement(transformation(extent={{-10,-10},{10,10}}, origin={50,0}, rotation=90)));
  Parts.Shaft mirrored annotation (Placement(transformation(extent={{60,40},{40,60}})));
  Parts.Friction friction annotation (Placement(transformation(extent={{20,-50},{40,-30}})));
  Unknown.Class lost;
  parameter Real c0 = 3;
equation
  connect(first.flange_b, turned.flange_a) annotation (Line(points={{10,0},{50,0},{50,-10}}, color={95,95,95}, thickness=0.5));
  connect(friction.flange, first.flange_b);
  connect(u, lost.u) annotation (Line(points={{-80,0},{-40,0}}));
  annotation (Diagram(coordinateSystem(extent={{-120,-60},{120,80}}), graphics={Rectangle(extent={{0,0},{1,1}})}));
end Drive;
)";

Library libraryOf(std::initializer_list<const char*> texts) {
    Library library;
    for (const char* text : texts) {
        auto added = library.withSource(std::make_shared<const Source>("test.mo", text));
        EXPECT_TRUE(added) << format(added.diagnostics());
        if (added) library = *added;
    }
    return library;
}

const Port* portOf(const Block& block, std::string_view name) {
    for (const Port& p : block.ports)
        if (p.name == name) return &p;
    return nullptr;
}

class DiagramOfDrive : public testing::Test {
protected:
    const Library library = libraryOf({parts, drive});
    const Outcome<Diagram> diagram = readDiagram(library, "Drive");
};

TEST_F(DiagramOfDrive, ListsBlocksConnectorsAndEffectsButNoVariables) {
    ASSERT_TRUE(diagram);
    std::vector<std::string> names;
    for (const Block& b : diagram->blocks) names.push_back(b.name);
    EXPECT_THAT(names, ElementsAre("u", "y", "first", "turned", "mirrored", "friction", "lost"));
    EXPECT_TRUE(diagram->find("u")->isConnector);
    EXPECT_EQ(diagram->find("u")->domain, Domain::RealInput);
    EXPECT_EQ(diagram->find("y")->domain, Domain::RealOutput);
    EXPECT_EQ(diagram->find("first")->className, "Parts.Shaft");
    EXPECT_EQ(diagram->find("first")->description, "elastic");
    EXPECT_THAT(diagram->find("first")->parameters, ElementsAre(std::pair<std::string, std::string>("c", "5")));
    EXPECT_FALSE(diagram->find("first")->isEffect);
    EXPECT_TRUE(diagram->find("friction")->isEffect);
    EXPECT_FALSE(diagram->find("lost")->isResolved);
    EXPECT_EQ(diagram->coordinates.p1, (Point{-120, -60}));
    EXPECT_EQ(diagram->graphics.size(), 1u);
}

TEST_F(DiagramOfDrive, FindsInheritedPortsAndTheirDomains) {
    ASSERT_TRUE(diagram);
    const Block& shaft = *diagram->find("first");
    ASSERT_EQ(shaft.ports.size(), 2u) << "protected connectors are not shown";
    EXPECT_EQ(portOf(shaft, "flange_a")->domain, Domain::Rotational);
    EXPECT_EQ(portOf(shaft, "flange_a")->className, "Parts.Flange_a");
    EXPECT_EQ(portOf(shaft, "flange_a")->icon.primitives.size(), 1u) << "its icon is inherited";
    EXPECT_EQ(portOf(shaft, "flange_b")->description, "the far end");
    EXPECT_EQ(portOf(shaft, "flange_b")->placement.extent.p1, (Point{80, -20})) << "iconTransformation counts";
    EXPECT_EQ(connectorDomain(library, "Parts.Heat"), Domain::Heat);
    EXPECT_EQ(connectorDomain(library, "Parts.Shaft"), Domain::Other);
}

TEST_F(DiagramOfDrive, DrawsBaseIconsFirstWithAllTheirProperties) {
    const Icon icon = readIcon(library, "Parts.Shaft");
    ASSERT_EQ(icon.primitives.size(), 4u) << "what is invisible or unknown is left out";
    const Primitive& r = icon.primitives[0];
    EXPECT_EQ(r.kind, Primitive::Kind::Rectangle);
    EXPECT_EQ(r.line, (Colour{1, 2, 3}));
    EXPECT_TRUE(r.dashed);
    EXPECT_TRUE(r.filled);
    EXPECT_EQ(r.gradient, Gradient::HorizontalCylinder);
    EXPECT_EQ(r.thickness, 0.5);
    EXPECT_EQ(r.radius, 5);
    EXPECT_EQ(r.rotation, 90);
    EXPECT_EQ(r.origin, (Point{1, 2}));
    const Primitive& l = icon.primitives[1];
    EXPECT_THAT(l.points, ElementsAre(Point{0, 0}, Point{10, -20}, Point{20, 0}));
    EXPECT_EQ(l.line, (Colour{0, 0, 127}));
    EXPECT_TRUE(l.smooth);
    EXPECT_FALSE(l.arrowAtStart);
    EXPECT_TRUE(l.arrowAtEnd);
    const Primitive& t = icon.primitives[2];
    EXPECT_EQ(t.text, "%name");
    EXPECT_TRUE(t.bold);
    EXPECT_EQ(t.line, (Colour{0, 0, 255}));
    EXPECT_EQ(icon.primitives[3].endAngle, 180);
}

/*  Drive, in diagram coordinates:
 *
 *                                (60)mirrored(40)     flipped: flange_a is right
 *                                     y=50
 *    u -80 ...      -10[first]10      turned          rotated: flange_b is on top (50,10)
 *                                     x=50
 *                         friction (30,-40), flange on top
 */
TEST_F(DiagramOfDrive, PutsAnchorsWhereThePortsAreDrawn) {
    ASSERT_TRUE(diagram);
    const auto at = [&](const char* connector) {
        const auto p = diagram->anchor(connector);
        return p ? Point{std::round(p->x), std::round(p->y)} : Point{999, 999};
    };
    EXPECT_EQ(at("first.flange_a"), (Point{-10, 0}));
    EXPECT_EQ(at("first.flange_b"), (Point{10, 0}));
    EXPECT_EQ(at("turned.flange_b"), (Point{50, 10}));
    EXPECT_EQ(at("mirrored.flange_a"), (Point{60, 50}));
    EXPECT_EQ(at("mirrored.flange_b"), (Point{40, 50}));
    EXPECT_EQ(at("friction.flange"), (Point{30, -30}));
    EXPECT_EQ(at("u"), (Point{-80, 0})) << "an input hands over at its tip";
    EXPECT_EQ(at("y"), (Point{80, 0}));
    EXPECT_FALSE(diagram->anchor("first.no_such_port"));
    EXPECT_FALSE(diagram->anchor("nobody.flange"));
    EXPECT_EQ(diagram->direction("turned.flange_b"), (Point{0, 1}));
    EXPECT_EQ(diagram->direction("mirrored.flange_a"), (Point{1, 0}));
    EXPECT_EQ(diagram->direction("friction.flange"), (Point{0, 1}));
}

TEST_F(DiagramOfDrive, ReadsWiresAndLaysThoseWithoutAWay) {
    ASSERT_TRUE(diagram);
    ASSERT_EQ(diagram->wires.size(), 3u);
    EXPECT_THAT(diagram->wires[0].points, ElementsAre(Point{10, 0}, Point{50, 0}, Point{50, -10}));
    EXPECT_EQ(diagram->wires[0].thickness, 0.5);
    const Wire& laid = diagram->wires[1];
    ASSERT_EQ(laid.points.size(), 3u);
    EXPECT_EQ(laid.points.front(), (Point{30, -30}));
    EXPECT_EQ(laid.points[1], (Point{30, 0})) << "up out of the friction, then left into the shaft";
    EXPECT_EQ(laid.points.back(), (Point{10, 0}));
    EXPECT_EQ(laid.colour, domainColour(Domain::Rotational));
}

TEST_F(DiagramOfDrive, SuggestsANameForAMisspeltClass) {
    const auto missing = readDiagram(library, "Driev");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.diagnostics().front().hint, "did you mean \"Drive\"?");
}

TEST(Diagram, LaysOutComponentsWithoutAPlaceBesideEachOther) {
    const Library library = libraryOf({parts, "model M Parts.Shaft a, b, c, d, e, f, g; end M;"});
    const auto diagram = readDiagram(library, "M");
    ASSERT_TRUE(diagram);
    for (std::size_t i = 0; i < diagram->blocks.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_NE(diagram->blocks[i].placement.extent.p1, diagram->blocks[j].placement.extent.p1);
}

TEST(Diagram, ShowsTheBlocksOfAnExtendedModel) {
    const Library library = libraryOf({parts, drive, "model More extends Drive; Parts.Friction more; end More;"});
    const auto diagram = readDiagram(library, "More");
    ASSERT_TRUE(diagram);
    EXPECT_TRUE(diagram->find("first"));
    EXPECT_TRUE(diagram->find("more"));
    EXPECT_EQ(diagram->wires.size(), 3u);
}

TEST(Diagram, EndsACycleOfBaseClasses) {
    const Library library = libraryOf({"model A extends B; end A; model B extends A; end B;"});
    EXPECT_TRUE(readDiagram(library, "A"));
}

TEST(Annotation, PlacementReadsBackAsWritten) {
    const Placement placement{{{12.5, -10}, {-7.5, 10}}, {3, -0.0}, 270};
    const Library library = libraryOf(
        {parts, ("model M Parts.Shaft s annotation (" + placementAnnotation(placement) + "); end M;").c_str()});
    const auto diagram = readDiagram(library, "M");
    ASSERT_TRUE(diagram);
    const Placement& read = diagram->blocks.front().placement;
    EXPECT_EQ(read.extent.p1, placement.extent.p1);
    EXPECT_EQ(read.extent.p2, placement.extent.p2);
    EXPECT_EQ(read.origin, placement.origin);
    EXPECT_EQ(read.rotation, 270);
    EXPECT_EQ(lineAnnotation({{1, 2}, {3.25, -4}}, {0, 0, 127}), "Line(points={{1,2},{3.25,-4}}, color={0,0,127})");
}

TEST(ModelEdit, LaysTheWayOfANewConnectionToANewBlock) {
    const Library library = libraryOf({parts, drive});
    const auto diagram = readDiagram(library, "Drive");
    ASSERT_TRUE(diagram);
    ModelEdit edit(*library.find("Drive")->definition, &*diagram, &library);
    edit.addComponent({"Parts.Friction", "drag", {}, "", {{{-50, -50}, {-30, -30}}, {}, 0}});
    edit.addConnection("drag.flange", "first.flange_a", {}, domainColour(Domain::Rotational));
    const auto change = edit.finish("Add drag");
    ASSERT_TRUE(change);
    const std::string text = syntax::apply(drive, *change).text;
    EXPECT_THAT(text, testing::HasSubstr("connect(drag.flange, first.flange_a) annotation (Line(points={{-40,-30},"
                                         "{-40,0},{-10,0}}, color={95,95,95}));"));
}

// The block library as shipped: every icon is drawable, every port stands on or near its icon.
TEST(BlockLibrary, EveryBlockHasAnIconAndPortsOnItsEdge) {
    const auto library = builtInLibrary();
    ASSERT_TRUE(library) << format(library.diagnostics());
    int blocks = 0;
    for (const LibraryClass* cls : library->classes()) {
        using Restriction = syntax::ClassDefinition::Restriction;
        const auto restriction = cls->definition->restriction;
        const bool isBlock = restriction == Restriction::Model || restriction == Restriction::Block;
        if (!isBlock || cls->definition->isPartial) continue;
        ++blocks;
        EXPECT_FALSE(readIcon(*library, cls->qualifiedName).primitives.empty()) << cls->qualifiedName;
        const std::vector<Port> ports = readPorts(*library, cls->qualifiedName);
        EXPECT_FALSE(ports.empty()) << cls->qualifiedName;
        for (const Port& port : ports) {
            EXPECT_NE(port.domain, Domain::Other) << cls->qualifiedName << '.' << port.name;
            EXPECT_FALSE(port.icon.primitives.empty()) << cls->qualifiedName << '.' << port.name;
            const Point at = map(port.placement, port.icon.coordinates, {0, 0});
            EXPECT_LE(std::max(std::abs(at.x), std::abs(at.y)), 125) << cls->qualifiedName << '.' << port.name;
        }
    }
    EXPECT_GT(blocks, 20);
}

}  // namespace
}  // namespace analogon
