#include <gtest/gtest.h>

#include "core/syntax/parser.hpp"
#include "tests/core/syntax/tree_text.hpp"

namespace analogon::syntax {
namespace {

SourcePtr sourceOf(std::string text) { return std::make_shared<const Source>("e.mo", std::move(text)); }

std::string tree(const std::string& text) {
    const SourcePtr source = sourceOf(text);
    const auto expression = parseExpression(source);
    return expression ? TreeText::of(*expression) : format(expression.diagnostics());
}

Diagnostic faultOf(const std::string& text) {
    const auto expression = parseExpression(sourceOf(text));
    if (expression) return error("no fault in " + text);
    EXPECT_EQ(expression.diagnostics().size(), 1u) << format(expression.diagnostics());
    return expression.diagnostics().front();
}

TEST(Expression, BindsAsTheGrammarSays) {
    EXPECT_EQ(tree("a + b*c^d"), tree("a + (b*(c^d))"));
    EXPECT_EQ(tree("a - b - c"), tree("(a - b) - c"));
    EXPECT_EQ(tree("a/b/c"), tree("(a/b)/c"));
    EXPECT_EQ(tree("-a*b + c"), tree("(-(a*b)) + c"));
    EXPECT_EQ(tree("-a^2"), tree("-(a^2)"));
    EXPECT_EQ(tree("not a < b and c or d"), tree("((not (a < b)) and c) or d"));
    EXPECT_EQ(tree("a .* b .+ c"), tree("(a .* b) .+ c"));
    EXPECT_NE(tree("a - (b - c)"), tree("a - b - c"));
}

TEST(Expression, ReadsNumbers) {
    const auto value = [](const std::string& text) {
        const auto expression = parseExpression(sourceOf(text));
        return expression ? expression->number : -1.0;
    };
    EXPECT_EQ(value("1"), 1);
    EXPECT_EQ(value("1."), 1);
    EXPECT_EQ(value("2.5e-3"), 2.5e-3);
    EXPECT_EQ(value("1E+3"), 1000);
    EXPECT_EQ(value("6.02214076e23"), 6.02214076e23);
    EXPECT_EQ(value("1e-400"), 0);
    EXPECT_TRUE(parseExpression(sourceOf("12"))->isInteger);
    EXPECT_FALSE(parseExpression(sourceOf("12.0"))->isInteger);
}

TEST(Expression, ReadsStringsWithEscapes) {
    const SourcePtr source = sourceOf(R"("a\"b\\c\n\t\'\?")");
    EXPECT_EQ(parseExpression(source)->text, "a\"b\\c\n\t'?");
    const SourcePtr severalLines = sourceOf("\"one\ntwo\"");
    EXPECT_EQ(parseExpression(severalLines)->text, "one\ntwo");
}

TEST(Expression, ReadsReferencesWithSubscripts) {
    const SourcePtr source = sourceOf(".a.b[2, end - 1].'odd name'[:]");
    const auto expression = parseExpression(source);
    ASSERT_TRUE(expression) << format(expression.diagnostics());
    const Name& name = expression->name;
    EXPECT_TRUE(name.absolute);
    ASSERT_EQ(name.parts.size(), 3u);
    EXPECT_EQ(name.text(), ".a.b.'odd name'");
    ASSERT_EQ(name.parts[1].subscripts.size(), 2u);
    EXPECT_EQ(name.parts[1].subscripts[1].operands[0].kind, Expression::Kind::End);
    EXPECT_EQ(name.parts[2].subscripts[0].kind, Expression::Kind::Colon);
    EXPECT_EQ(name.parts[1].span.text(), "b[2, end - 1]");
}

TEST(Expression, ReadsRanges) {
    const SourcePtr source = sourceOf("1:2:n");
    const auto expression = parseExpression(source);
    ASSERT_TRUE(expression);
    EXPECT_EQ(expression->kind, Expression::Kind::Range);
    EXPECT_EQ(expression->operands.size(), 3u);
    EXPECT_NE(tree("x[2:end]").find("(Range (Number 2.000000 integer ) (End ) )"), std::string::npos);
}

TEST(Expression, ReadsIfExpressionsWithManyBranches) {
    const SourcePtr source = sourceOf("if a then 1 elseif b then 2 else 3");
    const auto expression = parseExpression(source);
    ASSERT_TRUE(expression);
    EXPECT_EQ(expression->kind, Expression::Kind::If);
    EXPECT_EQ(expression->operands.size(), 5u);
}

TEST(Expression, ReadsCallsArraysAndComprehensions) {
    const SourcePtr source = sourceOf("f(1, x, k=2, table={{0, 1}, {2, 3}})");
    const auto call = parseExpression(source);
    ASSERT_TRUE(call) << format(call.diagnostics());
    EXPECT_EQ(call->operands.size(), 2u);
    ASSERT_EQ(call->named.size(), 2u);
    EXPECT_EQ(call->named[1].name, "table");
    EXPECT_EQ(call->named[1].value.operands.size(), 2u);
    const SourcePtr list = sourceOf("{i^2 for i in 1:3, j in 1:2}");
    EXPECT_EQ(parseExpression(list)->iterators.size(), 2u);
    const SourcePtr sum = sourceOf("sum(x[i] for i in 1:n)");
    EXPECT_EQ(parseExpression(sum)->iterators.size(), 1u);
    const SourcePtr derivative = sourceOf("der(w)");
    EXPECT_EQ(parseExpression(derivative)->name.text(), "der");
}

TEST(Expression, SpansAreExact) {
    const SourcePtr source = sourceOf("  (a + b)*c - f( x ) ");
    const auto difference = parseExpression(source);
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->span.text(), "(a + b)*c - f( x )");
    EXPECT_EQ(difference->operands[0].span.text(), "(a + b)*c");
    EXPECT_EQ(difference->operands[0].operands[0].span.text(), "(a + b)");
    EXPECT_EQ(difference->operands[1].span.text(), "f( x )");
    EXPECT_EQ(difference->operands[1].operands[0].span.text(), "x");
}

int depthOf(const Expression& expression) {
    int deepest = 0;
    for (const Expression& operand : expression.operands) deepest = std::max(deepest, depthOf(operand));
    return deepest + 1;
}

double valueOf(const Expression& e) {
    if (e.kind == Expression::Kind::Number) return e.number;
    if (e.kind == Expression::Kind::Unary) return -valueOf(e.operands[0]);
    const double a = valueOf(e.operands[0]), b = valueOf(e.operands[1]);
    return e.text == "+" ? a + b : e.text == "-" ? a - b : e.text == "*" ? a * b : a / b;
}

TEST(Expression, LongSumsAreBalancedAndKeepTheirValue) {
    std::string text = "-1";
    double expected = -1;
    for (int i = 2; i <= 5000; ++i) {
        const bool isMinus = i % 3 == 0 || i % 7 == 1;
        text += (isMinus ? " - " : " + ") + std::to_string(i);
        expected += isMinus ? -i : i;
    }
    const SourcePtr source = sourceOf(text);
    const auto sum = parseExpression(source);
    ASSERT_TRUE(sum) << format(sum.diagnostics());
    EXPECT_LE(depthOf(*sum), 20);
    EXPECT_EQ(valueOf(*sum), expected);
    EXPECT_EQ(sum->span.text(), text);
}

TEST(Expression, LongProductsAreBalancedAndKeepTheirValue) {
    std::string text = "1.5";
    double expected = 1.5;
    for (int i = 2; i <= 400; ++i) {
        const double factor = 1.0 + 1.0 / i;
        const bool isDivision = i % 2 == 0 || i % 5 == 0;
        text += (isDivision ? "/" : "*") + std::to_string(factor);
        expected =
            isDivision ? expected / std::stod(std::to_string(factor)) : expected * std::stod(std::to_string(factor));
    }
    const SourcePtr source = sourceOf(text);
    const auto product = parseExpression(source);
    ASSERT_TRUE(product);
    EXPECT_LE(depthOf(*product), 12);
    EXPECT_NEAR(valueOf(*product), expected, 1e-12 * expected);
}

TEST(Expression, ShortSumsKeepTheirOrder) { EXPECT_EQ(tree("a + b + c + d"), tree("((a + b) + c) + d")); }

TEST(Expression, NamesWhatIsWrongAndWhere) {
    EXPECT_EQ(format(faultOf("a + * b")),
              "e.mo:1:5: error: expected an expression, found \"*\"\n    a + * b\n        ^\n");
    EXPECT_EQ(faultOf("(a + b").message, "expected \")\" to close the parenthesis, found the end of the text");
    EXPECT_EQ(faultOf("(a + b").place.column, 7);
    EXPECT_EQ(faultOf("f(a, b").message, "expected \")\" to close the arguments of \"f\", found the end of the text");
    EXPECT_EQ(faultOf("x[1").message, "expected \"]\" to close the subscripts, found the end of the text");
    EXPECT_EQ(faultOf("a b").message, "expected the end of the expression, found \"b\"");
    EXPECT_EQ(faultOf("").message, "expected an expression, found the end of the text");
}

TEST(Expression, HintsAtWhatModelicaWrites) {
    EXPECT_EQ(faultOf("a*-b").hint, "put the signed operand in parentheses: a*(-b)");
    EXPECT_EQ(faultOf("a^b^c").hint, "write (a^b)^c or a^(b^c)");
    EXPECT_EQ(faultOf("a < b < c").hint, "write \"a < b and b < c\"");
    EXPECT_EQ(faultOf("if a then b").hint, "an if expression needs a value for every case");
    EXPECT_EQ(faultOf("1 + if a then b else c").hint, "write a + (if b then c else d)");
    EXPECT_EQ(faultOf(".5").hint, "write 0.5");
    EXPECT_EQ(faultOf("2x").message, "\"2x\" is neither a number nor a name");
    EXPECT_EQ(faultOf("1e999").message, "the number is too large");
    EXPECT_EQ(faultOf("\"a\\qb\"").message, "unknown escape in a string");
    EXPECT_EQ(faultOf("f(k=1, 2)").message, "a positional argument behind a named one");
    EXPECT_EQ(faultOf("T_α").hint, "names hold ASCII letters, digits and _; others stand in quotes: 'T_α'");
}

TEST(Expression, DeepNestingIsAFaultNotACrash) {
    for (const char* open : {"(", "{", "f(", "-(", "x[", "not (", "if a then (", "(a + (b*"}) {
        std::string text;
        for (int i = 0; i < 20000; ++i) text += open;
        EXPECT_NE(faultOf(text).message.find("nested deeper than"), std::string::npos) << open;
    }
    std::string chain = "a";
    for (int i = 0; i < 20000; ++i) chain += " elseif a then b";
    EXPECT_TRUE(parseExpression(sourceOf("if a then b" + chain.substr(1) + " else c")));
}

TEST(Expression, LongMixedChainsAreAFaultNotADeepTree) {
    std::string text = "a";
    for (int i = 0; i < 20000; ++i) text += i % 2 == 0 ? " + a" : " .+ a";
    EXPECT_NE(faultOf(text).message.find("mixes scalar and element-wise operators"), std::string::npos);
}

}  // namespace
}  // namespace analogon::syntax
