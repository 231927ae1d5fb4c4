#include "core/diagram/edit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "core/syntax/parser.hpp"

namespace analogon {
namespace {

using testing::HasSubstr;
using testing::Not;

const char* const drive = R"(within Test;
model Drive "A drive"
  // supply
  Analogon.Interfaces.RealInput v(unit="V") annotation (Placement(transformation(extent={{-90,-10},{-70,10}})));
  Motor motor(R=0.36, k = 0.02) "the motor" annotation (Placement(transformation(extent={{-10,-10},{10,10}})));  // hand-wound
  Rotor a, b(J=1), c;
  parameter Real gain = 3 "a gain";
  parameter Real bare;
protected
  Real hidden;
equation
  connect(v, motor.v) annotation (Line(points={{-70,0},{-10,0}}, color={0,0,127}));
  connect(motor.flange, a.flange_a);  // rigid
  connect(a.flange_b,
          b.flange_a);
  hidden = gain*a.w + b.w;
  annotation (Diagram(coordinateSystem(extent={{-100,-100},{100,100}})));
end Drive;
)";

/// A text, its tree, and what an edit makes of it. Every result must parse and undo byte for byte.
class Edited {
public:
    explicit Edited(std::string text) : source_(std::make_shared<const Source>("model.mo", std::move(text))) {
        parsed_ = syntax::parse(source_);
        EXPECT_FALSE(hasError(parsed_.diagnostics)) << format(parsed_.diagnostics);
    }
    const syntax::ClassDefinition& definition() const { return *parsed_.definition.classes.front(); }
    ModelEdit edit() const { return ModelEdit(definition()); }
    std::string operator()(const ModelEdit& edit) const {
        const auto change = edit.finish("change");
        EXPECT_TRUE(change) << format(change.diagnostics());
        if (!change) return {};
        const syntax::AppliedEdit applied = syntax::apply(source_->text(), *change);
        EXPECT_EQ(syntax::apply(applied.text, applied.inverse).text, source_->text()) << "undo is not exact";
        const auto again = syntax::parse(std::make_shared<const Source>("edited.mo", applied.text));
        EXPECT_FALSE(hasError(again.diagnostics)) << format(again.diagnostics) << applied.text;
        return applied.text;
    }

private:
    SourcePtr source_;
    syntax::ParseResult parsed_;
};

std::string model(const std::string& body) { return "model M\n" + body + "end M;\n"; }

TEST(ModelEdit, ChangesNothingWhenNothingWasAsked) {
    const Edited text(drive);
    EXPECT_EQ(text(text.edit()), drive);
}

TEST(ModelEdit, SetsAnExistingModificationAndKeepsTheLayoutAroundIt) {
    const Edited text(drive);
    EXPECT_THAT(text(text.edit().setModifier("motor", "k", "0.05")),
                HasSubstr("motor(R=0.36, k = 0.05) \"the motor\""));
}

TEST(ModelEdit, CombinesSeveralModificationsOfOneComponent) {
    const Edited text(drive);
    auto edit = text.edit();
    edit.setModifier("motor", "R", "1").setModifier("motor", "L", "2").setModifier("motor", "tau", "3");
    edit.setModifier("motor", "R", "4").setModifier("motor", "k", "5");
    EXPECT_THAT(text(edit), HasSubstr("motor(R=4, k = 5, L=2, tau=3) \"the motor\""));
}

TEST(ModelEdit, OpensAModificationListWhereThereIsNone) {
    const Edited text(drive);
    auto edit = text.edit();
    edit.setModifier("a", "J", "1e-3").setModifier("a", "w0", "2").setModifier("c", "J", "5");
    EXPECT_THAT(text(edit), HasSubstr("Rotor a(J=1e-3, w0=2), b(J=1), c(J=5);"));
}

TEST(ModelEdit, FillsAnEmptyModificationList) {
    const Edited text(model("  Motor m() annotation (Dialog());\n"));
    EXPECT_THAT(text(text.edit().setModifier("m", "R", "1")), HasSubstr("Motor m(R=1) annotation (Dialog());"));
}

TEST(ModelEdit, RemovesModificationsWithTheirCommas) {
    const Edited text(model("  Motor m(R=1, /* keep */ k=2, L=3);\n"));
    EXPECT_THAT(text(text.edit().setModifier("m", "R", "")), HasSubstr("m(k=2, L=3);"));
    EXPECT_THAT(text(text.edit().setModifier("m", "k", "")), HasSubstr("m(R=1, /* keep */ L=3);"));
    EXPECT_THAT(text(text.edit().setModifier("m", "L", "")), HasSubstr("m(R=1, /* keep */ k=2);"));
    auto all = text.edit();
    all.setModifier("m", "R", "").setModifier("m", "k", "").setModifier("m", "L", "");
    EXPECT_THAT(text(all), HasSubstr("Motor m;"));
    auto tail = text.edit();
    tail.setModifier("m", "L", "").setModifier("m", "k", "").setModifier("m", "d", "9");
    EXPECT_THAT(text(tail), HasSubstr("m(R=1, d=9);"));
    auto exchanged = text.edit();
    exchanged.setModifier("m", "R", "").setModifier("m", "L", "").setModifier("m", "k", "").setModifier("m", "d", "9");
    EXPECT_THAT(text(exchanged), HasSubstr("Motor m(d=9);"));
}

TEST(ModelEdit, ReachesIntoNestedModifications) {
    const Edited text(model("  Drive d(rotor(J=1, min=0), motor.R=2, stage(start(fixed=true)), k(min=0));\n"));
    auto edit = text.edit();
    edit.setModifier("d", "rotor.J", "3").setModifier("d", "rotor.d", "4").setModifier("d", "motor.R", "5");
    edit.setModifier("d", "stage", "6").setModifier("d", "k", "7").setModifier("d", "motor.k", "8");
    EXPECT_THAT(text(edit), HasSubstr("d(rotor(J=3, min=0, d=4), motor.R=5, stage(start(fixed=true))=6, k(min=0)=7, "
                                      "motor.k=8);"));
}

TEST(ModelEdit, SetsAndRemovesBindings) {
    const Edited text(drive);
    EXPECT_THAT(text(text.edit().setParameter("gain", "4.5")), HasSubstr("parameter Real gain = 4.5 \"a gain\";"));
    EXPECT_THAT(text(text.edit().setParameter("gain", "")), HasSubstr("parameter Real gain \"a gain\";"));
    EXPECT_THAT(text(text.edit().setParameter("bare", "2")), HasSubstr("parameter Real bare = 2;"));
    EXPECT_THAT(text(text.edit().setParameter("motor.R", "2")), HasSubstr("motor(R=2, k = 0.02)"));
    auto both = text.edit();
    both.setModifier("bare", "min", "0").setBinding("bare", "2");
    EXPECT_THAT(text(both), HasSubstr("parameter Real bare(min=0) = 2;"));
}

TEST(ModelEdit, AddsComponentsBehindTheLastPublicOne) {
    const Edited text(drive);
    NewComponent friction{"Analogon.Effects.Mechanics.DryFriction",
                          "friction",
                          {{"tau_c", "0.002"}},
                          "dry friction",
                          {{{10, 20}, {30, 40}}, {}, 0}};
    const std::string result = text(text.edit().addComponent(friction).addComponent({"Clutch", "clutch", {}, "", {}}));
    EXPECT_THAT(result,
                HasSubstr("  parameter Real bare;\n"
                          "  Analogon.Effects.Mechanics.DryFriction friction(tau_c=0.002) \"dry friction\" "
                          "annotation (Placement(transformation(extent={{10,20},{30,40}})));\n"
                          "  Clutch clutch annotation (Placement(transformation(extent={{-10,-10},{10,10}})));\n"
                          "protected\n"));
}

TEST(ModelEdit, SetsModificationsOfAComponentItAdds) {
    const Edited text(drive);
    auto edit = text.edit();
    edit.addComponent({"Clutch", "clutch", {{"c", "1"}}, "", {}}).setModifier("clutch", "d", "2");
    edit.setModifier("clutch", "c", "3");
    EXPECT_THAT(text(edit), HasSubstr("Clutch clutch(d=2, c=3)"));
}

TEST(ModelEdit, AddsTheFirstComponentBehindTheDescription) {
    const Edited text("model Empty \"says \\\"nothing\\\"\" // yet\nend Empty;\n");
    const std::string result = text(text.edit().addComponent({"Motor", "m", {}, "", {}}));
    EXPECT_THAT(result, HasSubstr("// yet\n  Motor m annotation"));
    const Edited extended("model Empty\n  extends Base;  // of it\nequation\nend Empty;\n");
    EXPECT_THAT(extended(extended.edit().addComponent({"Motor", "m", {}, "", {}})),
                HasSubstr("  extends Base;  // of it\n  Motor m annotation"));
}

TEST(ModelEdit, AddsConnectionsBehindTheLastEquation) {
    const Edited text(drive);
    const std::string result =
        text(text.edit().addConnection("b.flange_b", "c.flange_a", {{0, 0}, {10, 0}, {10, 20}}, {95, 95, 95}));
    EXPECT_THAT(result, HasSubstr("  hidden = gain*a.w + b.w;\n"
                                  "  connect(b.flange_b, c.flange_a) annotation (Line(points={{0,0},{10,0},{10,20}}, "
                                  "color={95,95,95}));\n"
                                  "  annotation (Diagram("));
}

TEST(ModelEdit, OpensAnEquationSectionWhereThereIsNone) {
    const Edited bare(model("  Motor m;\n"));
    EXPECT_THAT(bare(bare.edit().addConnection("m.a", "m.b", {}, {})),
                HasSubstr("  Motor m;\nequation\n  connect(m.a, m.b);\nend M;"));
    const Edited annotated(model("  Motor m;\n  annotation (Icon());\n"));
    EXPECT_THAT(annotated(annotated.edit().addConnection("m.a", "m.b", {}, {})),
                HasSubstr("  Motor m;\nequation\n  connect(m.a, m.b);\n  annotation (Icon());\nend M;"));
    const Edited initial(model("  Real x;\ninitial equation\n  x = 1;\n"));
    EXPECT_THAT(initial(initial.edit().addConnection("m.a", "m.b", {}, {})),
                HasSubstr("  x = 1;\nequation\n  connect(m.a, m.b);\nend M;"));
    const Edited empty(model("  Motor m;\nequation // nothing yet\n"));
    EXPECT_THAT(empty(empty.edit().addConnection("m.a", "m.b", {}, {})),
                HasSubstr("equation // nothing yet\n  connect(m.a, m.b);\nend M;"));
    const Edited oneLine("model M Motor m; end M;");
    EXPECT_THAT(oneLine(oneLine.edit().addConnection("m.a", "m.b", {}, {})), HasSubstr("connect(m.a, m.b);"));
}

TEST(ModelEdit, RemovesAComponentWithItsConnections) {
    const Edited text(drive);
    const std::string result = text(text.edit().removeComponent("motor"));
    EXPECT_THAT(result, Not(HasSubstr("motor")));
    EXPECT_THAT(result, HasSubstr("// hand-wound"));
    EXPECT_THAT(result, HasSubstr("// rigid"));
    EXPECT_THAT(result, HasSubstr("  connect(a.flange_b,\n          b.flange_a);"));
}

TEST(ModelEdit, RemovesOneOfSeveralComponentsOfAClause) {
    const Edited text(drive);
    EXPECT_THAT(text(text.edit().removeComponent("a")), HasSubstr("  Rotor b(J=1), c;\n"));
    EXPECT_THAT(text(text.edit().removeComponent("b")), HasSubstr("  Rotor a, c;\n"));
    EXPECT_THAT(text(text.edit().removeComponent("c")), HasSubstr("  Rotor a, b(J=1);\n"));
    EXPECT_THAT(text(text.edit().removeComponent("a").removeComponent("c")), HasSubstr("  Rotor b(J=1);\n"));
    EXPECT_THAT(text(text.edit().removeComponent("b").removeComponent("c")), HasSubstr("  Rotor a;\n"));
    EXPECT_THAT(text(text.edit().removeComponent("a").removeComponent("b").removeComponent("c")),
                Not(HasSubstr("Rotor")));
}

TEST(ModelEdit, ChangesTheClassOfOneComponentOfAClause) {
    const Edited text(drive);
    EXPECT_THAT(text(text.edit().setClass("motor", "Lib.HotMotor").setModifier("motor", "alpha", "0.004")),
                HasSubstr("  Lib.HotMotor motor(R=0.36, k = 0.02, alpha=0.004) \"the motor\" annotation"));
    EXPECT_THAT(text(text.edit().setClass("b", "Heavy").setModifier("b", "J", "2")),
                HasSubstr("  Rotor a, c;\n  Heavy b(J=2);\n"));
}

TEST(ModelEdit, RenamesEverywhereButNotShadowedOrForeignNames) {
    const Edited text(
        model("  Rotor a, ab(J=a.J);\n  Real x[3] = {a * a.k for a in 1:3};\nequation\n"
              "  connect(a.flange, ab.flange);\n  for i in 1:3 loop\n    x[i] = a.w[i] + ab.a;\n"
              "  end for;\n"));
    const std::string result = text(text.edit().renameComponent("a", "rotor1"));
    EXPECT_THAT(result, HasSubstr("Rotor rotor1, ab(J=rotor1.J);"));
    EXPECT_THAT(result, HasSubstr("{a * a.k for a in 1:3}"));
    EXPECT_THAT(result, HasSubstr("connect(rotor1.flange, ab.flange);"));
    EXPECT_THAT(result, HasSubstr("x[i] = rotor1.w[i] + ab.a;"));
}

TEST(ModelEdit, InsertsIntoAConnection) {
    const Edited text(drive);
    auto edit = text.edit();
    edit.addComponent({"Lag", "lag", {}, "", {}});
    edit.replaceInConnections("motor.v", "lag.u").addConnection("lag.y", "motor.v", {}, {});
    const std::string result = text(edit);
    EXPECT_THAT(result, HasSubstr("connect(v, lag.u) annotation (Line(points={{-70,0},{-10,0}}"));
    EXPECT_THAT(result, HasSubstr("connect(lag.y, motor.v);"));
}

TEST(ModelEdit, RemovesAConnectionInEitherDirection) {
    const Edited text(drive);
    const std::string result = text(text.edit().removeConnection("b.flange_a", "a.flange_b"));
    EXPECT_THAT(result, Not(HasSubstr("a.flange_b")));
    EXPECT_THAT(result, HasSubstr("// rigid\n  hidden = "));
}

/// As when a block is led into the only connection: what is added stands where what goes has stood.
TEST(ModelEdit, ReplacesTheLastConnectionAndTheLastComponent) {
    const std::string before =
        "model M\n  Motor m;\n  Motor n;\nequation\n  connect(m.a, n.b);\n  annotation (Icon());\nend M;\n";
    const Edited text(before);
    auto edit = text.edit();
    edit.removeConnection("m.a", "n.b").addConnection("m.a", "x.a", {}, {}).addConnection("x.b", "n.b", {}, {});
    EXPECT_EQ(text(edit),
              "model M\n  Motor m;\n  Motor n;\nequation\n  connect(m.a, x.a);\n  connect(x.b, n.b);\n"
              "  annotation (Icon());\nend M;\n");
    auto other = text.edit();
    other.removeComponent("n").addConnection("m.a", "x.a", {}, {}).addComponent({"Motor", "x", {}, "", {}});
    const std::string replaced = text(other);
    EXPECT_THAT(replaced, HasSubstr("model M\n  Motor m;\n  Motor x annotation"));
    EXPECT_THAT(replaced, HasSubstr("equation\n  connect(m.a, x.a);\n  annotation (Icon());\nend M;"));
}

TEST(ModelEdit, MovesBlocksAndLines) {
    const Edited text(drive);
    const Placement moved{{{0, 0}, {20, 20}}, {5, 5}, 90};
    EXPECT_THAT(
        text(text.edit().setPlacement("motor", moved)),
        HasSubstr("(Placement(transformation(origin={5,5}, extent={{0,0},{20,20}}, rotation=90)));  // hand-wound"));
    EXPECT_THAT(text(text.edit().setPlacement("a", moved)), HasSubstr("Rotor a annotation (Placement("));
    EXPECT_THAT(text(text.edit().setLine("v", "motor.v", {{1, 2}, {3, 4}})),
                HasSubstr("(Line(points={{1,2},{3,4}}, color={0,0,127}));"));
    EXPECT_THAT(
        text(text.edit().setLine("motor.flange", "a.flange_a", {{1, 2}, {3, 4}})),
        HasSubstr(
            "connect(motor.flange, a.flange_a) annotation (Line(points={{1,2},{3,4}}, color={0,0,0}));  // rigid"));
}

TEST(ModelEdit, KeepsOtherAnnotationsOfAMovedBlock) {
    const Edited text(
        model("  Motor m annotation (Dialog(group=\"x\"), Placement(visible=true, transformation(extent="
              "{{0,0},{1,1}}), iconTransformation(rotation=5)));\n  Motor n annotation (Dialog(tab=\"y\"));\n"));
    auto edit = text.edit();
    edit.setPlacement("m", {{{0, 0}, {2, 2}}, {}, 0}).setPlacement("n", {{{0, 0}, {3, 3}}, {}, 0});
    const std::string result = text(edit);
    EXPECT_THAT(result, HasSubstr("(Dialog(group=\"x\"), Placement(visible=true, transformation(extent={{0,0},{2,2}}), "
                                  "iconTransformation(rotation=5)))"));
    EXPECT_THAT(result, HasSubstr("(Dialog(tab=\"y\"), Placement(transformation(extent={{0,0},{3,3}})))"));
}

TEST(ModelEdit, KeepsTheLineEndsOfTheFile) {
    std::string text = drive;
    for (std::size_t i = text.find('\n'); i != std::string::npos; i = text.find('\n', i + 2)) text.insert(i, "\r");
    const Edited windows(text);
    auto edit = windows.edit();
    edit.addComponent({"Clutch", "clutch", {}, "", {}}).addConnection("a.x", "b.y", {}, {}).removeComponent("v");
    const std::string result = windows(edit);
    for (std::size_t i = result.find('\n'); i != std::string::npos; i = result.find('\n', i + 1))
        EXPECT_EQ(result[i - 1], '\r');
}

TEST(ModelEdit, NamesWhatItCannotFind) {
    const Edited text(drive);
    const auto component = text.edit().setModifier("motr", "R", "1").finish("x");
    ASSERT_FALSE(component);
    EXPECT_EQ(component.diagnostics().front().message, "model Drive has no component \"motr\"");
    EXPECT_EQ(component.diagnostics().front().hint, "did you mean \"motor\"?");
    const auto connection = text.edit().removeConnection("v", "a.flange_a").finish("x");
    ASSERT_FALSE(connection);
    EXPECT_EQ(connection.diagnostics().front().message, "model Drive has no connection of \"v\" with \"a.flange_a\"");
    EXPECT_FALSE(text.edit().replaceInConnections("c.flange", "d.flange").finish("x"));
}

TEST(FreeName, CountsOnWhereTheNameIsTaken) {
    const Edited text(model("  Real lag, lag1;\n"));
    EXPECT_EQ(freeName(text.definition(), "lag"), "lag2");
    EXPECT_EQ(freeName(text.definition(), "friction"), "friction");
    EXPECT_EQ(freeName(text.definition(), "M"), "M1");
    EXPECT_EQ(freeName(text.definition(), "flow"), "flow1") << "a word of the language";
}

TEST(FreePlacement, CoversNoBlockAndStaysOnTheGrid) {
    Diagram diagram;
    for (int i = -2; i <= 2; ++i) {
        Block block;
        block.placement.extent = {{40.0 * i - 10, -10}, {40.0 * i + 10, 10}};
        diagram.blocks.push_back(block);
    }
    const Placement place = freePlacement(diagram, {0, 0}, 20, 20);
    const Extent& e = place.extent;
    EXPECT_EQ(std::fmod(e.p1.x, 10), 0);
    EXPECT_EQ(std::fmod(e.p1.y, 10), 0);
    EXPECT_GE(std::abs((e.p1.y + e.p2.y) / 2), 20) << "beside the row of blocks";
    EXPECT_LE(std::hypot(e.p1.x + 10, e.p1.y + 10), 45) << "near the place that was asked for";
    EXPECT_GT(e.p1.x, 0) << "its left port can be reached from the point without crossing it";
}

// ---- inherited components ------------------------------------------------------------------------------------

TEST(ModelEdit, WritesAnInheritedParameterIntoTheExtendsClause) {
    const Edited text("model Lag \"a lag\"\n  extends Own.First(T = 3);  // seconds\nend Lag;\n");
    EXPECT_EQ(text(text.edit().setParameter("T", "2.5")),
              "model Lag \"a lag\"\n  extends Own.First(T = 2.5);  // seconds\nend Lag;\n");
    EXPECT_EQ(text(text.edit().setParameter("k", "2").setParameter("rotor.J", "0.1")),
              "model Lag \"a lag\"\n  extends Own.First(T = 3, k=2, rotor.J=0.1);  // seconds\nend Lag;\n");
    EXPECT_EQ(text(text.edit().setParameter("T", "")),
              "model Lag \"a lag\"\n  extends Own.First;  // seconds\nend Lag;\n");
}

TEST(ModelEdit, OpensTheModificationsOfAnExtendsClauseAndOfAShortClass) {
    const Edited longer("model Lag\n  extends Own.First annotation (Icon());\nend Lag;\n");
    EXPECT_EQ(longer(longer.edit().setParameter("T", "2")),
              "model Lag\n  extends Own.First(T=2) annotation (Icon());\nend Lag;\n");
    const Edited brief("model Lag = Own.First(rotor(J = 1)) \"a lag\";\n");
    EXPECT_EQ(brief(brief.edit().setParameter("rotor.J", "2").setParameter("T", "3")),
              "model Lag = Own.First(rotor(J = 2), T=3) \"a lag\";\n");
}

TEST(ModelEdit, ReachesIntoARedeclaredComponent) {
    const Edited text(model("  Drive drive(redeclare Fast motor(R = 1), redeclare Slow rotor);\n"));
    EXPECT_THAT(text(text.edit().setModifier("drive", "motor.R", "2").setModifier("drive", "rotor.J", "3")),
                HasSubstr("drive(redeclare Fast motor(R = 2), redeclare Slow rotor(J=3));"));
}

/// Two bases and a model that inherits from both, as a library.
class InheritingModel {
public:
    explicit InheritingModel(const std::string& text) {
        static const char* const bases = R"(package Own
  model First
    parameter Real T = 1;
    replaceable Plain motor constrainedby Plain annotation (Placement(transformation(extent={{0,0},{20,20}})));
    Plain shaft;
  end First;
  model Second
    parameter Real k = 1;
  end Second;
  model Plain
    parameter Real R = 1;
  end Plain;
  model Other
    extends Plain;
    parameter Real a = 0;
  end Other;
end Own;
)";
        auto with = Library().withSource(std::make_shared<const Source>("own.mo", bases));
        EXPECT_TRUE(with) << format(with.diagnostics());
        source_ = std::make_shared<const Source>("model.mo", text);
        with = with->withSource(source_);
        EXPECT_TRUE(with) << format(with.diagnostics());
        library_ = *with;
    }
    ModelEdit edit() const { return ModelEdit(*library_.find("M")->definition, nullptr, &library_); }
    std::string operator()(const ModelEdit& edit) const {
        const auto change = edit.finish("change");
        if (!change) return format(change.diagnostics());
        const std::string text = syntax::apply(source_->text(), *change).text;
        EXPECT_TRUE(library_.withSource(std::make_shared<const Source>("model.mo", text))) << text;
        return text;
    }
    const Library& library() const { return library_; }

private:
    SourcePtr source_;
    Library library_;
};

