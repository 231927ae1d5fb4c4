#include "core/syntax/parser.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "core/syntax/printer.hpp"

namespace analogon::syntax {
namespace {

ParseResult read(std::string text) { return parse(std::make_shared<const Source>("m.mo", std::move(text))); }

/// The first class of a text without faults.
ClassPtr classOf(std::string text) {
    const ParseResult result = read(std::move(text));
    EXPECT_TRUE(result.diagnostics.empty()) << format(result.diagnostics);
    return result.definition.classes.empty() ? nullptr : result.definition.classes.front();
}

/// The message of the only fault.
Diagnostic faultOf(std::string text) {
    const ParseResult result = read(std::move(text));
    EXPECT_EQ(result.diagnostics.size(), 1u) << format(result.diagnostics);
    return result.diagnostics.empty() ? Diagnostic{} : result.diagnostics.front();
}

TEST(Parser, ReadsAModelWithItsSpans) {
    const std::string text =
        "within Plant.Drives;\n"
        "partial model Motor \"a motor\"\n"
        "  extends Base(R=2, final L=0.1);\n"
        "  parameter Real k(unit=\"V.s/rad\", min=0) = 0.05 \"constant\" annotation (Dialog(group=\"EMF\"));\n"
        "  Flange_a flange annotation (Placement(transformation(extent={{90,-10},{110,10}})));\n"
        "equation\n"
        "  v = R*i + k*der(flange.phi) \"voltage\";\n"
        "  connect(a.b[1], flange) annotation (Line(points={{0,0},{10,0}}));\n"
        "  annotation (Icon(graphics={Rectangle(extent={{-100,-100},{100,100}})}));\n"
        "end Motor;\n";
    const ParseResult result = read(text);
    ASSERT_TRUE(result.diagnostics.empty()) << format(result.diagnostics);
    EXPECT_EQ(result.definition.within->text(), "Plant.Drives");
    const ClassDefinition& motor = *result.definition.classes.at(0);
    EXPECT_TRUE(motor.isPartial);
    EXPECT_EQ(motor.name, "Motor");
    EXPECT_EQ(motor.description, "a motor");
    EXPECT_EQ(motor.nameSpan.text(), "Motor");
    EXPECT_EQ(motor.endSpan.text(), "end Motor");
    EXPECT_TRUE(motor.span.text().starts_with("partial model Motor") && motor.span.text().ends_with("end Motor"));

    ASSERT_EQ(motor.bases.size(), 1u);
    EXPECT_EQ(motor.bases[0].span.text(), "extends Base(R=2, final L=0.1);");
    EXPECT_TRUE(motor.bases[0].modifications.at(1).isFinal);

    const Component& k = motor.components.at(0);
    EXPECT_EQ(k.variability, Variability::Parameter);
    EXPECT_EQ(k.type.text(), "Real");
    EXPECT_EQ(k.nameSpan.text(), "k");
    EXPECT_EQ(k.modificationsSpan.text(), "(unit=\"V.s/rad\", min=0)");
    EXPECT_EQ(k.modifications.at(0).value->text, "V.s/rad");
    EXPECT_EQ(k.binding->number, 0.05);
    EXPECT_EQ(k.description, "constant");
    EXPECT_EQ(k.span.text(), "k(unit=\"V.s/rad\", min=0) = 0.05 \"constant\" annotation (Dialog(group=\"EMF\"))");
    EXPECT_TRUE(k.clauseSpan.text().starts_with("parameter Real k") && k.clauseSpan.text().ends_with(";"));

    const Component& flange = motor.components.at(1);
    EXPECT_EQ(flange.typeSpan.text(), "Flange_a");
    EXPECT_EQ(flange.modificationsSpan.begin, flange.modificationsSpan.end);
    EXPECT_EQ(flange.modificationsSpan.begin, flange.nameSpan.end);
    ASSERT_TRUE(flange.annotation);
    EXPECT_NE(flange.annotation->find("Placement"), nullptr);
    EXPECT_EQ(flange.annotation->find("Line"), nullptr);
    EXPECT_EQ(flange.annotation->span.text(), "annotation (Placement(transformation(extent={{90,-10},{110,10}})))");

    const EquationSection& section = motor.equationSections.at(0);
    EXPECT_EQ(section.keyword.text(), "equation");
    EXPECT_EQ(section.equations.at(0).span.text(), "v = R*i + k*der(flange.phi) \"voltage\";");
    EXPECT_EQ(section.equations.at(1).kind, Equation::Kind::Connect);
    EXPECT_EQ(section.equations.at(1).left.span.text(), "a.b[1]");
    EXPECT_TRUE(motor.annotation->span.text().starts_with("annotation (Icon("));
}

TEST(Parser, ReadsClausesWithSeveralComponents) {
    const ClassPtr a = classOf("model A protected flow Real[3] x[2](each start=1), y = z if b \"d\"; end A;");
    ASSERT_TRUE(a);
    ASSERT_EQ(a->components.size(), 2u);
    const Component& x = a->components[0];
    EXPECT_TRUE(x.isFlow && x.isProtected);
    EXPECT_EQ(x.clauseSize, 2);
    ASSERT_EQ(x.dimensions.size(), 2u);  // x is 2 by 3: the dimensions of the name come first
    EXPECT_EQ(x.dimensions[0].number, 2);
    EXPECT_EQ(x.dimensions[1].number, 3);
    EXPECT_TRUE(x.modifications[0].each);
    const Component& y = a->components[1];
    EXPECT_EQ(y.dimensions.size(), 1u);
    EXPECT_EQ(y.condition->name.text(), "b");
    EXPECT_EQ(y.description, "d");
    EXPECT_EQ(y.clauseSpan.begin, x.clauseSpan.begin);
}

TEST(Parser, ReadsShortClassesAndEnumerations) {
    const ClassPtr p = classOf(
        "package P\n"
        "  type Angle = Real(final unit=\"rad\") \"an angle\";\n"
        "  type Vector = Real[3];\n"
        "  connector RealInput = input Real annotation (Icon());\n"
        "  type Mode = enumeration(off \"no current\", on);\n"
        "  replaceable model Load = Inertia(J=1) constrainedby Base(x=2);\n"
        "end P;");
    ASSERT_TRUE(p);
    ASSERT_EQ(p->classes.size(), 5u);
    EXPECT_EQ(p->classes[0]->shortBase.text(), "Real");
    EXPECT_TRUE(p->classes[0]->shortModifications[0].isFinal);
    EXPECT_EQ(p->classes[0]->description, "an angle");
    EXPECT_FALSE(p->classes[0]->endSpan.valid());
    EXPECT_EQ(p->classes[1]->shortDimensions.size(), 1u);
    EXPECT_EQ(p->classes[2]->shortCausality, Causality::Input);
    EXPECT_TRUE(p->classes[3]->isEnumeration);
    EXPECT_EQ(p->classes[3]->enumeration, (std::vector<std::string>{"off", "on"}));
    EXPECT_EQ(p->classes[3]->enumerationDescriptions[0], "no current");
    EXPECT_TRUE(p->classes[4]->isReplaceable);
    EXPECT_EQ(p->classes[4]->constrainedBy->text(), "Base");
}

TEST(Parser, ReadsRedeclarations) {
    const ClassPtr a = classOf(
        "model A\n"
        "  replaceable Resistor r(R=1) constrainedby OnePort(i(start=0)) \"exchangeable\";\n"
        "  extends B(redeclare final HotResistor r(alpha=0.1), redeclare replaceable model M = N(k=2) constrainedby "
        "O);\n"
        "  redeclare Real x;\n"
        "end A;");
    ASSERT_TRUE(a);
    const Component& r = a->components[0];
    EXPECT_TRUE(r.isReplaceable);
    EXPECT_EQ(r.constrainedBy->text(), "OnePort");
    EXPECT_EQ(r.constrainedByModifications.size(), 1u);
    EXPECT_EQ(r.description, "exchangeable");
    EXPECT_TRUE(a->components[1].isRedeclare);
    const auto& modifications = a->bases[0].modifications;
    ASSERT_EQ(modifications.size(), 2u);
    ASSERT_TRUE(modifications[0].redeclaredComponent);
    EXPECT_EQ(modifications[0].name.text(), "r");
    EXPECT_EQ(modifications[0].redeclaredComponent->type.text(), "HotResistor");
    EXPECT_TRUE(modifications[0].isFinal && modifications[0].redeclaredComponent->isRedeclare);
    ASSERT_TRUE(modifications[1].redeclaredClass);
    EXPECT_EQ(modifications[1].redeclaredClass->shortBase.text(), "N");
    EXPECT_EQ(modifications[1].redeclaredClass->constrainedBy->text(), "O");
    EXPECT_EQ(modifications[1].span.text(), "redeclare replaceable model M = N(k=2) constrainedby O");
}

TEST(Parser, ReadsImports) {
    const ClassPtr a = classOf("model A import B.C; import D = E.F; import G.*; import H.{i, j}; end A;");
    ASSERT_TRUE(a);
    ASSERT_EQ(a->imports.size(), 5u);
    EXPECT_EQ(a->imports[0].alias, "C");
    EXPECT_EQ(a->imports[1].alias, "D");
    EXPECT_EQ(a->imports[1].name.text(), "E.F");
    EXPECT_TRUE(a->imports[2].wildcard);
    EXPECT_EQ(a->imports[4].name.text(), "H.j");
}

TEST(Parser, ReadsIfAndForEquations) {
    const ClassPtr a = classOf(
        "model A\n"
        "initial equation\n"
        "  x = 0;\n"
        "equation\n"
        "  if b then x = 1; elseif c then x = 2; y = 3; else x = 4; end if;\n"
        "  for i in 1:3, j in 1:n loop a[i, j] = i; end for;\n"
        "  assert(x > 0, \"positive\");\n"
        "  a = if b then 1 else 2;\n"
        "end A;");
    ASSERT_TRUE(a);
    ASSERT_EQ(a->equationSections.size(), 2u);
    EXPECT_TRUE(a->equationSections[0].isInitial);
    EXPECT_EQ(a->equationSections[0].keyword.text(), "initial equation");
    const auto& equations = a->equationSections[1].equations;
    ASSERT_EQ(equations.size(), 4u);
    ASSERT_EQ(equations[0].branches.size(), 3u);
    EXPECT_EQ(equations[0].branches[1].body.size(), 2u);
    EXPECT_FALSE(equations[0].branches[2].condition);
    EXPECT_EQ(equations[1].iterators.size(), 2u);
    EXPECT_EQ(equations[2].kind, Equation::Kind::Call);
    EXPECT_EQ(equations[3].right.kind, Expression::Kind::If);
}

TEST(Parser, ReadsCommentsAndAByteOrderMark) {
    const ClassPtr a = classOf("\xef\xbb\xbf// first\nmodel /* a\n b */ A // \"\nend A;");
    ASSERT_TRUE(a);
    EXPECT_EQ(a->name, "A");
}

TEST(Parser, JoinsDescriptionsInParts) {
    EXPECT_EQ(classOf("model A \"one \" + \"two\" end A;")->description, "one two");
}

TEST(Parser, AcceptsForeignAnnotations) {
    const ClassPtr a = classOf(
        "model A Real x annotation (choices(choice(redeclare B b \"x\")), __Vendor(table=[0, 1; 2, 3], list={}));\n"
        "  annotation (uses(Modelica(version=\"4.0.0\")), experiment(StopTime=1.0), version=\"1\");\n"
        "end A;");
    ASSERT_TRUE(a);
    EXPECT_EQ(a->annotation->arguments.size(), 3u);
}

TEST(Parser, KeepsTheSourceAlive) {
    ClassPtr a;
    { a = read("model A Real x; end A;").definition.classes.at(0); }
    EXPECT_EQ(a->components[0].span.text(), "x");
    EXPECT_EQ(a->source->name(), "m.mo");
}

TEST(Parser, PointsAtAMissingSemicolonAndGoesOn) {
    const ParseResult result = read("model A\n  Real x\n  Real y;\nequation\n  x = 1\n  y = 2;\nend A;\n");
    ASSERT_EQ(result.diagnostics.size(), 2u) << format(result.diagnostics);
    EXPECT_EQ(format(result.diagnostics[0]),
              "m.mo:2:9: error: expected \";\" after the declaration\n    Real x\n          ^\n");
    EXPECT_EQ(result.diagnostics[1].place.line, 5);
    EXPECT_EQ(result.diagnostics[1].place.column, 8);
    EXPECT_EQ(result.definition.classes.at(0)->components.size(), 2u);
    EXPECT_EQ(result.definition.classes.at(0)->equationSections.at(0).equations.size(), 2u);
}

TEST(Parser, ReportsIndependentFaultsInOneRun) {
    const ParseResult result = read(
        "model A\n"
        "  Real x = ;\n"
        "  parameter parameter Real p;\n"
        "  Real y;\n"
        "equation\n"
        "  x = = 3;\n"
        "  y = 1;\n"
        "  for i in 1:3 loop z[i] = ); w = 1; end for;\n"
        "  if x > then y = 2; else y = 3; end if;\n"
        "  y == 2;\n"
        "end A;\n"
        "model B\n"
        "  Real 3;\n"
        "end B;\n");
    std::vector<int> lines;
    for (const Diagnostic& diagnostic : result.diagnostics) lines.push_back(diagnostic.place.line);
    EXPECT_EQ(lines, (std::vector<int>{2, 3, 6, 8, 9, 10, 13})) << format(result.diagnostics);
    EXPECT_EQ(result.definition.classes.size(), 2u);
}

TEST(Parser, ExplainsCommonMistakes) {
    EXPECT_EQ(faultOf("model A Real x; equation x := 1; end A;").hint, "an equation is written with \"=\"");
    EXPECT_EQ(faultOf("model A Real x; equation x == 1; end A;").message,
              "\"==\" compares; an equation is written with \"=\"");
    EXPECT_EQ(faultOf("model A equation Real x; end A;").message, "a declaration cannot stand in the equation section");
    EXPECT_EQ(faultOf("model A Real output; end A;").hint, "\"output\" is a word of the language; choose another name");
    EXPECT_EQ(faultOf("model A Real x; end B;").message, "\"A\" is closed by the name \"B\"");
    EXPECT_EQ(faultOf("model A Real x; end B;").hint, "write \"end A;\"");
    EXPECT_EQ(faultOf("model A Real x;").message, "the model \"A\" is not closed");
    EXPECT_EQ(faultOf("model A Real x; end;").message, "expected the name of the class behind \"end\"");
    EXPECT_EQ(faultOf("model A Real x; end A").message,
              "expected \";\" after the class \"A\", found the end of the text");
    EXPECT_EQ(faultOf("Real x;").hint, "a Modelica file holds classes: model A … end A;");
    EXPECT_EQ(faultOf("modle A end A;").hint, "did you mean \"model\"?");
    EXPECT_EQ(faultOf("model A paramter Real k = 1; end A;").hint, "did you mean \"parameter\"?");
    EXPECT_EQ(faultOf("").message, "the text holds no class");
    EXPECT_EQ(faultOf("model A equation connect(a); end A;").hint, "connect(a.port, b.port)");
    EXPECT_EQ(faultOf("model A B b(x[1]=2); end A;").hint, "modify the whole array: x(start={1, 2, 3})");
    EXPECT_EQ(faultOf("model A parameter flow Real x; end A;").message,
              "the prefix \"flow\" is doubled or out of order");
    EXPECT_EQ(faultOf("model A annotation (a=1); Real x; end A;").hint, "move it right before the \"end\"");
    EXPECT_EQ(faultOf("model A algorithm x = 1; end A;").hint, "a statement is written with \":=\"");
    EXPECT_EQ(faultOf("model A B b(final each x=1); end A;").hint, "\"each\" stands before \"final\"");
    EXPECT_EQ(faultOf("model A Real x(start=1; end A;").message,
              "expected \")\" to close the modifications, found \";\"");
}

TEST(Parser, NamesADoubleDeclarationWithItsFirstPlace) {
    const Diagnostic fault = faultOf("model A\n  Real x;\n  Real x;\nend A;");
    EXPECT_EQ(fault.message, "\"x\" is declared twice in \"A\"");
    EXPECT_EQ(fault.place.line, 3);
    EXPECT_EQ(fault.hint, "the first declaration is in line 2, column 8");
}

TEST(Parser, AnOpenStringIsOneMessageAtItsStart) {
    const Diagnostic fault = faultOf("model A\n  Real x=1 \"abc;\nend A;");
    EXPECT_EQ(fault.message, "the string is not closed");
    EXPECT_EQ(fault.place.line, 2);
    EXPECT_EQ(fault.place.column, 12);
    EXPECT_EQ(faultOf("model A /* open\n end A;").message, "the comment is not closed");
    EXPECT_EQ(faultOf("model A Real 'x = 1; end A;").message, "the quoted name is not closed");
}

TEST(Parser, ReadsTheWholeGrammar) {
    const char* const texts[] = {
        "model A Real x; algorithm x := 1; while x < 2 loop x := x + 1; end while; if a then b := 1; elseif c then "
        "break; else return; end if; annotation (a=1); end A;",
        "model A initial algorithm x := 1; for i in 1:3, j loop x[i] := j; end for; end A;",
        "model A equation when x > 1 then reinit(v, 0); elsewhen {y, z} then z = 1; end when; x = 1; end A;",
        "model A algorithm when sample(0, 1) then x := pre(x); elsewhen initial() then x := 0; end when; end A;",
        "connector C stream Real h; flow Real m; end C;",
        "function f \"of x\" input Real x; output Real y; protected Real z[:]; algorithm y := x; end f;",
        "package P function g = f(k=1); model A end A; end P;",
        "pure function f input Real x; output Real y; external \"C\" y = f_c(x, size(x, 1)) annotation(Library=\"m\"); "
        "annotation(derivative=df); end f;",
        "impure function f external; end f;",
        "encapsulated partial function f end f;",
        "operator record C Real re; encapsulated operator 'constructor' function fromReal input Real r; output C c; "
        "algorithm c.re := r; end fromReal; end 'constructor'; operator function '0' end '0'; end C;",
        "expandable connector B Real x; end B;",
        "model A inner outer Real g; final inner replaceable B b constrainedby C(k=1) \"d\"; outer model M = N; end A;",
        "package P redeclare model extends M(k=1) Real x; end M; end P;",
        "function d = der(f, x, y) \"partial\";",
        "type E = enumeration(:);",
        "model A extends B(break c, break connect(a.p, b.p)); C c(x = break); end A;",
        "model A Real x = integrate(function f(k=1), 0, e=function g()); end A;",
        "model A equation (x, , y) = f(1); (a) = g(2); f(x); p.q.f(x=1); end A;",
        "model A algorithm (x, , y) := f(1); f(x); p.f(); end A;",
        "model A Real x = (f(1))[2], y = (a + b).re, z[2, 2] = [1, 2; 3, 4], w[:] = [1:3; x[end]]; end A;",
        "model A Real x = pure(f(1)); equation for i loop x[i] = 1; end for; if initial() then x = 1; end if; end A;",
    };
    for (const char* const text : texts) {
        const ParseResult result = read(text);
        ASSERT_TRUE(result.diagnostics.empty()) << text << "\n" << format(result.diagnostics);
        const std::string printed = print(result.definition);
        const ParseResult again = read(printed);
        ASSERT_TRUE(again.diagnostics.empty()) << printed << "\n" << format(again.diagnostics);
        EXPECT_EQ(print(again.definition), printed) << text;
    }
}

TEST(Parser, KeepsWhatAnAlgorithmSays) {
    const ClassPtr a = classOf(
        "model A Real x; algorithm x := 1; (x, ) := f(2); while x < 2 loop x := x + 1; end while; equation x = 2; "
        "when x > 1 then y = 2; elsewhen z then y = 3; end when; end A;");
    ASSERT_EQ(a->algorithmSections.size(), 1u);
    EXPECT_EQ(a->algorithmSections[0].keyword.text(), "algorithm");
    const auto& statements = a->algorithmSections[0].equations;
    ASSERT_EQ(statements.size(), 3u);
    EXPECT_EQ(statements[0].kind, Equation::Kind::Assign);
    EXPECT_EQ(statements[1].left.operands.at(1).kind, Expression::Kind::Empty);
    EXPECT_EQ(statements[2].kind, Equation::Kind::While);
    EXPECT_EQ(statements[2].branches.at(0).body.size(), 1u);
    ASSERT_EQ(a->equationSections.size(), 1u);
    const Equation& when = a->equationSections[0].equations.at(1);
    EXPECT_EQ(when.kind, Equation::Kind::When);
    EXPECT_EQ(when.keyword.text(), "when");
    EXPECT_EQ(when.branches.size(), 2u);
}

TEST(Parser, GoesOnBehindAFaultyStatement) {
    const ParseResult result = read(
        "model A\n  Real x;\nalgorithm\n  x := ;\n  for i in 1:3 loop x = i; end for;\n  x := 3;\nequation\n  x = 2;\n"
        "end A;");
    EXPECT_EQ(result.diagnostics.size(), 2u) << format(result.diagnostics);
    const ClassDefinition& a = *result.definition.classes.at(0);
    ASSERT_EQ(a.algorithmSections.size(), 1u);
    EXPECT_EQ(a.equationSections.size(), 1u);
}

TEST(Parser, DeepNestingIsAFaultNotACrash) {
    struct Nest {
        const char* head;
        const char* repeated;
    };
    for (const Nest& nest : {Nest{"", "package P "}, Nest{"model A B b(", "x("}, Nest{"model A annotation(", "a("},
                             Nest{"model A equation ", "if a then "}, Nest{"model A equation ", "for i in 1:2 loop "},
                             Nest{"model A Real x = ", "("}, Nest{"model A extends B(", "redeclare C c("}}) {
        std::string text = nest.head;
        for (int i = 0; i < 20000; ++i) text += nest.repeated;
        const ParseResult result = read(text);
        ASSERT_TRUE(hasError(result.diagnostics)) << nest.repeated;
        EXPECT_LE(result.diagnostics.size(), 30u) << nest.repeated;
        const bool isNamed = std::any_of(result.diagnostics.begin(), result.diagnostics.end(), [](const Diagnostic& d) {
            return d.message == "nested deeper than 128 levels";
        });
        EXPECT_TRUE(isNamed) << nest.repeated << format(result.diagnostics);
    }
}

TEST(Parser, AHundredThousandTermsAreReadQuickly) {
    std::string text = "model A Real x; equation x = 1";
    for (int i = 1; i < 100000; ++i) text += "+1";
    text += "; end A;";
    const auto begin = std::chrono::steady_clock::now();
    { EXPECT_TRUE(classOf(text)); }
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
}

TEST(Parser, TellsAtMostSoManyFaults) {
    std::string text = "model A\n";
    for (int i = 0; i < 1000; ++i) text += "Real = ;\n";
    const ParseResult result = read(text + "end A;");
    EXPECT_LE(result.diagnostics.size(), 30u);
    EXPECT_EQ(result.diagnostics.back().message, "too many faults: the rest of the text was not read");
}

TEST(Parser, BytesThatAreNoTextAreOneMessage) {
    std::string bytes;
    for (int i = 0; i < 4096; ++i) bytes += static_cast<char>((i * 7919 + i * i * 31) >> 3);
    EXPECT_EQ(read(bytes).diagnostics.size(), 1u);
    EXPECT_EQ(faultOf(std::string("model A\0 end A;", 15)).message, "a zero byte: this is not a Modelica text");
    EXPECT_EQ(faultOf("\xff\xfem\0o\0").message, "the text is encoded as UTF-16");
    EXPECT_EQ(faultOf("model A \"\xb0"
                      "C\" end A;")
                  .message,
              "the byte 0xb0 is not valid UTF-8");
}

TEST(Parser, ReadsFunctionsWithTheirAlgorithms) {
    const std::string text =
        "package P\n  function f input Real x; output Real y; algorithm y := x; while y > 1 loop y := y/2; end while;\n"
        "    annotation (__Analogon(builtin = true)); end f;\n  model A Real x; end A;\nend P;\n";
    const ClassPtr package = classOf(text);
    ASSERT_EQ(package->classes.size(), 2u);
    const ClassDefinition& f = *package->classes[0];
    EXPECT_EQ(f.restriction, ClassDefinition::Restriction::Function);
    EXPECT_EQ(f.components.size(), 2u);
    EXPECT_EQ(f.algorithmSections.at(0).equations.size(), 2u);
    EXPECT_TRUE(f.span.text().ends_with("end f"));
}

}  // namespace
}  // namespace analogon::syntax
