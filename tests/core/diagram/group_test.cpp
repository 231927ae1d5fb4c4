#include "core/diagram/group.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/syntax/parser.hpp"

namespace analogon {
namespace {

using testing::HasSubstr;
using testing::Not;

const char* const model = R"(package P
  connector Heat Real T; flow Real Q_flow; end Heat;
  connector RealInput = input Real;
  connector RealOutput = output Real;
  model Body
    Heat port annotation (Placement(transformation(extent={{-10,-110},{10,-90}})));
    parameter Real C = 1;
  end Body;
  model Conductor
    Heat port_a annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
    Heat port_b annotation (Placement(transformation(extent={{90,-10},{110,10}})));
    parameter Real G = 1;
  end Conductor;
  model Source
    RealInput Q_flow(unit="W") annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
    Heat port annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  end Source;
  model M "a model"
    RealInput u annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
    parameter Real k = 2;
    Source source annotation (Placement(transformation(extent={{-70,-10},{-50,10}})));
    Body body(C = 20) "the body" annotation (Placement(transformation(extent={{-20,0},{0,20}})));  // heavy
    Conductor mount(G=k) annotation (Placement(transformation(extent={{20,-10},{40,10}})));
    Body ambient annotation (Placement(transformation(extent={{60,0},{80,20}})));
    Real loss;
  equation
    connect(u, source.Q_flow) annotation (Line(points={{-90,0},{-70,0}}));
    connect(source.port, body.port) annotation (Line(points={{-50,0},{-10,0}}));  // kept
    connect(body.port, mount.port_a);
    connect(mount.port_b, ambient.port);
    loss = body.port.T - 3;
    annotation (Diagram(coordinateSystem(extent={{-120,-40},{100,40}})));
  end M;
end P;
)";

class Grouped : public testing::Test {
protected:
    void SetUp() override {
        Outcome<Library> read = Library().withSource(std::make_shared<const Source>("model.mo", model));
        ASSERT_TRUE(read) << format(read.diagnostics());
        library = std::move(*read);
        definition = library.find("P.M")->definition;
        diagram = *readDiagram(library, "P.M");
    }
    Outcome<std::string> group(std::vector<std::string> components) const {
        const Outcome<syntax::TextEdit> edit =
            groupComponents(library, diagram, *definition, {std::move(components), "Heated", "heated"}, "group");
        if (!edit) return edit.diagnostics();
        const syntax::AppliedEdit applied = syntax::apply(model, *edit);
        EXPECT_EQ(syntax::apply(applied.text, applied.inverse).text, model);
        return applied.text;
    }
    std::string fault(std::vector<std::string> components) const {
        const Outcome<std::string> text = group(std::move(components));
        return text ? "none" : text.diagnostics().front().message;
    }

    Library library;
    syntax::ClassPtr definition;
    Diagram diagram;
};

TEST_F(Grouped, StandsInANewClassWithAConnectorForEachWireAcrossTheBorder) {
    const Outcome<std::string> text = group({"source", "body"});
    ASSERT_TRUE(text) << format(text.diagnostics());
    Outcome<Library> read = Library().withSource(std::make_shared<const Source>("model.mo", *text));
    ASSERT_TRUE(read) << format(read.diagnostics()) << *text;

    const Diagram outer = *readDiagram(*read, "P.M"), inner = *readDiagram(*read, "P.Heated");
    EXPECT_FALSE(outer.find("source") || outer.find("body"));
    ASSERT_TRUE(outer.find("heated"));
    EXPECT_TRUE(outer.find("heated")->isResolved);
    std::vector<std::string> wires;
    for (const Wire& w : outer.wires) wires.push_back(w.from + " " + w.to);
    EXPECT_THAT(wires, testing::UnorderedElementsAre("u heated.Q_flow", "heated.port mount.port_a",
                                                     "mount.port_b ambient.port"));
    wires.clear();
    for (const Wire& w : inner.wires) wires.push_back(w.from + " " + w.to);
    EXPECT_THAT(wires,
                testing::UnorderedElementsAre("source.port body.port", "source.Q_flow Q_flow", "body.port port"));

    EXPECT_THAT(*text, HasSubstr("Body body(C = 20) \"the body\" annotation")) << "word for word";
    EXPECT_THAT(*text, HasSubstr("RealInput Q_flow(unit=\"W\")"));
    EXPECT_THAT(*text, HasSubstr("loss = heated.body.port.T - 3;")) << "references follow";
    EXPECT_EQ(outer.anchor("heated.Q_flow")->x, outer.find("heated")->placement.extent.p1.x) << "u is on the left";
    EXPECT_EQ(outer.anchor("heated.port")->x, outer.find("heated")->placement.extent.p2.x);
    for (const Wire& w : inner.wires) EXPECT_GE(w.points.size(), 2u);
}

TEST_F(Grouped, SharesOneConnectorBetweenTheWiresOfAPort) {
    const Outcome<std::string> text = group({"body"});
    ASSERT_TRUE(text) << format(text.diagnostics());
    EXPECT_THAT(*text, HasSubstr("connect(source.port, heated.port)"));
    EXPECT_THAT(*text, HasSubstr("connect(heated.port, mount.port_a)"));
    EXPECT_THAT(*text, Not(HasSubstr("port1")));
}

TEST_F(Grouped, SaysWhatCannotMove) {
    EXPECT_EQ(fault({"mount"}), "mount refers to k, which would stay outside");
    EXPECT_EQ(fault({"u", "source"}), "u is a connector of the model and stays outside");
    EXPECT_EQ(fault({"nothing"}), "nothing is not declared in M itself");
    EXPECT_EQ(fault({}), "there is nothing to be grouped");
}

}  // namespace
}  // namespace analogon