TEST(ModelEdit, FindsTheBaseThatHoldsTheComponent) {
    const InheritingModel text("model M\n  extends Own.First;\n  extends Own.Second(k = 2);\nend M;\n");
    EXPECT_EQ(text(text.edit().setParameter("k", "3").setParameter("motor.R", "4")),
              "model M\n  extends Own.First(motor.R=4);\n  extends Own.Second(k = 3);\nend M;\n");
    EXPECT_THAT(text(text.edit().setParameter("motr.R", "4")), HasSubstr("did you mean \"motor\"?"));
}

TEST(ModelEdit, RedeclaresAnInheritedReplaceableComponent) {
    const InheritingModel text("model M\n  extends Own.First(motor(R = 2));\nend M;\n");
    auto edit = text.edit();
    edit.setClass("motor", "Own.Other").setModifier("motor", "a", "3");
    EXPECT_EQ(text(edit), "model M\n  extends Own.First(redeclare Own.Other motor(R = 2, a=3));\nend M;\n");
    const InheritingModel bare("model M\n  extends Own.First;\nend M;\n");
    auto other = bare.edit();
    other.setClass("motor", "Own.Other").setModifier("motor", "a", "3");
    const std::string result = bare(other);
    EXPECT_EQ(result, "model M\n  extends Own.First(redeclare Own.Other motor(a=3));\nend M;\n");
    const auto diagram = readDiagram(InheritingModel(result).library(), "M");
    ASSERT_TRUE(diagram);
    const Block* motor = diagram->find("motor");
    ASSERT_NE(motor, nullptr);
    EXPECT_EQ(motor->className, "Own.Other");
    EXPECT_EQ(motor->parameters, (std::vector<std::pair<std::string, std::string>>{{"a", "3"}}));
    EXPECT_EQ(motor->placement.extent.p2, (Point{20, 20}));
}

TEST(ModelEdit, SaysWhatCannotBeDoneToAnInheritedComponent) {
    const InheritingModel text("model M\n  extends Own.First;\nend M;\n");
    EXPECT_THAT(text(text.edit().setClass("shaft", "Own.Other")),
                HasSubstr("it is inherited from Own.First, where it is not replaceable"));
    EXPECT_THAT(text(text.edit().removeComponent("shaft")),
                HasSubstr("\"shaft\" is inherited from Own.First and cannot be removed in model M"));
    EXPECT_THAT(text(text.edit().renameComponent("shaft", "axle")), HasSubstr("cannot be renamed"));
    EXPECT_THAT(text(text.edit().setPlacement("shaft", {})), HasSubstr("cannot be moved"));
    EXPECT_THAT(text(text.edit().replaceInConnections("shaft.a", "x.b")), HasSubstr("an inherited connection"));
}

TEST(ModelEdit, MakesRoomInAShortClass) {
    const InheritingModel text("model M = Own.First(T = 2) \"short\" annotation (Icon());\n");
    auto edit = text.edit();
    edit.addComponent({"Own.Plain", "more", {{"R", "5"}}, "", {{{-10, -10}, {10, 10}}, {}, 0}});
    edit.addConnection("more.a", "motor.b", {}, {}).setParameter("T", "4");
    EXPECT_EQ(text(edit), R"(model M "short"
  extends Own.First(T = 4);
  Own.Plain more(R=5) annotation (Placement(transformation(extent={{-10,-10},{10,10}})));
equation
  connect(more.a, motor.b);
  annotation (Icon());
end M;
)");
}

TEST(FreeName, AvoidsInheritedNamesToo) {
    const InheritingModel text("model M\n  extends Own.First;\nend M;\n");
    EXPECT_EQ(freeName(text.library(), *text.library().find("M")->definition, "motor"), "motor1");
}

TEST(ModelEdit, PutsAnotherVariableWhereOneIsUsed) {
    const Edited text(
        "model M\n  input Real u;\n  output Real y = 2*x + u;\n  Real x;\n  Part part(k = u);\nequation\n"
        "  der(x) = y*u;\n  connect(u, part.u);\nend M;\n");
    auto input = text.edit();
    input.replaceReferences("u", "lag.y").addEquation("lag.u = u");
    EXPECT_EQ(text(input),
              "model M\n  input Real u;\n  output Real y = 2*x + lag.y;\n  Real x;\n  Part part(k = lag.y);\n"
              "equation\n  der(x) = y*lag.y;\n  connect(u, part.u);\n  lag.u = u;\nend M;\n");
    auto output = text.edit();
    output.replaceReferences("y", "filter.u").addEquation("y = filter.y");
    EXPECT_EQ(text(output),
              "model M\n  input Real u;\n  output Real y;\n  Real x;\n  Part part(k = u);\nequation\n"
              "  der(x) = filter.u*u;\n  connect(u, part.u);\n  filter.u = 2*x + u;\n  y = filter.y;\nend M;\n");
}

TEST(ModelEdit, SetsOneElementOfAnArrayByWritingAll) {
    const Edited text(
        model("  parameter Real G[2] = {1, 2};\n  Mass mass[3](each C = 2, each final T = 1);\n"
              "  Mass grid[2, 2](v = fill(7, 2, 2, 2));\n"));
    std::map<std::string, std::string> values{
        {"G[1]", "1"},           {"G[2]", "2"},           {"mass[1].C", "2"},     {"mass[2].C", "2"},
        {"mass[3].C", "2"},      {"mass[1].T", "1"},      {"mass[2].T", "1"},     {"mass[3].T", "1"},
        {"mass[1].a", "5"},      {"mass[2].a", "5"},      {"mass[3].a", "5"},     {"grid[1,1].v[1]", "7"},
        {"grid[1,2].v[1]", "7"}, {"grid[2,1].v[1]", "7"}, {"grid[2,2].v[1]", "7"}};
    auto edit = text.edit();
    edit.valuesOf([&](const std::string& name) {
        const auto found = values.find(name);
        return found == values.end() ? std::nullopt : std::optional(found->second);
    });
    edit.setParameter("G[2]", "9").setParameter("mass[2].C", "3").setParameter("mass[3].C", "4");
    edit.setParameter("mass[1].T", "0").setParameter("mass[1].a", "6").setParameter("grid[2,1].v[1]", "8");
    EXPECT_EQ(text(edit), model("  parameter Real G[2] = {1, 9};\n"
                                "  Mass mass[3](C = {2, 3, 4}, final T = {0, 1, 1}, a={6, 5, 5});\n"
                                "  Mass grid[2, 2](v = {{{7}, {7}}, {{8}, {7}}});\n"));
    auto unknown = text.edit();
    const auto refused = unknown.setParameter("mass[2].C", "3").finish("set");
    ASSERT_FALSE(refused);
    EXPECT_THAT(format(refused.diagnostics()), HasSubstr("the values of the other elements are not known"));
}

}  // namespace
}  // namespace analogon
